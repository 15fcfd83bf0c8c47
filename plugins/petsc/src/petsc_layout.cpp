// SPDX-License-Identifier: BSD-3-Clause
#include "petsc_layout.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <string>

#include "boxplus/base/error.h"

namespace boxplus::petsc {

Layout::Layout(const BlockStructure& structure, const DividedSystem* divided, MPI_Comm communicator)
    : communicator_(communicator), numbers_(structure.blocks()) {
  std::iota(numbers_.begin(), numbers_.end(), 0);
  if (divided != nullptr) std::ranges::copy(divided->blocks, numbers_.begin());
  const auto count = static_cast<std::uint32_t>(divided != nullptr ? divided->dims.size() : numbers_.size());
  const auto dim_of = [&](std::uint32_t number) {
    return divided != nullptr ? divided->dims[number] : structure.dim(number);
  };
  std::uint64_t end = 0;
  bool is_equal = true;
  offset_.push_back(0);
  for (std::uint32_t number = 0; number < count; ++number) {
    end += dim_of(number);
    is_equal = is_equal && dim_of(number) == dim_of(0);
    offset_.push_back(static_cast<PetscInt>(std::min(end, kMost)));
  }
  if (end > kMost)
    throw InvalidArgument("PETSc: expected at most " + std::to_string(kMost) + " scalars, got " +
                          std::to_string(end));
  if (is_equal && count > 0) block_size_ = static_cast<PetscInt>(dim_of(0));
  int size = 1;
  MPI_Comm_rank(communicator, &rank_);
  MPI_Comm_size(communicator, &size);
  if (count > 0 && count < static_cast<unsigned>(size))  // parts of PETSc crash
    throw InvalidArgument(
        "PETSc: expected at least one vertex that is not eliminated for each process, got " +
        std::to_string(count) + " for " + std::to_string(size) + " processes");
  for (int process = 0; process <= size; ++process)
    first_rows_.push_back(static_cast<PetscInt>(std::uint64_t{count} * static_cast<unsigned>(process) /
                                                static_cast<unsigned>(size)));
}

bool Layout::any(const Calls& calls, bool here) const {
  if (processes() == 1) return here;
  int result = here ? 1 : 0;
  calls(MPI_Allreduce(MPI_IN_PLACE, &result, 1, MPI_INT, MPI_MAX, communicator_));
  return result != 0;
}

int Layout::owner(PetscInt number) const {
  return static_cast<int>(std::ranges::upper_bound(first_rows_, number) - first_rows_.begin() - 1);
}

std::vector<PetscInt> Layout::scalars_of_blocks() const {
  std::vector<PetscInt> scalars;
  for (const PetscInt number : numbers_) {
    for (PetscInt i = offset_[number]; i < offset_[number + 1]; ++i) scalars.push_back(i);
  }
  return scalars;
}

std::uint32_t Layout::find_block(PetscInt scalar) const {
  const auto number = static_cast<PetscInt>(std::ranges::upper_bound(offset_, scalar) - offset_.begin() - 1);
  const auto found = std::ranges::lower_bound(numbers_, number);
  if (found == numbers_.end() || *found != number) return BlockStructure::kAbsent;
  return static_cast<std::uint32_t>(found - numbers_.begin());
}

}  // namespace boxplus::petsc
