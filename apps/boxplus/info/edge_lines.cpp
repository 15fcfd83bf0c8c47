// SPDX-License-Identifier: BSD-3-Clause
#include "info/edge_lines.h"

#include <algorithm>
#include <array>
#include <set>

#include "boxplus/io/registry.h"

namespace boxplus::app {
namespace {

/// Whether the tag is that of a measurement of iSAM.
bool is_isam_edge(std::string_view name) {
  constexpr std::array<std::string_view, 6> kTags{"ODOMETRY",  "EDGE2", "LANDMARK",
                                                  "ODOMETRY3", "EDGE3", "POINT3"};
  return std::find(kTags.begin(), kTags.end(), name) != kTags.end();
}

bool begins_edge(std::string_view line, const GraphFile& file, const ReadOptions& reading) {
  FieldReader in("", 0, line);
  if (in.at_end()) return false;
  const std::string_view name = in.token("a tag");
  if (file.format == "iSAM") return is_isam_edge(name);
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

/// In a BAL file, the first edge begins with the fourth value, and each edge has four values.
std::vector<std::int64_t> find_bal_lines(std::string_view text, std::size_t edges) {
  constexpr std::size_t kCounts = 3, kValuesPerEdge = 4;
  constexpr std::string_view kBlanks = " \t\r\v\f\n";
  std::vector<std::int64_t> lines;
  std::int64_t line = 1;
  std::size_t begin = 0, end = 0;
  for (std::size_t value = 0; lines.size() < edges; ++value) {
    begin = text.find_first_not_of(kBlanks, end);
    if (begin == std::string_view::npos) return {};
    line += std::count(text.begin() + static_cast<std::ptrdiff_t>(end),
                       text.begin() + static_cast<std::ptrdiff_t>(begin), '\n');
    if (value >= kCounts && (value - kCounts) % kValuesPerEdge == 0) lines.push_back(line);
    end = std::min(text.find_first_of(kBlanks, begin), text.size());
  }
  return lines;
}

}  // namespace

std::vector<std::int64_t> find_edge_lines(std::string_view text, const GraphFile& file,
                                          const ReadOptions& reading) {
  if (file.format == "BAL") return find_bal_lines(text, file.edges.size());
  const std::set<std::int64_t> skipped = skipped_lines(file);
  std::vector<std::int64_t> lines;
  std::int64_t number = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    ++number;
    if (begins_edge(text.substr(begin, end - begin), file, reading) && !skipped.contains(number))
      lines.push_back(number);
    begin = end + 1;
  }
  if (lines.size() != file.edges.size()) lines.clear();
  return lines;
}

}  // namespace boxplus::app
