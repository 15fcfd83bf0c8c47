// SPDX-License-Identifier: BSD-3-Clause
#include "io/file_set.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <deque>
#include <filesystem>
#include <vector>

#include "boxplus/base/error.h"
#include "io/replacement.h"

namespace boxplus {
namespace {

[[noreturn]] void fail(const std::string& path, int error) {
  fail_at(path, "cannot be written", error);
}

std::string unfinished_path(const std::string& folder) {
  return (std::filesystem::path(folder) / kUnfinished).string();
}

/// An open folder, which has a lock until it is closed.
FileDescriptor locked(const std::string& folder, int kind) {
  FileDescriptor file(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!file.is_open()) fail_at(folder, "cannot be opened", errno);
  while (::flock(file.value(), kind) != 0 && errno == EINTR) {
  }
  return file;
}

bool exists(const std::string& path) {
  struct stat status {};
  return ::lstat(path.c_str(), &status) == 0;
}

std::string unused_name(const std::string& target) {
  std::string name;
  for (unsigned i = 0; name.empty() || exists(name); ++i)
    name = fmt::format("{}.{}.{}", target, ::getpid(), i);
  return name;
}

/// The renames that put complete new files in the places of the old ones.
class FileRenames {
 public:
  /// The new files must have their names.
  FileRenames(const std::string& folder, std::deque<Replacement>& replacements) : folder_(folder) {
    for (Replacement& replacement : replacements) steps_.push_back({replacement.target(), {}, {}});
    for (std::size_t i = 0; i < steps_.size(); ++i) steps_[i].fresh = replacements[i].release();
  }

  void run() {
    const bool was_unfinished = exists(unfinished_path(folder_));
    try {
      const FileDescriptor folder = locked(folder_, LOCK_EX);
      announce();
      ::fsync(folder.value());
      for (Step& step : steps_) take_place(step);
      ::fsync(folder.value());
    } catch (...) {
      if (put_back() && !was_unfinished) ::unlink(unfinished_path(folder_).c_str());
      throw;
    }
    ::unlink(unfinished_path(folder_).c_str());
    for (const Step& step : steps_) ::unlink(step.old.c_str());
  }

 private:
  struct Step {
    std::string target, fresh, old;  // old: a second name of the old file, or of no file
    bool has_old = false, is_done = false;
  };

  void announce() {
    std::string text =
        "boxplus was interrupted while it replaced files of this folder. Old and new files may be mixed.\n"
        "To get the new files, rename each file on the left that exists:\n";
    for (Step& step : steps_) {
      step.old = unused_name(step.target);
      text += fmt::format("  {} -> {}\n", step.fresh, step.target);
    }
    text +=
        "To get the old files, rename each file on the left that exists, and remove the others on the "
        "right:\n";
    for (const Step& step : steps_) text += fmt::format("  {} -> {}\n", step.old, step.target);
    text += "Then remove this file.\n";
    const std::string path = unfinished_path(folder_);
    const FileDescriptor file(::open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666));
    if (!file.is_open()) fail(path, errno);
    write_to(file, path, [&](TextSink sink) { sink(text); });
  }

  static void take_place(Step& step) {
    const char *target = step.target.c_str(), *old = step.old.c_str();
    require_regular(step.target);
    if (exists(step.target)) {
      // Not all file systems support a second name.
      if (::link(target, old) != 0 && ::rename(target, old) != 0) fail(step.target, errno);
      step.has_old = true;
    }
    if (::rename(step.fresh.c_str(), target) != 0) fail(step.target, errno);
    step.is_done = true;
  }

  /// Removes the new files and puts the old ones back. Returns false if this fails.
  bool put_back() noexcept {
    bool is_as_before = true;
    for (const Step& step : steps_) {
      const char* target = step.target.c_str();
      if (!step.is_done) ::unlink(step.fresh.c_str());
      if (step.has_old) {
        is_as_before &= ::rename(step.old.c_str(), target) == 0;
        ::unlink(step.old.c_str());  // rename() keeps both names of the same file
      } else if (step.is_done) {
        is_as_before &= ::unlink(target) == 0;
      }
    }
    return is_as_before;
  }

  const std::string& folder_;
  std::vector<Step> steps_;
};

}  // namespace

void require_regular(const std::string& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0 || S_ISREG(status.st_mode)) return;
  throw FileError(fmt::format("{}: cannot be written: expected a regular file or none, got {}", path,
                              S_ISDIR(status.st_mode)    ? "a folder"
                              : S_ISFIFO(status.st_mode) ? "a pipe"
                                                         : "a special file"));
}

void replace_together(const std::string& folder, std::span<const NewFile> files) {
  for (const NewFile& file : files) require_regular(file.path);
  std::deque<Replacement> replacements;
  for (const NewFile& file : files) replacements.emplace_back(file.path).write(file.write);
  for (Replacement& replacement : replacements) replacement.take_name();
  FileRenames(folder, replacements).run();
}

void open_together(const std::string& folder, detail::FunctionRef<void()> open) {
  const FileDescriptor lock = locked(folder, LOCK_SH);
  if (exists(unfinished_path(folder)))
    throw FileError(fmt::format(
        "{}: expected files that were written together, but writing them was interrupted, so that "
        "old and new files may be mixed; {} in this folder lists the files to rename",
        folder, kUnfinished));
  open();
}

}  // namespace boxplus
