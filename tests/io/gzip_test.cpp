// SPDX-License-Identifier: BSD-3-Clause
#include "io/gzip.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "boxplus/base/error.h"
#include "boxplus/boxplus.h"
#include "boxplus/io/text_source.h"
#include "boxplus/io/write_file.h"
#include "io/packed.h"

namespace boxplus {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

std::string unpacked(std::string_view bytes, std::size_t piece) {
  std::string text;
  const auto next = [&] {
    const std::string_view part = bytes.substr(0, piece);
    bytes.remove_prefix(part.size());
    return part;
  };
  unpack_gzip("g.gz", next, [&](std::string_view part) { text += part; });
  return text;
}

/// A text that does not compress well.
std::string varied(std::size_t size) {
  std::string text;
  for (std::uint32_t state = 1; text.size() < size; state = state * 1664525u + 1013904223u)
    text += std::to_string(state);
  return text;
}

class InTemporaryFolder : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::string path(const char* name) const { return (folder_ / name).string(); }

  const std::filesystem::path folder_ = std::filesystem::temp_directory_path() / "boxplus_gzip_test";
};

TEST(Gzip, UnpacksWhatItPacked) {
  for (const std::string& text :
       {std::string(), std::string("x"), std::string(3'000'000, 'a'), varied(1'000'000)}) {
    const std::string bytes = packed(text);
    EXPECT_TRUE(begins_as_gzip(bytes));
    for (const std::size_t piece : {std::size_t{1000}, bytes.size()})
      EXPECT_TRUE(unpacked(bytes, piece) == text);
  }
  EXPECT_LT(packed(std::string(3'000'000, 'a')).size(), 5'000u);
}

TEST(Gzip, ReadsFilesOfSeveralMembers) {
  const std::string bytes = packed("one\n") + packed("") + packed("two\n");
  for (std::size_t piece = 1; piece <= bytes.size(); ++piece) EXPECT_EQ(unpacked(bytes, piece), "one\ntwo\n");
}

TEST(Gzip, RefusesDamagedAndTruncatedFiles) {
  const std::string bytes = packed("VERTEX_SE2 0 0 0 0\n");
  for (std::size_t size = 1; size < bytes.size(); ++size)
    EXPECT_THAT([&] { unpacked(bytes.substr(0, size), 10); },
                ThrowsMessage<FileError>("g.gz: cannot be unpacked: the file ends early"));
  std::string damaged = bytes;
  damaged[damaged.size() - 6] ^= 1;  // the checksum
  EXPECT_THAT([&] { unpacked(damaged, 1000); }, ThrowsMessage<FileError>(HasSubstr("damaged data")));
  EXPECT_THAT([&] { unpacked(bytes + "garbage", 1000); },
              ThrowsMessage<FileError>(HasSubstr("damaged data")));
}

TEST_F(InTemporaryFolder, GraphsArePackedByNameInEveryTextFormat) {
  const GraphFile file =
      parse_graph("VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 1 0 0\nEDGE_SE2 0 1 1 0 0 1 0 0 1 0 1\n", "g");
  for (const auto& [name, format] : {std::pair{"a.g2o.gz", "g2o"}, {"a.json.gz", "json"}, {"a.gz", "g2o"}}) {
    write_graph(path(name), file);
    std::ifstream stream(path(name), std::ios::binary);
    EXPECT_TRUE(begins_as_gzip(std::string(std::istreambuf_iterator<char>(stream), {}))) << name;
    const GraphFile again = read_graph(path(name));
    EXPECT_EQ(again.format, format);
    EXPECT_EQ(format_graph(again, {.format = "g2o"}), format_graph(file));
  }
  write_file(path("b.txt"), packed("VERTEX_SE2 0 0 zero 0\n"));
  EXPECT_THAT([&] { read_graph(path("b.txt")); },
              ThrowsMessage<InputError>(HasSubstr("b.txt:1:16: expected")));
}

TEST_F(InTemporaryFolder, ALongTextIsReadFromATemporaryFile) {
  constexpr std::size_t kSize = std::size_t{70} << 20;  // longer than what stays in memory
  std::string text(kSize, '\n');
  text.replace(kSize - 20, 4, "last");
  write_file(path("long.gz"), packed(text));
  const TextSource source = TextSource::of_file(path("long.gz"));
  ASSERT_EQ(source.size(), kSize);
  std::string memory;
  EXPECT_EQ(source.bytes(kSize - 20, 100, memory), text.substr(kSize - 20));
  EXPECT_EQ(source.bytes(0, 10, memory), text.substr(0, 10));
}

}  // namespace
}  // namespace boxplus
