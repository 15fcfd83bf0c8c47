// SPDX-License-Identifier: BSD-3-Clause
// The joint chordal guess.
//
// If rotations are relaxed to arbitrary d × d matrices, the measurements are linear in the unknowns:
//   R_j = R_i R_ij,   t_j − t_i = R_i t_ij,   l − t_i = R_i z.
// Each scalar equation contains only row a of the R_i and coordinate a of the t_i, for a single axis a of the
// world. So the problem separates into d problems with the same matrix, one per axis. With X_i = [R_iᵀ;
// t_iᵀ], whose column a holds the unknowns of axis a, the equations are
//   pose → pose      X_j = M X_i,                 M = [R_ijᵀ 0; t_ijᵀ 1]
//   pose → position  [0 1] X_j = [t_ijᵀ 1] X_i    (l = [zᵀ 1] X_i for a point)
// The X of a constant frame or of the world is known. A measurement z between points k and l gives l − k = z.
//
// Weights. Let ω be the information per squared radian. A rotation error by a small angle θ adds ω θ² to
// chi2, and adds ‖R_i R_ij − R_j‖² ≈ 2θ² to the relaxed equation. So the right weight of rotation rows is
// ω/2. ω is the mean over the axes, because the axes of the world separate only if ω is a scalar. The weight
// of translation rows is the mean information of the translation. But relaxed rotations shrink with their
// distance from the known frames. Measured lengths do not shrink, so they distort the rotations. Therefore,
// rotation rows get kRotationEmphasis times more weight. Factors from 0.1 to 10⁴ were tried on public pose
// graphs and landmark maps. On each of them, the factor 10 gave a lower chi2 than 1. Larger factors are
// better for graphs without landmarks, but worse for graphs with landmarks.
#include <algorithm>
#include <atomic>
#include <utility>

#include "boxplus/base/parallel.h"
#include "guess/components.h"
#include "guess/initial_guess.h"
#include "guess/nearest_rotation.h"
#include "guess/restore.h"
#include "guess/separable_least_squares.h"

namespace boxplus {
namespace {

using namespace guess;

constexpr double kRotationEmphasis = 10;

/// [Rᵀ; tᵀ] of a pose, or tᵀ of a point.
SmallMatrix stacked(const detail::Frame& frame) {
  const int d = frame.dimension, rows = frame.has_rotation ? d + 1 : 1;
  SmallMatrix x(rows, d);
  if (frame.has_rotation) x.topRows(d) = rotation_of(frame).transpose();
  x.row(rows - 1) = translation_of(frame).transpose();
  return x;
}

/// Computes the guess for all vertices of one dimension d.
class Chordal {
 public:
  Chordal(const FrameGraph& frames, const Plan& plan, const Components& components, int d,
          const GuessLimits& limits);

  /// Computes all frames without moving a vertex.
  LinearStatus solve();
  void move_vertices(FrameGraph& frames) const;
  /// Whether some vertices were not measured in all directions, and kept their estimates in the directions
  /// that were not measured.
  bool anchored() const { return anchored_; }

 private:
  static constexpr std::uint32_t kConstant = SeparableLeastSquares::kConstant;

  LinearStatus solve_joint();
  LinearStatus solve_positions();
  SeparableLeastSquares make_system(std::vector<std::uint32_t> dims) const;
  LinearStatus solve_or_anchor(SeparableLeastSquares& system, bool positions_only);
  void add_joint_term(const Measurement& m, SeparableLeastSquares& system) const;
  void add_position_term(const Measurement& m, SeparableLeastSquares& system) const;
  std::uint32_t block(Node node) const { return node == FrameGraph::kWorld ? kConstant : block_[node]; }
  detail::Frame frame(Node node) const;
  template <class F>
  LinearStatus for_each(std::size_t count, F&& work) const;
  template <class F>
  LinearStatus for_each_in_parallel(std::size_t count, F&& work) const;

  const FrameGraph& frames_;
  const GuessLimits& limits_;
  std::vector<std::uint32_t> order_;  // the elimination order of the blocks; empty if the solver finds one
  int d_;
  std::vector<const Measurement*> measurements_;
  std::vector<std::uint32_t> block_;  // the block of each node, or kConstant
  std::vector<Node> unknowns_;        // the node of each block
  std::vector<detail::Frame> found_;  // the frame of each block
  bool anchored_ = false;
};

Chordal::Chordal(const FrameGraph& frames, const Plan& plan, const Components& components, int d,
                 const GuessLimits& limits)
    : frames_(frames), limits_(limits), d_(d), block_(frames.nodes(), kConstant) {
  PacedStop pace(limits.stop);
  for (const Measurement& m : frames.measurements()) {
    pace.step();
    if (frames.dimension(m.to) == d && !components.left_for_alignment(m)) measurements_.push_back(&m);
  }
  std::vector<bool> known(frames.nodes());
  for (Node root : components.free_roots()) known[root] = true;
  for (Node node = 0; node < frames.nodes(); ++node) {
    pace.step(4);
    if (!frames.used(node) || !frames.movable(node) || frames.dimension(node) != d || known[node]) continue;
    block_[node] = static_cast<std::uint32_t>(unknowns_.size());
    unknowns_.push_back(node);
    found_.push_back(frames.frame(node));
  }
  for (const std::uint32_t block : limits.order) {
    pace.step();
    const VertexRef& vertex = plan.block_vertex[block];
    const std::uint32_t mine = block_[frames.node(vertex.pool, vertex.slot)];
    if (mine != kConstant) order_.push_back(mine);
  }
  if (order_.size() != unknowns_.size()) order_.clear();
}

detail::Frame Chordal::frame(Node node) const {
  if (node == FrameGraph::kWorld) return world_frame(d_);
  return block_[node] == kConstant ? frames_.frame(node) : found_[block_[node]];
}

/// Calls work(0), work(1), …. Returns kStopped if the token is raised.
template <class F>
LinearStatus Chordal::for_each(std::size_t count, F&& work) const {
  PacedStop pace(limits_.stop, kBetweenStops);
  for (std::size_t k = 0; k < count; ++k) {
    if (pace.is_raised_after()) return LinearStatus::kStopped;
    work(k);
  }
  return LinearStatus::kOk;
}

/// Like for_each(), but uses all threads and calls work() in any order.
template <class F>
LinearStatus Chordal::for_each_in_parallel(std::size_t count, F&& work) const {
  constexpr std::size_t kMinPerThread = 500;
  const std::size_t most = static_cast<std::size_t>(std::max(1, limits_.threads));
  const std::size_t parts = std::clamp<std::size_t>(count / kMinPerThread, 1, most);
  std::atomic<bool> stopped = false;
  detail::parallel_tasks(static_cast<int>(parts), [&](int part) {
    const std::size_t p = static_cast<std::size_t>(part), begin = count * p / parts;
    const auto status = for_each(count * (p + 1) / parts - begin, [&](std::size_t k) { work(begin + k); });
    if (status != LinearStatus::kOk) stopped = true;
  });
  return stopped ? LinearStatus::kStopped : LinearStatus::kOk;
}

LinearStatus Chordal::solve() {
  const LinearStatus status = solve_joint();
  return status == LinearStatus::kOk ? solve_positions() : status;
}

SeparableLeastSquares Chordal::make_system(std::vector<std::uint32_t> dims) const {
  SeparableLeastSquares system(std::move(dims), d_);
  PacedStop pace(limits_.stop);
  for (const Measurement* m : measurements_) {
    pace.step();
    system.join(block(m->from), block(m->to));
  }
  system.finish_structure(limits_.stop);
  return system;
}

/// Solves the system. If an unknown is not measured in all directions (such as a pose that sees only one
/// landmark), ties all unknowns to their estimates, as weakly as rounding permits. Then only the measured
/// directions change noticeably.
LinearStatus Chordal::solve_or_anchor(SeparableLeastSquares& system, bool positions_only) {
  constexpr double kAnchor = 1e-9;  // the weight of the ties, relative to the largest entry of the matrix
  const LinearStatus status = system.solve(limits_, order_);
  if (status != LinearStatus::kNotPositiveDefinite) return status;
  anchored_ = true;
  const double weight = kAnchor * system.largest_diagonal();
  for (std::uint32_t k = 0; k < unknowns_.size(); ++k) {
    const SmallMatrix x = stacked(found_[k]);
    const Eigen::Index rows = positions_only ? 1 : x.rows();
    system.add(k, SmallMatrix::Identity(rows, rows), kConstant, SmallMatrix(), x.bottomRows(rows),
               SmallVector::Constant(rows, weight));
  }
  return system.solve(limits_, order_);
}

LinearStatus Chordal::solve_joint() {
  std::vector<std::uint32_t> dims;
  for (Node node : unknowns_) dims.push_back(frames_.pose(node) ? static_cast<std::uint32_t>(d_) + 1 : 1);
  SeparableLeastSquares system = make_system(std::move(dims));
  LinearStatus status =
      for_each(measurements_.size(), [&](std::size_t k) { add_joint_term(*measurements_[k], system); });
  if (status == LinearStatus::kOk) status = solve_or_anchor(system, false);
  if (status != LinearStatus::kOk) return status;
  return for_each_in_parallel(unknowns_.size(), [&](std::size_t k) {
    if (!frames_.pose(unknowns_[k])) return;
    const SmallMatrix relaxed = system.block(static_cast<std::uint32_t>(k)).topRows(d_).transpose();
    if (const auto rotation = nearest_rotation(relaxed)) set_rotation(found_[k], *rotation);
  });
}

/// Adds ‖ A X_to − B X_from ‖²_W. If X_to or X_from is known, moves its term to the right-hand side.
void Chordal::add_joint_term(const Measurement& m, SeparableLeastSquares& system) const {
  const detail::Frame motion = frames_.motion(m);
  const int rows = m.has_rotation ? d_ + 1 : 1;
  if (m.from != FrameGraph::kWorld && !frames_.pose(m.from)) return add_position_term(m, system);
  SmallMatrix b = SmallMatrix::Zero(rows, d_ + 1);
  if (m.has_rotation) b.topLeftCorner(d_, d_) = rotation_of(motion).transpose();
  b.bottomLeftCorner(1, d_) = translation_of(motion).transpose();
  b(rows - 1, d_) = 1;
  const int to_dim = frames_.pose(m.to) ? d_ + 1 : 1;
  const SmallMatrix a = SmallMatrix::Identity(to_dim, to_dim).bottomRows(rows);
  SmallVector weight = SmallVector::Constant(rows, kRotationEmphasis * m.rotation_weight / 2);
  weight[rows - 1] = m.translation_weight;
  SmallMatrix c = SmallMatrix::Zero(rows, d_);
  if (block(m.from) == kConstant) c += b * stacked(frame(m.from));
  if (block(m.to) == kConstant) c -= a * stacked(frame(m.to));
  system.add(block(m.to), a, block(m.from), b, c, weight);
}

/// Solves t_j − t_i = R_i t_ij for the positions again, with the projected rotations. This is necessary
/// because the positions from solve_joint() shrink with the distance from the known frames, as relaxed
/// rotations do. On public graphs, the second solution lowers chi2 by a factor of 2 to 3000. Its matrix is a
/// part of the joint matrix, so it is positive definite, too.
LinearStatus Chordal::solve_positions() {
  SeparableLeastSquares system = make_system(std::vector<std::uint32_t>(unknowns_.size(), 1));
  LinearStatus status =
      for_each(measurements_.size(), [&](std::size_t k) { add_position_term(*measurements_[k], system); });
  if (status == LinearStatus::kOk) status = solve_or_anchor(system, true);
  if (status != LinearStatus::kOk) return status;
  return for_each(unknowns_.size(), [&](std::size_t k) {
    set_translation(found_[k], system.block(static_cast<std::uint32_t>(k)).transpose());
  });
}

void Chordal::add_position_term(const Measurement& m, SeparableLeastSquares& system) const {
  const detail::Frame from = frame(m.from);
  const SmallMatrix one = SmallMatrix::Identity(1, 1);
  SmallMatrix c = (rotation_of(from) * translation_of(frames_.motion(m))).transpose();
  if (block(m.from) == kConstant) c += translation_of(from).transpose();
  if (block(m.to) == kConstant) c -= translation_of(frame(m.to)).transpose();
  system.add(block(m.to), one, block(m.from), one, c, SmallVector::Constant(1, m.translation_weight));
}

void Chordal::move_vertices(FrameGraph& frames) const {
  PacedStop pace(limits_.stop, kBetweenStops);
  for (std::uint32_t k = 0; k < unknowns_.size(); ++k) {
    pace.step();
    frames.set_frame(unknowns_[k], found_[k]);
  }
}

std::string_view why_not_solved(LinearStatus status) {
  switch (status) {
    case LinearStatus::kStopped:
      return kStopped;
    case LinearStatus::kNotFinite:
      return kNotFinite;
    case LinearStatus::kNotConverged:
      return kNotSolved;
    default:
      return kSingular;
  }
}

/// Makes the guess, and moves the vertices. If it throws Stopped, some vertices may have moved.
GuessResult find_chordal(Graph& graph, const Plan& plan, const GuessLimits& limits) {
  FrameGraph frames(graph, plan, limits.stop);
  if (frames.measurements().empty()) return {false, kNothingMeasured};
  const Components components(frames, limits.stop);
  Chordal plane(frames, plan, components, 2, limits), space(frames, plan, components, 3, limits);
  for (Chordal* part : {&plane, &space}) {
    const LinearStatus status = part->solve();
    if (status != LinearStatus::kOk) return {false, why_not_solved(status)};
  }
  plane.move_vertices(frames);
  space.move_vertices(frames);
  components.align(frames);
  return {true, plane.anchored() || space.anchored() ? kAnchored : std::string_view()};
}

}  // namespace

GuessResult guess_chordal(Graph& graph, const Plan& plan, const GuessLimits& limits) {
  return guess_or_restore(graph, plan, [&] { return find_chordal(graph, plan, limits); });
}

}  // namespace boxplus
