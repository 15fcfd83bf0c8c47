// SPDX-License-Identifier: BSD-3-Clause
#include "petsc_matrix.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <string>
#include <type_traits>

#include "boxplus/base/error.h"

namespace boxplus::petsc {
namespace {

static_assert(std::is_same_v<PetscScalar, double>, "boxplus needs a PETSc with real numbers in double");

/// The size that all blocks have, or 0.
PetscInt common_size(const BlockStructure& structure) {
  const std::uint32_t size = structure.dim(0);
  for (std::uint32_t j = 1; j < structure.blocks(); ++j) {
    if (structure.dim(j) != size) return 0;
  }
  return static_cast<PetscInt>(size);
}

}  // namespace

Matrix::Matrix(const Calls& calls, const BlockStructure& structure, MatType type)
    : structure_(&structure), block_size_(common_size(structure)) {
  const std::uint64_t most = std::numeric_limits<PetscInt>::max();
  if (2 * std::uint64_t{structure.nonzero_values()} > most)
    throw InvalidArgument("PETSc: expected at most " + std::to_string(most / 2) +
                          " values in the lower triangle, got " + std::to_string(structure.nonzero_values()));
  const auto size = static_cast<PetscInt>(structure.scalars());
  calls(MatCreate(PETSC_COMM_SELF, matrix_.out()));
  calls(MatSetSizes(matrix_, size, size, size, size));
  calls(MatSetType(matrix_, has_equal_blocks() ? type : MATSEQAIJ));
  calls(MatSetFromOptions(matrix_));
  PetscBool is_symmetric_type = PETSC_FALSE;
  calls(PetscObjectTypeCompareAny(reinterpret_cast<PetscObject>(static_cast<Mat>(matrix_)),
                                  &is_symmetric_type, MATSEQSBAIJ, MATSBAIJ, ""));
  upper_only_ = is_symmetric_type;
  if (has_equal_blocks()) calls(MatSetBlockSize(matrix_, block_size_));
  preallocate(calls);
  calls(MatSetOption(matrix_, MAT_SPD, PETSC_TRUE));
  calls(MatSetOption(matrix_, MAT_SPD_ETERNAL, PETSC_TRUE));
  if (upper_only_) calls(MatSetOption(matrix_, MAT_IGNORE_LOWER_TRIANGULAR, PETSC_TRUE));
  if (has_equal_blocks()) return;
  std::vector<PetscInt> sizes;
  for (std::uint32_t j = 0; j < structure.blocks(); ++j)
    sizes.push_back(static_cast<PetscInt>(structure.dim(j)));
  calls(MatSetVariableBlockSizes(matrix_, static_cast<PetscInt>(sizes.size()), sizes.data()));
}

/// Counts the blocks, or the scalars, of each row, and of the upper triangle of each row.
void Matrix::preallocate(const Calls& calls) {
  const BlockStructure& s = *structure_;
  const bool in_blocks = has_equal_blocks();
  const auto width = [&](std::uint32_t block) { return in_blocks ? 1 : static_cast<PetscInt>(s.dim(block)); };
  std::vector<PetscInt> of_row(s.blocks(), 0), of_upper(s.blocks(), 0);
  for (std::uint32_t j = 0; j < s.blocks(); ++j) {
    for (std::uint32_t k = s.column_start[j]; k < s.column_start[j + 1]; ++k) {
      const std::uint32_t i = s.row[k];
      of_row[j] += width(i);
      of_upper[j] += width(i);
      if (i != j) of_row[i] += width(j);
    }
  }
  if (!in_blocks) {
    std::vector<PetscInt> scalar_row, scalar_upper;
    for (std::uint32_t j = 0; j < s.blocks(); ++j) {
      scalar_row.insert(scalar_row.end(), s.dim(j), of_row[j]);
      scalar_upper.insert(scalar_upper.end(), s.dim(j), of_upper[j]);
    }
    of_row = std::move(scalar_row);
    of_upper = std::move(scalar_upper);
  }
  calls(MatXAIJSetPreallocation(matrix_, in_blocks ? block_size_ : 1, of_row.data(), nullptr, of_upper.data(),
                                nullptr));
}

void Matrix::insert(const Calls& calls, std::uint32_t row, std::uint32_t column, const double* values) {
  if (has_equal_blocks()) {
    const auto i = static_cast<PetscInt>(row), j = static_cast<PetscInt>(column);
    return calls(MatSetValuesBlocked(matrix_, 1, &i, 1, &j, values, INSERT_VALUES));
  }
  const BlockStructure& s = *structure_;
  rows_.resize(s.dim(row));
  columns_.resize(s.dim(column));
  std::iota(rows_.begin(), rows_.end(), static_cast<PetscInt>(s.offset[row]));
  std::iota(columns_.begin(), columns_.end(), static_cast<PetscInt>(s.offset[column]));
  calls(MatSetValues(matrix_, static_cast<PetscInt>(rows_.size()), rows_.data(),
                     static_cast<PetscInt>(columns_.size()), columns_.data(), values, INSERT_VALUES));
}

void Matrix::assign(const Calls& calls, const double* values, const Damping& damping) {
  const BlockStructure& s = *structure_;
  calls(MatSetOption(matrix_, MAT_ROW_ORIENTED, PETSC_TRUE));
  for (std::uint32_t j = 0; j < s.blocks(); ++j) {
    for (std::uint32_t k = s.column_start[j]; k < s.column_start[j + 1]; ++k) {
      const double* block = values + s.value_start[k];
      // A block of the lower triangle, column by column, is its transpose in the upper one, row by row.
      if (s.row[k] != j) {
        insert(calls, j, s.row[k], block);
        continue;
      }
      const std::uint32_t dim = s.dim(j);
      diagonal_.assign(block, block + dim * dim);
      for (std::uint32_t i = 0; i < dim; ++i) diagonal_[i * (dim + 1)] += damping(s.offset[j] + i);
      insert(calls, j, j, diagonal_.data());
    }
  }
  if (!upper_only_) {
    calls(MatSetOption(matrix_, MAT_ROW_ORIENTED, PETSC_FALSE));
    for (std::uint32_t j = 0; j < s.blocks(); ++j) {
      for (std::uint32_t k = s.column_start[j] + 1; k < s.column_start[j + 1]; ++k)
        insert(calls, s.row[k], j, values + s.value_start[k]);
    }
  }
  calls(MatAssemblyBegin(matrix_, MAT_FINAL_ASSEMBLY));
  calls(MatAssemblyEnd(matrix_, MAT_FINAL_ASSEMBLY));
}

}  // namespace boxplus::petsc
