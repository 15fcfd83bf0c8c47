// SPDX-License-Identifier: BSD-3-Clause
#include "io/text_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "boxplus/base/error.h"
#include "boxplus/io/write_file.h"
#include "io/temporary_name.h"

namespace boxplus {
namespace {

[[noreturn]] void fail(const std::string& path, const char* what, int error) {
  throw FileError(fmt::format("{}: {}: {}", path, what, std::strerror(error)));
}

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

/// The permissions of the file that is replaced, or the default permissions if there is no such file.
mode_t permissions_for(const std::string& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) == 0) return status.st_mode & 07777;
  const mode_t mask = ::umask(0);
  ::umask(mask);
  return 0666 & ~mask;
}

bool is_special_file(const std::string& path) {
  struct stat status {};
  return ::stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode);
}

/// The file to which `path` leads through symbolic links. The caller replaces or creates this file, and not a
/// link.
std::string target_of(const std::string& path) {
  constexpr int kMostLinks = 40;
  std::filesystem::path target = path;
  std::error_code error;
  for (int i = 0; std::filesystem::is_symlink(target, error); ++i) {
    if (i == kMostLinks) fail(path, "cannot be written", ELOOP);
    target = target.parent_path() / std::filesystem::read_symlink(target, error);
  }
  return target.string();
}

void write_to(const FileDescriptor& file, const std::string& path,
              detail::FunctionRef<void(TextSink)> write) {
  write([&](std::string_view text) {
    if (const int error = write_all(file.value(), text); error != 0) fail(path, "cannot be written", error);
  });
  if (const int error = flush(file.value()); error != 0) fail(path, "cannot be written", error);
}

/// A new file in the folder of `target` that will replace `target`. If the file system supports files without
/// a name, the new file gets its name only at the end, so that it disappears if the process ends early.
/// Otherwise, the file has a temporary name, and remove_temporary_files() can remove it.
class Replacement {
 public:
  Replacement(const std::string& path, const std::string& target) : path_(path), target_(target) {
    const std::string folder = std::filesystem::path(target).parent_path().string();
    file_ =
        FileDescriptor(::open(folder.empty() ? "." : folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0600));
    if (!file_.is_open()) file_ = make_named();
    if (!file_.is_open()) fail(path_, "cannot be written", errno);
  }
  const FileDescriptor& file() const { return file_; }
  void take_place() {
    if (::fchmod(file_.value(), permissions_for(target_)) != 0 || !has_name() ||
        ::rename(name_.c_str(), target_.c_str()) != 0) {
      fail(path_, "cannot be written", errno);
    }
    name_.release();
  }

 private:
  FileDescriptor make_named() {
    std::string name = target_ + ".XXXXXX";
    FileDescriptor file(::mkstemp(name.data()));
    if (file.is_open()) name_.assign(std::move(name));
    return file;
  }

  /// Gives the file a name if it has none. Returns false if this fails.
  bool has_name() {
    if (!name_.empty()) return true;
    const std::string source = fmt::format("/proc/self/fd/{}", file_.value());
    for (unsigned i = 0;; ++i) {
      std::string name = fmt::format("{}.{}.{}", target_, ::getpid(), i);
      if (::linkat(AT_FDCWD, source.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0) {
        name_.assign(std::move(name));
        return true;
      }
      if (errno != EEXIST) return false;
    }
  }

  const std::string &path_, &target_;
  TemporaryName name_;
  FileDescriptor file_;
};

}  // namespace

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
  if (!file.is_open()) fail(path, "cannot be opened", errno);
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
    if (count < 0) fail(path, "cannot be read", errno);
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
    if (count < 0) fail(path, "cannot be read", errno);
    if (count == 0) break;
    total += static_cast<std::size_t>(count);
  }
  return total;
}

void replace_file(const std::string& path, detail::FunctionRef<void(TextSink)> write) {
  if (is_special_file(path)) {
    const FileDescriptor file(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
    if (!file.is_open()) fail(path, "cannot be written", errno);
    write_to(file, path, write);
    return;
  }
  const std::string target = target_of(path);
  Replacement replacement(path, target);
  write_to(replacement.file(), path, write);
  replacement.take_place();
}

void require_writable(const std::string& path) {
  if (is_special_file(path)) {
    if (::access(path.c_str(), W_OK) != 0) fail(path, "cannot be written", errno);
    return;
  }
  std::error_code none;
  if (std::filesystem::is_directory(path, none)) fail(path, "cannot be written", EISDIR);
  const std::string target = target_of(path);
  const Replacement probe(path, target);
}

void write_file(const std::string& path, std::string_view text) {
  replace_file(path, [&](TextSink sink) { sink(text); });
}

}  // namespace boxplus
