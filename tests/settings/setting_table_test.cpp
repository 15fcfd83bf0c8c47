// SPDX-License-Identifier: BSD-3-Clause
#include "settings/setting_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "boxplus/base/error.h"
#include "boxplus/outliers/outliers.h"

namespace boxplus {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::ThrowsMessage;

const Setting& setting(std::string_view name) {
  const auto table = setting_table();
  return *std::find_if(table.begin(), table.end(), [&](const Setting& entry) { return entry.name == name; });
}

TEST(SettingTable, AcceptsItsOwnWordsAndDefaults) {
  for (const Setting& entry : setting_table()) {
    RunSettings settings;
    if (!entry.default_text.empty()) {
      EXPECT_NO_THROW(entry.set(settings, entry.default_text)) << entry.name;
    }
    if (entry.kind != Setting::Kind::kChoice) continue;
    for (const std::string& word : entry.words) EXPECT_NO_THROW(entry.set(settings, word)) << entry.name;
  }
}

TEST(SettingTable, HasTheDefaultsOfARun) {
  RunSettings settings, defaults;
  for (const Setting& entry : setting_table()) {
    if (!entry.default_text.empty()) entry.set(settings, entry.default_text);
  }
  EXPECT_EQ(settings.options.start, defaults.options.start);
  EXPECT_EQ(settings.options.algorithm, defaults.options.algorithm);
  EXPECT_EQ(settings.options.linear_solver, defaults.options.linear_solver);
  EXPECT_EQ(settings.options.max_iterations, defaults.options.max_iterations);
  EXPECT_EQ(settings.options.cost_tolerance, defaults.options.cost_tolerance);
  EXPECT_EQ(settings.options.step_tolerance, defaults.options.step_tolerance);
  EXPECT_EQ(settings.options.gradient_tolerance, defaults.options.gradient_tolerance);
}

TEST(SettingTable, ChoosesTheEdgesThatMayBeFalse) {
  EXPECT_EQ(run_settings({{"outliers", "all"}}).suspects, Suspects::kAll);
  EXPECT_EQ(run_settings({{"outliers", "loop-closures"}}).suspects, Suspects::kLoopClosures);
  EXPECT_EQ(run_settings({{"outliers", "none"}}).suspects, std::nullopt);
}

TEST(SettingTable, RefusesValuesWithAReason) {
  RunSettings settings;
  const auto refusal = [&](const char* name, const char* text) {
    return [&settings, name, text] { setting(name).set(settings, text); };
  };
  EXPECT_THAT(refusal("algorithm", "magic"),
              ThrowsMessage<InvalidArgument>(HasSubstr("expected one of automatic")));
  EXPECT_THAT(refusal("iterations", "-1"),
              ThrowsMessage<InvalidArgument>(HasSubstr("expected a whole number ≥ 0")));
  EXPECT_THAT(refusal("lambda", "0"), ThrowsMessage<InvalidArgument>(HasSubstr("expected a number > 0")));
  EXPECT_THAT(refusal("time-limit", "nan"),
              ThrowsMessage<InvalidArgument>(HasSubstr("expected a number ≥ 0")));
  EXPECT_THROW(refusal("kernel", "Nobody")(), InvalidArgument);
}

TEST(SettingTable, KnowsChoicesThatDoNotSuitAGraph) {
  Graph graph;
  graph.add_edge([](double x) { return x - 1; }, graph.add_vertex(2.0));
  EXPECT_THAT(why_unsuitable(graph, setting("start"), "odometry"), HasSubstr("relative pose"));
  EXPECT_THAT(why_unsuitable(graph, setting("start"), "automatic"), IsEmpty());
  EXPECT_THAT(why_unsuitable(graph, setting("kernel-on"), "loop-closures"), HasSubstr("no loop closures"));
  EXPECT_THAT(why_unsuitable(graph, setting("solver"), "dense"), IsEmpty());
}

}  // namespace
}  // namespace boxplus
