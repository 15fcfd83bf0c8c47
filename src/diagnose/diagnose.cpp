// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/diagnose/diagnose.h"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>

#include "diagnose/camera_views.h"
#include "diagnose/evidence.h"
#include "diagnose/finding_table.h"
#include "diagnose/sentences.h"

namespace boxplus {

std::string_view detail::to_string(Finding::Severity severity) {
  switch (severity) {
    case Finding::Severity::kError:
      return "error";
    case Finding::Severity::kWarning:
      return "warning";
    default:
      return "note";
  }
}

bool Diagnosis::ok() const {
  return count(Finding::Severity::kNote) == findings.size();
}

std::size_t Diagnosis::count(Finding::Severity severity) const {
  return static_cast<std::size_t>(
      std::count_if(findings.begin(), findings.end(),
                    [severity](const Finding& finding) { return finding.severity == severity; }));
}

Diagnosis diagnose(const Graph& graph, const Options& options) {
  const StopToken stop(options.stop, StopToken::Clock::now(), options.time_limit_s);
  Diagnosis diagnosis;
  std::vector<Finding>& findings = diagnosis.findings;
  try {
    Evidence evidence(graph, options, stop);
    evidence.cameras = find_camera_views(evidence);
    diagnosis.at_minimum = evidence.at_minimum();
    for (const FindingEntry& entry : finding_table()) {
      stop.check();
      const std::size_t first = findings.size();
      entry.find(evidence, findings);
      for (std::size_t k = first; k < findings.size(); ++k) findings[k].kind = entry.kind;
    }
  } catch (const Stopped&) {
    diagnosis.is_complete = false;
  }
  for (Finding& finding : findings) {
    std::sort(finding.edges.begin(), finding.edges.end());
    finding.ids.reserve(finding.vertices.size());
    for (const VertexRef& vertex : finding.vertices)
      finding.ids.push_back(graph.vertex_pools()[vertex.pool]->id(vertex.slot));
  }
  std::stable_sort(findings.begin(), findings.end(),
                   [](const Finding& a, const Finding& b) { return a.severity > b.severity; });
  return diagnosis;
}

std::string to_string(const Diagnosis& diagnosis) {
  std::string text;
  for (const Finding& finding : diagnosis.findings)
    text += fmt::format("{}: {} [{}]\n", to_string(finding.severity), finding.text, to_string(finding.kind));
  if (!diagnosis.is_complete) text += "the diagnosis was stopped before its end\n";
  return text;
}

std::ostream& operator<<(std::ostream& out, const Diagnosis& diagnosis) {
  return out << to_string(diagnosis);
}

}  // namespace boxplus
