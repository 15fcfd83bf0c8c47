// SPDX-License-Identifier: BSD-3-Clause
#include "io/replacement.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <system_error>
#include <utility>

namespace boxplus {
namespace {

[[noreturn]] void fail(const std::string& path, int error) {
  fail_at(path, "cannot be written", error);
}

/// The permissions of the file that is replaced, or the default permissions if there is no such file.
mode_t permissions_for(const std::string& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) == 0) return status.st_mode & 07777;
  const mode_t mask = ::umask(0);
  ::umask(mask);
  return 0666 & ~mask;
}

/// The file to which `path` leads through symbolic links. The caller replaces or creates this file, and not a
/// link.
std::string target_of(const std::string& path) {
  constexpr int kMostLinks = 40;
  std::filesystem::path target = path;
  std::error_code error;
  for (int i = 0; std::filesystem::is_symlink(target, error); ++i) {
    if (i == kMostLinks) fail(path, ELOOP);
    target = target.parent_path() / std::filesystem::read_symlink(target, error);
  }
  return target.string();
}

}  // namespace

Replacement::Replacement(const std::string& path) : path_(path), target_(target_of(path)) {
  const std::string folder = std::filesystem::path(target_).parent_path().string();
  file_ =
      FileDescriptor(::open(folder.empty() ? "." : folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0600));
  if (!file_.is_open()) file_ = make_named();
  if (!file_.is_open()) fail(path_, errno);
}

void Replacement::write(detail::FunctionRef<void(TextSink)> write) {
  write_to(file_, path_, write);
}

void Replacement::take_name() {
  if (::fchmod(file_.value(), permissions_for(target_)) != 0 || !has_name()) fail(path_, errno);
}

std::string Replacement::release() {
  std::string name = name_.c_str();
  name_.release();
  return name;
}

void Replacement::take_place() {
  take_name();
  if (::rename(name_.c_str(), target_.c_str()) != 0) fail(path_, errno);
  name_.release();
}

FileDescriptor Replacement::make_named() {
  std::string name = target_ + ".XXXXXX";
  FileDescriptor file(::mkstemp(name.data()));
  if (file.is_open()) name_.assign(std::move(name));
  return file;
}

/// Gives the file a name if it has none. Returns false if this fails.
bool Replacement::has_name() {
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

}  // namespace boxplus
