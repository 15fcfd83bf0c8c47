// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/stuff/filesys_tools.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <regex>

namespace {

using testing::ElementsAre;

TEST(FilesysTools, SplitAndJoinFileNames) {
  EXPECT_EQ(g2o::getFileExtension("/a.b/c.tar.gz"), "gz");
  EXPECT_EQ(g2o::getFileExtension("/a.b/c"), "");
  EXPECT_EQ(g2o::getPureFilename("/a.b/c.tar.gz"), "/a.b/c.tar");
  EXPECT_EQ(g2o::getPureFilename("/a.b/c"), "/a.b/c");
  EXPECT_EQ(g2o::getBasename("/a.b/c.gz"), "c.gz");
  EXPECT_EQ(g2o::getDirname("/a.b/c.gz"), "/a.b");
  EXPECT_EQ(g2o::getDirname("c.gz"), "");
  EXPECT_EQ(g2o::changeFileExtension("a.g2o", "graph"), "a.graph");
  EXPECT_EQ(g2o::changeFileExtension("a.g2o", ".graph", true), "a.graph");
  EXPECT_EQ(g2o::changeFileExtension("a", "graph"), "a");
  EXPECT_EQ(g2o::changeFileExtension("test.txt", ".dat"), "test.dat");
}

TEST(FilesysTools, FindFilesByPattern) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "g2o_files";
  std::filesystem::create_directories(folder);
  for (const char* name : {"b.g2o", "a.g2o", "c.txt"}) std::ofstream(folder / name) << "text";
  EXPECT_TRUE(g2o::fileExists((folder / "a.g2o").c_str(), true));
  EXPECT_TRUE(g2o::fileExists(folder.c_str()));
  EXPECT_FALSE(g2o::fileExists(folder.c_str(), true));
  EXPECT_FALSE(g2o::fileExists((folder / "d").c_str()));
  EXPECT_THAT(g2o::getFilesByPattern((folder / "*.g2o").c_str()),
              ElementsAre((folder / "a.g2o").string(), (folder / "b.g2o").string()));
  EXPECT_THAT(g2o::getFilesByPattern((folder / "none*").c_str()), ElementsAre());
  EXPECT_THAT(g2o::getFilesByPattern(folder.string(), std::regex(".*\\.g2o")),
              ElementsAre((folder / "a.g2o").string(), (folder / "b.g2o").string()));
  EXPECT_THAT(g2o::getFilesByPattern(std::string_view(folder.c_str()), std::regex("c")), ElementsAre());
  std::filesystem::remove_all(folder);
}

}  // namespace
