// SPDX-License-Identifier: BSD-3-Clause
#include "streams.h"

#include <cstdio>
#include <iostream>
#include <iterator>

#include "boxplus/base/error.h"

namespace boxplus::app {

GraphFile read_graph_or_stdin(const std::string& path) {
  if (path != kStream) return read_graph(path);
  const std::string text{std::istreambuf_iterator<char>(std::cin), {}};
  return parse_graph(text, "<stdin>");
}

void require_writable_or_stdout(const std::string& path) {
  if (path != kStream) require_writable(path);
}

void write_file_or_stdout(const std::string& path, std::string_view text) {
  if (path != kStream) return write_file(path, text);
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
    throw FileError("cannot write to the standard output");
}

}  // namespace boxplus::app
