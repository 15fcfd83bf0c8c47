// SPDX-License-Identifier: BSD-3-Clause
// Files of one folder that belong together, because only all of them are a graph. They are replaced all or
// not at all.
//
// All new files are complete, on the disk and beside their targets before the first one is renamed. If
// renaming fails, the old files are put back. If the process or the machine stops between two renames, a file
// kUnfinished stays in the folder. Readers refuse a folder with this file, which names all new and old files,
// so that nothing is lost. A lock on the folder keeps readers and other writers away from the renames, if the
// file system supports it.
#pragma once

#include <functional>
#include <span>
#include <string>

#include "io/text_file.h"

namespace boxplus {

/// In the folder while its files are replaced.
inline constexpr const char* kUnfinished = "boxplus_unfinished.txt";

/// A file to write.
struct NewFile {
  std::string path;
  std::function<void(TextSink)> write;
};

/// Throws FileError if the file exists, but is not a regular file or a link to one.
void require_regular(const std::string& path);

/// Replaces files of `folder`, or creates them. The folder must exist. Throws FileError, and whatever the
/// files' functions throw. Then the old files are unchanged. If they could not be put back after an error,
/// kUnfinished stays.
void replace_together(const std::string& folder, std::span<const NewFile> files);

/// Opens files of `folder` while no replace_together() of another process renames them. Throws FileError if
/// one was interrupted, and whatever `open` throws.
void open_together(const std::string& folder, detail::FunctionRef<void()> open);

}  // namespace boxplus
