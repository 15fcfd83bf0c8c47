// SPDX-License-Identifier: BSD-3-Clause
#include "io/text_file.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "boxplus/base/error.h"
#include "boxplus/io/graph_file.h"
#include "boxplus/io/write_file.h"

namespace boxplus {
namespace {

TEST(WriteFile, FollowsALinkToAFileThatDoesNotExistYet) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "boxplus_link_test";
  std::filesystem::create_directory(folder);
  std::filesystem::create_symlink("gone.g2o", folder / "link.g2o");
  write_file((folder / "link.g2o").string(), "text");
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.g2o"));
  EXPECT_TRUE(std::filesystem::is_regular_file(folder / "gone.g2o"));
  std::filesystem::remove_all(folder);
}

TEST(WriteFile, ThrowsAndChangesNothingIfThePathCannotBeWritten) {
  EXPECT_THROW(write_file("/nowhere/graph.g2o", "text"), FileError);
  const std::string folder = std::string(testing::TempDir()) + "boxplus_text_file_test";
  std::filesystem::create_directory(folder);
  EXPECT_THROW(write_file(folder, "text"), FileError);
  EXPECT_TRUE(std::filesystem::is_directory(folder));
  std::filesystem::remove(folder);
}

}  // namespace
}  // namespace boxplus
