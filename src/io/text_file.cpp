// SPDX-License-Identifier: BSD-3-Clause
#include "io/text_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "boxplus/base/error.h"

namespace boxplus {
namespace {

/// Writes all of `text`. Returns the error number, or 0.
int write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  return 0;
}

/// Waits until the written bytes are on the disk, if there is one. Returns the error number, or 0.
int flush(int descriptor) {
  return ::fsync(descriptor) != 0 && errno != EINVAL ? errno : 0;
}

}  // namespace

void fail_at(const std::string& path, const char* what, int error) {
  throw FileError(fmt::format("{}: {}: {}", path, what, std::strerror(error)));
}

FileDescriptor::~FileDescriptor() {
  if (is_open()) ::close(value_);
}

std::optional<std::size_t> FileDescriptor::regular_size() const {
  struct stat status {};
  // The files in /proc are regular files, but report a size of 0.
  if (::fstat(value_, &status) != 0 || !S_ISREG(status.st_mode) || status.st_size == 0) return std::nullopt;
  return static_cast<std::size_t>(status.st_size);
}

FileDescriptor open_for_reading(const std::string& path) {
  FileDescriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (!file.is_open()) fail_at(path, "cannot be opened", errno);
  return file;
}

std::string read_all(const FileDescriptor& file, const std::string& path) {
  std::string text;
  constexpr std::size_t kChunk = std::size_t{1} << 20;
  for (;;) {
    const std::size_t size = text.size();
    text.resize(size + kChunk);
    const ssize_t count = ::read(file.value(), text.data() + size, kChunk);
    text.resize(size + static_cast<std::size_t>(count > 0 ? count : 0));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail_at(path, "cannot be read", errno);
    if (count == 0) return text;
  }
}

std::size_t read_at(const FileDescriptor& file, const std::string& path, std::size_t offset, char* out,
                    std::size_t size) {
  std::size_t total = 0;
  while (total < size) {
    const ssize_t count =
        ::pread(file.value(), out + total, size - total, static_cast<off_t>(offset + total));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail_at(path, "cannot be read", errno);
    if (count == 0) break;
    total += static_cast<std::size_t>(count);
  }
  return total;
}

void write_to(const FileDescriptor& file, const std::string& path,
              detail::FunctionRef<void(TextSink)> write) {
  write([&](std::string_view text) {
    if (const int error = write_all(file.value(), text); error != 0)
      fail_at(path, "cannot be written", error);
  });
  if (const int error = flush(file.value()); error != 0) fail_at(path, "cannot be written", error);
}

}  // namespace boxplus
