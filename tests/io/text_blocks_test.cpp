// SPDX-License-Identifier: BSD-3-Clause
#include "io/text_blocks.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <filesystem>

#include "boxplus/io/graph_file.h"

namespace boxplus {
namespace {

/// All blocks, one after the other.
std::string joined(const TextBlocks& blocks) {
  std::string all, memory;
  for (std::size_t k = 0; k < blocks.count(); ++k) {
    const std::string_view lines = blocks.read(k, memory);
    EXPECT_TRUE(lines.empty() || lines.back() == '\n' || all.size() + lines.size() > 0);
    all += lines;
  }
  return all;
}

RC_GTEST_PROP(TextBlocks, HoldEveryLineOnce, ()) {
  const auto lines = *rc::gen::container<std::vector<std::string>>(
      rc::gen::container<std::string>(rc::gen::element('a', 'b', ' ')));
  std::string text;
  for (const std::string& line : lines) text += line + '\n';
  if (*rc::gen::arbitrary<bool>() && !text.empty()) text.pop_back();
  const auto block_size = *rc::gen::inRange<std::size_t>(1, 40);
  RC_ASSERT(joined(TextBlocks(text, block_size)) == text);

  const std::string path = testing::TempDir() + "text_blocks_test.txt";
  write_file(path, text);
  RC_ASSERT(joined(TextBlocks::of_file(path, block_size)) == text);
  std::filesystem::remove(path);
}

TEST(TextBlocks, BeginEachBlockWithALine) {
  std::string memory;
  const TextBlocks blocks("one\ntwo\nthree\n", 4);
  ASSERT_EQ(blocks.count(), 4u);
  EXPECT_EQ(blocks.read(0, memory), "one\n");
  EXPECT_EQ(blocks.read(1, memory), "two\n");
  EXPECT_EQ(blocks.read(2, memory), "three\n");
  EXPECT_EQ(blocks.read(3, memory), "");
}

TEST(TextBlocks, ReadWhatIsNoRegularFile) {
  EXPECT_EQ(joined(TextBlocks::of_file("/dev/null")), "");
  EXPECT_NE(joined(TextBlocks::of_file("/proc/self/status")), "");
}

}  // namespace
}  // namespace boxplus
