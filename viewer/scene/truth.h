// SPDX-License-Identifier: BSD-3-Clause
// The true estimates of a graph, from another file, and how far the current estimates are from them.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "boxplus/io/graph_file.h"
#include "viewer/scene/structure.h"

namespace boxplus::viewer {

/// The truth beside the current estimates: what `boxplus compare` computes without options.
struct TruthFit {
  /// The motion p ↦ rotation · p + translation that brings the positions of the truth, as TruthPlaces has
  /// them, closest to the positions of a frame. The rotation is row-major.
  std::array<double, 9> rotation{};
  std::array<double, 3> translation{};
  double ate = 0;              ///< rmse of the positions after the alignment, in meters
  double rpe_translation = 0;  ///< rmse of the motions from pose to pose: lengths in meters
  double rpe_rotation = 0;     ///< the same: angles in radians
  std::size_t motions = 0;     ///< the number of these motions; if it is 0, the last two are 0
};

/// x, y, z of the truth of each vertex of a structure, relative to the median of all of them; NaN if the
/// vertex has no truth.
using TruthPlaces = std::vector<float>;

/// How many poses of the graph and of the truth are the same, and how many the graph and the truth have.
struct TruthFacts {
  std::string name;
  std::string matched_by;  ///< PosePairs::matched_by
  std::size_t matched = 0, poses = 0, true_poses = 0;
};

class Truth {
 public:
  /// Takes the estimates of a file. Throws FileError if the file has no estimates or no poses, or as
  /// trajectory_of() does.
  Truth(const GraphFile& file, std::string name);
  ~Truth();
  Truth(Truth&&) noexcept;
  Truth& operator=(Truth&&) noexcept;

  /// Finds the vertices of a graph that have a truth: poses as matched_poses() does, all others by id. Throws
  /// FileError if no pose has one, if one has its poses in the plane and the other one in space, or if
  /// matched_poses() refuses them. Messages call the graph `name`. `file` is the file of the graph, or
  /// nullptr. Call it once, before all that follows.
  void match(const Graph& graph, const GraphFile* file, const std::string& name);
  const TruthFacts& facts() const { return facts_; }

  /// Call it when the structure is new. The graph may have lost vertices. O(n) in the vertices.
  TruthPlaces place(const Graph& graph, const Structure& structure);
  /// Compares the current estimates with the truth. Returns nothing if no matched pose is left, or if one is
  /// not finite or very far away. O(n) in the poses.
  std::optional<TruthFit> fit(const Graph& graph, const Structure& structure) const;

 private:
  struct Poses;

  TruthFacts facts_;
  std::unique_ptr<Poses> poses_;
};

/// Reads the truth from the text of a file. Throws InputError if it is malformed, and FileError as the
/// constructor of Truth does or if it is a TUM file.
Truth parse_truth(const std::string& name, const std::string& text);

}  // namespace boxplus::viewer
