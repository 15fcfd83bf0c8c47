// SPDX-License-Identifier: BSD-3-Clause
// factorize() and solve() allocate nothing after the first time. Counts every operator new of the program,
// and every malloc, calloc and realloc that the library itself calls (linked with --wrap).
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "boxplus/linear/linear_solver.h"
#include "linear/test_system.h"

namespace {
std::atomic<long> allocations{0};

void* counted(std::size_t size) {
  ++allocations;
  void* memory = std::malloc(size == 0 ? 1 : size);
  if (!memory) throw std::bad_alloc();
  return memory;
}

void* counted(std::size_t size, std::align_val_t alignment) {
  ++allocations;
  const auto step = static_cast<std::size_t>(alignment);
  void* memory = std::aligned_alloc(step, (size + step - 1) / step * step);
  if (!memory) throw std::bad_alloc();
  return memory;
}
}  // namespace

void* operator new(std::size_t size) {
  return counted(size);
}
void* operator new[](std::size_t size) {
  return counted(size);
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  return counted(size, alignment);
}
void* operator new[](std::size_t size, std::align_val_t alignment) {
  return counted(size, alignment);
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return ++allocations, std::malloc(size + 1);
}
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept {
  return ++allocations, std::malloc(size + 1);
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete[](void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
  std::free(memory);
}
void operator delete[](void* memory, std::align_val_t) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  std::free(memory);
}
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept {
  std::free(memory);
}

extern "C" {
void* __real_malloc(std::size_t size);
void* __real_calloc(std::size_t count, std::size_t size);
void* __real_realloc(void* memory, std::size_t size);
void* __wrap_malloc(std::size_t size) {
  ++allocations;
  return __real_malloc(size);
}
void* __wrap_calloc(std::size_t count, std::size_t size) {
  ++allocations;
  return __real_calloc(count, size);
}
void* __wrap_realloc(void* memory, std::size_t size) {
  ++allocations;
  return __real_realloc(memory, size);
}
}

namespace boxplus {
namespace {

/// All but LinearSolverKind::kEigenSparse: Eigen allocates temporaries in every call (see
/// eigen_sparse_solver.h).
class Allocations : public ::testing::TestWithParam<LinearSolverKind> {};

TEST_P(Allocations, AreCounted) {
  const long before = allocations;
  void* volatile by_new = ::operator new(8);
  EXPECT_GT(allocations, before);
  ::operator delete(by_new);
}

TEST_P(Allocations, StopAfterTheFirstFactorizationAndSolve) {
  std::mt19937 random(1);
  TestSystem system = random_system(std::vector<std::uint32_t>(225, 6), grid_edges(15, 15), random);
  const AssembledSystem view = system.view();
  const auto solver = make_linear_solver(GetParam());
  solver->analyze(system.structure, {.right_hand_sides = 2, .threads = 2});
  std::vector<double> b(2 * system.structure.scalars(), 1.0), x(b.size());
  bool good = true;
  const auto step = [&](double lambda, int columns) {
    good = solver->factorize(view, {.lambda = lambda}).status == LinearStatus::kOk &&
           solver->solve(b.data(), columns, x.data()).status == LinearStatus::kOk && good;
  };
  step(0, 1);
  const long before = allocations;
  step(1, 1);
  step(2, 2);
  step(0, 2);
  const long after = allocations;
  EXPECT_TRUE(good);
  EXPECT_EQ(after - before, 0);
}

INSTANTIATE_TEST_SUITE_P(All, Allocations,
                         ::testing::Values(LinearSolverKind::kBlockCholesky, LinearSolverKind::kPcg,
                                           LinearSolverKind::kDense),
                         [](const auto& test) { return std::string(to_string(test.param)); });

}  // namespace
}  // namespace boxplus
