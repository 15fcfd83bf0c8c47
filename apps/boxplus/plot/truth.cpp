// SPDX-License-Identifier: BSD-3-Clause
#include "plot/truth.h"

#include "boxplus/base/error.h"
#include "files/graph_input.h"
#include "files/trajectory_input.h"
#include "trajectory/alignment.h"
#include "trajectory/matching.h"

namespace boxplus::app {

TruePlaces true_places(const Graph& graph, const std::string& name, const std::string& truth,
                       const ReadOptions& reading) {
  const Trajectory places = trajectory_of(read_truth(truth, reading), input_name(truth));
  const std::vector<PosePair> pairs = matched_poses(places, trajectory_of(graph, name), 0).pairs;
  if (pairs.empty())
    throw FileError(input_name(truth) + ": expected poses with the same ids as in " + name + ", found none");
  const Alignment onto_graph = align_poses(pairs, places.dimension, AlignmentKind::kRigid, false);
  TruePlaces result;
  for (const TrajectoryPose& pose : places.poses) {
    const Vector3 place = onto_graph(pose).position;
    result[pose.id] = {place[0], place[1], place[2]};
  }
  return result;
}

}  // namespace boxplus::app
