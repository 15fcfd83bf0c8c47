// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/io/text_source.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <filesystem>

#include "boxplus/io/graph_file.h"
#include "boxplus/io/write_file.h"

namespace boxplus {
namespace {

/// The text of all blocks, one after the other.
std::string joined(const TextSource& source) {
  std::string all, memory;
  for (std::size_t k = 0; k < source.block_count(); ++k) {
    const std::string_view lines = source.block(k, memory);
    EXPECT_TRUE(lines.empty() || lines.back() == '\n' || all.size() + lines.size() > 0);
    all += lines;
  }
  return all;
}

RC_GTEST_PROP(TextSource, ContainsEveryLineOnce, ()) {
  const auto lines = *rc::gen::container<std::vector<std::string>>(
      rc::gen::container<std::string>(rc::gen::element('a', 'b', ' ')));
  std::string text;
  for (const std::string& line : lines) text += line + '\n';
  if (*rc::gen::arbitrary<bool>() && !text.empty()) text.pop_back();
  const auto block_size = *rc::gen::inRange<std::size_t>(1, 40);
  RC_ASSERT(joined(TextSource(text, "g", block_size)) == text);

  const std::string path = testing::TempDir() + "text_source_test.txt";
  write_file(path, text);
  const TextSource file = TextSource::of_file(path, block_size);
  RC_ASSERT(joined(file) == text);
  std::string memory;
  RC_ASSERT(file.text(memory) == text);
  std::filesystem::remove(path);
}

TEST(TextSource, BeginsEachBlockAtTheStartOfALine) {
  std::string memory;
  const TextSource source("one\ntwo\nthree\n", "g", 4);
  ASSERT_EQ(source.block_count(), 4u);
  EXPECT_EQ(source.block(0, memory), "one\n");
  EXPECT_EQ(source.block(1, memory), "two\n");
  EXPECT_EQ(source.block(2, memory), "three\n");
  EXPECT_EQ(source.block(3, memory), "");
}

TEST(TextSource, ReadsDevicesAndFilesOfUnknownSize) {
  EXPECT_EQ(joined(TextSource::of_file("/dev/null")), "");
  EXPECT_NE(joined(TextSource::of_file("/proc/self/status")), "");
}

}  // namespace
}  // namespace boxplus
