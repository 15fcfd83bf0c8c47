// SPDX-License-Identifier: BSD-3-Clause
#include "platform/files.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <utility>

namespace boxplus {

FileDescriptor::~FileDescriptor() {
  if (is_open()) ::close(value_);
}

std::optional<std::size_t> FileDescriptor::regular_size() const {
  struct stat status {};
  // The files in /proc are regular files, but report a size of 0.
  if (::fstat(value_, &status) != 0 || !S_ISREG(status.st_mode) || status.st_size == 0) return std::nullopt;
  return static_cast<std::size_t>(status.st_size);
}

std::optional<std::size_t> FileDescriptor::read(char* out, std::size_t size) const {
  for (;;) {
    const ssize_t count = ::read(value_, out, size);
    if (count >= 0) return static_cast<std::size_t>(count);
    if (errno != EINTR) return std::nullopt;
  }
}

std::optional<std::size_t> FileDescriptor::read_at(std::size_t offset, char* out, std::size_t size) const {
  std::size_t total = 0;
  while (total < size) {
    const ssize_t count = ::pread(value_, out + total, size - total, static_cast<off_t>(offset + total));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return std::nullopt;
    if (count == 0) break;
    total += static_cast<std::size_t>(count);
  }
  return total;
}

bool FileDescriptor::write(std::string_view text) const {
  while (!text.empty()) {
    const ssize_t written = ::write(value_, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

bool FileDescriptor::flush() const {
  return ::fsync(value_) == 0 || errno == EINVAL;
}

bool FileDescriptor::take_permissions(const std::string& path) const {
  struct stat status {};
  if (::stat(path.c_str(), &status) == 0) return ::fchmod(value_, status.st_mode & 07777) == 0;
  const mode_t mask = ::umask(0);
  ::umask(mask);
  return ::fchmod(value_, 0666 & ~mask) == 0;
}

FileDescriptor open_to_read(const std::string& path) {
  return FileDescriptor(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
}

FileDescriptor open_to_write(const std::string& path) {
  return FileDescriptor(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
}

FileDescriptor open_to_append(const std::string& path) {
  return FileDescriptor(::open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666));
}

bool may_write(const std::string& path) {
  return ::access(path.c_str(), W_OK) == 0;
}

FileDescriptor open_folder(const std::string& folder, FolderLock lock) {
  FileDescriptor file(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  const int kind = lock == FolderLock::kShared ? LOCK_SH : LOCK_EX;
  while (file.is_open() && ::flock(file.value(), kind) != 0 && errno == EINTR) {
  }
  return file;
}

FileDescriptor create_beside(const std::string& target, std::string& name) {
  const std::string folder = std::filesystem::path(target).parent_path().string();
  name.clear();
  FileDescriptor file(::open(folder.empty() ? "." : folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600));
  if (file.is_open()) return file;
  std::string pattern = target + ".XXXXXX";
  file = FileDescriptor(::mkostemp(pattern.data(), O_CLOEXEC));
  if (file.is_open()) name = std::move(pattern);
  return file;
}

std::string give_name(const FileDescriptor& file, const std::string& target) {
  const std::string source = "/proc/self/fd/" + std::to_string(file.value());
  for (unsigned i = 0;; ++i) {
    std::string name = target + "." + std::to_string(::getpid()) + "." + std::to_string(i);
    if (::linkat(AT_FDCWD, source.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0) return name;
    if (errno != EEXIST) return {};
  }
}

bool remove_file(const char* path) noexcept {
  return ::unlink(path) == 0;
}

}  // namespace boxplus
