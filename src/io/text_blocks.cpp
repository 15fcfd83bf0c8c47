// SPDX-License-Identifier: BSD-3-Clause
#include "io/text_blocks.h"

#include <algorithm>

namespace boxplus {

TextBlocks::TextBlocks(std::string_view text, std::size_t block_size)
    : size_(text.size()), block_size_(block_size), text_(text) {}

TextBlocks TextBlocks::of_file(const std::string& path, std::size_t block_size) {
  TextBlocks blocks({}, block_size);
  blocks.path_ = path;
  blocks.file_ = open_for_reading(path);
  if (const auto size = blocks.file_.regular_size()) {
    blocks.size_ = *size;
  } else {
    blocks.owned_ = read_all(blocks.file_, path);
    blocks.size_ = blocks.owned_.size();
    blocks.file_ = FileDescriptor();
  }
  return blocks;
}

std::string_view TextBlocks::read(std::size_t k, std::string& memory) const {
  // A line begins after a newline: its search begins one byte earlier.
  const std::size_t begin = k == 0 ? 0 : k * block_size_ - 1, end = std::min((k + 1) * block_size_, size_);
  std::string_view lines = file_.is_open() ? read_file(begin, end, memory) : read_text(begin, end);
  if (k == 0) return lines;
  const std::size_t newline = lines.substr(0, end - begin).find('\n');
  // Where the block's last byte is the newline, the next line begins in the next block.
  if (newline == std::string_view::npos || begin + newline + 1 >= end) return {};
  return lines.substr(newline + 1);
}

/// From `begin` to the end of the line that holds byte end − 1.
std::string_view TextBlocks::read_text(std::size_t begin, std::size_t end) const {
  const std::string_view text = owned_.empty() ? text_ : std::string_view(owned_);
  const std::size_t newline = text.find('\n', end - 1);
  return text.substr(begin, newline == std::string_view::npos ? newline : newline + 1 - begin);
}

std::string_view TextBlocks::read_file(std::size_t begin, std::size_t end, std::string& memory) const {
  constexpr std::size_t kMore = 4096;
  const std::size_t searched = end - 1 - begin;
  std::size_t wanted = end - begin + kMore, count = 0, from = searched;
  for (;;) {
    if (memory.size() < wanted) memory.resize(wanted);
    count += read_at(file_, path_, begin + count, memory.data() + count, wanted - count);
    const std::string_view text(memory.data(), count);
    const std::size_t newline = text.find('\n', from);
    if (newline != std::string_view::npos) return text.substr(0, newline + 1);
    if (count < wanted) return text;  // the end of the file
    from = count;
    wanted *= 2;
  }
}

}  // namespace boxplus
