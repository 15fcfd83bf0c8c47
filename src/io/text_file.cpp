// SPDX-License-Identifier: BSD-3-Clause
#include "io/text_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "boxplus/base/error.h"
#include "boxplus/io/graph_file.h"

namespace boxplus {
namespace {

[[noreturn]] void fail(const std::string& path, const char* what, int error) {
  throw FileError(fmt::format("{}: {}: {}", path, what, std::strerror(error)));
}

/// An open file, closed at the end of the scope.
struct Descriptor {
  int value;
  ~Descriptor() {
    if (value >= 0) ::close(value);
  }
};

/// Writes all of `text` and has it reach the disk; the error number, or 0.
int write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  return ::fsync(descriptor) != 0 && errno != EINVAL ? errno : 0;
}

/// The permissions of the file that is replaced, or those of a new one.
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

/// A link stays a link: the file that it names is replaced.
std::string target_of(const std::string& path) {
  std::error_code none;
  return std::filesystem::is_symlink(path, none) ? std::filesystem::weakly_canonical(path, none).string()
                                                 : path;
}

/// Pipes and devices, such as /dev/stdout, cannot be replaced: they are written to.
void write_through(const std::string& path, std::string_view text) {
  const Descriptor file{::open(path.c_str(), O_WRONLY | O_CLOEXEC)};
  if (file.value < 0) fail(path, "cannot be written", errno);
  if (const int error = write_all(file.value, text); error != 0) fail(path, "cannot be written", error);
}

}  // namespace

std::string read_file(const std::string& path) {
  const Descriptor file{::open(path.c_str(), O_RDONLY | O_CLOEXEC)};
  if (file.value < 0) fail(path, "cannot be opened", errno);
  struct stat status {};
  std::string text;
  if (::fstat(file.value, &status) == 0 && status.st_size > 0)
    text.reserve(static_cast<std::size_t>(status.st_size));
  constexpr std::size_t kChunk = std::size_t{1} << 20;
  for (;;) {
    const std::size_t size = text.size();
    text.resize(size + kChunk);
    const ssize_t count = ::read(file.value, text.data() + size, kChunk);
    text.resize(size + static_cast<std::size_t>(count > 0 ? count : 0));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail(path, "cannot be read", errno);
    if (count == 0) return text;
  }
}

void require_writable(const std::string& path) {
  if (is_special_file(path)) {
    if (::access(path.c_str(), W_OK) != 0) fail(path, "cannot be written", errno);
    return;
  }
  std::error_code none;
  if (std::filesystem::is_directory(path, none)) fail(path, "cannot be written", EISDIR);
  std::string probe = target_of(path) + ".XXXXXX";
  const Descriptor file{::mkstemp(probe.data())};
  if (file.value < 0) fail(path, "cannot be written", errno);
  ::unlink(probe.c_str());
}

void write_file(const std::string& path, std::string_view text) {
  if (is_special_file(path)) return write_through(path, text);
  const std::string target = target_of(path);
  std::string temporary = target + ".XXXXXX";
  int error = 0;
  {
    const Descriptor file{::mkstemp(temporary.data())};
    if (file.value < 0) fail(path, "cannot be written", errno);
    error = write_all(file.value, text);
    if (error == 0 && ::fchmod(file.value, permissions_for(target)) != 0) error = errno;
  }
  if (error == 0 && ::rename(temporary.c_str(), target.c_str()) != 0) error = errno;
  if (error != 0) {
    ::unlink(temporary.c_str());
    fail(path, "cannot be written", error);
  }
}

}  // namespace boxplus
