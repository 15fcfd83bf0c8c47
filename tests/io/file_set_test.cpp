// SPDX-License-Identifier: BSD-3-Clause
#include "io/file_set.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <stdexcept>
#include <vector>

#include "boxplus/base/error.h"
#include "io/colmap/model_folder.h"

namespace boxplus {
namespace {

NewFile new_file(const std::string& path, const std::string& text) {
  return {path, [text](TextSink sink) { sink(text); }};
}

std::size_t file_count(const TestFolder& folder) {
  const std::filesystem::directory_iterator files(folder.path());
  return static_cast<std::size_t>(std::distance(begin(files), end(files)));
}

TEST(FileSet, ReplacesAndCreatesFilesAndLeavesNoOtherFile) {
  const TestFolder folder("set");
  folder.write("a", "old");
  const std::vector<NewFile> files{new_file(folder.file("a"), "new a"), new_file(folder.file("b"), "new b")};
  replace_together(folder.path(), files);
  EXPECT_EQ(folder.content("a"), "new a");
  EXPECT_EQ(folder.content("b"), "new b");
  EXPECT_EQ(file_count(folder), 2u);
}

TEST(FileSet, KeepsThePermissionsAndTheLinksOfTheOldFiles) {
  const TestFolder folder("set");
  folder.write("target", "old");
  ::chmod(folder.file("target").c_str(), 0640);
  std::filesystem::create_symlink("target", folder.file("link"));
  replace_together(folder.path(), std::vector{new_file(folder.file("link"), "new")});
  EXPECT_TRUE(std::filesystem::is_symlink(folder.file("link")));
  EXPECT_EQ(folder.content("target"), "new");
  EXPECT_EQ(std::filesystem::status(folder.file("target")).permissions(), std::filesystem::perms{0640});
}

TEST(FileSet, ChangesNothingIfAFileCannotBeMade) {
  const TestFolder folder("set");
  folder.write("a", "old");
  const std::vector<NewFile> files{
      new_file(folder.file("a"), "new"),
      {folder.file("b"), [](TextSink /*sink*/) { throw std::runtime_error("no text"); }}};
  EXPECT_THROW(replace_together(folder.path(), files), std::runtime_error);
  EXPECT_EQ(folder.content("a"), "old");
  EXPECT_EQ(file_count(folder), 1u);
}

TEST(FileSet, PutsTheOldFilesBackIfALaterOneCannotBeReplaced) {
  const TestFolder folder("set");
  folder.write("a", "old");
  const std::vector<NewFile> files{
      new_file(folder.file("a"), "new"),
      new_file(folder.file("b"), "new"),
      {folder.file("c"), [&](TextSink /*sink*/) { std::filesystem::create_directory(folder.file("c")); }}};
  EXPECT_THROW(replace_together(folder.path(), files), FileError);
  EXPECT_EQ(folder.content("a"), "old");
  EXPECT_TRUE(std::filesystem::is_directory(folder.file("c")));
  EXPECT_EQ(file_count(folder), 2u);
}

TEST(FileSet, IsNotOpenedUntilAnInterruptedReplacementIsRepeated) {
  const TestFolder folder("set");
  folder.write(kUnfinished, "");
  bool is_open = false;
  const auto open = [&] { is_open = true; };
  EXPECT_THROW(open_together(folder.path(), open), FileError);
  EXPECT_FALSE(is_open);

  // A failure does not hide that the files are a mixture.
  const NewFile impossible{folder.file("c"),
                           [&](TextSink /*sink*/) { std::filesystem::create_directory(folder.file("c")); }};
  EXPECT_THROW(replace_together(folder.path(), std::vector{impossible}), FileError);
  EXPECT_THROW(open_together(folder.path(), open), FileError);

  replace_together(folder.path(), std::vector{new_file(folder.file("a"), "new")});
  open_together(folder.path(), open);
  EXPECT_TRUE(is_open);
}

}  // namespace
}  // namespace boxplus
