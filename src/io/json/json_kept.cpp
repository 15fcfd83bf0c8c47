// SPDX-License-Identifier: BSD-3-Clause
#include "io/json/json_kept.h"

#include <fmt/format.h>

#include <algorithm>

#include "boxplus/io/data.h"
#include "boxplus/io/text_source.h"
#include "io/characters.h"
#include "io/g2o/notes.h"
#include "io/g2o/vertex_ids.h"
#include "io/without_place.h"

namespace boxplus {
namespace {

using Place = GraphFile::KeptLine::Place;

std::string read_bytes(JsonScanner& in) {
  std::string bytes;
  in.array("a list of bytes ([)", [&] {
    in.next();
    const char* const at = in.at();
    const std::int64_t byte = in.integer("a byte");
    if (byte < 0 || byte > 255) refuse_meaning(at, fmt::format("a byte (0 … 255), got {}", byte));
    bytes += static_cast<char>(byte);
  });
  return bytes;
}

}  // namespace

void JsonKeptLine::read(JsonScanner& in) {
  in.next();
  at = in.at();
  line = {};
  int texts = 0, places = 0;
  in.object("a kept line ({)", [&](std::string_view name, const char* name_at) {
    if (name == "text" || name == "bytes") {
      if (++texts > 1) refuse_meaning(name_at, "either text or bytes, and only once");
      std::string memory;
      line.text = name == "text" ? std::string(in.string(memory, "a line (a string)")) : read_bytes(in);
    } else if (name == "after_vertex" || name == "after_edge") {
      if (++places > 1) refuse_meaning(name_at, "either after_vertex or after_edge, and only once");
      line.place = name == "after_vertex" ? Place::kAfterVertex : Place::kAfterEdge;
      line.after = in.integer(name == "after_vertex" ? "the id of a vertex" : "the position of an edge");
    } else {
      refuse_meaning(name_at, fmt::format("one of the members text, bytes, after_vertex, after_edge, got {}",
                                          in_quotes(name)));
    }
  });
  if (texts == 0) refuse_meaning(at, "a kept line with text or bytes");
}

void JsonKept::add(const JsonKeptLine& kept, std::int64_t line_number) {
  GraphFile::KeptLine line = kept.line;
  if (line.place == Place::kAfterVertex && !file_.graph.find_vertex(line.after))
    refuse_meaning(kept.at, fmt::format("the id of a vertex, but there is no vertex {}", line.after));
  const auto edges = static_cast<std::int64_t>(file_.edges.size() + skipped_.size());
  if (line.place == Place::kAfterEdge && (line.after < -1 || line.after >= edges))
    refuse_meaning(kept.at, fmt::format("the position of an edge (-1 … {}), got {}", edges - 1, line.after));
  check_text(kept, line_number);
  if (line.place == Place::kAfterEdge)
    line.after -=
        std::count_if(skipped_.begin(), skipped_.end(), [&](auto edge) { return edge <= line.after; });
  file_.kept.push_back(std::move(line));
}

void JsonKept::check_text(const JsonKeptLine& kept, std::int64_t line_number) {
  const std::string& text = kept.line.text;
  if (text.find('\n') != std::string::npos) refuse_meaning(kept.at, "a single line, got several");
  LineBlock block;
  block.read(TextSource(text, {}, text.size() + 1), 0, tags_);
  if (block.lines().empty()) return;  // blank
  const Line& line = block.lines().front();
  switch (line.kind) {
    case Line::Kind::kComment:
      return;
    case Line::Kind::kUnknown:
      if (data_tag_of(line.text).empty()) unknown_.add(line.text, line_number);
      return;
    case Line::Kind::kFix:
      refuse_meaning(kept.at, "a line that is not part of the graph, got FIX");
    case Line::Kind::kElement:
      check_unassigned(kept, *line.tag);
      ++unassigned_;
  }
}

/// Checks that a line with a known tag is an edge with the vertex −1.
void JsonKept::check_unassigned(const JsonKeptLine& kept, const Tag& tag) const {
  const UnknownTags none;
  VertexIds ids(file_.graph, none, tags_.registry());
  ids.end_of_vertices(false);
  FieldReader in({}, 0, without_byte_order_mark(kept.line.text));
  in.token("a tag");
  try {
    const bool is_kept =
        tag.kind == Tag::Kind::kEdge && ids.read_of_edge(tag, in) == VertexIds::Result::kUnassigned;
    if (!is_kept)
      refuse_meaning(kept.at, fmt::format("a line that is not part of the graph, got {}", tag.name));
    tag.check_edge(in);
  } catch (const InputError& error) {
    throw JsonError(kept.at, without_place(error, {}), JsonError::Kind::kMeaning);
  }
}

void JsonKept::add_notes() {
  unknown_.append_notes(file_.notes);
  std::stable_sort(file_.notes.begin(), file_.notes.end(),
                   [](const auto& a, const auto& b) { return a.line < b.line; });
  if (unassigned_ > 0) file_.notes.push_back({0, unassigned_note(unassigned_)});
}

}  // namespace boxplus
