// SPDX-License-Identifier: BSD-3-Clause
#include "info/edge_lines.h"

#include <algorithm>
#include <set>

#include "boxplus/io/registry.h"

namespace boxplus::app {
namespace {

bool begins_edge(std::string_view line, const ReadOptions& reading) {
  FieldReader in("", 0, line);
  if (in.at_end()) return false;
  const std::string_view name = in.token("a tag");
  const auto renamed = reading.renames.find(name);
  const Tag* tag = default_registry().find(renamed == reading.renames.end() ? name : renamed->second);
  return tag && tag->kind == Tag::Kind::kEdge;
}

/// Returns the numbers of the lines that the reader skipped because it was lenient.
std::set<std::int64_t> skipped_lines(const GraphFile& file) {
  std::set<std::int64_t> lines;
  for (const GraphFile::Note& note : file.notes) {
    if (note.skipped) lines.insert(note.line);
  }
  return lines;
}

}  // namespace

std::vector<std::int64_t> find_edge_lines(std::string_view text, const GraphFile& file,
                                          const ReadOptions& reading) {
  const std::set<std::int64_t> skipped = skipped_lines(file);
  std::vector<std::int64_t> lines;
  std::int64_t number = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    ++number;
    if (begins_edge(text.substr(begin, end - begin), reading) && !skipped.contains(number))
      lines.push_back(number);
    begin = end + 1;
  }
  if (lines.size() != file.edges.size()) lines.clear();
  return lines;
}

}  // namespace boxplus::app
