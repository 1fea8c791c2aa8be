// The factorisation in the process that it runs in.
#include <dlfcn.h>
#include <gtest/gtest.h>

#include "runtime/solve/sparse.hpp"

extern "C" void GOMP_parallel(void (*loop)(void*), void* data, unsigned threads, unsigned flags);

namespace toile {
namespace {

TEST(CholeskyTest, SolvesWhatItFactorises) {
  SparseMatrix matrix({0, 1, 2}, {{0, 1, 2}});
  for (int i = 0; i < 3; ++i) matrix.add(i, i, 4);
  matrix.add(1, 0, 1);
  Cholesky cholesky;
  cholesky.analyse(matrix);
  ASSERT_TRUE(cholesky.factorise(matrix));
  Vector b(3);
  b << 5, 5, 8;
  const Vector x = cholesky.solve(b);
  EXPECT_NEAR(x[0], 1, 1e-14);
  EXPECT_NEAR(x[1], 1, 1e-14);
  EXPECT_NEAR(x[2], 2, 1e-14);
}

/// CHOLMOD is opened when it is first needed, and finds the program's own way of running OpenMP's loops before
/// OpenMP's.
TEST(CholeskyTest, LoopsOfOpenMPRunWhereTheyStand) {
  int runs = 0;
  const auto count = [](void* data) { ++*static_cast<int*>(data); };
  GOMP_parallel(count, &runs, 4, 0);
  EXPECT_EQ(runs, 1);
  EXPECT_EQ(dlsym(RTLD_DEFAULT, "GOMP_parallel"), reinterpret_cast<void*>(&GOMP_parallel));
}

}  // namespace
}  // namespace toile
