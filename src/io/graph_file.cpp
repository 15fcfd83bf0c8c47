// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/io/graph_file.h"

#include <algorithm>

#include "boxplus/base/error.h"
#include "boxplus/io/file_format.h"
#include "io/text_file.h"

namespace boxplus {
namespace {

const FileFormats& formats_of(const FileFormats* formats) {
  return formats ? *formats : default_formats();
}

std::string labels_of(const FileFormats& formats) {
  std::string labels;
  for (const FileFormat& format : formats.all()) labels += (labels.empty() ? "" : ", ") + format.label();
  return labels;
}

GraphFile read(const TextSource& text, const ReadOptions& options) {
  const FileFormats& formats = formats_of(options.formats);
  std::string memory;
  const FileFormat* format =
      formats.recognize(text.block_count() == 0 ? std::string_view() : text.block(0, memory));
  if (!format)
    throw InputError(text.name(), 1, 1,
                     "expected a supported format (" + labels_of(formats) + "), got another one");
  GraphFile file = format->read(text, options);
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
  if (!format->write) throw InvalidArgument("cannot write " + format->label() + ": the format is read-only");
  return *format;
}

/// `read_as`: the name of the format from which the graph was read, if any.
const FileFormat& format_to_write(std::string_view path, std::string_view read_as,
                                  const WriteOptions& options) {
  const FileFormats& formats = formats_of(options.formats);
  if (!options.format.empty()) return named_format(formats, options.format);
  const FileFormat* format = formats.of_path(path);
  if (format && format->write) return *format;
  format = formats.find(read_as);
  if (format && format->write) return *format;
  const auto first = std::find_if(formats.all().begin(), formats.all().end(),
                                  [](const FileFormat& any) { return static_cast<bool>(any.write); });
  if (first == formats.all().end())
    throw InvalidArgument("cannot write a graph: no writable format is registered");
  return *first;
}

void write(const std::string& path, const GraphFileView& file, std::string_view read_as,
           const WriteOptions& options) {
  const FileFormat& format = format_to_write(path, read_as, options);
  replace_file(path, [&](TextSink sink) { format.write(file, options, sink); });
}

GraphFileView view_of(const GraphFile& file) {
  return {file.graph, file.edges, file.kept};
}

}  // namespace

GraphFile read_graph(const std::string& path, const ReadOptions& options) {
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

std::string format_graph(const GraphFile& file, const WriteOptions& options) {
  std::string text;
  format_to_write({}, file.format, options).write(view_of(file), options, [&](std::string_view piece) {
    text += piece;
  });
  return text;
}

}  // namespace boxplus
