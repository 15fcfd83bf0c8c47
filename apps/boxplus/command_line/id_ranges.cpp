// SPDX-License-Identifier: BSD-3-Clause
#include "command_line/id_ranges.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace boxplus::app {
namespace {

[[noreturn]] void fail(const std::string& text) {
  throw InvalidArgument(fmt::format("expected ids and ranges such as 0-99,120, got '{}'", text));
}

Id parse_id(const std::string& text, const std::string& whole) {
  Id id = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, id);
  if (error != std::errc() || stop != end || id < 0) fail(whole);
  return id;
}

IdRange parse_range(const std::string& text) {
  const std::size_t dash = text.find('-');
  const Id first = parse_id(text.substr(0, dash), text);
  const Id last = dash == std::string::npos ? first : parse_id(text.substr(dash + 1), text);
  if (last < first) fail(text);
  return {first, last};
}

}  // namespace

std::vector<IdRange> parse_id_ranges(const std::string& text) {
  std::vector<IdRange> ranges;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    ranges.push_back(parse_range(text.substr(begin, end - begin)));
    begin = end + 1;
  }
  return ranges;
}

std::vector<VertexRef> find_vertices(const Graph& graph, const std::vector<IdRange>& ranges,
                                     const std::string& option) {
  if (ranges.empty()) return {};
  const std::vector<VertexRef> all = graph.all_vertices();  // sorted by id
  const auto position = [&](Id id) {
    return std::partition_point(all.begin(), all.end(), [&](VertexRef v) { return graph.id(v) < id; });
  };
  const auto position_after = [&](Id id) {
    return std::partition_point(all.begin(), all.end(), [&](VertexRef v) { return graph.id(v) <= id; });
  };
  std::vector<VertexRef> found;
  for (const auto& [first, last] : ranges) {
    const auto begin = position(first), end = position_after(last);
    if (begin == end) {
      throw InvalidArgument(first == last ? fmt::format("{}: there is no vertex with id {}", option, first)
                                          : fmt::format("{}: there is no vertex with an id from {} to {}",
                                                        option, first, last));
    }
    found.insert(found.end(), begin, end);
  }
  const auto by_id = [&](VertexRef a, VertexRef b) { return graph.id(a) < graph.id(b); };
  std::sort(found.begin(), found.end(), by_id);
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}  // namespace boxplus::app
