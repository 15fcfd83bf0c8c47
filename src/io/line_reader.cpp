// SPDX-License-Identifier: BSD-3-Clause
#include "io/line_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "boxplus/base/error.h"
#include "io/characters.h"
#include "io/without_place.h"

namespace boxplus {
namespace {

/// Removes the first line from `text`, and returns it without its newline.
std::string_view take_line(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return without_byte_order_mark(line);  // in concatenated files, any line may have one
}

}  // namespace

void read_lines(const TextSource& text, const ReadOptions& options, GraphFile& file, LineAction action) {
  std::string memory;
  for (std::size_t k = 0; k < text.block_count(); ++k) {
    std::string_view block = text.block(k, memory);
    while (!block.empty()) {
      const std::string_view line = take_line(block);
      FieldReader in(text.name(), ++file.lines, line);
      if (in.at_end()) continue;
      try {
        const std::string_view tag = in.token("a tag");
        action(tag, in, line);
      } catch (const InputError& error) {
        if (!options.lenient) throw;
        ++file.skipped;
        file.notes.push_back({file.lines, without_place(error, text.name()), error.column(), true});
      }
    }
  }
}

std::string_view first_tag(std::string_view text, detail::FunctionRef<bool(std::string_view)> skipped) {
  while (!text.empty()) {
    FieldReader line({}, 0, take_line(text));
    if (line.at_end()) continue;
    const std::string_view tag = line.token("a tag");
    if (!skipped(tag)) return tag;
  }
  return {};
}

void OtherLines::append_note(std::vector<GraphFile::Note>& notes) const {
  constexpr std::size_t kShown = 5;
  std::vector<std::pair<std::int64_t, std::string>> sorted;
  std::int64_t total = 0;
  for (const auto& [tag, count] : counts_) {
    sorted.emplace_back(-count, tag);
    total += count;
  }
  if (sorted.empty()) return;
  std::sort(sorted.begin(), sorted.end());
  std::string tags;
  for (std::size_t k = 0; k < std::min(kShown, sorted.size()); ++k)
    tags += fmt::format("{}{} {}", k == 0 ? "" : ", ", -sorted[k].first, in_quotes(sorted[k].second));
  if (sorted.size() > kShown) tags += ", …";
  notes.push_back({0, fmt::format("{} not part of the graph: {}",
                                  total == 1 ? "1 line is" : fmt::format("{} lines are", total), tags)});
}

}  // namespace boxplus
