// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/io/text_source.h"

#include <algorithm>
#include <utility>

#include "io/text_file.h"

namespace boxplus {
namespace {

constexpr std::size_t kFirstExtension = 4096;

}  // namespace

TextSource::TextSource(std::string_view text, std::string name, std::size_t block_size)
    : size_(text.size()), block_size_(block_size), text_(text), name_(std::move(name)) {}

TextSource TextSource::of_file(const std::string& path, std::size_t block_size) {
  TextSource source({}, path, block_size);
  FileDescriptor file = open_for_reading(path);
  if (const auto size = file.regular_size()) {
    source.size_ = *size;
    source.file_ = std::make_shared<const FileDescriptor>(std::move(file));
  } else {
    source.owned_ = read_all(file, path);
    source.size_ = source.owned_.size();
  }
  return source;
}

std::string_view TextSource::block(std::size_t k, std::string& memory) const {
  // A line begins after a newline, so the search for the first newline begins one byte before the block.
  const std::size_t begin = k == 0 ? 0 : k * block_size_ - 1, end = std::min((k + 1) * block_size_, size_);
  std::string_view part = bytes(begin, end - begin, memory);
  std::size_t first = 0;
  if (k > 0) {
    first = part.find('\n');
    if (first == std::string_view::npos || ++first >= part.size()) return {};  // no line begins in this block
  }
  // The last line may end in any later block.
  std::size_t searched = part.size() - 1, newline = part.find('\n', searched);
  for (std::size_t more = kFirstExtension; newline == std::string_view::npos; more *= 2) {
    const std::size_t wanted = part.size() + more;
    searched = part.size();
    part = bytes(begin, wanted, memory);
    newline = part.find('\n', searched);
    if (part.size() < wanted) break;  // the end of the text
  }
  return part.substr(first, newline == std::string_view::npos ? newline : newline + 1 - first);
}

/// The `count` bytes from `begin` on; fewer at the end of the text.
std::string_view TextSource::bytes(std::size_t begin, std::size_t count, std::string& memory) const {
  if (!file_) return (owned_.empty() ? text_ : std::string_view(owned_)).substr(begin, count);
  if (memory.size() < count) memory.resize(count);
  return {memory.data(), read_at(*file_, name_, begin, memory.data(), count)};
}

}  // namespace boxplus
