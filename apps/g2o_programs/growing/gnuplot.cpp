// SPDX-License-Identifier: BSD-3-Clause
#include "growing/gnuplot.h"

#include <fmt/format.h>

#include <iterator>

#include "common/program.h"

namespace boxplus::programs {

std::string gnuplot_commands(const Graph& graph) {
  std::string points;
  bool in_space = false;
  const std::vector<EdgeRef> edges = graph.all_edges();
  for (const EdgeRef& edge : edges) {
    int drawn = 0;
    for (const VertexRef& vertex : graph.vertices(edge)) {
      const detail::VertexPool& pool = *graph.vertex_pools()[vertex.pool];
      detail::Frame frame;
      if (pool.parameter(vertex.slot) || !pool.get_frame(vertex.slot, frame)) continue;
      const auto& [x, y, z] = frame.translation;
      fmt::format_to(std::back_inserter(points), "{:g} {:g} {:g}\n", x, y, frame.dimension == 3 ? z : 0);
      in_space = in_space || frame.dimension == 3;
      ++drawn;
    }
    if (drawn > 0) points += '\n';
  }
  const char* const plot = in_space ? "set view equal xyz\nsplot" : "set size ratio -1\nplot";
  const char* const columns = in_space ? "1:2:3" : "1:2";
  return fmt::format("{} \"-\" using {} with lines title \"{} edges\"\n{}e\n", plot, columns, edges.size(),
                     points);
}

Gnuplot::Gnuplot() : pipe_(::popen("exec gnuplot -persist", "w")) {  // NOLINT(cert-env33-c): a constant
  if (!pipe_) print_message("gnuplot cannot be started");
}

void Gnuplot::draw(const Graph& graph) {
  if (!pipe_) return;
  const std::string text = gnuplot_commands(graph);
  if (std::fwrite(text.data(), 1, text.size(), pipe_.get()) == text.size() && std::fflush(pipe_.get()) == 0)
    return;
  print_message("gnuplot has ended, so nothing is drawn any more");
  pipe_.reset();
}

void Gnuplot::Close::operator()(std::FILE* pipe) const {
  ::pclose(pipe);
}

}  // namespace boxplus::programs
