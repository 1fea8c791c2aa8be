// A cloth that has come to rest, and how it gives way to a small load there.
#pragma once

#include <functional>

#include "runtime/energy/elastic.hpp"

namespace toile {

struct RestState {
  const ElasticForm& elastic;
  const Vector& q;
  double weight = 0;  // [N/m2] of the cloth that hangs in it
  /// The small motion that balances a load on the unknowns: the true Hessian of all energies is solved with. What is
  /// held stays.
  std::function<Vector(const Vector& load)> give;
};

}  // namespace toile
