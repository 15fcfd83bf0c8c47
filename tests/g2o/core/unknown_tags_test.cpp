// SPDX-License-Identifier: BSD-3-Clause
// What load() says about tags that the Factory does not know. This program links the types of slam2d, but not
// those of slam3d.
#include <gmock/gmock.h>

#include <sstream>
#include <string>
#include <vector>

#include "g2o/core/factory.h"
#include "g2o/core/sparse_optimizer.h"
#include "g2o/stuff/logger.h"
#include "sanitized.h"

G2O_USE_TYPE_GROUP(slam2d);

namespace {

using testing::ElementsAre;

constexpr const char* kTwoPosesInSpace =
    "VERTEX_SE3:QUAT 0 0 0 0 0 0 0 1\n"
    "VERTEX_SE3:QUAT 1 1 0 0 0 0 0 1\n"
    "EDGE_SE3:QUAT 0 1 1 0 0 0 0 0 1 1 0 0 0 0 0 1 0 0 0 0 1 0 0 0 1 0 0 1 0 1\n";

/// Loads a text whose tags are unknown, and returns the errors.
std::vector<std::string> errors_of(const std::string& text) {
  std::vector<std::string> errors;
  g2o::logging::setSink([&](g2o::logging::Level level, const std::string& said) {
    if (level == g2o::logging::Level::kError) errors.push_back(said);
  });
  g2o::SparseOptimizer optimizer;
  std::istringstream file(text);
  EXPECT_TRUE(optimizer.load(file));
  EXPECT_TRUE(optimizer.vertices().empty());
  g2o::logging::setSink({});
  return errors;
}

TEST(UnknownTags, AreReportedOncePerTagWithTheNumberOfLinesAndTheLibrary) {
  EXPECT_THAT(errors_of(kTwoPosesInSpace),
              ElementsAre("line 1: unknown tag 'VERTEX_SE3:QUAT', 2 lines are skipped; link "
                          "libg2o_types_slam3d and use G2O_USE_TYPE_GROUP(slam3d)",
                          "line 3: unknown tag 'EDGE_SE3:QUAT', 1 line is skipped; link libg2o_types_slam3d "
                          "and use G2O_USE_TYPE_GROUP(slam3d)"));
  EXPECT_THAT(errors_of("VERTEX_SE3:EXPMAP\nVERTEX_CAM\n"),
              ElementsAre(testing::HasSubstr("libg2o_types_sba and use G2O_USE_TYPE_GROUP(expmap)"),
                          testing::HasSubstr("libg2o_types_sba and use G2O_USE_TYPE_GROUP(sba)")));
}

TEST(UnknownTags, OfNoLibraryAreQuotedAndCounted) {
  EXPECT_THAT(errors_of("A 1\nB\x7f 1\nA 2\nA 3\n"),
              ElementsAre("line 1: unknown tag 'A', 3 lines are skipped",
                          "line 2: unknown tag 'B\\x7f', 1 line is skipped"));
}

TEST(UnknownTags, OfNoLibraryAreNotNamedAfterTheFirstFive) {
  EXPECT_THAT(
      errors_of("A\nB\nC\nD\nE\nF\nG\nF\nVERTEX_SE3:QUAT\n"),
      ElementsAre(testing::HasSubstr("'A'"), testing::HasSubstr("'B'"), testing::HasSubstr("'C'"),
                  testing::HasSubstr("'D'"), testing::HasSubstr("'E'"),
                  testing::HasSubstr("'VERTEX_SE3:QUAT'"), "2 other unknown tags, 3 lines are skipped"));
}

TEST(UnknownTags, AreReportedOnStderrByDefault) {
  if (boxplus::is_emulated()) GTEST_SKIP() << "an emulated program cannot start itself again";
  testing::FLAGS_gtest_death_test_style = "threadsafe";  // in a new process, which has set no sink
  const auto load = [] {
    g2o::SparseOptimizer optimizer;
    std::istringstream file(kTwoPosesInSpace);
    _exit(optimizer.load(file) ? 0 : 1);
  };
  EXPECT_EXIT(load(), testing::ExitedWithCode(0), "g2o: line 1: unknown tag 'VERTEX_SE3:QUAT', 2 lines");
}

}  // namespace
