// SPDX-License-Identifier: BSD-3-Clause
// Replaces a file by a new one.
#pragma once

#include <string>

#include "boxplus/base/function_ref.h"
#include "io/temporary_name.h"
#include "io/text_file.h"

namespace boxplus {

/// A new file that will replace the file at `path`, or the file to which `path` leads through symbolic links.
/// It is in the same folder. If the file system supports files without a name, the new file has none until
/// take_name(), so that it disappears if the process ends early. Otherwise, it has a temporary name, and
/// remove_temporary_files() can remove it. All functions throw FileError.
class Replacement {
 public:
  explicit Replacement(const std::string& path);

  /// The file that will be replaced.
  const std::string& target() const { return target_; }
  /// Passes a sink for the text to `write`, and waits until the text is on the disk.
  void write(detail::FunctionRef<void(TextSink)> write);
  /// Gives the new file the permissions of its target, and a name if it has none.
  void take_name();
  /// The name of the new file, which the caller must rename or remove: neither the destructor nor
  /// remove_temporary_files() will remove it. Call take_name() first.
  std::string release();
  /// Replaces the target.
  void take_place();

 private:
  std::string path_, target_;
  TemporaryName name_;
  FileDescriptor file_;
};

}  // namespace boxplus
