// SPDX-License-Identifier: BSD-3-Clause
#include "settings/setting_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cassert>
#include <cctype>
#include <cmath>
#include <limits>
#include <tuple>
#include <type_traits>
#include <utility>

#include "boxplus/base/error.h"
#include "boxplus/options/option_table.h"
#include "boxplus/outliers/outliers.h"
#include "boxplus/robust/default_width.h"
#include "boxplus/robust/kernel_table.h"
#include "boxplus/robust/make_robust_kernel.h"
#include "graph/graph_view.h"
#include "settings/parse_number.h"

namespace boxplus {
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
    access(settings) = choices[found - words.begin()].second;
  };
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
    add_options("Method");
    add_outliers();
    add_false_edges();
    add_options("Problem");
    add_options("Stop");
    return std::move(table_);
  }

 private:
  Setting& add(std::string_view group, std::string_view name, std::string help) {
    Setting setting;
    setting.group = group;
    setting.name = name;
    setting.help = std::move(help);
    table_.push_back(std::move(setting));
    return table_.back();
  }

  /// The options of a run that can be chosen, under one heading.
  void add_options(std::string_view group) {
    const auto add_row = [&](const auto& option) {
      if (option.group != group) return;
      Setting& setting = add(option.group, option.setting, std::string(option.help));
      setting.unit = option.unit;
      if (!option.needed_algorithm.empty()) {
        setting.needed_setting = "algorithm";
        setting.needed_value = option.needed_algorithm;
      }
      make_option(setting, option);
    };
    std::apply([&](const auto&... option) { (add_row(option), ...); }, detail::kOptions);
  }

  template <class T>
  static void make_option(Setting& setting, const detail::Option<T>& option) {
    const auto access = [member = option.member](RunSettings& settings) -> T& {
      return settings.options.*member;
    };
    RunSettings defaults;
    [[maybe_unused]] const T by_default = access(defaults);
    if constexpr (std::is_enum_v<T>) {
      Choices<T> choices;
      for (const std::string_view word : detail::OptionWords<T>::kAll)
        choices.emplace_back(word, static_cast<T>(choices.size()));
      std::stable_partition(choices.begin(), choices.end(),
                            [](const auto& choice) { return choice.first == "automatic"; });
      make_choice(setting, choices, access);
    } else if constexpr (std::is_same_v<T, int>) {
      make_whole_number(setting, 0, access);
      if (option.group == "Stop") setting.default_text = fmt::format("{}", by_default);
    } else if constexpr (std::is_same_v<T, double>) {
      make_number(setting, option.excludes_zero, access);
      if (option.unit.empty()) setting.default_text = fmt::format("{:g}", by_default);
    } else {
      assert(!"there is no setting of this type yet");
    }
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

}  // namespace boxplus
