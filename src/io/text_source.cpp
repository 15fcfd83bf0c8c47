// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/io/text_source.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "io/gzip.h"
#include "io/text_file.h"
#include "io/unpacked_text.h"

namespace boxplus {
namespace {

constexpr std::size_t kFirstExtension = 4096;

}  // namespace

TextSource::TextSource(std::string_view text, std::string name, std::size_t block_size)
    : size_(text.size()), block_size_(block_size), text_(text), name_(std::move(name)) {
  if (!begins_as_gzip(text)) return;
  UnpackedText unpacked = unpack(text, name_);
  size_ = unpacked.size;
  text_ = {};
  owned_ = std::move(unpacked.text);
  if (unpacked.file.is_open()) file_ = std::make_shared<const FileDescriptor>(std::move(unpacked.file));
}

TextSource TextSource::of_file(const std::string& path, std::size_t block_size) {
  TextSource source({}, path, block_size);
  FileDescriptor file = open_for_reading(path);
  const std::optional<std::size_t> size = file.regular_size();
  if (size && begins_as_gzip(file, path)) {
    UnpackedText unpacked = unpack(file, path);
    source.size_ = unpacked.size;
    source.owned_ = std::move(unpacked.text);
    file = std::move(unpacked.file);
  } else if (size) {
    source.size_ = *size;
  } else {
    std::string text = read_all(file, path);
    if (begins_as_gzip(text)) return {text, path, block_size};
    source.size_ = text.size();
    source.owned_ = std::move(text);
    file = FileDescriptor();
  }
  if (file.is_open()) source.file_ = std::make_shared<const FileDescriptor>(std::move(file));
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

std::string_view TextSource::bytes(std::size_t begin, std::size_t count, std::string& memory) const {
  if (!file_) return (owned_.empty() ? text_ : std::string_view(owned_)).substr(begin, count);
  if (memory.size() < count) memory.resize(count);
  return {memory.data(), read_at(*file_, name_, begin, memory.data(), count)};
}

}  // namespace boxplus
