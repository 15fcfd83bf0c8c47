// SPDX-License-Identifier: BSD-3-Clause
// Reads and replaces files.
#pragma once

#include <cstddef>
#include <string>

#include "boxplus/base/function_ref.h"
#include "boxplus/io/text_sink.h"
#include "platform/files.h"

namespace boxplus {

/// Throws FileError: "path: what: the text of errno's value `error`".
[[noreturn]] void fail_at(const std::string& path, const char* what, int error);

/// These functions throw FileError, with `path` as the name of the file.
FileDescriptor open_for_reading(const std::string& path);
std::string read_all(const FileDescriptor& file, const std::string& path);
/// Up to `size` bytes from `offset` on; fewer only at the end of the file.
std::size_t read_at(const FileDescriptor& file, const std::string& path, std::size_t offset, char* out,
                    std::size_t size);

/// Writes to an open file, and waits until the text is on the disk, if there is one.
void write_to(const FileDescriptor& file, const std::string& path, detail::FunctionRef<void(TextSink)> write);

}  // namespace boxplus
