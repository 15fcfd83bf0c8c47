// SPDX-License-Identifier: BSD-3-Clause
// Splits a block of lines into tags and numbers. This does not access the graph, so several threads can split
// blocks at once.
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

/// Looks up the tags of a file in the registry, after it has replaced the tags that the user wants to rename.
class TagLookup {
 public:
  TagLookup(const Registry& registry, const Renames& renames) : registry_(registry), renames_(renames) {}
  /// nullptr if the tag is unknown.
  const Tag* find(std::string_view tag) const {
    const auto renamed = renames_.find(tag);
    return registry_.find(renamed == renames_.end() ? tag : renamed->second);
  }
  const Registry& registry() const { return registry_; }

 private:
  const Registry& registry_;
  const Renames& renames_;
};

/// A line that is not blank.
struct Line {
  enum class Kind : std::uint8_t {
    kElement,  ///< a vertex, a parameter or an edge of the type `tag`
    kFix,
    kUnknown,
    kComment
  };
  std::string_view text;
  std::int64_t number = 0;  ///< the line number, from 1; in LineBlock::lines(), it counts within the block
  Kind kind = Kind::kUnknown;
  bool is_numeric = false;  ///< whether this is an element, and `fields` contains all its fields
  const Tag* tag = nullptr;
  NumericFields fields = {};
  std::size_t value_count = 0;
};

/// The lines of one block. A worker reads one block after another into the same object, to reuse its memory.
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
  const char* text_end_ = nullptr;  // the end of the block's text; all characters before it may be read
  std::string_view last_name_;      // the last tag that was looked up; the next line often has the same tag
  const Tag* last_tag_ = nullptr;
};

}  // namespace boxplus
