// SPDX-License-Identifier: BSD-3-Clause
#include "platform/memory.h"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <limits>
#include <string>

namespace boxplus {
namespace {

constexpr std::uint64_t kUnlimited = std::numeric_limits<std::uint64_t>::max();

std::uint64_t memory_of_machine() {
  const long pages = sysconf(_SC_PHYS_PAGES), page = sysconf(_SC_PAGESIZE);
  if (pages <= 0 || page <= 0) return 0;
  return static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(page);
}

/// The lowest limit of a control group ("/a/b") and of its parents. A group counts as unlimited if its value
/// is "max", or if this process cannot see the group. (A process in a container cannot see the groups outside
/// of the container.)
std::uint64_t limit_of_group(const std::filesystem::path& mount, std::string group, const char* file) {
  std::uint64_t least = kUnlimited;
  for (;;) {
    std::uint64_t limit = 0;
    if (std::ifstream(mount.string() + group + "/" + file) >> limit) least = std::min(least, limit);
    if (group.empty()) return least;
    group.resize(std::min(group.rfind('/'), group.size() - 1));
  }
}

/// The lowest limit of all control groups of this process. The lines of /proc/self/cgroup have the form
/// NUMBER:CONTROLLERS:GROUP. A line without controllers belongs to version 2 of control groups.
std::uint64_t limit_of_groups(const std::filesystem::path& root) {
  const std::filesystem::path mount = root / "sys/fs/cgroup";
  std::uint64_t least = kUnlimited;
  std::ifstream lines(root / "proc/self/cgroup");
  for (std::string number, controllers, group; std::getline(lines, number, ':') &&
                                               std::getline(lines, controllers, ':') &&
                                               std::getline(lines, group);) {
    if (controllers.empty()) {
      least = std::min(least, limit_of_group(mount, group, "memory.max"));
    } else if (("," + controllers + ",").find(",memory,") != std::string::npos) {
      least = std::min(least, limit_of_group(mount / "memory", group, "memory.limit_in_bytes"));
    }
  }
  return least;
}

}  // namespace

std::uint64_t physical_memory(const std::filesystem::path& root) {
  const std::uint64_t machine = memory_of_machine(), limit = limit_of_groups(root);
  if (machine == 0) return limit == kUnlimited ? 0 : limit;
  return std::min(machine, limit);
}

void use_large_pages([[maybe_unused]] const void* memory, [[maybe_unused]] std::size_t bytes) {
#if defined(MADV_HUGEPAGE)
  // Rounds the range inward to whole large pages, because other objects may use the rest of the first and the
  // last page.
  constexpr std::uintptr_t kPage = std::uintptr_t{1} << 21;
  const auto address = reinterpret_cast<std::uintptr_t>(memory);
  const std::uintptr_t before = (kPage - address % kPage) % kPage, after = (address + bytes) % kPage;
  if (before + after >= bytes) return;
  char* const begin = const_cast<char*>(static_cast<const char*>(memory)) + before;
  const int error = errno;  // restored below, because a system without large pages is not an error
  madvise(begin, bytes - before - after, MADV_HUGEPAGE);
  errno = error;
#endif
}

}  // namespace boxplus
