// SPDX-License-Identifier: BSD-3-Clause
#include "linear/ordering/amd_ordering.h"

#include <amd.h>
#include <camd.h>

#include <array>
#include <string>

#include "base/paced_stop.h"
#include "boxplus/base/error.h"

namespace boxplus {
namespace {

/// An upper estimate of the time that AMD takes. CAMD takes twice as long. The constants were measured on
/// pose graphs in 2 and 3 dimensions with up to 300,000 blocks.
double predicted_seconds(std::size_t blocks, std::size_t entries) {
  constexpr double kPerBlock = 300e-9, kPerEntry = 250e-9;
  return kPerBlock * static_cast<double>(blocks) + kPerEntry * static_cast<double>(entries);
}

/// Throws Stopped if there is not enough time left. Never throws for small structures, because ordering them
/// takes no longer than the work between two checks of a token.
void check_room(const StopToken& stop, double seconds) {
  constexpr double kBetweenQuestions = 100e-6;
  if (seconds > kBetweenQuestions) stop.check_room_for(seconds);
}

}  // namespace

std::vector<int> number_free_blocks(const BlockStructure& structure, std::span<const std::uint32_t> last) {
  std::vector<int> number(structure.blocks(), 0);
  for (const std::uint32_t block : last) {
    if (block >= structure.blocks() || number[block] == kIsLast) {
      throw InvalidArgument("AnalyzeHints::last: expected distinct blocks below " +
                            std::to_string(structure.blocks()) + ", got " + std::to_string(block));
    }
    number[block] = kIsLast;
  }
  int next = 0;
  for (int& n : number) {
    if (n != kIsLast) n = next++;
  }
  return number;
}

std::vector<std::uint32_t> amd_ordering(const BlockStructure& structure, std::span<const std::uint32_t> last,
                                        const StopToken& stop, DenseRows dense_rows) {
  PacedStop pace(stop);
  const std::vector<int> number = number_free_blocks(structure, last);
  std::vector<int> start{0}, row;
  std::vector<std::uint32_t> free_blocks;
  for (std::uint32_t j = 0; j < structure.blocks(); ++j) {
    if (number[j] == kIsLast) continue;
    for (std::uint32_t k = structure.column_start[j] + 1; k < structure.column_start[j + 1]; ++k) {
      pace.step();
      if (number[structure.row[k]] != kIsLast) row.push_back(number[structure.row[k]]);
    }
    start.push_back(static_cast<int>(row.size()));
    free_blocks.push_back(j);
  }
  std::vector<int> permutation(free_blocks.size());
  row.reserve(1);  // AMD needs a non-null pointer
  if (!free_blocks.empty()) {
    check_room(stop, predicted_seconds(free_blocks.size(), row.size()));
    std::array<double, AMD_CONTROL> control{};
    amd_defaults(control.data());
    if (dense_rows == DenseRows::kOrdered) control[AMD_DENSE] = -1;
    const int status = amd_order(static_cast<int>(free_blocks.size()), start.data(), row.data(),
                                 permutation.data(), control.data(), nullptr);
    if (status == AMD_OUT_OF_MEMORY) throw std::bad_alloc();
    if (status < AMD_OK) throw InvalidArgument("amd_ordering: expected sorted columns of distinct rows");
  }
  std::vector<std::uint32_t> order;
  order.reserve(structure.blocks());
  for (const int k : permutation) order.push_back(free_blocks[k]);
  order.insert(order.end(), last.begin(), last.end());
  return order;
}

std::vector<std::uint32_t> constrained_amd_ordering(const BlockStructure& structure, std::span<int> rank_of,
                                                    const StopToken& stop) {
  PacedStop pace(stop);
  std::vector<int> start{0}, row;
  for (std::uint32_t j = 0; j < structure.blocks(); ++j) {
    for (std::uint32_t k = structure.column_start[j] + 1; k < structure.column_start[j + 1]; ++k) {
      pace.step();
      row.push_back(static_cast<int>(structure.row[k]));
    }
    start.push_back(static_cast<int>(row.size()));
  }
  std::vector<int> permutation(structure.blocks());
  row.reserve(1);
  if (structure.blocks() > 0) {
    check_room(stop, 2 * predicted_seconds(structure.blocks(), row.size()));
    const int status = camd_order(static_cast<int>(structure.blocks()), start.data(), row.data(),
                                  permutation.data(), nullptr, nullptr, rank_of.data());
    if (status == CAMD_OUT_OF_MEMORY) throw std::bad_alloc();
    if (status < CAMD_OK)
      throw InvalidArgument("constrained_amd_ordering: expected sorted columns of distinct rows");
  }
  return {permutation.begin(), permutation.end()};
}

}  // namespace boxplus
