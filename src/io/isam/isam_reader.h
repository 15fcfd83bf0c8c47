// SPDX-License-Identifier: BSD-3-Clause
// The measurements of an iSAM file, before the ids of landmarks are known.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <variant>
#include <vector>

#include "boxplus/graph/handle.h"
#include "boxplus/graph/information.h"
#include "boxplus/io/graph_file.h"
#include "boxplus/io/text_source.h"
#include "boxplus/manifold/se2.h"
#include "boxplus/manifold/se3.h"

namespace boxplus {

struct IsamMeasurements {
  /// A relative pose in the plane or in space, or a point as seen from the first pose.
  using Value = std::variant<SE2, SE3, Vector2, Vector3>;
  struct One {
    Id from = 0;  ///< of a pose
    Id to = 0;    ///< of a pose or, if the value is a point, of a landmark
    Value value;
    Information information;
  };
  std::vector<One> all;
  /// Per pose (landmark) of the file: the index of its type in Value.
  using Types = std::unordered_map<Id, std::size_t>;
  Types poses, landmarks;
};

/// The largest id that a file may have, so that landmarks can have other ids than poses.
inline constexpr Id kLargestIsamId = 1'000'000'000'000'000;

/// Counts the lines in `file`, and adds notes. Throws InputError for a malformed line, unless the reading is
/// lenient: for an id that is negative or above kLargestIsamId, the same pose twice in a line, a pose
/// (landmark) that is in the plane in one line and in space in another, and an R whose Ω is zero or not
/// finite.
IsamMeasurements read_isam(const TextSource& text, const ReadOptions& options, GraphFile& file);

}  // namespace boxplus
