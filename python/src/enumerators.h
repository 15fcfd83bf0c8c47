// SPDX-License-Identifier: BSD-3-Clause
// The enumerations of options and reports, with the names of their values. Python may also pass a value as
// text, as on command lines: "levenberg-marquardt" for kLevenbergMarquardt.
#pragma once

#include <cctype>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

#include "boxplus/certify/certificate.h"
#include "boxplus/covariance/covariance.h"
#include "boxplus/diagnose/diagnose.h"
#include "boxplus/incremental/smoother_options.h"
#include "boxplus/optimize/report.h"
#include "boxplus/outliers/outliers.h"
#include "convert.h"

namespace boxplus::python {

template <class E>
struct Enumerator {
  const char* name;
  E value;
};

/// Enumerators<E>::kName is the name of the enumeration, and kAll lists its values.
template <class E>
struct Enumerators;

template <>
struct Enumerators<AlgorithmKind> {
  using enum AlgorithmKind;
  static constexpr const char* kName = "AlgorithmKind";
  static constexpr Enumerator<AlgorithmKind> kAll[] = {{"kAutomatic", kAutomatic},
                                                       {"kGaussNewton", kGaussNewton},
                                                       {"kLevenbergMarquardt", kLevenbergMarquardt},
                                                       {"kDogleg", kDogleg}};
};
template <>
struct Enumerators<LinearSolverKind> {
  using enum LinearSolverKind;
  static constexpr const char* kName = "LinearSolverKind";
  static constexpr Enumerator<LinearSolverKind> kAll[] = {{"kAutomatic", kAutomatic},
                                                          {"kBlockCholesky", kBlockCholesky},
                                                          {"kPcg", kPcg},
                                                          {"kDense", kDense},
                                                          {"kEigenSparse", kEigenSparse}};
};
template <>
struct Enumerators<Precision> {
  using enum Precision;
  static constexpr const char* kName = "Precision";
  static constexpr Enumerator<Precision> kAll[] = {
      {"kAutomatic", kAutomatic}, {"kDouble", kDouble}, {"kMixed", kMixed}};
};
template <>
struct Enumerators<Ordering> {
  using enum Ordering;
  static constexpr const char* kName = "Ordering";
  static constexpr Enumerator<Ordering> kAll[] = {{"kAutomatic", kAutomatic},
                                                  {"kMinimumDegree", kMinimumDegree},
                                                  {"kNestedDissection", kNestedDissection}};
};
template <>
struct Enumerators<Start> {
  using enum Start;
  static constexpr const char* kName = "Start";
  static constexpr Enumerator<Start> kAll[] = {{"kCurrent", kCurrent},
                                               {"kOdometry", kOdometry},
                                               {"kSpanningTree", kSpanningTree},
                                               {"kChordal", kChordal},
                                               {"kAutomatic", kAutomatic}};
};
template <>
struct Enumerators<GaugePolicy> {
  using enum GaugePolicy;
  static constexpr const char* kName = "GaugePolicy";
  static constexpr Enumerator<GaugePolicy> kAll[] = {
      {"kFixFirst", kFixFirst}, {"kDamp", kDamp}, {"kError", kError}};
};
template <>
struct Enumerators<SchurMode> {
  using enum SchurMode;
  static constexpr const char* kName = "SchurMode";
  static constexpr Enumerator<SchurMode> kAll[] = {
      {"kAutomatic", kAutomatic}, {"kExplicit", kExplicit}, {"kImplicit", kImplicit}};
};
template <>
struct Enumerators<Options::DampingScale> {
  using enum Options::DampingScale;
  static constexpr const char* kName = "DampingScale";
  static constexpr Enumerator<Options::DampingScale> kAll[] = {{"kIdentity", kIdentity},
                                                               {"kDiagonal", kDiagonal}};
};
template <>
struct Enumerators<detail::JacobianSource> {
  using enum detail::JacobianSource;
  static constexpr const char* kName = "JacobianSource";
  static constexpr Enumerator<detail::JacobianSource> kAll[] = {
      {"kAnalytic", kAnalytic}, {"kAutomatic", kAutomatic}, {"kNumeric", kNumeric}};
};
template <>
struct Enumerators<Report::Status> {
  using enum Report::Status;
  static constexpr const char* kName = "Status";
  static constexpr Enumerator<Report::Status> kAll[] = {
      {"kConverged", kConverged}, {"kNotConverged", kNotConverged}, {"kFailed", kFailed}};
};
template <>
struct Enumerators<Report::Reason> {
  using enum Report::Reason;
  static constexpr const char* kName = "Reason";
  static constexpr Enumerator<Report::Reason> kAll[] = {{"kCostTolerance", kCostTolerance},
                                                        {"kStepTolerance", kStepTolerance},
                                                        {"kGradientTolerance", kGradientTolerance},
                                                        {"kNoFurtherDecrease", kNoFurtherDecrease},
                                                        {"kNothingToOptimize", kNothingToOptimize},
                                                        {"kMaxIterations", kMaxIterations},
                                                        {"kTimeLimit", kTimeLimit},
                                                        {"kStopFlag", kStopFlag},
                                                        {"kCallback", kCallback},
                                                        {"kNoStepFound", kNoStepFound},
                                                        {"kRaisedChi2", kRaisedChi2},
                                                        {"kNotPositiveDefinite", kNotPositiveDefinite},
                                                        {"kNotFinite", kNotFinite},
                                                        {"kRejectedEdges", kRejectedEdges},
                                                        {"kWeightSpan", kWeightSpan},
                                                        {"kConstraints", kConstraints},
                                                        {"kGaugeFreedom", kGaugeFreedom}};
};

template <>
struct Enumerators<Covariance::Status> {
  using enum Covariance::Status;
  static constexpr const char* kName = "Status";
  static constexpr Enumerator<Covariance::Status> kAll[] = {
      {"kOk", kOk}, {"kSingular", kSingular}, {"kNotFinite", kNotFinite}, {"kStopped", kStopped}};
};

template <>
struct Enumerators<Finding::Kind> {
  using enum Finding::Kind;
  static constexpr const char* kName = "Kind";
  static constexpr Enumerator<Finding::Kind> kAll[] = {{"kNonFiniteEstimate", kNonFiniteEstimate},
                                                       {"kNonFiniteError", kNonFiniteError},
                                                       {"kNonFiniteJacobian", kNonFiniteJacobian},
                                                       {"kImplausibleEstimate", kImplausibleEstimate},
                                                       {"kNothingMoves", kNothingMoves},
                                                       {"kWrongJacobian", kWrongJacobian},
                                                       {"kIsolatedVertex", kIsolatedVertex},
                                                       {"kFreeComponent", kFreeComponent},
                                                       {"kZeroJacobian", kZeroJacobian},
                                                       {"kUndeterminedDirection", kUndeterminedDirection},
                                                       {"kSeenOnce", kSeenOnce},
                                                       {"kBehindCameras", kBehindCameras},
                                                       {"kFarPoint", kFarPoint},
                                                       {"kZeroInformation", kZeroInformation},
                                                       {"kMixedUnits", kMixedUnits},
                                                       {"kDuplicateEdge", kDuplicateEdge},
                                                       {"kOutlier", kOutlier},
                                                       {"kDominantVertex", kDominantVertex},
                                                       {"kFixedEdge", kFixedEdge},
                                                       {"kNotAtMinimum", kNotAtMinimum},
                                                       {"kChi2Ratio", kChi2Ratio}};
};
template <>
struct Enumerators<Finding::Severity> {
  using enum Finding::Severity;
  static constexpr const char* kName = "Severity";
  static constexpr Enumerator<Finding::Severity> kAll[] = {
      {"kNote", kNote}, {"kWarning", kWarning}, {"kError", kError}};
};
template <>
struct Enumerators<Finding::Direction::Kind> {
  using enum Finding::Direction::Kind;
  static constexpr const char* kName = "Kind";
  static constexpr Enumerator<Finding::Direction::Kind> kAll[] = {
      {"kAlong", kAlong}, {"kAbout", kAbout}, {"kScale", kScale}, {"kTangent", kTangent}};
};
template <>
struct Enumerators<Suspects> {
  static constexpr const char* kName = "Suspects";
  static constexpr Enumerator<Suspects> kAll[] = {{"kLoopClosures", Suspects::kLoopClosures},
                                                  {"kAll", Suspects::kAll}};
};
template <>
struct Enumerators<Verdict> {
  using enum Verdict;
  static constexpr const char* kName = "Verdict";
  static constexpr Enumerator<Verdict> kAll[] = {
      {"kInlier", kInlier}, {"kOutlier", kOutlier}, {"kUndecided", kUndecided}};
};
template <>
struct Enumerators<Certificate::Verdict> {
  using enum Certificate::Verdict;
  static constexpr const char* kName = "Verdict";
  static constexpr Enumerator<Certificate::Verdict> kAll[] = {
      {"kGlobalMinimum", kGlobalMinimum}, {"kLocalMinimum", kLocalMinimum}, {"kUndecided", kUndecided}};
};
template <>
struct Enumerators<Certificate::Relation> {
  using enum Certificate::Relation;
  static constexpr const char* kName = "Relation";
  static constexpr Enumerator<Certificate::Relation> kAll[] = {
      {"kEqual", kEqual}, {"kBelow", kBelow}, {"kSimilar", kSimilar}};
};
template <>
struct Enumerators<SmootherReport::Reason> {
  using enum SmootherReport::Reason;
  static constexpr const char* kName = "Reason";
  static constexpr Enumerator<SmootherReport::Reason> kAll[] = {
      {"kConverged", kConverged},        {"kMaxIterations", kMaxIterations}, {"kMaxFlops", kMaxFlops},
      {"kTimeLimit", kTimeLimit},        {"kStopFlag", kStopFlag},           {"kNonFinite", kNonFinite},
      {"kNotDetermined", kNotDetermined}};
};

/// "levenberg-marquardt" for "kLevenbergMarquardt".
inline std::string text_of(std::string_view enumerator) {
  std::string text;
  for (const char c : enumerator.substr(1)) {
    if (std::isupper(static_cast<unsigned char>(c)) != 0 && !text.empty()) text += '-';
    text += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return text;
}

template <class E>
void bind_enum(py::handle scope) {
  py::enum_<E> type(scope, Enumerators<E>::kName);
  for (const Enumerator<E>& enumerator : Enumerators<E>::kAll) type.value(enumerator.name, enumerator.value);
}

/// A value of E, or its text.
template <class E>
E read_enumerator(py::handle value, std::string_view name) {
  if (py::isinstance<E>(value)) return value.cast<E>();
  std::string expected;
  for (const Enumerator<E>& enumerator : Enumerators<E>::kAll) {
    const std::string text = text_of(enumerator.name);
    if (py::isinstance<py::str>(value) && value.cast<std::string>() == text) return enumerator.value;
    expected.append(expected.empty() ? "one of '" : ", '").append(text).append("'");
  }
  if (py::isinstance<py::str>(value)) throw_value_error(name, expected, value);
  throw_type_error(name, expected, value);
}

}  // namespace boxplus::python
