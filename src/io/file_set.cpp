// SPDX-License-Identifier: BSD-3-Clause
#include "io/file_set.h"

#include <fmt/format.h>

#include <cerrno>
#include <deque>
#include <filesystem>
#include <system_error>
#include <vector>

#include "boxplus/base/error.h"
#include "io/replacement.h"
#include "platform/files.h"
#include "platform/process.h"

namespace boxplus {
namespace {

[[noreturn]] void fail(const std::string& path, int error) {
  fail_at(path, "cannot be written", error);
}

std::string unfinished_path(const std::string& folder) {
  return (std::filesystem::path(folder) / kUnfinished).string();
}

/// An open folder, which has a lock until it is closed.
FileDescriptor locked(const std::string& folder, FolderLock lock) {
  FileDescriptor file = open_folder(folder, lock);
  if (!file.is_open()) fail_at(folder, "cannot be opened", errno);
  return file;
}

bool is_taken(const std::filesystem::path& path) {
  std::error_code none;
  return std::filesystem::exists(std::filesystem::symlink_status(path, none));
}

std::string unused_name(const std::string& target) {
  std::string name;
  for (unsigned i = 0; name.empty() || is_taken(name); ++i)
    name = fmt::format("{}.{}.{}", target, process_id(), i);
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
    const bool was_unfinished = is_taken(unfinished_path(folder_));
    try {
      const FileDescriptor folder = locked(folder_, FolderLock::kExclusive);
      announce();
      folder.flush();
      for (Step& step : steps_) take_place(step);
      folder.flush();
    } catch (...) {
      if (put_back() && !was_unfinished) remove_file(unfinished_path(folder_).c_str());
      throw;
    }
    remove_file(unfinished_path(folder_).c_str());
    for (const Step& step : steps_) remove_file(step.old.c_str());
  }

 private:
  struct Step {
    std::filesystem::path target, fresh, old;  // old: a second name of the old file, or of no file
    bool has_old = false, is_done = false;
  };

  void announce() {
    std::string text =
        "boxplus was interrupted while it replaced files of this folder. Old and new files may be mixed.\n"
        "To get the new files, rename each file on the left that exists:\n";
    for (Step& step : steps_) {
      step.old = unused_name(step.target.string());
      text += fmt::format("  {} -> {}\n", step.fresh.string(), step.target.string());
    }
    text +=
        "To get the old files, rename each file on the left that exists, and remove the others on the "
        "right:\n";
    for (const Step& step : steps_)
      text += fmt::format("  {} -> {}\n", step.old.string(), step.target.string());
    text += "Then remove this file.\n";
    const std::string path = unfinished_path(folder_);
    const FileDescriptor file = open_to_append(path);
    if (!file.is_open()) fail(path, errno);
    write_to(file, path, [&](TextSink sink) { sink(text); });
  }

  static void take_place(Step& step) {
    std::error_code error;
    require_regular(step.target.string());
    if (is_taken(step.target)) {
      std::filesystem::create_hard_link(step.target, step.old, error);
      // Not all file systems support a second name.
      if (error) std::filesystem::rename(step.target, step.old, error);
      if (error) fail(step.target.string(), error.value());
      step.has_old = true;
    }
    std::filesystem::rename(step.fresh, step.target, error);
    if (error) fail(step.target.string(), error.value());
    step.is_done = true;
  }

  /// Removes the new files and puts the old ones back. Returns false if this fails.
  bool put_back() noexcept {
    bool is_as_before = true;
    for (const Step& step : steps_) {
      if (!step.is_done) remove_file(step.fresh.c_str());
      if (step.has_old) {
        std::error_code error;
        std::filesystem::rename(step.old, step.target, error);
        is_as_before &= !error;
        remove_file(step.old.c_str());  // rename() keeps both names of the same file
      } else if (step.is_done) {
        is_as_before &= remove_file(step.target.c_str());
      }
    }
    return is_as_before;
  }

  const std::string& folder_;
  std::vector<Step> steps_;
};

}  // namespace

void require_regular(const std::string& path) {
  std::error_code none;
  const std::filesystem::file_status status = std::filesystem::status(path, none);
  if (!std::filesystem::exists(status) || std::filesystem::is_regular_file(status)) return;
  throw FileError(fmt::format("{}: cannot be written: expected a regular file or none, got {}", path,
                              std::filesystem::is_directory(status) ? "a folder"
                              : std::filesystem::is_fifo(status)    ? "a pipe"
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
  const FileDescriptor lock = locked(folder, FolderLock::kShared);
  if (is_taken(unfinished_path(folder))) {
    throw FileError(fmt::format(
        "{}: expected files that were written together, but writing them was interrupted, so that "
        "old and new files may be mixed; {} in this folder lists the files to rename",
        folder, kUnfinished));
  }
  open();
}

}  // namespace boxplus
