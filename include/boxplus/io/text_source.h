// SPDX-License-Identifier: BSD-3-Clause
// The text that a file format reads.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

#include "boxplus/base/abi.h"

namespace boxplus {

class FileDescriptor;

/// Text in blocks of whole lines, for several workers. If s is the block size, block k holds the lines that
/// begin in the bytes [k s, (k + 1) s). A file is read block by block, so that it is never completely in
/// memory. A file in gzip is unpacked first. A pipe or a device is read completely.
class TextSource {
 public:
  static constexpr std::size_t kBlockSize = std::size_t{1} << 17;

  /// The text must outlive the source. Messages use `name` as the name of the file.
  TextSource(std::string_view text, std::string name, std::size_t block_size = kBlockSize);
  /// Throws FileError if the file cannot be opened or read.
  static TextSource of_file(const std::string& path, std::size_t block_size = kBlockSize);

  const std::string& name() const { return name_; }
  /// The number of bytes.
  std::size_t size() const { return size_; }
  std::size_t block_count() const { return (size_ + block_size_ - 1) / block_size_; }
  /// The lines of block k, each with its newline. May use `memory` to hold them. Thread-safe.
  std::string_view block(std::size_t k, std::string& memory) const;
  /// The `count` bytes from `begin` on; fewer at the end of the text. May use `memory` to hold them.
  /// Thread-safe.
  std::string_view bytes(std::size_t begin, std::size_t count, std::string& memory) const;
  /// The whole text. May use `memory` to hold it.
  std::string_view text(std::string& memory) const { return bytes(0, size_, memory); }

 private:
  std::size_t size_ = 0, block_size_;
  std::string_view text_;
  std::string name_, owned_;
  std::shared_ptr<const FileDescriptor> file_;
};

}  // namespace boxplus
