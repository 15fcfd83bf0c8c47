// SPDX-License-Identifier: BSD-3-Clause
#include "linear/column_inverse.h"

#include <algorithm>
#include <string>

#include "boxplus/base/error.h"

namespace boxplus {

std::vector<InverseRequest> list_requests(const BlockStructure& structure,
                                          std::span<const BlockCoordinate> blocks, double* out) {
  std::vector<InverseRequest> requests;
  requests.reserve(blocks.size());
  for (const BlockCoordinate block : blocks) {
    if (block.row >= structure.blocks() || block.column > block.row) {
      throw InvalidArgument("selected_inverse: expected column ≤ row < " +
                            std::to_string(structure.blocks()) + ", got row " + std::to_string(block.row) +
                            ", column " + std::to_string(block.column));
    }
    requests.push_back({block, out});
    out += std::size_t{structure.dim(block.row)} * structure.dim(block.column);
  }
  return requests;
}

bool solve_for_inverse(LinearSolver& solver, const BlockStructure& structure,
                       std::span<InverseRequest> requests, const StopToken& stop) {
  std::sort(requests.begin(), requests.end(),
            [](const InverseRequest& a, const InverseRequest& b) { return a.block.column < b.block.column; });
  const SolveControl control{.stop = stop};
  std::vector<double> x(structure.scalars());
  for (std::size_t begin = 0; begin < requests.size();) {
    const std::uint32_t column = requests[begin].block.column;
    std::size_t end = begin;
    while (end < requests.size() && requests[end].block.column == column) ++end;
    for (std::uint32_t j = 0; j < structure.dim(column); ++j) {
      std::fill(x.begin(), x.end(), 0.0);
      x[structure.offset[column] + j] = 1;
      if (solver.solve(x.data(), 1, x.data(), control).status != LinearStatus::kOk) return false;
      for (const InverseRequest& request : requests.subspan(begin, end - begin)) {
        const std::uint32_t rows = structure.dim(request.block.row);
        std::copy_n(x.data() + structure.offset[request.block.row], rows,
                    request.out + std::size_t{j} * rows);
      }
    }
    begin = end;
  }
  return true;
}

}  // namespace boxplus
