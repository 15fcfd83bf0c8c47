// SPDX-License-Identifier: BSD-3-Clause
// A system of boxplus as a matrix of PETSc.
#pragma once

#include <petscmat.h>

#include <vector>

#include "boxplus/linear/linear_solver.h"
#include "petsc_calls.h"

namespace boxplus::petsc {

/// The places of the blocks of a system in matrices and vectors of PETSc. Each process of the communicator
/// has the rows of some consecutive blocks.
class Layout {
 public:
  /// If `divided` is not null, the system is the sum over the processes. Otherwise, the system belongs to
  /// this process, and the communicator must be PETSC_COMM_SELF.
  Layout(const BlockStructure& structure, const DividedSystem* divided, MPI_Comm communicator);

  MPI_Comm communicator() const { return communicator_; }
  /// Whether it is so in any process. Collective.
  bool any(const Calls& calls, bool here) const;
  PetscInt scalars() const { return offset_.back(); }
  /// The size that all blocks have, or 0.
  PetscInt block_size() const { return block_size_; }
  /// The number of a block of this process in the whole system.
  PetscInt number(std::uint32_t block) const { return numbers_[block]; }
  /// The first scalar of a block in the whole system.
  PetscInt first_scalar(PetscInt number) const { return offset_[number]; }
  PetscInt dim(PetscInt number) const { return offset_[number + 1] - offset_[number]; }
  int processes() const { return static_cast<int>(first_rows_.size()) - 1; }
  int rank() const { return rank_; }
  /// The process that has the rows of a block, and the first block of which a process has the rows.
  int owner(PetscInt number) const;
  PetscInt first_row(int process) const { return first_rows_[static_cast<std::size_t>(process)]; }
  /// The scalars of the blocks of this process.
  std::vector<PetscInt> scalars_of_blocks() const;
  /// The block of this process that has a scalar of the whole system, or BlockStructure::kAbsent.
  std::uint32_t find_block(PetscInt scalar) const;

 private:
  MPI_Comm communicator_;
  std::vector<PetscInt> numbers_, offset_, first_rows_;
  PetscInt block_size_ = 0;
  int rank_ = 0;
};

/// A + λD. The structure and the layout must outlive the matrix.
class Matrix {
 public:
  /// `type` is MATBAIJ, MATSBAIJ or MATAIJ. If the blocks have different sizes, it becomes MATAIJ.
  Matrix(const Calls& calls, const BlockStructure& structure, const Layout& layout, MatType type);
  /// `values` are in the layout of the structure.
  void assign(const Calls& calls, const double* values, const Damping& damping);
  operator Mat() const { return matrix_; }

 private:
  /// The place of a block in the matrix.
  struct Place {
    PetscInt row, column;
  };
  /// The items that go to each process, or come from it: its share, and the first one of each share.
  struct Shares {
    std::vector<int> count, first;
  };

  bool is_type(const Calls& calls, MatType type) const;
  template <class F>
  void for_each_block(F&& f) const;
  void exchange_places(const Calls& calls);
  void preallocate(const Calls& calls);
  const double* by_rows(std::uint32_t k, std::uint32_t column, bool is_upper, const double* values,
                        const Damping& damping);
  void insert(const Calls& calls, Place place, const double* values);
  std::size_t size(Place place) const {
    return static_cast<std::size_t>(layout_->dim(place.row)) *
           static_cast<std::size_t>(layout_->dim(place.column));
  }

  const BlockStructure* structure_;
  const Layout* layout_;
  Owned<Mat, MatDestroy> matrix_;
  bool upper_only_ = false;  // whether the matrix stores only its upper triangle
  // What this process contributes to rows of others, and what they contribute to its rows.
  std::vector<Place> received_places_;
  Shares sent_, received_;  // of values
  std::vector<double> sent_values_, received_values_;
  std::vector<double> block_;  // scratch memory
  std::vector<PetscInt> rows_, columns_;
};

}  // namespace boxplus::petsc
