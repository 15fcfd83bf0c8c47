// SPDX-License-Identifier: BSD-3-Clause
#include "guess/propagate.h"

#include <limits>
#include <queue>

#include "guess/frame_math.h"

namespace boxplus::guess {
namespace {

class ShortestPaths {
 public:
  ShortestPaths(FrameGraph& frames, std::span<const double> cost, const StopToken& stop)
      : frames_(frames),
        stop_(stop),
        pace_(stop, kBetweenStops),
        components_(frames, stop),
        cost_(cost),
        distance_(frames.nodes(), std::numeric_limits<double>::infinity()),
        arrival_(frames.nodes(), kNone) {}

  void run() {
    relax_neighbors(FrameGraph::kWorld, 0);
    for (Node node = 0; node < frames_.nodes(); ++node) {
      if (frames_.used(node) && !frames_.movable(node)) start_at(node);
    }
    for (Node root : components_.free_roots()) start_at(root);
    settle_all();
    for (Node node : frames_.movable_by_id(stop_)) {  // poses that only landmarks connect to a root
      if (distance_[node] < std::numeric_limits<double>::infinity()) continue;
      start_at(node);
      settle_all();
    }
    components_.align(frames_);
  }

 private:
  static constexpr std::uint32_t kNone = 0xFFFFFFFFu;
  struct Entry {
    double distance;
    Node node;
    bool operator>(const Entry& other) const {
      return distance != other.distance ? distance > other.distance : node > other.node;
    }
  };

  void start_at(Node root) {
    distance_[root] = 0;
    relax_neighbors(root, 0);
  }

  void settle_all() {
    while (!queue_.empty()) {
      const auto [distance, node] = queue_.top();
      queue_.pop();
      pace_.step();
      if (distance > distance_[node]) continue;
      set_from_arrival(node);
      relax_neighbors(node, distance);
    }
  }

  void relax_neighbors(Node node, double distance) {
    for (std::uint32_t k : frames_.touching(node)) {
      const Measurement& m = frames_.measurements()[k];
      const bool forward = m.from == node;
      const Node other = forward ? m.to : m.from;
      const bool leads_there =
          (forward ? m.leads_forward : m.leads_backward) && !components_.left_for_alignment(m);
      if (!leads_there || other == FrameGraph::kWorld || !frames_.movable(other)) continue;
      const double through = distance + cost_[k];
      if (!(through < distance_[other])) continue;
      distance_[other] = through;
      arrival_[other] = k;
      queue_.push({through, other});
    }
  }

  void set_from_arrival(Node node) {
    const Measurement& m = frames_.measurements()[arrival_[node]];
    const detail::Frame motion = frames_.motion(m);
    if (m.to == node) {
      const detail::Frame from =
          m.from == FrameGraph::kWorld ? world_frame(motion.dimension) : frames_.frame(m.from);
      frames_.set_frame(node, compose(from, motion));
    } else {
      frames_.set_frame(node, compose_with_inverse(frames_.frame(m.to), motion));
    }
  }

  FrameGraph& frames_;
  const StopToken& stop_;
  PacedStop pace_;
  Components components_;
  std::span<const double> cost_;
  std::vector<double> distance_;
  std::vector<std::uint32_t> arrival_;  // the measurement through which the shortest path reaches each node
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
};

}  // namespace

void propagate(FrameGraph& frames, std::span<const double> cost, const StopToken& stop) {
  ShortestPaths(frames, cost, stop).run();
}

}  // namespace boxplus::guess
