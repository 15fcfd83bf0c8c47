// SPDX-License-Identifier: BSD-3-Clause
#include "outliers/annealing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "boxplus/base/progress.h"
#include "boxplus/robust/default_width.h"
#include "outliers/doubts.h"

namespace boxplus::outliers {
namespace {

/// The surrogate as a robust kernel.
class AnnealedSaturated final : public RobustKernel {
 public:
  AnnealedSaturated(double c2, double mu) : c2_(c2), mu_(mu) {}

  Rho operator()(double e2) const override {
    const double weight = annealed_weight(e2, c2_, mu_);
    if (weight == 1) return {e2, 1, 0};
    if (weight == 0) return {c2_, 0, 0};
    const double root = std::sqrt(c2_ * e2 * mu_ * (mu_ + 1));
    return {2 * root - mu_ * (c2_ + e2), weight, -0.5 * root / (e2 * e2)};
  }
  std::string_view name() const override { return "AnnealedSaturated"; }
  double delta() const override { return std::sqrt(c2_); }
  std::unique_ptr<RobustKernel> clone() const override { return std::make_unique<AnnealedSaturated>(*this); }

 private:
  double c2_, mu_;
};

Options options_of_stages(const Options& options) {
  constexpr int kIterations = 3;
  Options result = options;
  result.start = Start::kCurrent;
  result.max_iterations = kIterations;
  result.callback = {};
  return result;
}

/// The vertices of an edge without parameters.
std::vector<VertexRef> estimated_vertices(const Graph& graph, const EdgeRef& edge) {
  std::vector<VertexRef> vertices = graph.vertices(edge);
  const auto is_parameter = [&](const VertexRef& vertex) {
    return graph.vertex_pools()[vertex.pool]->parameter(vertex.slot);
  };
  vertices.erase(std::remove_if(vertices.begin(), vertices.end(), is_parameter), vertices.end());
  return vertices;
}

}  // namespace

double annealed_weight(double e2, double c2, double mu) {
  if (e2 * (mu + 1) <= c2 * mu) return 1;
  if (e2 * mu < c2 * (mu + 1)) return std::sqrt(c2 * mu * (mu + 1) / e2) - mu;
  return 0;  // also if e² is not a number
}

Annealing::Annealing(Graph& graph, const OutlierOptions& options) : graph_(graph), options_(options) {
  const Options& chosen = options.options;
  std::map<int, std::pair<double, double>> quantiles;
  for (const EdgeRef& edge : chosen.edges.empty() ? graph.all_edges() : chosen.edges) {
    if (!graph.is_enabled(edge) || (chosen.level >= 0 && graph.level(edge) != chosen.level)) continue;
    const int rows = graph.edge_pools()[edge.pool]->shape(edge.slot).rows;
    if (rows == 0) continue;
    auto& [quantile, median] = quantiles[rows];
    if (quantile == 0) {
      quantile = chi2_quantile(rows, 1 - options.false_alarm);
      median = chi2_quantile(rows, 0.5);
    }
    const RobustKernel* const kernel = graph.kernel(edge);
    state_.edges.push_back({.edge = edge,
                            .rows = rows,
                            .quantile = quantile,
                            .median = median,
                            .kernel = kernel != nullptr ? kernel->clone() : nullptr});
  }
  initial_estimates_.take(graph);
  for (std::size_t k = 0; k < state_.edges.size(); ++k) {
    vertices_.push_back(estimated_vertices(graph, state_.edges[k].edge));
    for (const VertexRef& vertex : vertices_.back()) {
      if (!graph.is_fixed(vertex)) incident_[vertex].push_back(k);
    }
  }
}

Annealing::~Annealing() {
  restore();
}

void Annealing::restore() {
  for (const Edge& edge : state_.edges) graph_.set_kernel(edge.edge, edge.kernel);
}

/// Evaluates the edges. The median of those that have a weight shows the scale of the noise, as long as fewer
/// than half of them are false.
void Annealing::measure() {
  std::vector<double> ratios;
  for (std::size_t k = 0; k < state_.edges.size(); ++k) {
    Edge& edge = state_.edges[k];
    edge.chi2 = graph_.chi2(edge.edge);
    if (edge.accepted && state_.weights[k] > 0 && std::isfinite(edge.chi2))
      ratios.push_back(edge.chi2 / edge.median);
  }
  if (ratios.empty()) return;
  const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
  std::nth_element(ratios.begin(), middle, ratios.end());
  state_.noise_scale = *middle;
  state_.limit_scale = trusts_omega_ ? 1 : std::max(1.0, state_.noise_scale);
}

double Annealing::largest_ratio() const {
  double largest = 0;
  for (const Edge& edge : state_.edges) {
    if (std::isfinite(edge.chi2)) largest = std::max(largest, edge.chi2 / limit(edge));
  }
  return largest;
}

/// Gives each edge the surrogate for μ. Returns the sum of the changes of the weights.
double Annealing::change_weights(double mu) {
  std::map<int, std::shared_ptr<const RobustKernel>> kernels;  // by rows
  double change = 0;
  for (std::size_t k = 0; k < state_.edges.size(); ++k) {
    const Edge& edge = state_.edges[k];
    auto& kernel = kernels[edge.rows];
    if (!kernel) kernel = std::make_shared<const AnnealedSaturated>(limit(edge), mu);
    graph_.set_kernel(edge.edge, kernel);
    const double weight = annealed_weight(edge.chi2, limit(edge), mu);
    change += std::abs(weight - state_.weights[k]);
    state_.weights[k] = weight;
  }
  return change;
}

void Annealing::anneal(double mu) {
  constexpr double kFactor = 2, kLargest = 100, kSmallChange = 1e-4;
  measure();
  const double ratio = largest_ratio();
  if (ratio <= 1) return;  // all edges fit
  const double first = std::max(mu, 1 / (2 * ratio - 1));
  for (mu = first; mu < kLargest && !was_stopped(); mu *= kFactor) {
    detail::note_progress(std::log(mu / first) / std::log(kLargest / first), "weighing the edges");
    const double change = change_weights(mu);
    if (!optimizer_ || change > kSmallChange * static_cast<double>(state_.edges.size())) run();
  }
}

/// Optimizes briefly. The first run chooses the edges for the next ones: those that have a weight, because
/// false edges between distant vertices make H less sparse.
void Annealing::run() {
  if (!optimizer_) {
    Options options = options_of_stages(options_.options);
    options.edges.clear();
    for (std::size_t k = 0; k < state_.edges.size(); ++k) {
      if (state_.edges[k].accepted && state_.weights[k] > 0) options.edges.push_back(state_.edges[k].edge);
    }
    if (options.edges.empty()) return;
    optimizer_.emplace(graph_, options);
  }
  static_cast<void>(optimizer_->run());
  measure();
}

/// If none of the edges of a vertex fits, moving the vertex to one that measures all of its degrees of
/// freedom makes this one fit.
void Annealing::hold_lost_vertices(std::vector<std::uint8_t>& fits) const {
  for (const auto& [vertex, edges] : incident_) {
    if (std::any_of(edges.begin(), edges.end(), [&](std::size_t k) { return fits[k] != 0; })) continue;
    const auto ratio = [&](std::size_t k) { return state_.edges[k].chi2 / state_.edges[k].quantile; };
    const std::size_t nearest = *std::min_element(
        edges.begin(), edges.end(), [&](std::size_t a, std::size_t b) { return ratio(a) < ratio(b); });
    if (state_.edges[nearest].rows >= graph_.tangent_dim(vertex)) fits[nearest] = 1;
  }
}

/// If the noise is far below Ω, limits in proportion to Ω accept edges that disagree with all others.
void Annealing::tighten_limits() {
  constexpr double kMargin = 250, kLeastRedundancy = 0.05;
  const Rows rows = this->rows();
  if (rows.redundant > kLeastRedundancy * rows.accepted)
    state_.limit_scale = std::min(state_.limit_scale, kMargin * state_.noise_scale);
}

void Annealing::settle() {
  constexpr int kMostPasses = 10, kMostAdditions = 5;
  restore();
  state_.weights.assign(state_.edges.size(), 1);
  std::vector<std::uint8_t> fits(state_.edges.size());
  for (int pass = 0; pass < kMostPasses && !was_stopped(); ++pass) {
    tighten_limits();
    std::transform(state_.edges.begin(), state_.edges.end(), fits.begin(),
                   [&](const Edge& edge) { return edge.chi2 <= limit(edge) ? 1 : 0; });
    if (pass < kMostAdditions) hold_lost_vertices(fits);
    bool changed = false;
    for (std::size_t k = 0; k < fits.size(); ++k) {
      Edge& edge = state_.edges[k];
      if (edge.accepted == (fits[k] != 0) || (fits[k] && pass >= kMostAdditions)) continue;
      edge.accepted = fits[k] != 0;
      changed = true;
    }
    if (!changed && pass > 0) return;
    optimizer_.reset();
    run();
  }
}

void Annealing::go_to(const std::function<void()>& start) {
  restore();
  optimizer_.reset();
  initial_estimates_.put_back(graph_);
  for (Edge& edge : state_.edges) edge.accepted = true;
  state_.weights.assign(state_.edges.size(), 1);
  start();
}

void Annealing::minimize_from(const std::function<void()>& start, Begin begin) {
  constexpr double kConvex = 1e-9, kNear = 0.1;
  if (best_ && was_stopped()) return;
  trusts_omega_ = begin == Begin::kTrustingOmega;
  go_to(start);
  anneal(begin == Begin::kNear ? kNear : kConvex);
  settle();
  keep_if_better();
}

bool Annealing::is_doubtful() const {
  constexpr double kMany = 0.01;
  std::vector<EdgeRef> edges;
  for (const Edge& edge : best_->edges) edges.push_back(edge.edge);
  return rejected_share(edges) > kMany || is_noisy();
}

bool Annealing::is_noisy() const {
  constexpr double kMuchNoise = 4;
  return best_->noise_scale > kMuchNoise;
}

bool Annealing::was_stopped() const {
  const Options& options = options_.options;
  return (options.stop != nullptr && options.stop->load()) || watch_.seconds() > options.time_limit_s;
}

double Annealing::rejected_share(std::span<const EdgeRef> edges) const {
  const std::set<EdgeRef> chosen(edges.begin(), edges.end());
  std::size_t count = 0, rejected = 0;
  for (const Edge& edge : best_->edges) {
    if (chosen.count(edge.edge) == 0) continue;
    ++count;
    rejected += !edge.accepted;
  }
  return static_cast<double>(rejected) / static_cast<double>(std::max<std::size_t>(count, 1));
}

Annealing::Rows Annealing::rows() const {
  Rows rows;
  for (const Edge& edge : state_.edges) (edge.accepted ? rows.accepted : rows.rejected) += edge.rows;
  rows.redundant = rows.accepted;
  for (const auto& [vertex, edges] : incident_) {
    if (std::any_of(edges.begin(), edges.end(), [&](std::size_t k) { return state_.edges[k].accepted; }))
      rows.redundant -= free_dim(vertex);
  }
  return rows;
}

/// Minus the logarithm of the likelihood of two normal distributions, up to constants: one for the accepted
/// edges, and a wider one for the rejected edges. Each has the variance that fits best. Only redundant rows
/// count, because a tree of edges fits exactly.
double Annealing::cost() const {
  constexpr double kSmallest = 1e-30, kLargest = 1e30;
  double accepted = 0, rejected = 0;
  for (const Edge& edge : state_.edges)
    (edge.accepted ? accepted : rejected) +=
        edge.chi2 < kLargest ? edge.chi2 : kLargest;  // also if it is NaN
  const Rows rows = this->rows();
  if (rows.redundant <= 0) return std::numeric_limits<double>::infinity();
  const auto part = [&](double count, double sum) {
    return count > 0 ? count * std::log(std::max(sum / count, kSmallest)) : 0;
  };
  return part(rows.redundant, accepted) + part(rows.rejected, rejected);
}

int Annealing::free_dim(const VertexRef& vertex) const {
  return graph_.tangent_dim(vertex) - static_cast<int>(graph_.fixed_directions(vertex).size());
}

void Annealing::keep_if_better() {
  const double cost = this->cost();
  if (best_ && !(cost < best_cost_)) return;
  best_ = state_;
  best_cost_ = cost;
  best_estimates_.take(graph_);
}

OutlierReport Annealing::finish() {
  const bool stopped = was_stopped();
  restore();
  best_estimates_.put_back(graph_);
  state_ = std::move(*best_);
  Options options = options_.options;
  options.start = Start::kCurrent;
  options.edges.clear();
  for (const Edge& edge : state_.edges) {
    if (edge.accepted) options.edges.push_back(edge.edge);
  }
  Report report;
  if (!options.edges.empty()) report = optimize(graph_, options);
  measure();
  return judge(std::move(report), stopped);
}

/// Whether the accepted edges of the vertices of each edge have more rows than these vertices have degrees of
/// freedom. Without this, an edge fits whatever it measures, as at the end of a chain.
std::vector<std::uint8_t> Annealing::has_redundancy() const {
  std::map<VertexRef, int> surplus;  // rows beyond the degrees of freedom
  std::vector<VertexRef> open;
  for (const auto& [vertex, edges] : incident_) {
    int& rows = surplus[vertex];
    rows = -free_dim(vertex);
    for (const std::size_t k : edges) rows += state_.edges[k].accepted ? state_.edges[k].rows : 0;
    if (rows <= 0) open.push_back(vertex);
  }
  std::vector<std::uint8_t> redundant(state_.edges.size(), 1);
  while (!open.empty()) {
    const VertexRef lost = open.back();
    open.pop_back();
    for (const std::size_t k : incident_.at(lost)) {
      if (!redundant[k]) continue;
      redundant[k] = 0;
      if (!state_.edges[k].accepted) continue;
      for (const VertexRef& vertex : vertices_[k]) {
        const auto other = surplus.find(vertex);
        if (other == surplus.end()) continue;  // a fixed vertex
        const bool had_surplus = other->second > 0;
        other->second -= state_.edges[k].rows;
        if (had_surplus && other->second <= 0) open.push_back(vertex);
      }
    }
  }
  return redundant;
}

OutlierReport Annealing::judge(Report report, bool stopped) const {
  constexpr double kMuchNoise = 10;
  OutlierReport result;
  result.suspects = Suspects::kAll;
  const std::vector<std::uint8_t> redundant = has_redundancy();
  std::size_t rejected = 0;
  for (std::size_t k = 0; k < state_.edges.size(); ++k) {
    const Edge& edge = state_.edges[k];
    const std::vector<VertexRef>& vertices = vertices_[k];
    EdgeVerdict verdict{.edge = edge.edge, .weight = edge.accepted ? 1.0 : 0.0, .chi2 = edge.chi2};
    if (!vertices.empty()) {
      verdict.from = graph_.id(vertices.front());
      verdict.to = graph_.id(vertices.back());
    }
    if (!stopped && redundant[k]) verdict.verdict = edge.accepted ? Verdict::kInlier : Verdict::kOutlier;
    rejected += !edge.accepted;
    result.verdicts.push_back(verdict);
  }
  result.noise_scale = state_.noise_scale;
  if (stopped) {
    result.note = "the search was stopped, so no edge is judged";
    mark_as_stopped(report, options_.options);
  } else if (rejected > state_.edges.size() / 2) {
    result.note = "more than half of the edges do not fit, so the verdicts and the map may be wrong";
    if (report.converged()) {
      report.status = Report::Status::kNotConverged;
      report.reason = Report::Reason::kRejectedEdges;
      report.message = fmt::format("{} of the {} edges were rejected", rejected, state_.edges.size());
    }
  } else if (state_.noise_scale > kMuchNoise) {
    result.note = fmt::format(
        "the squared errors of most edges are {:.3g} times as large as Ω says, and so are the limits",
        state_.noise_scale);
  }
  result.report = std::move(report);
  return result;
}

}  // namespace boxplus::outliers
