// SPDX-License-Identifier: BSD-3-Clause
#include "protocol/serve_commands.h"

#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <optional>
#include <string>

#include "boxplus/base/error.h"
#include "files/interrupt.h"
#include "protocol/protocol.h"

namespace boxplus::app {
namespace {

/// Waits for input. Returns false if Interrupt is raised.
bool wait_for_input(const std::function<void()>& idle) {
  constexpr int kPatienceMs = 100;
  pollfd input{STDIN_FILENO, POLLIN, 0};
  while (!Interrupt::raised()) {
    if (::poll(&input, 1, kPatienceMs) > 0) return true;
    idle();
  }
  return false;
}

}  // namespace

void serve_commands(Graph& graph, const CommandCalls& calls) {
  CommandStream stream("<stdin>");
  Protocol protocol(graph, stream.name(), calls.solve);
  std::array<char, 1 << 16> piece;
  while (wait_for_input(calls.idle)) {
    const ssize_t count = ::read(STDIN_FILENO, piece.data(), piece.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) throw FileError(stream.name() + ": cannot be read: " + std::strerror(errno));
    if (count == 0) return stream.finish();
    std::string_view received(piece.data(), static_cast<std::size_t>(count));
    while (const std::optional<CommandText> command = stream.next(received)) {
      std::string answer;
      protocol.execute(*command, answer);
      if (!answer.empty()) calls.answer(answer);
    }
  }
}

}  // namespace boxplus::app
