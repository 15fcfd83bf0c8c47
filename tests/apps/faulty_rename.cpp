// SPDX-License-Identifier: BSD-3-Clause
// For LD_PRELOAD: the rename() with the number FAIL_AT_RENAME (from 1) fails, or the process is killed before
// the rename() with the number DIE_AT_RENAME.
#include <fcntl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>

namespace {

int number_in(const char* variable) {
  const char* text = std::getenv(variable);
  return text ? std::atoi(text) : 0;
}

}  // namespace

extern "C" int rename(const char* from, const char* to) {
  static int count = 0;
  ++count;
  if (count == number_in("DIE_AT_RENAME")) std::raise(SIGKILL);
  if (count == number_in("FAIL_AT_RENAME")) {
    errno = EIO;
    return -1;
  }
  return static_cast<int>(syscall(SYS_renameat2, AT_FDCWD, from, AT_FDCWD, to, 0));
}
