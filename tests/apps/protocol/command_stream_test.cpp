// SPDX-License-Identifier: BSD-3-Clause
#include "protocol/command_stream.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "boxplus/base/error.h"

namespace boxplus::app {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<std::string> commands_of(std::string_view text, std::size_t piece) {
  CommandStream stream("input");
  std::vector<std::string> commands;
  for (; !text.empty(); text.remove_prefix(std::min(piece, text.size()))) {
    std::string_view received = text.substr(0, piece);
    while (const auto command = stream.next(received)) commands.push_back(command->text);
  }
  stream.finish();
  return commands;
}

TEST(CommandStream, CommandsEndAtSemicolonsInPiecesOfAnySize) {
  for (const std::size_t piece : {1, 2, 3, 100}) {
    EXPECT_THAT(commands_of("A 1;B\n2 3;;\n ; C;", piece), ElementsAre("A 1", "B 2 3", "C"));
  }
}

TEST(CommandStream, ACommentEndsWithItsLineAndMayHaveSemicolons) {
  EXPECT_THAT(commands_of("# a; b\nA # c;\n 1#2; # d", 1), ElementsAre("A   1#2"));
}

TEST(CommandStream, EveryCharacterOfACommandHasItsPlaceInTheStream) {
  CommandStream stream("input");
  std::string_view text = "\n  ADD # comment\n\n   X 1;";
  const auto command = stream.next(text);
  ASSERT_TRUE(command);
  const auto place = [&](char c) {
    const auto [line, column] = command->place_of(command->text.find(c));
    return std::pair(line, column);
  };
  EXPECT_EQ(place('A'), std::pair(std::int64_t{2}, std::int64_t{3}));
  EXPECT_EQ(place('X'), std::pair(std::int64_t{4}, std::int64_t{4}));
  EXPECT_EQ(place('1'), std::pair(std::int64_t{4}, std::int64_t{6}));
  const auto [line, column] = command->place_of(command->text.size());  // the semicolon
  EXPECT_EQ(std::pair(line, column), std::pair(std::int64_t{4}, std::int64_t{7}));
}

TEST(CommandStream, TheEndOfTheInputWithinACommandIsAnError) {
  try {
    commands_of("A;\nB 1", 2);
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "input:2:4: expected a ; after the command, got the end of the input");
  }
}

TEST(CommandStream, ACommandHasALargestSize) {
  CommandStream stream("input");
  const std::string longest(CommandStream::kMaxBytes, 'x');
  std::string_view text = longest;
  EXPECT_FALSE(stream.next(text));
  std::string_view more = "x";
  try {
    stream.next(more);
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("input:1:1: expected a command of at most 1048576 bytes"));
  }
}

}  // namespace
}  // namespace boxplus::app
