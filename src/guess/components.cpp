// SPDX-License-Identifier: BSD-3-Clause
#include "guess/components.h"

#include <array>

#include "base/align_points.h"
#include "guess/frame_math.h"

namespace boxplus::guess {
namespace {

constexpr std::uint32_t kRooted = 0xFFFFFFFEu;

/// The guessed and the measured positions of points in a part of the graph.
struct Correspondences {
  int dimension = 0;
  std::vector<double> guessed, measured;

  void add(const SmallVector& guess, const SmallVector& measurement) {
    dimension = static_cast<int>(guess.size());
    guessed.insert(guessed.end(), guess.data(), guess.data() + dimension);
    measured.insert(measured.end(), measurement.data(), measurement.data() + dimension);
  }

  Eigen::Index count() const {
    return dimension > 0 ? static_cast<Eigen::Index>(guessed.size()) / dimension : 0;
  }

  /// The rigid motion that fits the guessed positions to the measured positions best. If there is only one
  /// point, it is a translation.
  detail::Frame alignment() const {
    const Eigen::Map<const Eigen::MatrixXd> from(guessed.data(), dimension, count());
    const Eigen::Map<const Eigen::MatrixXd> to(measured.data(), dimension, count());
    detail::Frame motion = world_frame(dimension);
    if (count() == 1) {
      set_translation(motion, to.col(0) - from.col(0));
    } else {
      const PointAlignment aligned = align_points(from, to, false);
      set_rotation(motion, aligned.rotation);
      set_translation(motion, aligned.translation);
    }
    return motion;
  }
};

}  // namespace

Components::Components(const FrameGraph& frames, const StopToken& stop)
    : frames_(frames), stop_(stop), pace_(stop), label_(frames.nodes(), kNone) {
  for (const Measurement& m : frames.measurements()) {
    pace_.step();
    if (is_root(m)) flood(movable_end(m), kRooted);
  }
  const std::vector<Node> by_id = frames.movable_by_id(stop);
  for (Node node : by_id) {
    if (frames.pose(node)) add_free_root(node);
  }
  // The remaining parts have no poses. For their points, a known position serves as a root.
  for (const Measurement& m : frames.measurements()) {
    if (is_position_anchor(m)) flood(movable_end(m), kRooted);
  }
  for (Node node : by_id) add_free_root(node);
}

void Components::add_free_root(Node node) {
  if (label_[node] != kNone) return;
  flood(node, static_cast<std::uint32_t>(free_roots_.size()));
  free_roots_.push_back(node);
}

/// The movable end of a measurement with one constant end, or kWorld if both ends move.
Node Components::movable_end(const Measurement& m) const {
  if (m.from == FrameGraph::kWorld || !frames_.movable(m.from)) return m.to;
  return frames_.movable(m.to) ? FrameGraph::kWorld : m.from;
}

/// Whether a measurement makes its movable end a root. This is the case if its other end is constant, and if
/// the measurement involves a pose whose rotation determines the orientation.
bool Components::is_root(const Measurement& m) const {
  const Node moving = movable_end(m);
  if (moving == FrameGraph::kWorld) return false;
  if (m.has_rotation) return true;
  return moving == m.to && m.leads_forward && m.from != FrameGraph::kWorld && frames_.pose(m.from);
}

bool Components::is_position_anchor(const Measurement& m) const {
  return movable_end(m) != FrameGraph::kWorld && !is_root(m);
}

bool Components::left_for_alignment(const Measurement& m) const {
  return is_position_anchor(m) && label_[movable_end(m)] < kRooted;
}

void Components::flood(Node start, std::uint32_t label) {
  if (label_[start] != kNone) return;
  label_[start] = label;
  stack_.assign(1, start);
  while (!stack_.empty()) {
    const Node node = stack_.back();
    stack_.pop_back();
    for (std::uint32_t k : frames_.touching(node)) {
      pace_.step();
      const Measurement& m = frames_.measurements()[k];
      const Node other = m.from == node ? m.to : m.from;
      if (other == FrameGraph::kWorld || !frames_.movable(other) || label_[other] != kNone) continue;
      label_[other] = label;
      stack_.push_back(other);
    }
  }
}

void Components::align(FrameGraph& frames) const {
  PacedStop pace(stop_, kBetweenStops);
  std::vector<Correspondences> points(free_roots_.size());
  for (const Measurement& m : frames.measurements()) {
    pace.step();
    if (!left_for_alignment(m)) continue;
    const detail::Frame motion = frames.motion(m);
    const detail::Frame from =
        m.from == FrameGraph::kWorld ? world_frame(motion.dimension) : frames.frame(m.from);
    const SmallVector composed = translation_of(compose(from, motion));
    const SmallVector position = translation_of(frames.frame(m.to));
    const Node moving = movable_end(m);
    if (moving == m.to) {
      points[label_[moving]].add(position, composed);
    } else {
      points[label_[moving]].add(composed, position);
    }
  }
  std::vector<detail::Frame> alignment(points.size());
  bool any = false;
  for (std::size_t c = 0; c < points.size(); ++c) {
    if (points[c].count() == 0) continue;
    alignment[c] = points[c].alignment();
    any |= is_finite(alignment[c]);
  }
  if (!any) return;
  for (Node node = 0; node < frames.nodes(); ++node) {
    pace.step();
    if (label_[node] >= kRooted) continue;
    const detail::Frame& motion = alignment[label_[node]];
    if (motion.dimension > 0 && is_finite(motion))
      frames.set_frame(node, compose(motion, frames.frame(node)));
  }
}

}  // namespace boxplus::guess
