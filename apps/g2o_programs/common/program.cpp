// SPDX-License-Identifier: BSD-3-Clause
#include "common/program.h"

#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>
#include <iostream>
#include <iterator>

#include "boxplus/base/error.h"
#include "boxplus/io/write_file.h"
#include "files/clean_end.h"
#include "io/printable.h"

namespace boxplus::programs {
namespace {

constexpr const char* kStandardStream = "-";
const char* program_name = "";

std::string read_standard_input() {
  std::string text{std::istreambuf_iterator<char>(std::cin), {}};
  if (std::cin.bad()) throw FileError("<stdin>: cannot be read");
  return text;
}

}  // namespace

int run_program(const char* name, detail::FunctionRef<int()> body) {
  program_name = name;
  app::end_cleanly_on_signals();
  std::signal(SIGPIPE, SIG_IGN);  // so that a reader that ends early is a write error
  std::signal(SIGXFSZ, SIG_IGN);  // and exceeding `ulimit -f`, too
  try {
    return body();
  } catch (const InputError& error) {
    print_message(error.what());
    return kBadInput;
  } catch (const std::exception& error) {
    print_message(error.what());
    return kBadFile;
  }
}

void print_error(std::string_view line) {
  std::fwrite(line.data(), 1, line.size(), stderr);
}

void print_message(std::string_view text) {
  print_error(fmt::format("{}: {}\n", program_name, escaped(text)));
}

void print_remark(std::string_view text) {
  print_error(fmt::format("# {}\n", escaped(text)));
}

void print_output(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
    throw FileError("cannot write to standard output");
}

GraphFile load_graph(const std::string& path) {
  constexpr std::size_t kShownNotes = 10;
  const bool is_stream = path == kStandardStream;
  GraphFile file = is_stream ? parse_graph(read_standard_input(), "<stdin>") : read_graph(path);
  const std::string name = is_stream ? "<stdin>" : path;
  if (file.graph.vertex_count() == 0 && file.graph.edge_count() == 0)
    throw InputError(name, file.lines + 1, 1, "expected a vertex or an edge, got the end of the file");
  for (std::size_t k = 0; k < std::min(kShownNotes, file.notes.size()); ++k) {
    const GraphFile::Note& note = file.notes[k];
    const std::string line = note.line > 0 ? fmt::format(":{}", note.line) : "";
    print_message(fmt::format("{}{}: {}", name, line, note.text));
  }
  if (file.notes.size() > kShownNotes)
    print_message(fmt::format("{}: … and {} more notes", name, file.notes.size() - kShownNotes));
  return file;
}

void save_graph(const std::string& path, const GraphFile& file) {
  if (path != kStandardStream) return write_graph(path, file);
  print_output(format_graph(file));
}

void require_output(const std::string& path) {
  if (!path.empty() && path != kStandardStream) require_writable(path);
}

}  // namespace boxplus::programs
