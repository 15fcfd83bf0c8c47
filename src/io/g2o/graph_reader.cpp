// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "boxplus/base/error.h"
#include "boxplus/graph/make_room.h"
#include "boxplus/io/data.h"
#include "io/g2o/element_reader.h"
#include "io/g2o/g2o_format.h"
#include "io/g2o/line_block.h"
#include "io/g2o/notes.h"
#include "io/g2o/unknown_tags.h"
#include "io/pipeline.h"
#include "io/without_place.h"

namespace boxplus {
namespace {

/// A line that is processed only at the end of the file, because the line itself, or an edge before it,
/// refers to a vertex that has not been read yet.
struct WaitingLine {
  Line line;
  std::string text;  ///< a copy, because the line's block no longer exists at the end of the file
  GraphFile::KeptLine::Place place;
  Id vertex;
};

/// Builds a GraphFile. All workers split blocks into lines and numbers. The calling thread adds the finished
/// blocks to the graph in the order of the file. So the elements have the order of the file, except that
/// edges are added after all vertices if a vertex comes after an edge that refers to it.
class GraphReader {
 public:
  GraphReader(const TextSource& text, const ReadOptions& options)
      : text_(text),
        options_(options),
        tags_(options.registry ? *options.registry : default_registry(), options.renames),
        elements_(file_.graph, unknown_, tags_.registry()) {}

  GraphFile read() {
    prepare_and_consume<LineBlock>(
        text_.block_count(), options_.threads,
        [&](std::size_t k, LineBlock& block) { block.read(text_, k, tags_); },
        [&](const LineBlock& block) { take(block); });
    const bool has_no_vertices = file_.graph.vertex_count() == 0;
    elements_.end_of_vertices(has_no_vertices);
    take_waiting();
    file_.vertices_created = has_no_vertices && elements_.created_vertices() > 0;
    add_notes();
    return std::move(file_);
  }

 private:
  void take(const LineBlock& block) {
    const std::size_t edges_before = file_.edges.size();
    for (Line line : block.lines()) {
      line.number += file_.lines;
      guarded(line, [&] { take(line); });
    }
    file_.lines += block.line_count();
    ++blocks_taken_;
    if (place_ == GraphFile::KeptLine::Place::kAfterEdge) make_room(file_.edges.size() - edges_before);
  }

  /// Reserves memory for more edges. If a block ends with edges, the rest of the file probably consists of
  /// edges of the same type.
  void make_room(std::size_t edges_in_block) {
    if (edges_in_block == 0) return;
    const std::size_t expected = file_.edges.size() + edges_in_block * (text_.block_count() - blocks_taken_);
    if (expected <= file_.edges.capacity()) return;
    detail::reserve(file_.edges, expected + expected / 32);
    file_.graph.reserve_edges(file_.edges.back(), expected + expected / 32);
  }

  void take(const Line& line) {
    switch (line.kind) {
      case Line::Kind::kElement:
        is_owner_skipped_ = false;
        return line.tag->kind == Tag::Kind::kEdge ? take_edge(line) : take_vertex(line);
      case Line::Kind::kFix:
        return take_fix(line);
      case Line::Kind::kUnknown:
        if (data_tag_of(line.text).empty()) {
          refuse_tag_with_blanks(line);
          unknown_.add(line.text, line.number);
        } else if (is_owner_skipped_) {
          fields_of(line).fail({}, "the line before it, to which this data belongs, was skipped");
        }
        [[fallthrough]];
      case Line::Kind::kComment:
        if (place_ == GraphFile::KeptLine::Place::kAfterEdge && !waiting_.empty()) return wait(line);
        keep(line);
    }
  }

  /// Throws InputError if the fields at the beginning of the line make up a known tag, such as
  /// "VERTEX_SE3 : QUAT".
  void refuse_tag_with_blanks(const Line& line) const {
    constexpr int kMostParts = 3;
    FieldReader in(text_.name(), line.number, line.text);
    std::string tag(in.token("a tag")), given = tag;
    for (int parts = 1; parts < kMostParts && !in.at_end(); ++parts) {
      const std::string part(in.token("a part of the tag"));
      tag += part;
      given += ' ' + part;
      if (tag.find(':') != std::string::npos && tags_.find(tag) != nullptr)
        in.fail({}, fmt::format("expected the tag {} without blanks, got '{}'", tag, given));
    }
  }

  void take_vertex(const Line& line) {
    FieldReader in = fields_of(line);
    const Id id = elements_.read_vertex(*line.tag, in);
    if (line.tag->kind == Tag::Kind::kVertex) {
      place_ = GraphFile::KeptLine::Place::kAfterVertex;
      vertex_ = id;
    }
    add_note_of(in);
  }

  void take_edge(const Line& line) {
    place_ = GraphFile::KeptLine::Place::kAfterEdge;
    if (!waiting_.empty()) return wait(line);  // edges stay in the order of the file
    FieldReader in = fields_of(line);
    in.set_policy(options_.indefinite);
    const ElementReader::Edge edge = elements_.read_edge(*line.tag, in);
    if (edge.vertices == VertexIds::Result::kNotYetKnown) return wait(line);
    if (edge.vertices == VertexIds::Result::kUnassigned) {
      ++unassigned_;
      keep(line);
    } else {
      file_.edges.push_back(edge.added);
      if (in.has_indefinite()) ++file_.indefinite;
    }
    add_note_of(in);
  }

  void take_fix(const Line& line) {
    FieldReader in = fields_of(line);
    if (!elements_.fix(in)) wait(line);
  }

  void wait(const Line& line) { waiting_.push_back({line, std::string(line.text), place_, vertex_}); }

  void take_waiting() {
    is_owner_skipped_ = false;
    for (WaitingLine& waiting : std::exchange(waiting_, {})) {
      Line& line = waiting.line;
      line.text = waiting.text;
      line.is_numeric = false;  // the block with the numbers no longer exists
      place_ = waiting.place;
      vertex_ = waiting.vertex;
      if (line.kind == Line::Kind::kUnknown && data_tag_of(line.text).empty())
        line.kind = Line::Kind::kComment;  // its tag already has a note
      guarded(line, [&] { take(line); });
    }
  }

  /// Reads one line. If the line has an error, a lenient reader adds a note and continues.
  template <class F>
  void guarded(const Line& line, F&& read_line) {
    try {
      read_line();
    } catch (const InputError& error) {
      if (!options_.lenient) throw;
      if (line.kind == Line::Kind::kElement) is_owner_skipped_ = true;
      ++file_.skipped;
      file_.notes.push_back({line.number, without_place(error, text_.name()), error.column(), true});
    }
  }

  /// The fields after the tag.
  FieldReader fields_of(const Line& line) const {
    if (line.is_numeric) return {text_.name(), line.number, line.text, line.fields};
    FieldReader in(text_.name(), line.number, line.text);
    in.token("a tag");
    return in;
  }

  void add_note_of(const FieldReader& in) {
    if (!in.noted().empty()) file_.notes.push_back({in.line_number(), in.noted()});
  }

  void keep(const Line& line) {
    std::string_view text = line.text;
    while (text.ends_with('\r')) text.remove_suffix(1);
    GraphFile::KeptLine kept{place_, 0, std::string(text), line.number};
    if (place_ == GraphFile::KeptLine::Place::kAfterEdge)
      kept.after = static_cast<std::int64_t>(file_.edges.size()) - 1;
    if (place_ == GraphFile::KeptLine::Place::kAfterVertex) kept.after = vertex_;
    file_.kept.push_back(std::move(kept));
  }

  /// Adds the notes on single lines, sorted by line, and then the notes on the whole file.
  void add_notes() {
    unknown_.append_notes(file_.notes);
    std::stable_sort(file_.notes.begin(), file_.notes.end(),
                     [](const auto& a, const auto& b) { return a.line < b.line; });
    if (unassigned_ > 0) file_.notes.push_back({0, unassigned_note(unassigned_)});
    if (file_.indefinite > 0) file_.notes.push_back({0, indefinite_note(file_, options_.indefinite)});
    if (file_.vertices_created) {
      file_.notes.push_back(
          {0, fmt::format("the file has edges only: {} an initial guess",
                          counted(elements_.created_vertices(), "vertex was created and needs",
                                  "vertices were created and need"))});
    }
  }

  const TextSource& text_;
  const ReadOptions& options_;
  const TagLookup tags_;
  GraphFile file_;
  UnknownTags unknown_;
  ElementReader elements_;
  /// The place of the next line that is kept.
  GraphFile::KeptLine::Place place_ = GraphFile::KeptLine::Place::kBegin;
  Id vertex_ = 0;                  // the id of the last vertex that was read
  bool is_owner_skipped_ = false;  // the last element was malformed, so data after it belongs to nothing
  std::vector<WaitingLine> waiting_;
  std::size_t blocks_taken_ = 0;
  std::int64_t unassigned_ = 0;
};

}  // namespace

GraphFile read_tagged_lines(const TextSource& text, const ReadOptions& options) {
  return GraphReader(text, options).read();
}

}  // namespace boxplus
