// SPDX-License-Identifier: BSD-3-Clause
#include "io/replace_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <system_error>

#include "boxplus/io/write_file.h"
#include "io/replacement.h"
#include "io/text_file.h"

namespace boxplus {
namespace {

bool is_special_file(const std::string& path) {
  struct stat status {};
  return ::stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode);
}

}  // namespace

void replace_file(const std::string& path, detail::FunctionRef<void(TextSink)> write) {
  if (is_special_file(path)) {
    const FileDescriptor file(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
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
    if (::access(path.c_str(), W_OK) != 0) fail_at(path, "cannot be written", errno);
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
