// SPDX-License-Identifier: BSD-3-Clause
#include "petsc_matrix.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <string>
#include <type_traits>

#include "boxplus/base/error.h"

namespace boxplus::petsc {
namespace {

static_assert(std::is_same_v<PetscScalar, double>, "boxplus needs a PETSc with real numbers in double");

}  // namespace

Matrix::Matrix(const Calls& calls, const BlockStructure& structure, const Layout& layout, MatType type)
    : structure_(&structure), layout_(&layout) {
  if (layout.any(calls, 2 * std::uint64_t{structure.nonzero_values()} > kMost)) {
    throw InvalidArgument("PETSc: expected at most " + std::to_string(kMost / 2) +
                          " values in the lower triangle" +
                          (layout.processes() > 1 ? " of what a process contributes; use more processes"
                                                  : ", got " + std::to_string(structure.nonzero_values())));
  }
  const PetscInt first = layout.first_row(layout.rank()), end = layout.first_row(layout.rank() + 1);
  const PetscInt rows = layout.first_scalar(end) - layout.first_scalar(first);
  const bool has_equal_blocks = layout.block_size() > 0;
  calls(MatCreate(layout.communicator(), matrix_.out()));
  calls(MatSetSizes(matrix_, rows, rows, layout.scalars(), layout.scalars()));
  calls(MatSetType(matrix_, has_equal_blocks ? type : MATAIJ));
  calls(MatSetFromOptions(matrix_));
  upper_only_ = is_type(calls, Mat(matrix_), MATSEQSBAIJ) || is_type(calls, Mat(matrix_), MATMPISBAIJ);
  if (has_equal_blocks) calls(MatSetBlockSize(matrix_, layout.block_size()));
  exchange_places(calls);
  preallocate(calls);
  if (!is_type(calls, Mat(matrix_), MATMPIBAIJ)) {  // which does not know these options
    calls(MatSetOption(matrix_, MAT_SPD, PETSC_TRUE));
    calls(MatSetOption(matrix_, MAT_SPD_ETERNAL, PETSC_TRUE));
  }
  if (upper_only_) calls(MatSetOption(matrix_, MAT_IGNORE_LOWER_TRIANGULAR, PETSC_TRUE));
  if (has_equal_blocks) return;
  std::vector<PetscInt> sizes;
  for (PetscInt number = first; number < end; ++number) sizes.push_back(layout.dim(number));
  calls(MatSetVariableBlockSizes(matrix_, static_cast<PetscInt>(sizes.size()), sizes.data()));
}

/// Calls f(k, column, whether it is in the upper triangle, place) for the blocks of the structure, and, if
/// the matrix stores both triangles, for their transposes.
template <class F>
void Matrix::for_each_block(F&& f) const {
  const BlockStructure& s = *structure_;
  for (std::uint32_t j = 0; j < s.blocks(); ++j) {
    for (std::uint32_t k = s.column_start[j]; k < s.column_start[j + 1]; ++k) {
      const PetscInt low = layout_->number(j), high = layout_->number(s.row[k]);
      f(k, j, true, Place{low, high});
      if (!upper_only_ && low != high) f(k, j, false, Place{high, low});
    }
  }
}

/// Tells other processes which blocks they will get.
void Matrix::exchange_places(const Calls& calls) {
  const auto processes = static_cast<std::size_t>(layout_->processes());
  std::vector<std::vector<Place>> places(processes);
  for_each_block([&](std::uint32_t, std::uint32_t, bool, Place place) {
    const int owner = layout_->owner(place.row);
    if (owner != layout_->rank()) places[static_cast<std::size_t>(owner)].push_back(place);
  });
  const auto shares_of = [&](const std::vector<std::vector<Place>>& of_processes, auto&& count) {
    Shares shares;
    std::size_t end = 0;
    for (const std::vector<Place>& of_process : of_processes) {
      shares.first.push_back(static_cast<int>(end));
      std::size_t items = 0;
      for (const Place place : of_process) items += count(place);
      end += items;
      shares.count.push_back(static_cast<int>(items));
    }
    return shares;
  };
  const auto exchange = [&](const Shares& of_sent) {
    Shares shares{std::vector<int>(processes), std::vector<int>(processes, 0)};
    calls(MPI_Alltoall(of_sent.count.data(), 1, MPI_INT, shares.count.data(), 1, MPI_INT,
                       layout_->communicator()));
    std::int64_t end = 0;
    for (std::size_t p = 0; p < processes; ++p) {
      shares.first[p] = static_cast<int>(end);
      end += shares.count[p];
    }
    if (layout_->any(calls, end > std::numeric_limits<int>::max()))
      throw Error("PETSc: the processes contribute too many values to the rows of one; use more processes");
    return shares;
  };
  const auto total = [](const Shares& shares) {
    return static_cast<std::size_t>(shares.first.back() + shares.count.back());
  };
  const Shares sent = shares_of(places, [](Place) { return std::size_t{2}; }), received = exchange(sent);
  std::vector<Place> all;
  for (const std::vector<Place>& of_process : places)
    all.insert(all.end(), of_process.begin(), of_process.end());
  received_places_.resize(total(received) / 2);
  calls(MPI_Alltoallv(all.data(), sent.count.data(), sent.first.data(), MPIU_INT, received_places_.data(),
                      received.count.data(), received.first.data(), MPIU_INT, layout_->communicator()));
  sent_ = shares_of(places, [&](Place place) { return size(place); });
  received_ = exchange(sent_);
  sent_values_.resize(total(sent_));
  received_values_.resize(total(received_));
}

/// Tells the matrix where it will have values. If the blocks have equal sizes, one value stands for its
/// block.
void Matrix::preallocate(const Calls& calls) {
  const Layout& layout = *layout_;
  PetscInt rows = 0, block_size = 1;
  calls(MatGetLocalSize(matrix_, &rows, nullptr));
  calls(MatGetBlockSize(matrix_, &block_size));
  Owned<Mat, MatDestroy> pattern;
  calls(MatCreate(layout.communicator(), pattern.out()));
  calls(MatSetSizes(pattern, rows, rows, layout.scalars(), layout.scalars()));
  calls(MatSetType(pattern, MATPREALLOCATOR));
  calls(MatSetBlockSize(pattern, block_size));
  calls(MatSetUp(pattern));
  const auto add = [&](Place place) {
    rows_.resize(static_cast<std::size_t>(layout.block_size() > 0 ? 1 : layout.dim(place.row)));
    columns_.resize(static_cast<std::size_t>(layout.block_size() > 0 ? 1 : layout.dim(place.column)));
    std::iota(rows_.begin(), rows_.end(), layout.first_scalar(place.row));
    std::iota(columns_.begin(), columns_.end(), layout.first_scalar(place.column));
    block_.assign(rows_.size() * columns_.size(), 0.0);
    calls(MatSetValues(pattern, static_cast<PetscInt>(rows_.size()), rows_.data(),
                       static_cast<PetscInt>(columns_.size()), columns_.data(), block_.data(),
                       INSERT_VALUES));
  };
  for_each_block([&](std::uint32_t, std::uint32_t, bool, Place place) {
    if (layout.owner(place.row) == layout.rank()) add(place);
  });
  for (const Place place : received_places_) add(place);
  calls(MatAssemblyBegin(pattern, MAT_FINAL_ASSEMBLY));
  calls(MatAssemblyEnd(pattern, MAT_FINAL_ASSEMBLY));
  calls(MatPreallocatorPreallocate(pattern, PETSC_FALSE, matrix_));
}

void Matrix::insert(const Calls& calls, Place place, const double* values) {
  const Layout& layout = *layout_;
  if (layout.block_size() > 0)
    return calls(MatSetValuesBlocked(matrix_, 1, &place.row, 1, &place.column, values, ADD_VALUES));
  rows_.resize(static_cast<std::size_t>(layout.dim(place.row)));
  columns_.resize(static_cast<std::size_t>(layout.dim(place.column)));
  std::iota(rows_.begin(), rows_.end(), layout.first_scalar(place.row));
  std::iota(columns_.begin(), columns_.end(), layout.first_scalar(place.column));
  calls(MatSetValues(matrix_, static_cast<PetscInt>(rows_.size()), rows_.data(),
                     static_cast<PetscInt>(columns_.size()), columns_.data(), values, ADD_VALUES));
}

/// The values, row by row, of a block of A + λD or of its transpose. Valid until the next call.
const double* Matrix::by_rows(std::uint32_t k, std::uint32_t column, bool is_upper, const double* values,
                              const Damping& damping) {
  const BlockStructure& s = *structure_;
  const double* block = values + s.value_start[k];
  const std::uint32_t row = s.row[k], height = s.dim(row), width = s.dim(column);
  // A block of the lower triangle, column by column, is its transpose in the upper one, row by row.
  if (row != column && is_upper) return block;
  block_.assign(block, block + height * width);
  if (row == column) {
    for (std::uint32_t i = 0; i < height; ++i) block_[i * (height + 1)] += damping(s.offset[column] + i);
  } else {
    for (std::uint32_t i = 0; i < height; ++i) {
      for (std::uint32_t j = 0; j < width; ++j) block_[i * width + j] = block[j * height + i];
    }
  }
  return block_.data();
}

/// Adds contributions in the order of ranks, so that the bits of the sums repeat. (PETSc would add them as
/// they arrive.)
void Matrix::assign(const Calls& calls, const double* values, const Damping& damping) {
  calls(MatZeroEntries(matrix_));
  std::vector<int> next = sent_.first;
  for_each_block([&](std::uint32_t k, std::uint32_t column, bool is_upper, Place place) {
    const double* block = by_rows(k, column, is_upper, values, damping);
    const int owner = layout_->owner(place.row);
    if (owner == layout_->rank()) return insert(calls, place, block);
    int& end = next[static_cast<std::size_t>(owner)];
    std::copy_n(block, size(place), sent_values_.data() + end);
    end += static_cast<int>(size(place));
  });
  if (layout_->processes() > 1)
    calls(MPI_Alltoallv(sent_values_.data(), sent_.count.data(), sent_.first.data(), MPI_DOUBLE,
                        received_values_.data(), received_.count.data(), received_.first.data(), MPI_DOUBLE,
                        layout_->communicator()));
  const double* block = received_values_.data();
  for (const Place place : received_places_) {
    insert(calls, place, block);
    block += size(place);
  }
  calls(MatAssemblyBegin(matrix_, MAT_FINAL_ASSEMBLY));
  calls(MatAssemblyEnd(matrix_, MAT_FINAL_ASSEMBLY));
}

}  // namespace boxplus::petsc
