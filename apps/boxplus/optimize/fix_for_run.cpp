// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/fix_for_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "boxplus/base/error.h"

namespace boxplus::app {
namespace {

void hold_all(Graph& graph, const std::vector<BundlePart>& parts, bool held) {
  for (const BundlePart part : parts) {
    if (hold(graph, part, held) == 0)
      throw InvalidArgument(fmt::format("{}: expected a graph of bundle adjustment with {}, got another one",
                                        held ? "--hold" : "--free", to_string(part)));
  }
}

}  // namespace

FixForRun::FixForRun(Graph& graph, const OptimizeArguments& arguments) : graph_(graph) {
  const std::vector<VertexRef> fixed = find_vertices(graph, arguments.fixed, "--fix");
  if (fixed.empty() && arguments.held.empty() && arguments.freed.empty()) return;
  for (const auto& vertices : {graph.all_parameters(), graph.all_vertices()}) {
    for (const VertexRef& vertex : vertices) {
      const std::span<const int> directions = graph.fixed_directions(vertex);
      before_.push_back({vertex, graph.is_fixed(vertex), {directions.begin(), directions.end()}});
    }
  }
  for (const BundlePart part : arguments.held) {
    if (std::ranges::count(arguments.freed, part) > 0)
      throw InvalidArgument(
          fmt::format("--hold and --free: expected different parts, got {} in both", to_string(part)));
  }
  try {
    hold_all(graph, arguments.freed, false);
    hold_all(graph, arguments.held, true);
  } catch (...) {
    restore();
    throw;
  }
  for (const VertexRef& vertex : fixed) graph.fix(vertex);
}

void FixForRun::restore() {
  for (const Before& before : before_) {
    graph_.set_fixed(before.vertex, before.is_fixed);
    graph_.fix_directions(before.vertex, before.directions);
  }
}

}  // namespace boxplus::app
