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

bool begins_as_gzip(const FileDescriptor& file, const std::string& path);

/// Both throw FileError, with `path` as the name of the packed file, if the file is damaged, if the text has
/// more than 64 GiB, or if there is no room for the temporary file.
UnpackedText unpack(const FileDescriptor& file, const std::string& path);
UnpackedText unpack(std::string_view packed, const std::string& path);

}  // namespace boxplus
