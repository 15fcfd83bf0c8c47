// SPDX-License-Identifier: BSD-3-Clause
#include "io/unpacked_text.h"

#include <fmt/format.h>

#include <cerrno>
#include <filesystem>
#include <system_error>
#include <utility>

#include "boxplus/base/error.h"
#include "io/gzip.h"
#include "platform/files.h"

namespace boxplus {
namespace {

/// Longer texts are in a temporary file.
constexpr std::size_t kLongestInMemory = std::size_t{1} << 26;

[[noreturn]] void fail_to_unpack(const std::string& path, int error) {
  fail_at(path, "cannot be unpacked into the folder of temporary files", error);
}

FileDescriptor make_temporary(const std::string& path) {
  std::error_code none;
  const std::string folder = std::filesystem::temp_directory_path(none).string();
  std::string name;
  FileDescriptor file = create_beside((folder.empty() ? "/tmp" : folder) + "/boxplus", name);
  if (!file.is_open()) fail_to_unpack(path, errno);
  if (!name.empty()) remove_file(name.c_str());
  return file;
}

/// Collects the text.
class Unpacker {
 public:
  Unpacker(const std::string& path, const UnpackLimits& limits) : path_(path), limits_(limits) {}

  /// `packed` is the number of packed bytes from which all of the text so far was unpacked.
  void append(std::string_view text, std::size_t packed) {
    result_.size += text.size();
    if (result_.size > limits_.size)
      throw FileError(fmt::format("{}: cannot be unpacked: expected at most {} bytes", path_, limits_.size));
    if (result_.size > limits_.small_size && result_.size / limits_.ratio > packed) {
      throw FileError(fmt::format(
          "{}: cannot be unpacked: expected a text that is at most {} times as long as the packed "
          "file, got {} bytes from {} (to read it anyway, unpack it with gunzip)",
          path_, limits_.ratio, result_.size, packed));
    }
    if (!result_.file.is_open() && result_.size > kLongestInMemory) {
      result_.file = make_temporary(path_);
      write(std::exchange(result_.text, {}));
    }
    result_.file.is_open() ? write(text) : void(result_.text += text);
  }
  UnpackedText take() { return std::move(result_); }

 private:
  void write(std::string_view text) const {
    if (!result_.file.write(text)) fail_to_unpack(path_, errno);
  }

  const std::string& path_;
  const UnpackLimits& limits_;
  UnpackedText result_;
};

}  // namespace

bool begins_as_gzip(const FileDescriptor& file, const std::string& path) {
  char bytes[4];
  return begins_as_gzip({bytes, read_at(file, path, 0, bytes, sizeof bytes)});
}

UnpackedText unpack(const FileDescriptor& file, const std::string& path, const UnpackLimits& limits) {
  std::string memory(std::size_t{1} << 17, '\0');
  std::size_t offset = 0;
  const auto next = [&]() -> std::string_view {
    const std::size_t count = read_at(file, path, offset, memory.data(), memory.size());
    offset += count;
    return {memory.data(), count};
  };
  Unpacker unpacker(path, limits);
  unpack_gzip(path, next, [&](std::string_view text) { unpacker.append(text, offset); });
  return unpacker.take();
}

UnpackedText unpack(std::string_view packed, const std::string& path, const UnpackLimits& limits) {
  const std::size_t size = packed.size();
  const auto next = [&] { return std::exchange(packed, {}); };
  Unpacker unpacker(path, limits);
  unpack_gzip(path, next, [&](std::string_view text) { unpacker.append(text, size); });
  return unpacker.take();
}

}  // namespace boxplus
