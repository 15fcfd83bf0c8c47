// SPDX-License-Identifier: BSD-3-Clause
// A block of lines, split into tags and numbers. Splitting needs no graph, so several threads can do it.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "boxplus/io/field_reader.h"
#include "boxplus/io/registry.h"
#include "boxplus/io/text_source.h"

namespace boxplus {

using Renames = std::map<std::string, std::string, std::less<>>;

/// Finds the types that the tags of a file stand for.
class TagLookup {
 public:
  TagLookup(const Registry& registry, const Renames& renames) : registry_(registry), renames_(renames) {}
  /// nullptr if the tag is unknown.
  const Tag* find(std::string_view tag) const {
    const auto renamed = renames_.find(tag);
    return registry_.find(renamed == renames_.end() ? tag : renamed->second);
  }

 private:
  const Registry& registry_;
  const Renames& renames_;
};

/// A line that is not blank.
struct Line {
  enum class Kind : std::uint8_t {
    kElement,  ///< of the type `tag`
    kFix,
    kUnknown,
    kComment
  };
  std::string_view text;
  std::int64_t number = 0;  ///< from 1; within the block for LineBlock::lines
  Kind kind = Kind::kUnknown;
  bool is_numeric = false;  ///< an element whose fields are all numbers: `fields` holds them
  const Tag* tag = nullptr;
  NumericFields fields = {};
  std::size_t value_count = 0;
};

/// The lines of one block. A worker uses its memory again for the next block.
class LineBlock {
 public:
  void read(const TextSource& source, std::size_t k, const TagLookup& tags);
  const std::vector<Line>& lines() const { return lines_; }
  /// The number of lines that begin in the block, including blank ones.
  std::int64_t line_count() const { return line_count_; }

 private:
  void read_line(std::string_view text, const TagLookup& tags);
  void place_fields();
  bool read_fields(const char* at, const char* end, std::size_t& integers);

  std::string memory_;
  std::vector<double> values_;  // the fields of all numeric lines
  std::vector<Line> lines_;
  std::int64_t line_count_ = 0;
  const char* text_end_ = nullptr;  // of the block; characters before it may be read
  std::string_view last_name_;      // most lines begin like the one before
  const Tag* last_tag_ = nullptr;
};

}  // namespace boxplus
