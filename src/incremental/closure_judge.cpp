// SPDX-License-Identifier: BSD-3-Clause
#include "incremental/closure_judge.h"

#include <algorithm>

#include "boxplus/outliers/outliers.h"
#include "boxplus/robust/default_width.h"

namespace boxplus {

void take_estimates(Graph& graph, const Graph& copy) {
  for (std::uint32_t p = 0; p < graph.vertex_pools().size(); ++p) {
    detail::VertexPool& pool = *graph.vertex_pools()[p];
    std::vector<std::uint32_t> slots;
    for (std::uint32_t slot = 0; slot < pool.slots(); ++slot) {
      if (pool.alive(slot) && !pool.fixed(slot)) slots.push_back(slot);
    }
    pool.copy_estimates(slots, *copy.vertex_pools()[p]);
  }
}

Graph ClosureJudge::copy_without_aside(const Graph& graph) const {
  Graph copy = graph;
  for (const EdgeRef& edge : graph.all_edges()) {
    if (aside_.contains(edge) || !graph.is_enabled(edge)) copy.remove(edge);
  }
  return copy;
}

bool ClosureJudge::is_closure(const Graph& graph, EdgeRef edge) const {
  detail::RelativeFrame relative;
  const bool is_motion = graph.edge_pools()[edge.pool]->relative_frame(edge.slot, relative) &&
                         relative.motion.has_rotation && relative.from != detail::RelativeFrame::kWorld;
  if (!is_motion) return false;
  const std::vector<VertexRef> ends = graph.vertices(edge);
  const Id from = graph.id(ends[0]), to = graph.id(ends[1]);
  const auto next = poses_.upper_bound(std::min(from, to));
  return next != poses_.end() && next->first != std::max(from, to);
}

std::vector<EdgeRef> ClosureJudge::hold_closures(const Graph& graph, const detail::ChangeLog& log) {
  for (const VertexRef& vertex : log.vertices) {
    if (!graph.contains(vertex)) continue;
    const detail::VertexPool& pool = *graph.vertex_pools()[vertex.pool];
    detail::Frame frame;
    if (!pool.parameter(vertex.slot) && pool.get_frame(vertex.slot, frame) && frame.has_rotation)
      poses_[graph.id(vertex)] = vertex;
  }
  const bool loses_vertices = std::any_of(log.vertices.begin(), log.vertices.end(),
                                          [&](VertexRef vertex) { return !graph.contains(vertex); });
  if (loses_vertices) std::erase_if(poses_, [&](const auto& pose) { return !graph.contains(pose.second); });
  std::erase_if(aside_, [&](EdgeRef edge) { return !graph.contains(edge); });
  std::vector<EdgeRef> held;
  for (const EdgeRef& edge : log.edges) {
    aside_.erase(edge);
    const bool takes_part = graph.contains(edge) && graph.is_enabled(edge) && graph.level(edge) == 0;
    if (!takes_part || !is_closure(graph, edge)) continue;
    aside_.insert(edge);
    held.push_back(edge);
  }
  std::sort(held.begin(), held.end());
  held.erase(std::unique(held.begin(), held.end()), held.end());
  return held;
}

bool ClosureJudge::accepts(EdgeRef edge, const EdgePreview& preview, double false_alarm) {
  ++judged_;
  const bool fits = preview.chi2_increase <= noise_scale_ * chi2_quantile(preview.rows, 1 - false_alarm);
  fits ? take_back(edge) : void(++rejected_);
  return fits;
}

bool ClosureJudge::is_search_due(bool finishes) const {
  if (is_new_) return true;
  constexpr double kGrowth = 0.3;
  constexpr std::uint32_t kFewest = 10;
  if (finishes) return judged_ > 0 && (rejected_ > 0 || !aside_.empty());
  return rejected_ > 0 && judged_ >= std::max<double>(kFewest, kGrowth * at_search_);
}

std::vector<EdgeRef> ClosureJudge::search(Graph& graph, double false_alarm, const std::atomic<bool>* stop) {
  Graph copy = graph;
  for (const EdgeRef& edge : aside_) copy.set_enabled(edge, true);
  OutlierOptions options;
  options.options.threads = 1;
  options.options.stop = stop;
  options.false_alarm = false_alarm;
  const OutlierReport found = find_outliers(copy, options);
  std::vector<EdgeRef> changed;
  if (stop != nullptr && stop->load()) return changed;  // it has judged nothing
  at_search_ = static_cast<std::uint32_t>(found.verdicts.size());
  judged_ = rejected_ = 0;
  is_new_ = false;
  noise_scale_ = found.noise_scale;
  for (const EdgeVerdict& verdict : found.verdicts) {
    const bool was_aside = aside_.contains(verdict.edge), is_aside = verdict.weight == 0;
    if (was_aside == is_aside) continue;
    changed.push_back(verdict.edge);
    is_aside ? void(aside_.insert(verdict.edge)) : void(aside_.erase(verdict.edge));
  }
  if (!changed.empty()) take_estimates(graph, copy);
  return changed;
}

}  // namespace boxplus
