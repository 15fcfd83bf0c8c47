// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/rejection.h"

#include <fmt/format.h>

#include "optimize/cut_off.h"
#include "optimize/rejected_edges.h"

namespace boxplus {
namespace {

bool rejects_most(const Report::RejectionReport& rejection) {
  return rejection.by_redescending > rejection.redescending / 2;
}

}  // namespace

void find_rejection(Report::RejectionReport& rejection, const Graph& graph, const Plan& plan, int workers) {
  const RejectionCounts counts = count_rejected(graph, plan, workers);
  rejection.is_known = true;
  rejection.edges = counts.rejected;
  rejection.redescending = counts.redescending;
  rejection.by_redescending = counts.by_redescending;
  if (counts.by_redescending == 0) return;
  for (const VertexRef& vertex : find_cut_off(graph, plan, flag_rejected(graph, plan)))
    rejection.cut_off.push_back(graph.id(vertex));
}

bool rejects_too_much(const Report::RejectionReport& rejection) {
  return rejects_most(rejection) || !rejection.cut_off.empty();
}

std::string rejection_text(const Report::RejectionReport& rejection) {
  const std::size_t parts = rejection.cut_off.size();
  std::string text;
  if (rejects_most(rejection)) {
    text = fmt::format("{} of the {} edges with redescending kernels", rejection.by_redescending,
                       rejection.redescending);
  } else if (parts == 1) {
    text = fmt::format("nothing else holds the part with vertex {}", rejection.cut_off.front());
  } else {
    text = fmt::format("nothing else holds {} parts, such as that with vertex {}", parts,
                       rejection.cut_off.front());
  }
  return text +
         "; try another start, a larger width, a kernel that keeps its influence (such as Huber), or no "
         "kernel "
         "on edges without outliers";
}

}  // namespace boxplus
