// SPDX-License-Identifier: BSD-3-Clause
// Files. If a function fails, it returns false, nullopt or a file that is not open, and errno says why.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace boxplus {

/// An open file, which is closed when this object is destroyed.
class FileDescriptor {
 public:
  explicit FileDescriptor(int value = -1) : value_(value) {}
  FileDescriptor(FileDescriptor&& other) noexcept : value_(std::exchange(other.value_, -1)) {}
  FileDescriptor& operator=(FileDescriptor&& other) noexcept {
    std::swap(value_, other.value_);
    return *this;
  }
  ~FileDescriptor();

  bool is_open() const { return value_ >= 0; }
  int value() const { return value_; }
  /// The size of a regular file; nullopt for a pipe, a device, or a file that reports a size of 0.
  std::optional<std::size_t> regular_size() const;
  /// Reads up to `size` bytes, and returns their number. It is 0 only at the end of the file.
  std::optional<std::size_t> read(char* out, std::size_t size) const;
  /// The same from `offset` on. Reads fewer than `size` bytes only at the end of the file.
  std::optional<std::size_t> read_at(std::size_t offset, char* out, std::size_t size) const;
  /// Writes all of the text.
  bool write(std::string_view text) const;
  /// Waits until what was written is on the disk, if there is one.
  bool flush() const;
  /// Takes the permissions of the file at `path`, or the default permissions if there is no such file.
  bool take_permissions(const std::string& path) const;

 private:
  int value_;
};

FileDescriptor open_to_read(const std::string& path);
FileDescriptor open_to_write(const std::string& path);
/// Creates the file if there is none.
FileDescriptor open_to_append(const std::string& path);
/// Whether this process may open the file to write. Does not open it.
bool may_write(const std::string& path);

enum class FolderLock : bool { kShared, kExclusive };
/// Opens a folder, and locks it until it is closed, if its file system supports locks. Waits until no other
/// process has a lock that excludes this one.
FileDescriptor open_folder(const std::string& folder, FolderLock lock);

/// Creates a file in the folder of `target`. If the file system supports it, the file has no name, so that it
/// disappears when it is closed, and `name` is empty. Otherwise, its name is that of the target and more.
FileDescriptor create_beside(const std::string& target, std::string& name);
/// Gives a file without a name one, which is that of the target and more, and returns it. Empty on failure.
std::string give_name(const FileDescriptor& file, const std::string& target);
/// Signal handlers may call this function.
bool remove_file(const char* path) noexcept;

}  // namespace boxplus
