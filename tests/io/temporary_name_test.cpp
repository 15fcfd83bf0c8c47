// SPDX-License-Identifier: BSD-3-Clause
#include "io/temporary_name.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "boxplus/io/graph_file.h"
#include "boxplus/io/write_file.h"

namespace boxplus {
namespace {

std::string new_file() {
  std::string path =
      testing::TempDir() + "boxplus_" + testing::UnitTest::GetInstance()->current_test_info()->name();
  std::ofstream(path) << "text";
  return path;
}

TEST(TemporaryName, RemovesItsFileUnlessItIsReleased) {
  const std::string path = new_file();
  {
    TemporaryName name;
    name.assign(path);
  }
  EXPECT_FALSE(std::filesystem::exists(path));
  new_file();
  {
    TemporaryName name;
    name.assign(path);
    name.release();
  }
  EXPECT_TRUE(std::filesystem::remove(path));
}

TEST(TemporaryName, LetsSignalHandlersRemoveItsFile) {
  TemporaryName name;
  const std::string path = new_file();
  name.assign(path);
  remove_temporary_files();
  EXPECT_FALSE(std::filesystem::exists(path));
}

}  // namespace
}  // namespace boxplus
