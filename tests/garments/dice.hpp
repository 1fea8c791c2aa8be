// Random numbers that are the same on every machine.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace toile::test {

class Dice {
 public:
  explicit Dice(unsigned seed) : random_(seed) {}
  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(random_() >> 11) / 9007199254740992.0;
  }
  /// Each factor between the two as likely as the next.
  double scaled(double low, double high) { return low * std::pow(high / low, uniform(0, 1)); }
  int from(int low, int high) { return low + static_cast<int>(random_() % static_cast<std::uint64_t>(high - low + 1)); }
  bool chance(double share) { return uniform(0, 1) < share; }
  template <class T>
  const T& one_of(const std::vector<T>& all) {
    return all[static_cast<std::size_t>(random_() % all.size())];
  }

 private:
  std::mt19937_64 random_;
};

}  // namespace toile::test
