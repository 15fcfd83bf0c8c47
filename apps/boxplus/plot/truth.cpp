// SPDX-License-Identifier: BSD-3-Clause
#include "plot/truth.h"

#include <fmt/format.h>

#include "boxplus/base/error.h"
#include "files/graph_input.h"
#include "files/trajectory_input.h"
#include "trajectory/alignment.h"
#include "trajectory/matching.h"
#include "viewer/scene/bundle_view.h"

namespace boxplus::app {

TruePlaces true_places(const GraphFile& file, const std::string& name, const std::string& truth,
                       const ReadOptions& reading) {
  const bool is_bundle = viewer::is_bundle(file.graph);
  const Trajectory places = trajectory_of(read_truth(truth, reading), input_name(truth));
  const PosePairs matched = matched_poses(places, trajectory_of(file, name), 0);
  if (matched.pairs.empty())
    throw FileError(fmt::format("{}: expected poses that match {} by {}, found none", input_name(truth), name,
                                matched.matched_by));
  const Alignment onto_graph = align_poses(matched.pairs, places.dimension, AlignmentKind::kRigid, is_bundle);
  TruePlaces result;
  const auto add = [&](Id id, const TrajectoryPose& pose) {
    const Vector3 place = onto_graph(pose).position;
    result[id] = {place[0], place[1], place[2]};
  };
  // Without bundle adjustment, the poses are matched by id, and the others of the truth are drawn, too.
  if (is_bundle)
    for (const PosePair& pair : matched.pairs) add(pair.truth.id, pair.result);
  else
    for (const TrajectoryPose& pose : places.poses) add(pose.id, pose);
  return result;
}

}  // namespace boxplus::app
