// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/options/option_table.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <initializer_list>
#include <limits>
#include <set>
#include <sstream>
#include <utility>

#include "boxplus/algorithm/algorithm_table.h"
#include "boxplus/base/error.h"
#include "boxplus/linear/linear_solver_table.h"
#include "guess/start_table.h"

namespace boxplus {
namespace {

using detail::Option;
using detail::OptionRange;
using detail::OptionWords;

template <class F>
void for_each_option(F&& f) {
  std::apply([&](const auto&... option) { (f(option), ...); }, detail::kOptions);
}

TEST(OptionTable, HasEachNameOnceAndAHelp) {
  std::set<std::string_view> names, settings;
  for_each_option([&](const auto& option) {
    EXPECT_TRUE(names.insert(option.name).second) << option.name;
    EXPECT_FALSE(option.help.empty()) << option.name;
    EXPECT_EQ(option.setting.empty(), option.group.empty()) << option.name;
    if (!option.setting.empty()) {
      EXPECT_TRUE(settings.insert(option.setting).second) << option.setting;
    }
  });
}

template <class E>
void expect_words(std::initializer_list<std::pair<E, std::string_view>> words) {
  EXPECT_EQ(OptionWords<E>::kAll.size(), words.size());
  for (const auto& [value, word] : words) EXPECT_EQ(detail::word_of(value), word);
}

TEST(OptionTable, HasTheWordOfEachValueInItsPlace) {
  using enum Options::DampingScale;
  expect_words<AlgorithmKind>({{AlgorithmKind::kAutomatic, "automatic"},
                               {AlgorithmKind::kGaussNewton, "gauss-newton"},
                               {AlgorithmKind::kLevenbergMarquardt, "levenberg-marquardt"},
                               {AlgorithmKind::kDogleg, "dogleg"}});
  expect_words<LinearSolverKind>({{LinearSolverKind::kAutomatic, "automatic"},
                                  {LinearSolverKind::kBlockCholesky, "cholesky"},
                                  {LinearSolverKind::kPcg, "pcg"},
                                  {LinearSolverKind::kDense, "dense"},
                                  {LinearSolverKind::kEigenSparse, "eigen"}});
  expect_words<Precision>(
      {{Precision::kAutomatic, "automatic"}, {Precision::kDouble, "double"}, {Precision::kMixed, "mixed"}});
  expect_words<Start>({{Start::kCurrent, "current"},
                       {Start::kOdometry, "odometry"},
                       {Start::kSpanningTree, "spanning-tree"},
                       {Start::kChordal, "chordal"},
                       {Start::kAutomatic, "automatic"}});
  expect_words<GaugePolicy>(
      {{GaugePolicy::kFixFirst, "fix-first"}, {GaugePolicy::kDamp, "damp"}, {GaugePolicy::kError, "error"}});
  expect_words<SchurMode>({{SchurMode::kAutomatic, "automatic"},
                           {SchurMode::kExplicit, "explicit"},
                           {SchurMode::kImplicit, "implicit"}});
  expect_words<Options::DampingScale>({{kIdentity, "identity"}, {kDiagonal, "diagonal"}});
}

TEST(OptionTable, HasAWordForEachRowOfTheOtherTables) {
  EXPECT_EQ(OptionWords<AlgorithmKind>::kAll.size(), detail::algorithm_table().size());
  EXPECT_EQ(OptionWords<Start>::kAll.size(), detail::start_table().size());
  EXPECT_EQ(OptionWords<LinearSolverKind>::kAll.size(), detail::linear_solver_table().size());
  EXPECT_EQ(to_string(AlgorithmKind::kDogleg), "dogleg");
  EXPECT_EQ(to_string(Start::kSpanningTree), "spanning-tree");
  EXPECT_EQ(to_string(static_cast<Start>(9)), "unknown");
}

/// The message of check_options(), or an empty text.
std::string complaint_on(const Options& options) {
  try {
    detail::check_options(options);
    return {};
  } catch (const InvalidArgument& error) {
    return error.what();
  }
}

TEST(CheckOptions, AcceptsTheDefaultsAndRefusesEachValueOutOfItsRange) {
  EXPECT_EQ(complaint_on({}), "");
  for_each_option([]<class T>(const Option<T>& option) {
    Options options;
    if constexpr (std::is_enum_v<T>) {
      options.*option.member = static_cast<T>(OptionWords<T>::kAll.size());
      EXPECT_EQ(complaint_on(options), "Options: expected one of the values of " +
                                           std::string(OptionWords<T>::kName) + ", got " +
                                           std::to_string(OptionWords<T>::kAll.size()));
    } else if constexpr (std::is_same_v<T, double>) {
      options.*option.member = std::numeric_limits<double>::quiet_NaN();
      EXPECT_NE(complaint_on(options), "") << option.name;
    }
    if constexpr (std::is_same_v<T, double> || std::is_same_v<T, int>) {
      options.*option.member = -1;
      EXPECT_EQ(complaint_on(options).empty(), option.range == OptionRange::kAny) << option.name;
    }
  });
  EXPECT_EQ(complaint_on({.initial_lambda = std::numeric_limits<double>::infinity()}),
            "Options: expected a finite initial_lambda ≥ 0");
  EXPECT_EQ(complaint_on({.linear_tolerance = 1}), "Options: expected 0 ≤ linear_tolerance < 1");
}

template <class T>
std::string values_of(const Option<T>& option) {
  if constexpr (std::is_enum_v<T>) {
    std::string words;
    for (const std::string_view word : OptionWords<T>::kAll)
      words += (words.empty() ? "" : ", ") + std::string(word);
    return words;
  } else if constexpr (std::is_same_v<T, bool>) {
    return "true, false";
  } else {
    const char* const ranges[] = {"any", "≥ 0", "finite, ≥ 0", "≥ 0, < 1"};
    return std::string(std::is_integral_v<T> ? "whole number, " : "number, ") +
           ranges[static_cast<std::size_t>(option.range)];
  }
}

template <class T>
std::string default_of(const Option<T>& option) {
  std::ostringstream text;
  const T value = Options().*option.member;
  if constexpr (std::is_enum_v<T>) {
    text << detail::word_of(value);
  } else {
    text << std::boolalpha << value;
  }
  return text.str();
}

std::string page() {
  std::ostringstream text;
  text
      << "# The options of a run\n\n"
         "Each is a member of `Options` in C++ (`boxplus/options/options.h`, which says more), a keyword of\n"
         "`optimize()` in Python, and, if the second column has a name, an option of `boxplus optimize` and "
         "a\n"
         "setting of the viewer. This page follows from the table `boxplus/options/option_table.h`; the "
         "test\n"
         "`options_test` writes it if the variable `BOXPLUS_WRITE_PAGES` is set.\n\n"
         "| Option | Command | Values | Default | |\n|---|---|---|---|---|\n";
  for_each_option([&](const auto& option) {
    text << "| `" << option.name << "` | "
         << (option.setting.empty() ? "" : "`--" + std::string(option.setting) + "`") << " | "
         << values_of(option) << " | " << default_of(option) << " | " << option.help << " |\n";
  });
  return text.str();
}

TEST(OptionTable, IsThePageInTheDocuments) {
  if (std::getenv("BOXPLUS_WRITE_PAGES") != nullptr) std::ofstream(BOXPLUS_OPTIONS_PAGE) << page();
  std::ostringstream text;
  text << std::ifstream(BOXPLUS_OPTIONS_PAGE).rdbuf();
  EXPECT_EQ(text.str(), page()) << "run options_test with BOXPLUS_WRITE_PAGES=1";
}

}  // namespace
}  // namespace boxplus
