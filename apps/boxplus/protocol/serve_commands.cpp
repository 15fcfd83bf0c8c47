// SPDX-License-Identifier: BSD-3-Clause
#include "protocol/serve_commands.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <optional>
#include <string>

#include "boxplus/base/error.h"
#include "files/interrupt.h"
#include "platform/standard_streams.h"
#include "protocol/protocol.h"

namespace boxplus::app {
namespace {

/// Waits for input. Returns false if Interrupt is raised.
bool has_input(const std::function<void()>& idle) {
  constexpr int kPatienceMs = 100;
  while (!Interrupt::raised()) {
    if (wait_for_stdin(kPatienceMs)) return true;
    idle();
  }
  return false;
}

}  // namespace

void serve_commands(Graph& graph, const CommandCalls& calls) {
  CommandStream stream("<stdin>");
  Protocol protocol(graph, stream.name(), calls.solve);
  std::array<char, 1 << 16> piece;
  while (has_input(calls.idle)) {
    const std::optional<std::size_t> count = read_stdin(piece.data(), piece.size());
    if (!count && errno == EINTR) continue;
    if (!count) throw FileError(stream.name() + ": cannot be read: " + std::strerror(errno));
    if (*count == 0) return stream.finish();
    std::string_view received(piece.data(), *count);
    while (const std::optional<CommandText> command = stream.next(received)) {
      std::string answer;
      protocol.execute(*command, answer);
      if (!answer.empty()) calls.answer(answer);
    }
  }
}

}  // namespace boxplus::app
