// SPDX-License-Identifier: BSD-3-Clause
#include "platform/standard_streams.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <initializer_list>

namespace boxplus {

void reserve_standard_streams() {
  for (const int each : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(each, F_GETFD) != -1) continue;
    // open() returns the lowest free descriptor, which is `each`.
    static_cast<void>(::open("/dev/null", each == STDIN_FILENO ? O_WRONLY : O_RDONLY));  // NOLINT: no mode
  }
}

bool wait_for_stdin(int milliseconds) {
  pollfd input{STDIN_FILENO, POLLIN, 0};
  return ::poll(&input, 1, milliseconds) > 0;
}

std::optional<std::size_t> read_stdin(char* out, std::size_t size) {
  const ssize_t count = ::read(STDIN_FILENO, out, size);
  return count < 0 ? std::nullopt : std::optional(static_cast<std::size_t>(count));
}

bool stderr_is_terminal() {
  return ::isatty(STDERR_FILENO) == 1;
}

std::size_t stderr_columns() {
  winsize size{};
  return ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 ? size.ws_col : 0;
}

}  // namespace boxplus
