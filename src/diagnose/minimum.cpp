// SPDX-License-Identifier: BSD-3-Clause
// Findings about chi2: whether it is at a minimum and, if so, outliers and the size of chi2.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "boxplus/robust/default_width.h"
#include "diagnose/evidence.h"
#include "diagnose/finding_table.h"
#include "diagnose/sentences.h"

namespace boxplus {
namespace {

/// The largest e² that noise explains, for errors of `rows` rows. `typical` is the median of e² over the
/// edges of the type. If it is larger than for a right Ω, Ω is too large, and the limit grows in proportion.
double limit_of(int rows, double typical) {
  constexpr double kProbable = 1 - 1e-9, kWild = 10;
  const double scale = typical / chi2_quantile(rows, 0.5);
  return kWild * std::max(1.0, scale) * chi2_quantile(rows, kProbable);
}

double median_of_positive(std::vector<double> values) {
  std::erase_if(values, [](double value) { return !(value > 0); });
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// An edge and its e².
struct Outlier {
  EdgeRef edge;
  double chi2 = 0;
};

std::vector<Outlier> outliers_of(const Evidence& evidence, const PoolEvidence& edges, double& limit) {
  const detail::EdgePool& pool = *evidence.graph.edge_pools()[edges.pool];
  std::map<int, std::vector<double>> chi2_by_rows;
  for (std::size_t k = 0; k < edges.edges.size(); ++k)
    chi2_by_rows[pool.shape(edges.edges[k]).rows].push_back(edges.chi2[k]);
  std::map<int, double> limit_by_rows;
  for (auto& [rows, chi2] : chi2_by_rows) {
    if (rows > 0) limit_by_rows[rows] = limit_of(rows, median_of_positive(std::move(chi2)));
  }
  std::vector<Outlier> result;
  for (std::size_t k = 0; k < edges.edges.size(); ++k) {
    const auto found = limit_by_rows.find(pool.shape(edges.edges[k]).rows);
    if (found == limit_by_rows.end() || !(edges.chi2[k] > found->second)) continue;
    result.push_back({evidence.edge_ref(edges.pool, edges.edges[k]), edges.chi2[k]});
    limit = found->second;
  }
  return result;
}

/// Rows minus unknowns that the edges determine, as Report::degrees_of_freedom.
std::int64_t degrees_of_freedom(const Evidence& evidence) {
  auto degrees = static_cast<std::int64_t>(evidence.rows);
  for (const VertexRef& vertex : evidence.active.block_vertex) {
    const detail::VertexPool& pool = *evidence.graph.vertex_pools()[vertex.pool];
    degrees -= pool.tangent_dim(vertex.slot);
    degrees += static_cast<std::int64_t>(pool.fixed_directions(vertex.slot).size());
  }
  for (const detail::GaugeFreedom& freedom : evidence.active.gauge.freedoms) degrees += freedom.directions;
  for (const FreeDirections& free : evidence.free_directions)
    degrees += static_cast<std::int64_t>(free.directions.size());
  return degrees;
}

}  // namespace

/// Away from a minimum, large errors are no sign of an outlier. Outliers that are only a small part of chi2
/// do not spoil the result.
void find_outliers(const Evidence& evidence, Findings& out) {
  constexpr double kNoticeable = 0.1;
  if (!evidence.at_minimum()) return;
  for (const PoolEvidence& edges : evidence.pools) {
    double limit = 0;
    const std::vector<Outlier> outliers = outliers_of(evidence, edges, limit);
    if (outliers.empty()) continue;
    const Outlier& worst = *std::max_element(
        outliers.begin(), outliers.end(), [](const Outlier& a, const Outlier& b) { return a.chi2 < b.chi2; });
    Finding finding;
    double sum = 0;
    for (const Outlier& outlier : outliers) {
      finding.edges.push_back(outlier.edge);
      sum += outlier.chi2;
    }
    finding.severity =
        sum > kNoticeable * evidence.chi2 ? Finding::Severity::kWarning : Finding::Severity::kNote;
    finding.text = fmt::format(
        "{} of {} edges {} {} a chi2 above {:.3g}, which noise does not explain; the worst, {:.4g}, is that "
        "of {}: check the measurements, or use a robust kernel",
        outliers.size(), edges.edges.size(), evidence.graph.edge_pools()[edges.pool]->type_name(),
        by_count(outliers.size(), "has", "have"), limit, worst.chi2,
        edges_text(evidence.graph, std::span(&worst.edge, 1)));
    out.push_back(std::move(finding));
  }
}

void find_not_at_minimum(const Evidence& evidence, Findings& out) {
  if (evidence.at_minimum() || evidence.vertices.empty() || !evidence.non_finite_errors.empty() ||
      !evidence.non_finite_jacobians.empty())
    return;
  Finding finding;
  finding.text = fmt::format(
      "chi2 is not at a minimum: steps of single vertices alone can lower it by {:.3g} %; outliers and the "
      "size of chi2 can be judged only after a run",
      std::round(1000 * std::min(1.0, evidence.single_decrease / evidence.chi2)) / 10);
  out.push_back(std::move(finding));
}

void find_chi2_ratio(const Evidence& evidence, Findings& out) {
  constexpr std::int64_t kFewestDegrees = 10;
  constexpr double kMost = 4, kLeast = 0.25;  // the limits of Report::chi2_remark()
  const std::int64_t degrees = degrees_of_freedom(evidence);
  constexpr double kExact = 1e-12;  // chi2 per row below which the errors are those of rounding
  if (!evidence.at_minimum() || degrees < kFewestDegrees) return;
  const double ratio = evidence.chi2 / static_cast<double>(degrees);
  Finding finding;
  if (ratio > kMost) {
    finding.text = fmt::format(
        "chi2 is {:.3g} times its degrees of freedom ({}); at a minimum, this ratio is about 1 if Ω is "
        "right: Ω is too large, there are outliers, or this is a local minimum",
        ratio, degrees);
  } else if (ratio < kLeast && evidence.chi2 > kExact * static_cast<double>(evidence.rows) &&
             !evidence.has_kernels) {
    finding.text = fmt::format(
        "chi2 is only {:.3g} times its degrees of freedom ({}); at a minimum, this ratio is about 1 if Ω is "
        "right: Ω is too small for errors as small as these, so covariances are too large",
        ratio, degrees);
  } else {
    return;
  }
  out.push_back(std::move(finding));
}

}  // namespace boxplus
