// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/server/command.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "boxplus/base/error.h"

namespace boxplus::viewer {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;
using testing::ThrowsMessage;

TEST(ParseCommand, ReadsWhatItsKindNeeds) {
  const Command run = parse_command(R"({"type": "optimize", "settings": {"algorithm": "dogleg"}})");
  EXPECT_EQ(run.kind, Command::Kind::kOptimize);
  EXPECT_THAT(run.settings, ElementsAre(Pair("algorithm", "dogleg")));
  EXPECT_EQ(parse_command(R"({"type": "guess", "start": "odometry"})").start, "odometry");
  EXPECT_EQ(parse_command(R"({"type": "stop"})").kind, Command::Kind::kStop);
  const Command edit =
      parse_command(R"({"type": "edit", "edit": "scale", "factor": "0.5", "structure": "3", "line": "7"})");
  EXPECT_EQ(edit.structure, 3U);
  EXPECT_EQ(edit.edit.kind, Edit::Kind::kScale);
  EXPECT_EQ(edit.edit.element.kind, ElementName::Kind::kLine);
  EXPECT_EQ(edit.edit.element.number, 7U);
  EXPECT_EQ(edit.edit.factor, 0.5);
}

TEST(ParseCommand, SaysWhatIsWrong) {
  const auto expect = [](const char* text, const char* message) {
    EXPECT_THAT([&] { parse_command(text); }, ThrowsMessage<InvalidArgument>(HasSubstr(message))) << text;
  };
  expect("", "expected a command as a JSON object");
  expect("[1]", "expected a command as a JSON object");
  expect(R"({"type": 1})", "expected a command with a \"type\"");
  expect(R"({"type": "dance"})", "type: expected one of optimize, step");
  expect(R"({"type": "optimize", "settings": [1]})", "settings: expected an object");
  expect(R"({"type": "step", "settings": {"lambda": 3}})", "lambda: expected a text");
  expect(R"({"type": "guess"})", "expected the name of an initial guess");
  expect(R"({"type": "edit", "edit": "explode", "structure": "1", "line": "0"})",
         "edit: expected one of fix, free");
  expect(R"({"type": "edit", "edit": "scale", "structure": "1", "line": "0"})", "factor: expected a number");
  expect(R"({"type": "edit", "edit": "fix", "line": "0"})", "expected the number of the structure");
}

TEST(ParseCommand, RefusesDeepNestingWithoutDeepRecursion) {
  const std::string deep = R"({"type": )" + std::string(50'000, '[');
  EXPECT_THROW(parse_command(deep), InvalidArgument);
}

}  // namespace
}  // namespace boxplus::viewer
