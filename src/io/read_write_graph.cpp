// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <filesystem>
#include <system_error>

#include "boxplus/base/error.h"
#include "boxplus/io/file_format.h"
#include "boxplus/io/graph_file.h"
#include "boxplus/io/write_file.h"
#include "io/g2o/notes.h"
#include "io/gzip.h"
#include "io/replace_file.h"
#include "io/text_file.h"

namespace boxplus {
namespace {

const FileFormats& formats_of(const FileFormats* formats) {
  return formats ? *formats : default_formats();
}

/// The formats that boxplus can read: texts or folders.
std::string labels_of(const FileFormats& formats, bool of_folders) {
  std::string labels;
  for (const FileFormat& format : formats.all()) {
    if (format.can_read() && format.is_folder() == of_folders)
      labels += (labels.empty() ? "" : ", ") + format.label();
  }
  return labels;
}

GraphFile read(const TextSource& text, const ReadOptions& options) {
  const FileFormats& formats = formats_of(options.formats);
  std::string memory;
  const FileFormat* format =
      formats.recognize(text.block_count() == 0 ? std::string_view() : text.block(0, memory));
  if (!format || !format->read)
    throw InputError(text.name(), 1, 1,
                     "expected a supported format (" + labels_of(formats, false) + "), got " +
                         (format ? format->label() + ", which boxplus can only write" : "another one"));
  GraphFile file = format->read(text, options);
  file.format = format->name;
  return file;
}

GraphFile read_folder(const std::string& path, const ReadOptions& options) {
  const FileFormats& formats = formats_of(options.formats);
  const FileFormat* format = formats.recognize_folder(path);
  if (!format) {
    const std::string labels = labels_of(formats, true);
    throw FileError(path + ": expected a file" + (labels.empty() ? "" : " or a " + labels) +
                    ", got a folder without the files of a graph");
  }
  GraphFile file = format->folder.read(path, options);
  file.format = format->name;
  return file;
}

const FileFormat& named_format(const FileFormats& formats, const std::string& name) {
  const FileFormat* format = formats.find(name);
  if (!format) {
    std::string known;
    for (const FileFormat& each : formats.all()) known += (known.empty() ? "" : ", ") + each.name;
    throw InvalidArgument("unknown file format '" + name + "'; known formats: " + known);
  }
  if (!format->can_write())
    throw InvalidArgument("cannot write " + format->label() + ": the format is read-only");
  return *format;
}

bool is_folder(std::string_view path) {
  std::error_code none;
  return path.ends_with('/') || std::filesystem::is_directory(path, none);
}

/// `read_as`: the name of the format from which the graph was read, if any.
const FileFormat& format_to_write(std::string_view path, std::string_view read_as,
                                  const WriteOptions& options) {
  const FileFormats& formats = formats_of(options.formats);
  if (!options.format.empty()) return named_format(formats, options.format);
  const bool to_folder = is_folder(path);
  const auto is_possible = [&](const FileFormat& format) {
    return format.can_write() && (format.is_folder() || !to_folder);
  };
  if (const FileFormat* format = formats.of_path(path); format && is_possible(*format)) return *format;
  if (const FileFormat* format = formats.find(read_as);
      format && is_possible(*format) && !format->written_on_request)
    return *format;
  const auto first = std::find_if(formats.all().begin(), formats.all().end(), is_possible);
  if (first == formats.all().end())
    throw InvalidArgument("cannot write a graph: no writable format is registered");
  return *first;
}

/// Calls f(), and names the path if it throws InvalidArgument, because the path may be a folder by mistake.
template <class F>
void with_path(const std::string& path, F&& f) {
  try {
    f();
  } catch (const InvalidArgument& error) {
    throw InvalidArgument(path + ": " + error.what());
  }
}

void write(const std::string& path, const GraphFileView& file, std::string_view read_as,
           const WriteOptions& options) {
  const FileFormat& format = format_to_write(path, read_as, options);
  if (format.is_folder()) return with_path(path, [&] { format.folder.write(file, path); });
  replace_file(path, [&](TextSink sink) {
    if (!is_gzip_name(path)) return format.write(file, options, sink);
    GzipPacker packer(sink);
    format.write(file, options, [&](std::string_view text) { packer.write(text); });
    packer.finish();
  });
}

/// The number of vertices and parameters with bounds.
std::int64_t count_bounded(const Graph& graph) {
  std::int64_t count = 0;
  for (const auto& pool : graph.vertex_pools()) {
    for (std::uint32_t slot = 0; slot < pool->slots(); ++slot)
      count += pool->alive(slot) && !pool->bounds(slot).empty();
  }
  return count;
}

GraphFileView view_of(const GraphFile& file) {
  return {file.graph, file.edges, file.kept, file.model.get()};
}

std::string format_as_text(const GraphFileView& file, std::string_view read_as, const WriteOptions& options) {
  const FileFormat& format = format_to_write({}, read_as, options);
  if (format.is_folder())
    throw InvalidArgument("cannot write " + format.label() +
                          " as one text; expected the name of a folder, or of a file in another format");
  std::string text;
  format.write(file, options, [&](std::string_view piece) { text += piece; });
  return text;
}

}  // namespace

GraphFile read_graph(const std::string& path, const ReadOptions& options) {
  std::error_code none;
  if (std::filesystem::is_directory(path, none)) return read_folder(path, options);
  return read(TextSource::of_file(path), options);
}

GraphFile parse_graph(std::string_view text, const std::string& name, const ReadOptions& options) {
  return read(TextSource(text, name), options);
}

void write_graph(const std::string& path, const GraphFile& file, const WriteOptions& options) {
  write(path, view_of(file), file.format, options);
}

void write_graph(const std::string& path, const Graph& graph, const WriteOptions& options) {
  write(path, {graph}, {}, options);
}

void require_writable(const std::string& path, const GraphFile& file, const WriteOptions& options) {
  const FileFormat& format = format_to_write(path, file.format, options);
  if (format.is_folder()) {
    if (format.folder.check) with_path(path, [&] { format.folder.check(view_of(file), path); });
    return;
  }
  if (format.name != file.format || format.written_on_request)
    format.write(view_of(file), options, [](std::string_view) {});
  require_writable(path);
}

std::vector<std::string> losses(const std::string& path, const GraphFile& file, const WriteOptions& options) {
  const FileFormat& format = format_to_write(path, file.format, options);
  std::vector<std::string> result;
  if (format.losses) result = format.losses(view_of(file));
  const std::int64_t bounded = format.keeps_everything ? 0 : count_bounded(file.graph);
  if (bounded > 0) result.push_back("the bounds of " + counted(bounded, "vertex", "vertices"));
  return result;
}

std::string format_graph(const GraphFile& file, const WriteOptions& options) {
  return format_as_text(view_of(file), file.format, options);
}

std::string format_graph(const Graph& graph, const WriteOptions& options) {
  return format_as_text({graph}, {}, options);
}

}  // namespace boxplus
