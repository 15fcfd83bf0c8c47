// SPDX-License-Identifier: BSD-3-Clause
#include "files/format_names.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <vector>

#include "boxplus/base/error.h"
#include "boxplus/io/file_format.h"

namespace boxplus::app {

std::string readable_formats() {
  std::vector<std::string> labels;
  for (const FileFormat& format : default_formats().all()) {
    if (format.can_read()) labels.push_back(format.label());
  }
  return fmt::format("{}", fmt::join(labels, ", "));
}

std::string graph_to_read() {
  return fmt::format("The graph: {}, or - for standard input", readable_formats());
}

std::string writable_formats() {
  std::vector<std::string> labels;
  for (const FileFormat& format : default_formats().all()) {
    if (format.can_write()) labels.push_back(format.label());
  }
  const std::string last = labels.back();
  labels.pop_back();
  return fmt::format("{} or {}", fmt::join(labels, ", "), last);
}

std::vector<std::string> writable_names() {
  std::vector<std::string> names;
  for (const FileFormat& format : default_formats().all()) {
    if (format.can_write()) names.push_back(CLI::detail::to_lower(format.name));
  }
  return names;
}

std::string format_name(const std::string& in_lower_case) {
  for (const FileFormat& format : default_formats().all()) {
    if (CLI::detail::to_lower(format.name) == in_lower_case) return format.name;
  }
  return in_lower_case;
}

void require_writable_format(const std::string& path) {
  const FileFormat* format = default_formats().of_path(path);
  if (!format || format->can_write()) return;
  throw InvalidArgument(fmt::format("{}: expected a {} as output, because boxplus can only read {}", path,
                                    writable_formats(), format->label()));
}

}  // namespace boxplus::app
