#include <cholmod.h>

#include <mutex>
#include <utility>

#include "runtime/library/late_library.hpp"
#include "runtime/solve/sparse.hpp"

// CHOLMOD shares its loops out by OpenMP. Its threads wait for each other by spinning, which costs more than they bring
// at the sizes of garments, and even a team of one wakes the others, who are not there, some three hundred times a
// factor: a sixth of its time. So such loops run where they stand. Nothing else here is threaded by OpenMP.
extern "C" void GOMP_parallel(void (*loop)(void*), void* data, unsigned /*threads*/, unsigned /*flags*/) {
  loop(data);
}

namespace toile {
namespace {

/// The functions of CHOLMOD that are called here.
struct Cholmod {
  LateLibrary library{TOILE_CHOLMOD};
  decltype(cholmod_start)* start = library.function<decltype(cholmod_start)>("cholmod_start");
  decltype(cholmod_finish)* finish = library.function<decltype(cholmod_finish)>("cholmod_finish");
  decltype(cholmod_analyze)* analyze = library.function<decltype(cholmod_analyze)>("cholmod_analyze");
  decltype(cholmod_factorize)* factorize = library.function<decltype(cholmod_factorize)>("cholmod_factorize");
  decltype(cholmod_solve)* solve = library.function<decltype(cholmod_solve)>("cholmod_solve");
  decltype(cholmod_free_factor)* free_factor = library.function<decltype(cholmod_free_factor)>("cholmod_free_factor");
  decltype(cholmod_free_dense)* free_dense = library.function<decltype(cholmod_free_dense)>("cholmod_free_dense");
};

const Cholmod& cholmod() {
  static const Cholmod opened;
  return opened;
}

}  // namespace

struct Cholesky::Handle {
  cholmod_common common{};
  cholmod_factor* factor = nullptr;

  Handle() {
    cholmod().start(&common);
    common.print = 0;
    common.quick_return_if_not_posdef = 1;
    common.supernodal = CHOLMOD_SUPERNODAL;
    common.final_ll = 1;
    common.nmethods = 1;
    common.method[0].ordering = CHOLMOD_METIS;
    common.postorder = 1;
  }
  ~Handle() {
    cholmod().free_factor(&factor, &common);
    cholmod().finish(&common);
  }
};

namespace {

/// BLAS built for one thread shares its buffers among all, and METIS draws from the one rand(): of two drapes in one
/// process, one factorises at a time.
std::mutex& one_at_a_time() {
  static std::mutex mutex;
  return mutex;
}

/// CHOLMOD's view of our arrays; it does not write to them.
cholmod_sparse view(const SparseMatrix& matrix) {
  cholmod_sparse sparse{};
  sparse.nrow = sparse.ncol = static_cast<std::size_t>(matrix.rows());
  sparse.nzmax = matrix.values().size();
  sparse.p = const_cast<int*>(matrix.column_start().data());
  sparse.i = const_cast<int*>(matrix.row_index().data());
  sparse.x = const_cast<double*>(matrix.values().data());
  sparse.stype = -1;
  sparse.itype = CHOLMOD_INT;
  sparse.xtype = CHOLMOD_REAL;
  sparse.dtype = CHOLMOD_DOUBLE;
  sparse.sorted = 1;
  sparse.packed = 1;
  return sparse;
}

}  // namespace

Cholesky::Cholesky() : handle_(std::make_unique<Handle>()) {}
Cholesky::~Cholesky() = default;

std::vector<int> Cholesky::good_order(const SparseMatrix& matrix) const {
  cholmod_sparse a = view(matrix);
  const std::lock_guard<std::mutex> alone(one_at_a_time());
  cholmod_factor* factor = cholmod().analyze(&a, &handle_->common);
  const int* order = static_cast<const int*>(factor->Perm);
  std::vector<int> rows(order, order + matrix.rows());
  cholmod().free_factor(&factor, &handle_->common);
  return rows;
}

void Cholesky::analyse(const SparseMatrix& matrix) {
  cholmod_sparse a = view(matrix);
  cholmod().free_factor(&handle_->factor, &handle_->common);
  const std::lock_guard<std::mutex> alone(one_at_a_time());
  handle_->factor = cholmod().analyze(&a, &handle_->common);
}

void Cholesky::analyse_in_order(const SparseMatrix& matrix) {
  cholmod_common& common = handle_->common;
  const int ordering = std::exchange(common.method[0].ordering, CHOLMOD_NATURAL);
  common.postorder = 0;
  analyse(matrix);
  common.method[0].ordering = ordering;
  common.postorder = 1;
}

void Cholesky::order_by_degree() {
  handle_->common.method[0].ordering = CHOLMOD_AMD;
}

void Cholesky::join_more_columns() {
  handle_->common.nrelax[0] = 16;
  handle_->common.nrelax[1] = 32;
  handle_->common.nrelax[2] = 64;
}

bool Cholesky::factorise(const SparseMatrix& matrix) {
  cholmod_sparse a = view(matrix);
  ++factorisations_;
  const std::lock_guard<std::mutex> alone(one_at_a_time());
  cholmod().factorize(&a, handle_->factor, &handle_->common);
  return handle_->common.status == CHOLMOD_OK && handle_->factor->minor == handle_->factor->n;
}

Vector Cholesky::solve(const Vector& right) const {
  cholmod_dense b{};
  b.nrow = b.nzmax = b.d = static_cast<std::size_t>(right.size());
  b.ncol = 1;
  b.x = const_cast<double*>(right.data());
  b.xtype = CHOLMOD_REAL;
  b.dtype = CHOLMOD_DOUBLE;
  const std::lock_guard<std::mutex> alone(one_at_a_time());
  cholmod_dense* x = cholmod().solve(CHOLMOD_A, handle_->factor, &b, &handle_->common);
  if (x == nullptr) return Vector::Zero(right.size());
  Vector solution = Eigen::Map<const Vector>(static_cast<double*>(x->x), right.size());
  cholmod().free_dense(&x, &handle_->common);
  return solution;
}

Vector Cholesky::solve_free(const SparseMatrix& matrix, const Vector& right) const {
  const std::vector<int>& reduced = matrix.reduced();
  Vector free(matrix.rows());
  for (std::size_t i = 0; i < reduced.size(); ++i) {
    if (reduced[i] >= 0) free[reduced[i]] = right[static_cast<Eigen::Index>(i)];
  }
  const Vector solution = solve(free);
  Vector all = Vector::Zero(right.size());
  for (std::size_t i = 0; i < reduced.size(); ++i) {
    if (reduced[i] >= 0) all[static_cast<Eigen::Index>(i)] = solution[reduced[i]];
  }
  return all;
}

}  // namespace toile
