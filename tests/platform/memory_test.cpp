// SPDX-License-Identifier: BSD-3-Clause
#include "platform/memory.h"

#include <gtest/gtest.h>

#include <fstream>

namespace boxplus {
namespace {

/// A folder that represents the root folder of a machine.
class PhysicalMemory : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::remove_all(root_); }
  void TearDown() override { std::filesystem::remove_all(root_); }

  void write(const std::string& path, const std::string& text) {
    std::filesystem::create_directories((root_ / path).parent_path());
    std::ofstream(root_ / path) << text;
  }

  const std::filesystem::path root_ =
      std::filesystem::path(testing::TempDir()) /
      (std::string("boxplus_") + testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(PhysicalMemory, IsTheMemoryOfTheMachineIfNoControlGroupLimitsIt) {
  const std::uint64_t machine = physical_memory(root_);
  EXPECT_GT(machine, 1u << 20);
  write("proc/self/cgroup", "0::/user.slice\n");
  write("sys/fs/cgroup/user.slice/memory.max", "max\n");
  EXPECT_EQ(physical_memory(root_), machine);
  write("proc/self/cgroup", "4:cpu,memory:/\n");
  write("sys/fs/cgroup/memory/memory.limit_in_bytes", "9223372036854771712\n");
  EXPECT_EQ(physical_memory(root_), machine);
}

TEST_F(PhysicalMemory, IsTheLimitOfTheContainer) {
  write("proc/self/cgroup", "0::/\n");
  write("sys/fs/cgroup/memory.max", "1048576\n");
  EXPECT_EQ(physical_memory(root_), 1048576u);
}

TEST_F(PhysicalMemory, IsTheSmallestLimitOfTheGroupAndItsParents) {
  write("proc/self/cgroup", "0::/a/b/c\n");
  write("sys/fs/cgroup/a/b/c/memory.max", "max\n");
  write("sys/fs/cgroup/a/b/memory.max", "3000000\n");
  write("sys/fs/cgroup/a/memory.max", "2000000\n");
  EXPECT_EQ(physical_memory(root_), 2000000u);
}

TEST_F(PhysicalMemory, IsLimitedByControlGroupsOfVersionOneToo) {
  write("proc/self/cgroup", "5:cpu:/x\n4:hugetlb,memory:/docker/0123\n0::/\n");
  write("sys/fs/cgroup/memory/memory.limit_in_bytes", "1000000\n");  // the path inside a container
  EXPECT_EQ(physical_memory(root_), 1000000u);
  write("sys/fs/cgroup/memory/docker/0123/memory.limit_in_bytes", "500000\n");  // the path outside of it
  EXPECT_EQ(physical_memory(root_), 500000u);
}

}  // namespace
}  // namespace boxplus
