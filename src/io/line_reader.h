// SPDX-License-Identifier: BSD-3-Clause
// For formats whose lines begin with tags that are not those of a Registry.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "boxplus/base/function_ref.h"
#include "boxplus/io/field_reader.h"
#include "boxplus/io/graph_file.h"
#include "boxplus/io/text_source.h"

namespace boxplus {

/// Reads the rest of a line after its tag. `line` is the whole line.
using LineAction = detail::FunctionRef<void(std::string_view tag, FieldReader& in, std::string_view line)>;

/// Calls action() for each line that is neither blank nor a comment, in order, and counts all lines
/// (GraphFile::lines). If action() throws InputError and the reading is lenient, the line is skipped, noted
/// and counted. Then, action() must not have changed anything.
void read_lines(const TextSource& text, const ReadOptions& options, GraphFile& file, LineAction action);

/// The tag of the first line that is neither blank nor a comment, and for which `skipped` does not hold;
/// empty if there is none.
std::string_view first_tag(
    std::string_view text,
    detail::FunctionRef<bool(std::string_view tag)> skipped = [](std::string_view) { return false; });

/// Counts the lines with tags that a format does not use.
class OtherLines {
 public:
  void add(std::string_view tag) { ++counts_[std::string(tag)]; }
  /// Appends one note, which names the most frequent tags, if there are any lines.
  void append_note(std::vector<GraphFile::Note>& notes) const;

 private:
  std::map<std::string, std::int64_t> counts_;
};

}  // namespace boxplus
