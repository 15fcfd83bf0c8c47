// SPDX-License-Identifier: BSD-3-Clause
// Writes a file as a whole: programs that are interrupted leave the old file, or the new one, and nothing
// else.
#pragma once

#include <string>
#include <string_view>

namespace boxplus {

/// Replaces a file atomically. Throws FileError.
void write_file(const std::string& path, std::string_view text);
/// Throws the FileError that write_file() would throw for this path, as far as this can be checked without
/// writing. Call it before a long computation, whose result could otherwise not be saved.
void require_writable(const std::string& path);
/// Removes the files that these functions have begun and not finished. Only for handlers of signals that end
/// the process; it may be called at any time. If the file system supports it, unfinished files have no name
/// and vanish by themselves.
void remove_temporary_files() noexcept;

}  // namespace boxplus
