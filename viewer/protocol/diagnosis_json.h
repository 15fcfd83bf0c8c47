// SPDX-License-Identifier: BSD-3-Clause
// What diagnose() finds, as JSON (PROTOCOL.md).
#pragma once

#include <cstdint>
#include <string>

#include "boxplus/diagnose/diagnose.h"
#include "viewer/scene/structure.h"

namespace boxplus::viewer {

/// At most kMostFindings findings, each with at most kMostMarked vertices and kMostMarked lines. O(n log n).
/// `left_out` is the number of edges that the diagnosis ignores.
std::string diagnosis_json(const Graph& graph, const Structure& structure, const Diagnosis& diagnosis,
                           std::uint64_t structure_number, std::size_t left_out = 0);

inline constexpr std::size_t kMostFindings = 500, kMostMarked = 10'000;

}  // namespace boxplus::viewer
