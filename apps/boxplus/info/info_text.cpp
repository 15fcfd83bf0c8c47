// SPDX-License-Identifier: BSD-3-Clause
#include "info/info_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "command_line/message.h"
#include "command_line/table.h"
#include "optimize/optimize_report.h"
#include "optimize/outlier_search.h"

namespace boxplus::app {
namespace {

constexpr std::size_t kShownComponents = 10, kShownIds = 6;

std::string list(const std::vector<Id>& ids) {
  const std::vector<Id> shown(ids.begin(),
                              ids.begin() + static_cast<std::ptrdiff_t>(std::min(kShownIds, ids.size())));
  std::string text = fmt::format("{}", fmt::join(shown, ", "));
  if (ids.size() > kShownIds) text += fmt::format(", … ({} in all)", ids.size());
  return text;
}

std::string fact(const char* name, const std::string& text) {
  return fmt::format("  {:<14}{}\n", name, text);
}

std::size_t count_of(const GraphFacts& facts, VertexRole role) {
  std::size_t count = 0;
  for (const VertexTypeFacts& type : facts.vertex_types) {
    if (!type.parameter && type.role == role) count += type.count;
  }
  return count;
}

/// Returns a text such as "1250  (1200 poses, 50 landmarks)". Kinds whose count is 0 are left out.
std::string with_kinds(std::size_t total, const std::vector<std::pair<std::size_t, std::string>>& kinds) {
  std::vector<std::string> parts;
  for (const auto& [count, name] : kinds) {
    if (count > 0) parts.push_back(fmt::format("{} {}", count, name));
  }
  if (parts.empty()) return fmt::format("{}", total);
  return fmt::format("{}  ({})", total, fmt::join(parts, ", "));
}

std::string vertices_text(const GraphFacts& facts) {
  const std::size_t poses = count_of(facts, VertexRole::kPose);
  const std::size_t landmarks = count_of(facts, VertexRole::kLandmark);
  const std::size_t others = count_of(facts, VertexRole::kOther);
  return with_kinds(facts.vertices, {{poses, poses == 1 ? "pose" : "poses"},
                                     {landmarks, landmarks == 1 ? "landmark" : "landmarks"},
                                     {others, others == 1 ? "other" : "others"}});
}

std::string edges_text(const GraphFacts& facts) {
  std::vector<std::pair<std::size_t, std::string>> kinds;
  for (std::size_t k = 0; k < kEdgeRoles; ++k)
    kinds.emplace_back(facts.roles[k], name_of(static_cast<EdgeRole>(k), facts.roles[k]));
  return with_kinds(facts.edges, kinds);
}

std::string data_text(const GraphFacts& facts) {
  std::vector<std::string> parts;
  for (const auto& [tag, count] : facts.data) parts.push_back(fmt::format("{} {}", count, tag));
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string extent_text(const GraphFacts& facts) {
  std::string text;
  for (int axis = 0; axis < facts.dimension; ++axis)
    text += fmt::format("{}{:.4g}", axis == 0 ? "" : " × ", facts.extent[axis]);
  return text + " m";
}

/// Returns chi2, or a ratio of two chi2 values, with `digits` digits. NaN is printed without a sign.
std::string number(double value, int digits) {
  return std::isnan(value) ? "nan" : fmt::format("{:.{}g}", value, digits);
}

std::string chi2_text(const GraphFacts& facts) {
  std::string text = number(facts.chi2, 9);
  if (facts.rows > 0)
    text += fmt::format("  ({} per row of error)", number(facts.chi2 / static_cast<double>(facts.rows), 4));
  return text;
}

std::string summary_text(const GraphFacts& facts) {
  std::string text = fact("vertices", vertices_text(facts));
  if (facts.parameters > 0) text += fact("parameters", fmt::format("{}", facts.parameters));
  text += fact("edges", edges_text(facts));
  if (!facts.data.empty()) text += fact("data", data_text(facts));
  text += fact("unknowns", fmt::format("{}  against {} rows of error", facts.unknowns, facts.rows));
  if (facts.dimension > 0) text += fact("extent", extent_text(facts));
  if (facts.indefinite > 0) {
    text +=
        fact("indefinite", fmt::format("{} of {} information matrices; chi2 is computed with {}",
                                       facts.indefinite, facts.edges,
                                       facts.keeps_indefinite ? "them, and may be negative"
                                                              : "the nearest positive semi-definite ones"));
  }
  text += fact("chi2", chi2_text(facts));
  if (!facts.kernel.name.empty()) {
    text +=
        fact("kernel", fmt::format("{}; at these estimates, it rejects {} of {} edges (weight below {:g})",
                                   kernel_text(facts.kernel, facts.edges), facts.rejected, facts.edges,
                                   Report::kRejectedWeight));
  }
  return text;
}

std::string vertex_types_text(const GraphFacts& facts) {
  if (facts.vertex_types.empty()) return {};
  Table table({"<vertices", "count", "fixed", "unknowns", "degree: min", "mean", "max"});
  for (const VertexTypeFacts& type : facts.vertex_types) {
    table.add({escaped(type.tag), fmt::format("{}", type.count), fmt::format("{}", type.fixed),
               fmt::format("{}", type.unknowns), fmt::format("{}", type.degrees.min),
               fmt::format("{:.2f}", type.degrees.mean), fmt::format("{}", type.degrees.max)});
  }
  return "\n" + table.text();
}

std::string edge_types_text(const GraphFacts& facts) {
  if (facts.edge_types.empty()) return {};
  Table table({"<edges", "count", "rows", "chi2", "chi2/row", "worst chi2", "<worst between"});
  for (const EdgeTypeFacts& type : facts.edge_types) {
    table.add({escaped(type.tag), fmt::format("{}", type.count), fmt::format("{}", type.rows),
               number(type.chi2, 6),
               number(type.chi2 / static_cast<double>(std::max<std::size_t>(type.rows, 1)), 4),
               number(type.worst.chi2, 4), list(type.worst.vertices)});
  }
  return "\n" + table.text();
}

/// Lists edges with their chi2, and with its share of `total` unless that is absent.
std::string edges_table(const std::string& title, const std::vector<EdgeFacts>& edges,
                        std::optional<double> total) {
  if (edges.empty()) return {};
  // A COLMAP model has no lines of edges.
  const bool has_lines =
      std::any_of(edges.begin(), edges.end(), [](const EdgeFacts& edge) { return edge.line > 0; });
  const auto row = [&](std::string edge, std::string chi2, std::string share, std::string line,
                       std::string vertices) {
    std::vector<std::string> cells{std::move(edge), std::move(chi2)};
    if (total) cells.push_back(std::move(share));
    if (has_lines) cells.push_back(std::move(line));
    cells.push_back(std::move(vertices));
    return cells;
  };
  Table table(row("<" + title, "chi2", "share", "line", "<between"));
  for (const EdgeFacts& edge : edges) {
    const double share = total.value_or(0) > 0 ? 100 * edge.chi2 / *total : 0;
    table.add(row(escaped(edge.tag), number(edge.chi2, 6), fmt::format("{:.1f} %", share),
                  edge.line > 0 ? fmt::format("{}", edge.line) : "?", list(edge.vertices)));
  }
  return "\n" + table.text();
}

std::string false_edges_text(const GraphFacts& facts) {
  if (!facts.outliers) return {};
  if (!facts.outliers->found) return fmt::format("\n  outliers: no verdicts: {}\n", facts.outliers->obstacle);
  const OutlierReport& found = *facts.outliers->found;
  std::string text =
      fmt::format("\n  outliers: {}; {} fit\n", verdicts_text(found), found.count(Verdict::kInlier));
  if (!found.note.empty()) text += fmt::format("  note: {}\n", found.note);
  if (!found.report.converged())
    text += fmt::format("  the final run of the search is not converged: {}\n", found.report.message);
  return text + edges_table("worst outliers", facts.outliers->worst, std::nullopt);
}

std::string anchor_text(const ComponentFacts& component) {
  std::vector<std::string> anchors;
  if (!component.fixed.empty()) {
    anchors.push_back(
        fmt::format("fixed vert{} {}", component.fixed.size() == 1 ? "ex" : "ices", list(component.fixed)));
  }
  if (component.priors > 0)
    anchors.push_back(fmt::format("{} prior{}", component.priors, component.priors == 1 ? "" : "s"));
  if (!component.held.empty()) {
    anchors.push_back(fmt::format("{}optimize will hold vertex {}", anchors.empty() ? "nothing; " : "",
                                  list(component.held)));
  }
  if (!component.free.empty()) anchors.push_back(fmt::format("free: {}", component.free));
  return anchors.empty() ? "nothing" : fmt::format("{}", fmt::join(anchors, "; "));
}

std::string components_text(const GraphFacts& facts) {
  std::string text;
  if (!facts.components.empty()) {
    Table table({"<components", "vertices", "edges", "<held in place by"});
    for (std::size_t k = 0; k < std::min(kShownComponents, facts.components.size()); ++k) {
      const ComponentFacts& component = facts.components[k];
      table.add({fmt::format("of vertex {}", component.first), fmt::format("{}", component.vertices),
                 fmt::format("{}", component.edges), anchor_text(component)});
    }
    text = "\n" + table.text();
    if (facts.components.size() > kShownComponents)
      text += fmt::format("  … and {} smaller components\n", facts.components.size() - kShownComponents);
  }
  if (!facts.isolated.empty()) {
    text += fmt::format("\n  without edges: vert{} {}\n", facts.isolated.size() == 1 ? "ex" : "ices",
                        list(facts.isolated));
  }
  return text;
}

std::string diagnosis_text(const GraphFacts& facts) {
  if (!facts.diagnosis) return {};
  if (facts.diagnosis->findings.empty()) return "\n  diagnosis: nothing unusual\n";
  std::string text = "\n  diagnosis\n";
  for (const FindingFacts& facts_of_finding : facts.diagnosis->findings) {
    const Finding& finding = facts_of_finding.finding;
    text += fmt::format("  {}: {} [{}]\n", to_string(finding.severity), escaped(finding.text),
                        to_string(finding.kind));
  }
  return text;
}

}  // namespace

std::string facts_text(const GraphFacts& facts, const std::string& name) {
  return escaped(name) + "\n" + summary_text(facts) + vertex_types_text(facts) + edge_types_text(facts) +
         components_text(facts) + edges_table("worst edges", facts.worst, facts.chi2) +
         false_edges_text(facts) + diagnosis_text(facts);
}

}  // namespace boxplus::app
