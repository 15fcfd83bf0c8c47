// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/settings/setting_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <utility>

#include "boxplus/algorithm/algorithm_table.h"
#include "boxplus/base/error.h"
#include "boxplus/linear/linear_solver_table.h"
#include "boxplus/outliers/outliers.h"
#include "boxplus/robust/default_width.h"
#include "boxplus/robust/kernel_table.h"
#include "boxplus/robust/make_robust_kernel.h"
#include "graph/graph_view.h"
#include "guess/start_table.h"
#include "viewer/settings/parse_number.h"

namespace boxplus::viewer {
namespace {

// ---- Numbers ----

template <class Access>
void make_whole_number(Setting& setting, int low, Access access) {
  setting.kind = Setting::Kind::kWholeNumber;
  setting.unit = "N";
  setting.set = [low, access](RunSettings& settings, const std::string& text) {
    constexpr int kMost = std::numeric_limits<int>::max();
    long value = 0;
    const bool is_number = parse_number(text, value);
    if (is_number && value > kMost)
      throw InvalidArgument(fmt::format("expected a whole number ≤ {}, got '{}'", kMost, text));
    if (!is_number || value < low)
      throw InvalidArgument(fmt::format("expected a whole number ≥ {}, got '{}'", low, text));
    access(settings) = static_cast<int>(value);
  };
}

/// Accepts finite numbers ≥ 0 or, if `excludes_zero`, > 0.
template <class Access>
void make_number(Setting& setting, bool excludes_zero, Access access) {
  setting.kind = Setting::Kind::kNumber;
  if (setting.unit.empty()) setting.unit = "X";
  setting.set = [excludes_zero, access](RunSettings& settings, const std::string& text) {
    double value = 0;
    const bool is_number = parse_number(text, value) && std::isfinite(value);
    if (!is_number || value < 0 || (excludes_zero && value == 0))
      throw InvalidArgument(fmt::format("expected a number {} 0, got '{}'", excludes_zero ? ">" : "≥", text));
    access(settings) = value;
  };
}

// ---- Choices ----

template <class T>
using Choices = std::vector<std::pair<std::string, T>>;

template <class T, class Access>
void make_choice(Setting& setting, const Choices<T>& choices, Access access) {
  setting.kind = Setting::Kind::kChoice;
  RunSettings defaults;
  for (const auto& [word, value] : choices) {
    setting.words.push_back(word);
    if (value == access(defaults)) setting.default_text = word;
  }
  setting.set = [choices, access, words = setting.words](RunSettings& settings, const std::string& text) {
    const auto found = std::find(words.begin(), words.end(), text);
    if (found == words.end())
      throw InvalidArgument(fmt::format("expected one of {}, got '{}'", fmt::join(words, ", "), text));
    access(settings) = choices[static_cast<std::size_t>(found - words.begin())].second;
  };
}

template <class Entry, class T>
Choices<T> choices_of(std::span<const Entry> table, std::string_view Entry::*name, T Entry::*value) {
  Choices<T> choices;
  for (const Entry& entry : table) choices.emplace_back(entry.*name, entry.*value);
  return choices;
}

// ---- Kernels ----

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

/// Returns the usual spelling of a name: "Huber" for "huber" and "Barron:1" for "barron:1". Returns unknown
/// names unchanged.
std::string spelt_out(const std::string& text) {
  const std::size_t end = std::min(text.find(':'), text.size());
  for (const detail::KernelEntry& kernel : detail::kernel_table()) {
    const std::string known(kernel.name.substr(0, kernel.name.find(':')));
    if (lower(text.substr(0, end)) == lower(known)) return known + text.substr(end);
  }
  return text;
}

std::string kernels_with_squared_width() {
  std::vector<std::string_view> names;
  for (const detail::KernelEntry& kernel : detail::kernel_table()) {
    if (kernel.width_is_squared) names.push_back(kernel.name);
  }
  return fmt::format("{}", fmt::join(names, " and "));
}

void make_kernel_name(Setting& setting) {
  setting.kind = Setting::Kind::kKernel;
  for (const detail::KernelEntry& kernel : detail::kernel_table()) setting.words.emplace_back(kernel.name);
  setting.set = [](RunSettings& settings, const std::string& text) {
    const std::string name = spelt_out(text);
    make_default_kernel(name, 1);  // throws if there is no such kernel
    settings.kernel = name;
  };
}

// ---- The table ----

class TableMaker {
 public:
  std::vector<Setting> make() {
    add_method();
    add_damping();
    add_outliers();
    add_false_edges();
    add_problem();
    add_stop();
    return std::move(table_);
  }

 private:
  Setting& add(const char* group, const char* name, std::string help) {
    Setting setting;
    setting.group = group;
    setting.name = name;
    setting.help = std::move(help);
    table_.push_back(std::move(setting));
    return table_.back();
  }

  void add_method() {
    make_choice(
        add("Method", "start",
            "The initial estimates; automatic: keep the estimates of the file if there is no --kernel "
            "and the first step reduces chi2 as the linear model predicts, and otherwise use either "
            "these estimates or the chordal guess, whichever is better"),
        choices_of(detail::start_table(), &detail::StartEntry::name, &detail::StartEntry::start),
        [](RunSettings& settings) -> Start& { return settings.options.start; });
    make_choice(
        add("Method", "algorithm", "The optimization algorithm"),
        choices_of(detail::algorithm_table(), &detail::AlgorithmEntry::name, &detail::AlgorithmEntry::kind),
        [](RunSettings& settings) -> AlgorithmKind& { return settings.options.algorithm; });
    make_choice(add("Method", "solver", "The linear solver"),
                choices_of(detail::linear_solver_table(), &detail::LinearSolverEntry::option,
                           &detail::LinearSolverEntry::kind),
                [](RunSettings& settings) -> LinearSolverKind& { return settings.options.linear_solver; });
    make_choice(
        add("Method", "precision",
            "The precision of the cholesky solver; mixed: factorize in float and refine the solutions "
            "in double; automatic: whichever is predicted to be faster, but always double for "
            "gauss-newton"),
        Choices<Precision>{{"automatic", Precision::kAutomatic},
                           {"double", Precision::kDouble},
                           {"mixed", Precision::kMixed}},
        [](RunSettings& settings) -> Precision& { return settings.options.precision; });
    make_whole_number(
        add("Method", "threads",
            "Use at most this many threads; 0: one per hardware thread. Results do not depend on "
            "this number"),
        0, [](RunSettings& settings) -> int& { return settings.options.threads; });
  }

  void add_damping() {
    const auto needs_levenberg_marquardt = [](Setting& setting) -> Setting& {
      setting.needed_setting = "algorithm";
      setting.needed_value = "levenberg-marquardt";
      return setting;
    };
    make_choice(needs_levenberg_marquardt(
                    add("Method", "damping",
                        "The matrix that Levenberg-Marquardt multiplies by lambda and adds to H: identity or "
                        "diagonal of H")),
                Choices<Options::DampingScale>{{"identity", Options::DampingScale::kIdentity},
                                               {"diagonal", Options::DampingScale::kDiagonal}},
                [](RunSettings& settings) -> Options::DampingScale& { return settings.options.damping; });
    make_number(needs_levenberg_marquardt(
                    add("Method", "lambda",
                        "The initial lambda of Levenberg-Marquardt; by default, it is computed from H")),
                true, [](RunSettings& settings) -> double& { return settings.options.initial_lambda; });
  }

  void add_outliers() {
    make_kernel_name(
        add("Outliers", "kernel",
            "Robust kernel, which gives less weight to outliers. For Barron, the name contains the shape: "
            "Barron:-2"));
    Setting& width = add(
        "Outliers", "kernel-width",
        "The error, in standard deviations, above which the kernel reduces weights; for " +
            kernels_with_squared_width() +
            ", the square of this error. The default is above 95 % of the errors of inliers: 1.96 for "
            "errors with one row, 2.45 for two rows, 2.80 for three, 3.55 for six (or the squares of these "
            "numbers)");
    width.needed_setting = "kernel";
    make_number(width, true,
                [](RunSettings& settings) -> std::optional<double>& { return settings.kernel_width; });
    Setting& scope = add(
        "Outliers", "kernel-on",
        "The edges that get the kernel; loop closures are edges between poses whose ids are not consecutive");
    scope.needed_setting = "kernel";
    make_choice(
        scope,
        Choices<KernelScope>{{"all", KernelScope::kAll}, {"loop-closures", KernelScope::kLoopClosures}},
        [](RunSettings& settings) -> KernelScope& { return settings.kernel_scope; });
  }

  /// Commands that have this setting add it as an option themselves, with a help text of their own.
  void add_false_edges() {
    make_choice(
        add("False edges", "outliers",
            "Find false edges, and optimize without them: among the loop closures (edges between "
            "poses whose ids are not consecutive) or among all edges. Begins with the odometry, if "
            "there is any"),
        Choices<std::optional<Suspects>>{
            {"none", std::nullopt}, {"loop-closures", Suspects::kLoopClosures}, {"all", Suspects::kAll}},
        [](RunSettings& settings) -> std::optional<Suspects>& { return settings.suspects; });
  }

  void add_problem() {
    make_choice(add("Problem", "gauge",
                    "How to treat a part of the graph that nothing holds in place; fix-first: fix its first "
                    "pose; damp: add minimal damping; error: stop with exit code 3"),
                Choices<GaugePolicy>{{"fix-first", GaugePolicy::kFixFirst},
                                     {"damp", GaugePolicy::kDamp},
                                     {"error", GaugePolicy::kError}},
                [](RunSettings& settings) -> GaugePolicy& { return settings.options.gauge; });
  }

  void add_stop() {
    const Options defaults;
    Setting& iterations = add("Stop", "iterations", "Stop after this many iterations");
    iterations.default_text = fmt::format("{}", defaults.max_iterations);
    make_whole_number(iterations, 0,
                      [](RunSettings& settings) -> int& { return settings.options.max_iterations; });
    Setting& time = add("Stop", "time-limit",
                        "Stop after this many seconds of optimization, or earlier if the next computation "
                        "cannot be interrupted and would end too late (ordering 100,000 poses: up to 0.1 s)");
    time.unit = "SECONDS";
    make_number(time, false, [](RunSettings& settings) -> double& { return settings.options.time_limit_s; });
    add_tolerance("cost-tolerance", "Converged if a step reduces chi2 by less than this fraction",
                  &Options::cost_tolerance);
    add_tolerance("step-tolerance",
                  "Converged if no entry of a step is larger than this fraction of its standard deviation",
                  &Options::step_tolerance);
    add_tolerance("gradient-tolerance", "Converged if no entry of the gradient is larger than this",
                  &Options::gradient_tolerance);
  }

  void add_tolerance(const char* name, const char* help, double Options::*tolerance) {
    Setting& setting = add("Stop", name, help);
    setting.default_text = fmt::format("{:g}", Options().*tolerance);
    make_number(setting, false,
                [tolerance](RunSettings& settings) -> double& { return settings.options.*tolerance; });
  }

  std::vector<Setting> table_;
};

// ---- Suitability ----

bool has_relative_poses(const Graph& graph) {
  detail::RelativeFrame frame;
  return std::any_of(graph.edge_pools().begin(), graph.edge_pools().end(), [&](const auto& pool) {
    for (std::uint32_t slot = 0; slot < pool->slots(); ++slot) {
      if (pool->alive(slot)) return pool->relative_frame(slot, frame);
    }
    return false;
  });
}

bool has_loop_closures(const Graph& graph) {
  const EdgeRoles role(graph);
  const std::vector<EdgeRef> edges = graph.all_edges();
  return std::any_of(edges.begin(), edges.end(),
                     [&](const EdgeRef& edge) { return role(edge) == EdgeRole::kLoopClosure; });
}

/// The bytes of a dense H of the vertices that are not eliminated.
double dense_bytes(const Graph& graph) {
  double scalars = 0;
  for (const VertexRef& vertex : graph.all_vertices()) {
    if (!graph.is_eliminated(vertex) && !graph.is_fixed(vertex)) scalars += graph.tangent_dim(vertex);
  }
  return sizeof(double) * scalars * scalars;
}

}  // namespace

std::span<const Setting> setting_table() {
  static const std::vector<Setting> table = TableMaker().make();
  return table;
}

std::string why_unsuitable(const Graph& graph, const Setting& setting, std::string_view word) {
  if (setting.name == "start" && word != "automatic" && word != "current" && !has_relative_poses(graph))
    return "no edge of this graph measures a relative pose";
  if (setting.name == "kernel-on" && word == "loop-closures" && !has_loop_closures(graph))
    return "this graph has no loop closures";
  if (setting.name == "outliers" && word == "loop-closures" && !has_loop_closures(graph))
    return "this graph has no loop closures";
  if (setting.name == "solver" && word == "dense") {
    constexpr double kMost = 4e9;
    if (const double bytes = dense_bytes(graph); bytes > kMost)
      return fmt::format("a dense H would take {:.0f} GB", bytes / 1e9);
  }
  return {};
}

RunSettings run_settings(const Settings& values) {
  RunSettings settings;
  for (const auto& [name, value] : values) {
    const std::span<const Setting> table = setting_table();
    const auto setting = std::find_if(table.begin(), table.end(),
                                      [&key = name](const Setting& each) { return each.name == key; });
    if (setting == table.end()) throw InvalidArgument(fmt::format("settings: '{}' is unknown", name));
    try {
      setting->set(settings, value);
    } catch (const InvalidArgument& error) {
      throw InvalidArgument(fmt::format("{}: {}", name, error.what()));
    }
  }
  for (const Setting& setting : setting_table()) {
    if (setting.needed_setting.empty() || values.count(setting.name) == 0) continue;
    const auto needed = values.find(setting.needed_setting);
    const std::string other = needed == values.end() ? "" : needed->second;
    if (setting.needed_value.empty() ? other.empty() : other != setting.needed_value)
      throw InvalidArgument(fmt::format("{}: needs the setting {} {}", setting.name, setting.needed_setting,
                                        setting.needed_value));
  }
  if (settings.options.max_iterations > kMostIterations)
    throw InvalidArgument(fmt::format("iterations: expected at most {}, got {}", kMostIterations,
                                      settings.options.max_iterations));
  return settings;
}

}  // namespace boxplus::viewer
