// SPDX-License-Identifier: BSD-3-Clause
#include "certify/chordal_problem.h"

#include "boxplus/base/error.h"
#include "guess/frame_math.h"
#include "guess/nearest_rotation.h"

namespace boxplus::certificate {
namespace {

detail::Frame frame_of(const Graph& graph, const VertexRef& vertex) {
  detail::Frame frame;
  graph.vertex_pools()[vertex.pool]->get_frame(vertex.slot, frame);
  return frame;
}

}  // namespace

StackedPose difference(const ChordalEdge& edge, const StackedPoses& poses) {
  return poses[edge.to] - edge.motion.lazyProduct(poses[edge.from]);
}

double ChordalProblem::cost(const StackedPoses& poses) const {
  double sum = 0;
  for (const ChordalEdge& edge : edges) {
    const StackedPose d = difference(edge, poses);
    sum += d.cwiseProduct(edge.weight.lazyProduct(d)).sum();
  }
  return sum;
}

StackedPoses ChordalProblem::gradient(const StackedPoses& poses) const {
  StackedPoses result(poses.size(), StackedPose::Zero(dimension + 1, poses.front().cols()));
  for (const ChordalEdge& edge : edges) {
    const StackedPose weighted = edge.weight.lazyProduct(difference(edge, poses));
    result[edge.to] += weighted;
    result[edge.from] -= edge.motion.transpose().lazyProduct(weighted);
  }
  return result;
}

namespace {

/// The estimates in the frame of the graph.
StackedPoses absolute_poses(const Graph& graph, const ChordalProblem& problem) {
  const int d = problem.dimension;
  StackedPoses poses;
  poses.reserve(problem.vertices.size());
  for (const VertexRef& vertex : problem.vertices) {
    const detail::Frame frame = frame_of(graph, vertex);
    const guess::SmallMatrix rotation = guess::rotation_of(frame);
    StackedPose pose(d + 1, d);
    pose.topRows(d) = guess::nearest_rotation(rotation).value_or(rotation).transpose();
    pose.row(d) = guess::translation_of(frame).transpose();
    poses.push_back(pose);
  }
  return poses;
}

}  // namespace

StackedPoses read_poses(const Graph& graph, const ChordalProblem& problem) {
  const int d = problem.dimension;
  const StackedPoses absolute = absolute_poses(graph, problem);
  StackedPoses poses = absolute;
  for (std::size_t node = 0; node < poses.size(); ++node) {
    const StackedPose& pin = absolute[problem.pin[node]];
    poses[node].row(d) -= pin.row(d);
    poses[node] *= pin.topRows(d).transpose().eval();
    if (problem.pin[node] == node) poses[node] = StackedPose::Identity(d + 1, d);
  }
  return poses;
}

StackedPoses round_poses(const StackedPoses& poses, const ChordalProblem& problem) {
  const int d = problem.dimension;
  StackedPoses result;
  result.reserve(poses.size());
  for (const StackedPose& pose : poses) {
    StackedPose rounded = pose.leftCols(d);
    const guess::SmallMatrix relaxed = rounded.topRows(d);
    rounded.topRows(d) = guess::nearest_rotation(relaxed).value_or(guess::SmallMatrix::Identity(d, d));
    result.push_back(rounded);
  }
  return result;
}

void write_poses(const StackedPoses& poses, const ChordalProblem& problem, Graph& graph) {
  const int d = problem.dimension;
  StackedPoses rounded = round_poses(poses, problem);
  const StackedPoses absolute = absolute_poses(graph, problem);
  for (const std::uint32_t node : problem.moving) {
    const StackedPose& pin = absolute[problem.pin[node]];
    rounded[node] *= pin.topRows(d);
    rounded[node].row(d) += pin.row(d);
    const VertexRef& vertex = problem.vertices[node];
    detail::Frame frame = frame_of(graph, vertex);
    guess::set_rotation(frame, rounded[node].topRows(d).transpose());
    guess::set_translation(frame, rounded[node].row(d).transpose());
    graph.vertex_pools()[vertex.pool]->set_frame(vertex.slot, frame);
  }
}

}  // namespace boxplus::certificate
