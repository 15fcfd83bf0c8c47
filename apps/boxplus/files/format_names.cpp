// SPDX-License-Identifier: BSD-3-Clause
#include "files/format_names.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

#include "boxplus/base/error.h"
#include "boxplus/io/file_format.h"

namespace boxplus::app {

std::string readable_formats() {
  std::vector<std::string> labels;
  for (const FileFormat& format : default_formats().all()) labels.push_back(format.label());
  return fmt::format("{}", fmt::join(labels, ", "));
}

std::string graph_to_read() {
  return fmt::format("The graph: {}, or - for standard input", readable_formats());
}

std::string writable_formats() {
  std::vector<std::string> labels;
  for (const FileFormat& format : default_formats().all()) {
    if (format.write) labels.push_back(format.label());
  }
  return fmt::format("{}", fmt::join(labels, " or "));
}

void require_writable_format(const std::string& path) {
  const FileFormat* format = default_formats().of_path(path);
  if (!format || format->write) return;
  throw InvalidArgument(fmt::format("{}: expected a {} file as output, because boxplus can only read {}",
                                    path, writable_formats(), format->label()));
}

}  // namespace boxplus::app
