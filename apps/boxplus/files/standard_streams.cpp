// SPDX-License-Identifier: BSD-3-Clause
#include "files/standard_streams.h"

#include <fcntl.h>
#include <unistd.h>

#include <initializer_list>

namespace boxplus::app {

void reserve_standard_streams() {
  for (const int each : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(each, F_GETFD) != -1) continue;
    // open() returns the lowest free descriptor, which is `each`.
    static_cast<void>(::open("/dev/null", each == STDIN_FILENO ? O_WRONLY : O_RDONLY));  // NOLINT: no mode
  }
}

}  // namespace boxplus::app
