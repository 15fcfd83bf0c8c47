// SPDX-License-Identifier: BSD-3-Clause
#include "io/replace_file.h"

#include <cerrno>
#include <filesystem>
#include <system_error>

#include "boxplus/io/write_file.h"
#include "io/replacement.h"
#include "io/text_file.h"

namespace boxplus {
namespace {

/// Whether it is a pipe or a device.
bool is_special_file(const std::string& path) {
  std::error_code none;
  return std::filesystem::is_other(path, none);
}

}  // namespace

void replace_file(const std::string& path, detail::FunctionRef<void(TextSink)> write) {
  if (is_special_file(path)) {
    const FileDescriptor file = open_to_write(path);
    if (!file.is_open()) fail_at(path, "cannot be written", errno);
    write_to(file, path, write);
    return;
  }
  Replacement replacement(path);
  replacement.write(write);
  replacement.take_place();
}

void require_writable(const std::string& path) {
  if (is_special_file(path)) {
    if (!may_write(path)) fail_at(path, "cannot be written", errno);
    return;
  }
  std::error_code none;
  if (std::filesystem::is_directory(path, none)) fail_at(path, "cannot be written", EISDIR);
  const Replacement probe(path);
}

void write_file(const std::string& path, std::string_view text) {
  replace_file(path, [&](TextSink sink) { sink(text); });
}

}  // namespace boxplus
