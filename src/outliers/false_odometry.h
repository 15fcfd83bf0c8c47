// SPDX-License-Identifier: BSD-3-Clause
// Odometry that may be false, so that it has to be judged as loop closures are.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "boxplus/outliers/outliers.h"
#include "outliers/cycle_test.h"

namespace boxplus::outliers {

/// For each link, whether another link between the same two poses contradicts it.
std::vector<std::uint8_t> contradicting_links(const PoseGraph& poses, const Evidence& evidence, double scale,
                                              double needed);

/// Rejected closures that agree with each other, and all of which lead across one link.
struct Contradiction {
  std::uint32_t to = 0;      ///< the later pose of the link
  std::size_t closures = 0;  ///< how many more closures are rejected than accepted
};

/// The link that most closures contradict, if these are more than a group of false closures has. Among equal
/// ones, the one with the largest error. `verdicts` are those of all closures.
std::optional<Contradiction> most_contradicted_link(const Graph& graph, const PoseGraph& poses,
                                                    const CycleTests& cycles,
                                                    std::span<const EdgeVerdict> verdicts);

/// The number of rejected closures that agree with so many others that they are probably true, if these are
/// more than a group of false closures and 1 % of all closures.
std::size_t rejected_in_large_groups(const CycleTests& cycles, std::span<const EdgeVerdict> verdicts);

/// The later poses of the links whose errors are far above those of most links, and above what noise of this
/// scale explains, with the largest error first, and at most three: accepted closures bend a false link.
std::vector<std::uint32_t> bent_links(const Graph& graph, const PoseGraph& poses, double noise_scale);

}  // namespace boxplus::outliers
