// SPDX-License-Identifier: BSD-3-Clause
#include "files/graph_input.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>

#include "boxplus/base/error.h"
#include "boxplus/io/file_format.h"
#include "boxplus/io/registry.h"
#include "boxplus/optimize/optimizer.h"
#include "command_line/message.h"
#include "command_line/option_kinds.h"
#include "command_line/progress.h"
#include "files/outputs.h"

namespace boxplus::app {
namespace {

[[noreturn]] void fail(const std::string& path, const char* what) {
  throw FileError(fmt::format("{}: {}: {}", input_name(path), what, std::strerror(errno)));
}

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

bool is_folder(const std::string& path) {
  std::error_code none;
  return path != kStandardStream && std::filesystem::is_directory(path, none);
}

std::string read_all(std::FILE* file, const std::string& path) {
  std::string text;
  constexpr std::size_t kChunk = std::size_t{1} << 20;
  for (;;) {
    const std::size_t size = text.size();
    text.resize(size + kChunk);
    const std::size_t count = std::fread(text.data() + size, 1, kChunk, file);
    text.resize(size + count);
    if (std::ferror(file) != 0) fail(path, "cannot be read");
    if (count == 0) return text;
  }
}

/// Throws InputError if the file has neither vertices nor edges. Such a file is most likely not a graph, so
/// notes about each of its lines would not help anybody.
void require_graph(const GraphFile& file, const std::string& path) {
  if (file.graph.vertex_count() > 0 || file.graph.edge_count() > 0) return;
  std::string message = "expected a vertex or an edge, got the end of the file";
  if (!file.kept.empty()) {
    constexpr std::size_t kShown = 40;
    const std::string& line = file.kept.front().text;
    message += fmt::format("; its first line is '{}{}'", escaped(line.substr(0, kShown)),
                           line.size() > kShown ? "…" : "");
  }
  const auto first =
      std::find_if(file.notes.begin(), file.notes.end(), [](const auto& note) { return note.skipped; });
  if (first != file.notes.end())
    message += fmt::format("; {} line{} skipped, the first at {}:{}: {}", file.skipped,
                           file.skipped == 1 ? " was" : "s were", first->line, first->column, first->text);
  throw InputError(input_name(path), file.lines + 1, 1, message);
}

/// Computes initial estimates (the chordal guess) for the vertices of a file that contains only edges.
void place_vertices(Graph& graph, const std::string& path) {
  Options guess_only;
  guess_only.start = Start::kChordal;
  guess_only.max_iterations = 0;
  const Report report = optimize(graph, guess_only);
  print_message(
      report.start.note.empty()
          ? fmt::format("{}: the file has no estimates; initial estimates were computed from the edges",
                        input_name(path))
          : fmt::format("{}: the file has no estimates; all vertices start at the origin: {}",
                        input_name(path), report.start.note));
}

/// Checks that the text has the form "OLD=NEW" and that boxplus can read the tag NEW. Returns an error
/// message, or an empty string if the text is valid.
std::string complaint_about_rename(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0)
    return fmt::format("expected OLD=NEW[,OLD=NEW…], got '{}'", text);
  const std::string known = text.substr(equals + 1);
  if (default_registry().find(known)) return {};
  return fmt::format("expected a tag that boxplus can read after '{}=', got '{}'", text.substr(0, equals),
                     known);
}

std::string complaint_about_renames(const std::string& text) {
  for (const std::string& rename : CLI::detail::split(text, ',')) {
    if (std::string complaint = complaint_about_rename(rename); !complaint.empty()) return complaint;
  }
  return {};
}

/// Says what the written file does not keep of a file that had it, because whoever reads it would, for
/// example, use edges that were disabled.
void note_what_is_lost(const std::string& path, const GraphFile& file, const std::string& format) {
  const std::string name = path == kStandardStream ? "<stdout>" : path;
  for (const std::string& loss : losses(path == kStandardStream ? "" : path, file, {.format = format}))
    print_message(fmt::format("{}: the format does not keep {}", name, loss));
  const FileFormats& formats = default_formats();
  const FileFormat* const read = formats.find(file.format);
  const FileFormat* written = format.empty() ? formats.of_path(path) : formats.find(format);
  if (written == nullptr && format.empty() && (path.ends_with('/') || is_folder(path)))
    written = formats.find("COLMAP");
  if (written == nullptr) written = read;
  if (read == nullptr || !read->keeps_everything || written->keeps_everything) return;
  std::size_t disabled = 0, levels = 0, kernels = 0, directions = 0;
  for (const EdgeRef& edge : file.graph.all_edges()) {
    disabled += !file.graph.is_enabled(edge);
    levels += file.graph.level(edge) != 0;
    kernels += file.graph.kernel(edge) != nullptr;
  }
  for (const VertexRef& vertex : file.graph.all_vertices())
    directions += !file.graph.fixed_directions(vertex).empty();
  std::string lost;
  const auto add = [&](std::size_t count, const char* what) {
    if (count > 0) lost += fmt::format("{}{} {}", lost.empty() ? "" : ", ", count, what);
  };
  add(disabled, "edges are disabled");
  add(levels, "edges have another level than 0");
  add(kernels, "edges have kernels");
  add(directions, "vertices have fixed directions");
  if (!lost.empty()) print_message(fmt::format("{}: only JSON keeps that {}", name, lost));
}

}  // namespace

std::string input_name(const std::string& path) {
  return path == kStandardStream ? "<stdin>" : path;
}

std::string read_text(const std::string& path) {
  if (path == kStandardStream) return read_all(stdin, path);
  if (is_folder(path)) return {};
  const std::unique_ptr<std::FILE, CloseFile> file(std::fopen(path.c_str(), "rbe"));
  if (!file) fail(path, "cannot be opened");
  return read_all(file.get(), path);
}

void add_reading_options(CLI::App& command, ReadOptions& options) {
  command
      .add_flag("--lenient", options.lenient,
                "Skip lines that cannot be read, and report their number and the first errors")
      ->group("Reading");
  const Choices<ReadOptions::Indefinite> policies = {{"refuse", ReadOptions::Indefinite::kRefuse},
                                                     {"project", ReadOptions::Indefinite::kProject},
                                                     {"as-given", ReadOptions::Indefinite::kAsGiven}};
  add_choice(command, "--information", options.indefinite, policies,
             "If an information matrix has a negative eigenvalue, refuse the file, use the nearest positive "
             "semi-definite matrix, or use the matrix as given")
      ->group("Reading");
  const auto add_renames = [&options](const std::string& text) {
    for (const std::string& rename : CLI::detail::split(text, ',')) {
      const std::size_t equals = rename.find('=');
      options.renames[rename.substr(0, equals)] = rename.substr(equals + 1);
    }
  };
  command
      .add_option_function<std::string>("--rename", add_renames,
                                        "Treat the tag OLD in the file as the tag NEW")
      ->type_name("OLD=NEW,...")
      ->check(CLI::Validator(complaint_about_renames, ""))
      ->join(',')
      ->group("Reading");
}

GraphFile read_input(const std::string& path, const ReadOptions& options, bool quiet) {
  Progress progress(choose_progress(quiet, false));
  progress.later(fmt::format("reading {} …", input_name(path)));
  if (path == kStandardStream) return parse_input(read_text(path), path, options);
  GraphFile file = read_graph(path, options);
  require_graph(file, path);
  return file;
}

GraphFile parse_input(const std::string& text, const std::string& path, const ReadOptions& options) {
  if (is_folder(path)) return read_input(path, options);
  GraphFile file = parse_graph(text, input_name(path), options);
  require_graph(file, path);
  return file;
}

GraphFile load_graph(const std::string& path, const ReadOptions& options, bool quiet) {
  GraphFile file = read_input(path, options, quiet);
  print_notes(file, path);
  if (file.vertices_created) place_vertices(file.graph, path);
  return file;
}

void print_notes(const GraphFile& file, const std::string& path) {
  print_notes(file.notes, path);
}

void print_notes(const std::vector<GraphFile::Note>& notes, const std::string& path) {
  constexpr std::size_t kShown = 10;
  const std::string name = input_name(path);
  for (std::size_t k = 0; k < std::min(kShown, notes.size()); ++k) {
    const GraphFile::Note& note = notes[k];
    std::string place = name;
    for (const std::int64_t number : {note.line, note.column}) {
      if (number > 0) place += fmt::format(":{}", number);
    }
    print_message(fmt::format("{}: {}{}", place, note.skipped ? "skipped: " : "", note.text));
  }
  if (notes.size() > kShown)
    print_message(fmt::format("{}: … and {} more notes", name, notes.size() - kShown));
}

void require_representable(const std::string& path, const GraphFile& file) {
  if (path == kStandardStream) {
    const FileFormat* format = default_formats().find(file.format);
    if (format && format->is_folder()) format_graph(file);  // throws
  } else if (!path.empty()) {
    require_writable(path, file);
  }
}

void save_graph(const std::string& path, const GraphFile& file, const std::string& format, bool quiet) {
  note_what_is_lost(path, file, format);
  Progress progress(choose_progress(quiet, false));
  progress.later(fmt::format("writing {} …", output_name(path)));
  if (path == kStandardStream) {
    write_output(path, format_graph(file, {.format = format}));
  } else {
    write_graph(path, file, {.format = format});
  }
}

}  // namespace boxplus::app
