// SPDX-License-Identifier: BSD-3-Clause
// The options of a run in one table. From a row follow the check of the option, its name and help on the
// command line and in the viewer, its attribute in Python, and its line in docs/options.md. To add an option,
// add a member to Options and a row.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

#include "boxplus/options/options.h"

namespace boxplus::detail {

/// The name of an enum of Options, and the words for people of its values, which begin with 0.
template <class E>
struct OptionWords;
template <>
struct OptionWords<AlgorithmKind> {
  static constexpr std::string_view kName = "AlgorithmKind";
  static constexpr std::array<std::string_view, 4> kAll{"automatic", "gauss-newton", "levenberg-marquardt",
                                                        "dogleg"};
};
template <>
struct OptionWords<LinearSolverKind> {
  static constexpr std::string_view kName = "LinearSolverKind";
  static constexpr std::array<std::string_view, 5> kAll{"automatic", "cholesky", "pcg", "dense", "eigen"};
};
template <>
struct OptionWords<Precision> {
  static constexpr std::string_view kName = "Precision";
  static constexpr std::array<std::string_view, 3> kAll{"automatic", "double", "mixed"};
};
template <>
struct OptionWords<Start> {
  static constexpr std::string_view kName = "Start";
  static constexpr std::array<std::string_view, 5> kAll{"current", "odometry", "spanning-tree", "chordal",
                                                        "automatic"};
};
template <>
struct OptionWords<GaugePolicy> {
  static constexpr std::string_view kName = "GaugePolicy";
  static constexpr std::array<std::string_view, 3> kAll{"fix-first", "damp", "error"};
};
template <>
struct OptionWords<SchurMode> {
  static constexpr std::string_view kName = "SchurMode";
  static constexpr std::array<std::string_view, 3> kAll{"automatic", "explicit", "implicit"};
};
template <>
struct OptionWords<Options::DampingScale> {
  static constexpr std::string_view kName = "DampingScale";
  static constexpr std::array<std::string_view, 2> kAll{"identity", "diagonal"};
};

/// The numbers that an option accepts. NaN is never one of them.
enum class OptionRange : std::uint8_t { kAny, kNotNegative, kFiniteNotNegative, kFraction };

template <class T>
struct Option {
  std::string_view name;  ///< of the member, and in Python
  T Options::*member;
  /// The name on the command line and in the viewer, and the heading under which it stands there; empty if it
  /// cannot be chosen there.
  std::string_view setting = {}, group = {};
  std::string_view help = {};  ///< one or two sentences, without a period at the end
  OptionRange range = OptionRange::kAny;
  std::string_view unit = {};  ///< what stands for the value in help texts
  /// On the command line and in the viewer, 0 is refused, because it stands for the default.
  bool excludes_zero = false;
  /// On the command line and in the viewer, the option needs `algorithm` with this word.
  std::string_view needed_algorithm = {};
};
template <class T, class... More>
Option(std::string_view, T Options::*, More...) -> Option<T>;

/// All options but those that only C++ can write: lists of vertices and edges, `stop`, `callback` and
/// `custom_linear_solver`. In the order of help texts.
inline constexpr std::tuple kOptions{
    Option{
        "start", &Options::start, "start", "Method",
        "The initial estimates; automatic: keep the estimates of the file if there is no --kernel and the "
        "first step reduces chi2 as the linear model predicts, and otherwise use either these estimates or "
        "the chordal guess, whichever is better"},
    Option{"algorithm", &Options::algorithm, "algorithm", "Method", "The optimization algorithm"},
    Option{"linear_solver", &Options::linear_solver, "solver", "Method", "The linear solver"},
    Option{
        "precision", &Options::precision, "precision", "Method",
        "The precision of the cholesky solver; mixed: factorize in float and refine the solutions in double; "
        "automatic: whichever is predicted to be faster, but always double for gauss-newton"},
    Option{"threads", &Options::threads, "threads", "Method",
           "Use at most this many threads; 0: one per hardware thread. Results do not depend on this number",
           OptionRange::kNotNegative},
    Option{
        "damping", &Options::damping, "damping", "Method",
        "The matrix that Levenberg-Marquardt multiplies by lambda and adds to H: identity or diagonal of H",
        OptionRange::kAny, "", false, "levenberg-marquardt"},
    Option{"initial_lambda", &Options::initial_lambda, "lambda", "Method",
           "The initial lambda of Levenberg-Marquardt; by default, it is computed from H",
           OptionRange::kFiniteNotNegative, "X", true, "levenberg-marquardt"},
    Option{"initial_radius", &Options::initial_radius, "", "",
           "The first trust-region radius of dogleg; 0: unbounded", OptionRange::kNotNegative},
    Option{
        "gauge", &Options::gauge, "gauge", "Problem",
        "How to treat a part of the graph that nothing holds in place; fix-first: fix its first pose; damp: "
        "add minimal damping; error: stop with exit code 3"},
    Option{"schur", &Options::schur, "", "", "How the Schur complement is formed if vertices are eliminated"},
    Option{"level", &Options::level, "", "", "Edges of this level take part; if negative, all edges"},
    Option{"max_iterations", &Options::max_iterations, "iterations", "Stop",
           "Stop after this many iterations", OptionRange::kNotNegative},
    Option{"time_limit_s", &Options::time_limit_s, "time-limit", "Stop",
           "Stop after this many seconds of optimization, or earlier if the next computation cannot be "
           "interrupted and would end too late (ordering 100,000 poses: up to 0.1 s)",
           OptionRange::kAny, "SECONDS"},
    Option{"cost_tolerance", &Options::cost_tolerance, "cost-tolerance", "Stop",
           "Converged if a step reduces chi2 by less than this fraction", OptionRange::kNotNegative},
    Option{"noise_tolerance", &Options::noise_tolerance, "", "",
           "Converged if the decreases of chi2 are below this fraction of the variance of the noise",
           OptionRange::kNotNegative},
    Option{"step_tolerance", &Options::step_tolerance, "step-tolerance", "Stop",
           "Converged if no entry of a step is larger than this fraction of its standard deviation",
           OptionRange::kNotNegative},
    Option{"gradient_tolerance", &Options::gradient_tolerance, "gradient-tolerance", "Stop",
           "Converged if no entry of the gradient is larger than this", OptionRange::kNotNegative},
    Option{"linear_tolerance", &Options::linear_tolerance, "", "",
           "The relative residual at which iterative linear solvers and refinement stop; 0: chosen by the "
           "solver",
           OptionRange::kFraction},
    Option{"max_factor_bytes", &Options::max_factor_bytes, "", "",
           "Use pcg if a factor would take more memory; 0: half of the memory of the machine"},
    Option{"numeric_jacobians", &Options::numeric_jacobians, "", "", "Differentiate every edge numerically"},
    Option{"triggs_correction", &Options::triggs_correction, "", "",
           "Add the second-order term of robust kernels"},
};

/// The word of a value, or "unknown".
template <class E>
constexpr std::string_view word_of(E value) {
  const auto number = static_cast<std::size_t>(value);
  return number < OptionWords<E>::kAll.size() ? OptionWords<E>::kAll[number] : "unknown";
}

/// Throws InvalidArgument if an option is not in its range.
void check_options(const Options& options);

}  // namespace boxplus::detail
