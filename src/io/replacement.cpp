// SPDX-License-Identifier: BSD-3-Clause
#include "io/replacement.h"

#include <cerrno>
#include <filesystem>
#include <system_error>
#include <utility>

namespace boxplus {
namespace {

[[noreturn]] void fail(const std::string& path, int error) {
  fail_at(path, "cannot be written", error);
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
  std::string name;
  file_ = create_beside(target_, name);
  if (!file_.is_open()) fail(path_, errno);
  if (!name.empty()) name_.assign(std::move(name));
}

void Replacement::write(detail::FunctionRef<void(TextSink)> write) {
  write_to(file_, path_, write);
}

void Replacement::take_name() {
  if (!file_.take_permissions(target_)) fail(path_, errno);
  if (!name_.empty()) return;
  std::string name = give_name(file_, target_);
  if (name.empty()) fail(path_, errno);
  name_.assign(std::move(name));
}

std::string Replacement::release() {
  std::string name = name_.c_str();
  name_.release();
  return name;
}

void Replacement::take_place() {
  take_name();
  std::error_code error;
  std::filesystem::rename(name_.c_str(), target_, error);
  if (error) fail(path_, error.value());
  name_.release();
}

}  // namespace boxplus
