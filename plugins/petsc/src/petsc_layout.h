// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <petscsys.h>

#include <cstdint>
#include <limits>
#include <vector>

#include "boxplus/linear/linear_solver.h"
#include "petsc_calls.h"

namespace boxplus::petsc {

/// The largest number of rows or values that PETSc can count.
inline constexpr std::uint64_t kMost = std::numeric_limits<PetscInt>::max();

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

}  // namespace boxplus::petsc
