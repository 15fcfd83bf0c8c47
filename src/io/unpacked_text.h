// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "io/text_file.h"

namespace boxplus {

/// The text of a packed file. A long text is in a temporary file without a name, which disappears with its
/// descriptor, so that the text is never completely in memory.
struct UnpackedText {
  std::size_t size = 0;
  std::string text;     ///< if `file` is not open
  FileDescriptor file;  ///< may be read from any offset
};

/// What is unpacked at most.
struct UnpackLimits {
  std::size_t size = std::size_t{1} << 36;  ///< bytes; a packed file must not fill the disk
  /// A text of more than `small_size` bytes must not be more than `ratio` times as long as its packed form.
  /// Graphs have ratios below 30, but a packed file of 10 MB can also hold 10 GB of empty lines.
  std::size_t small_size = std::size_t{1} << 28;
  std::size_t ratio = 200;
};

bool begins_as_gzip(const FileDescriptor& file, const std::string& path);

/// Both throw FileError, with `path` as the name of the packed file, if the file is damaged, if the text
/// exceeds the limits, or if there is no room for the temporary file.
UnpackedText unpack(const FileDescriptor& file, const std::string& path, const UnpackLimits& limits = {});
UnpackedText unpack(std::string_view packed, const std::string& path, const UnpackLimits& limits = {});

}  // namespace boxplus
