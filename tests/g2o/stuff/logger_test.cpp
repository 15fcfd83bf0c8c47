// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/stuff/logger.h"

#include <gtest/gtest.h>

namespace {

TEST(Logger, WritesErrorsToStderrUntilASinkIsSet) {
  testing::internal::CaptureStderr();
  G2O_ERROR("vertex {} is missing", 3);
  G2O_WARN("dropped");
  G2O_TRACE("dropped");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "g2o: vertex 3 is missing\n");

  std::string messages;
  g2o::logging::setSink([&](g2o::logging::Level, const std::string& text) { messages += text + "|"; });
  testing::internal::CaptureStderr();
  G2O_ERROR("one");
  G2O_WARN("two");
  G2O_TRACE("dropped");
  EXPECT_EQ(messages, "one|two|");
  g2o::logging::setSink({});
  G2O_ERROR("dropped");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
