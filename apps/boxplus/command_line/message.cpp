// SPDX-License-Identifier: BSD-3-Clause
#include "command_line/message.h"

#include <fmt/format.h>

#include <cstdio>

#include "io/printable.h"

namespace boxplus::app {
std::string escaped(std::string_view text) {
  return boxplus::escaped(text);
}

void write_to_stderr(std::string_view text) noexcept {
  std::fwrite(text.data(), 1, text.size(), stderr);
}

void print_message(std::string_view text) {
  write_to_stderr(fmt::format("boxplus: {}\n", escaped(text)));
}

}  // namespace boxplus::app
