// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <string>

#include "boxplus/io/graph_file.h"

namespace boxplus {

/// "1 edge", "3 edges".
inline std::string counted(std::int64_t count, const char* one, const char* many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

/// The note on edges that are kept as lines, because a vertex of theirs has the id −1.
inline std::string unassigned_note(std::int64_t count) {
  return fmt::format("{} with the unassigned vertex -1: kept as {}, but not part of the graph",
                     counted(count, "edge", "edges"), count == 1 ? "it is" : "they are");
}

/// The note on the edges with an indefinite Ω.
inline std::string indefinite_note(const GraphFile& file, ReadOptions::Indefinite policy) {
  const char* treatment = policy == ReadOptions::Indefinite::kAsGiven
                              ? "it was kept as given"
                              : "the nearest positive semi-definite matrix was used";
  return fmt::format("{} of {} with an indefinite information matrix: {}", file.indefinite,
                     counted(static_cast<std::int64_t>(file.edges.size()), "edge", "edges"), treatment);
}

}  // namespace boxplus
