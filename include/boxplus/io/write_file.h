// SPDX-License-Identifier: BSD-3-Clause
// Replaces a file completely or not at all: an interrupted program leaves the old file or the new one, never
// a part of the new one.
#pragma once

#include <string>
#include <string_view>

namespace boxplus {

/// Replaces a file atomically. Throws FileError.
void write_file(const std::string& path, std::string_view text);
/// Throws the FileError that write_file() would throw for this path, as far as this can be checked without
/// writing. Call it before a long computation, so that its result can be saved.
void require_writable(const std::string& path);
/// Removes the temporary files that unfinished calls of these functions have created. This function is only
/// for handlers of signals that end the process, and may be called at any time. If the file system supports
/// it, temporary files have no name and vanish by themselves.
void remove_temporary_files() noexcept;

}  // namespace boxplus
