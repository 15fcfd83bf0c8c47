// SPDX-License-Identifier: BSD-3-Clause
#include "io/text_file.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>

#include "boxplus/base/error.h"

namespace boxplus {

void fail_at(const std::string& path, const char* what, int error) {
  throw FileError(fmt::format("{}: {}: {}", path, what, std::strerror(error)));
}

FileDescriptor open_for_reading(const std::string& path) {
  FileDescriptor file = open_to_read(path);
  if (!file.is_open()) fail_at(path, "cannot be opened", errno);
  return file;
}

std::string read_all(const FileDescriptor& file, const std::string& path) {
  std::string text;
  constexpr std::size_t kChunk = std::size_t{1} << 20;
  for (;;) {
    const std::size_t size = text.size();
    text.resize(size + kChunk);
    const std::optional<std::size_t> count = file.read(text.data() + size, kChunk);
    if (!count) fail_at(path, "cannot be read", errno);
    text.resize(size + *count);
    if (*count == 0) return text;
  }
}

std::size_t read_at(const FileDescriptor& file, const std::string& path, std::size_t offset, char* out,
                    std::size_t size) {
  const std::optional<std::size_t> count = file.read_at(offset, out, size);
  if (!count) fail_at(path, "cannot be read", errno);
  return *count;
}

void write_to(const FileDescriptor& file, const std::string& path,
              detail::FunctionRef<void(TextSink)> write) {
  write([&](std::string_view text) {
    if (!file.write(text)) fail_at(path, "cannot be written", errno);
  });
  if (!file.flush()) fail_at(path, "cannot be written", errno);
}

}  // namespace boxplus
