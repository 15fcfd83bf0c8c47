// SPDX-License-Identifier: BSD-3-Clause
// A text in blocks of whole lines, for several workers.
#pragma once

#include <string>
#include <string_view>

#include "io/text_file.h"

namespace boxplus {

/// Block k holds the lines that begin in bytes [k s, (k + 1) s) of the text, s being the block size. A file
/// is read block by block, so that it never lies in memory as a whole; what is no regular file (a pipe) does.
class TextBlocks {
 public:
  static constexpr std::size_t kBlockSize = std::size_t{1} << 17;

  /// The text must outlive the blocks.
  explicit TextBlocks(std::string_view text, std::size_t block_size = kBlockSize);
  /// Throws FileError where the file cannot be opened or read.
  static TextBlocks of_file(const std::string& path, std::size_t block_size = kBlockSize);

  std::size_t count() const { return (size_ + block_size_ - 1) / block_size_; }
  /// The lines of block k, each with its newline; `memory` may hold them. Several threads may read at once.
  std::string_view read(std::size_t k, std::string& memory) const;

 private:
  std::string_view bytes(std::size_t begin, std::size_t count, std::string& memory) const;

  std::size_t size_ = 0, block_size_;
  std::string_view text_;
  std::string path_, owned_;
  FileDescriptor file_;
};

}  // namespace boxplus
