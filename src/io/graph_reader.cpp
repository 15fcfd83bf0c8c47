// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <system_error>
#include <unordered_map>
#include <utility>

#include "boxplus/graph/make_room.h"
#include "boxplus/io/graph_file.h"
#include "boxplus/io/registry.h"
#include "io/characters.h"
#include "io/line_block.h"
#include "io/pipeline.h"

namespace boxplus {
namespace {

/// The element before a line, which a line that is kept belongs to.
struct Neighbour {
  enum class Kind : std::uint8_t { kNone, kVertex, kEdge };
  Kind kind = Kind::kNone;
  Id vertex = 0;
};

/// A line whose turn comes after all others, since it, or an edge before it, names a vertex that came not
/// yet.
struct PendingLine {
  Line::Kind kind;
  const Tag* tag;
  std::string text;
  std::int64_t number;
  Neighbour neighbour;
};

/// A word that stands for nothing, and where it came first.
struct UnknownWord {
  std::int64_t count = 0, first_line = 0;
};

/// A line with an unknown word that is followed by an id: perhaps it defines a vertex or a parameter.
struct UnreadLine {
  const std::string* word;
  std::int64_t number;
};

/// What an error says after its place, "file:line:column: ".
std::string without_place(const InputError& error, std::string_view file) {
  const std::string place = fmt::format("{}:{}:{}: ", file, error.line(), error.column());
  const std::string_view text = error.what();
  return std::string(text.starts_with(place) ? text.substr(place.size()) : text);
}

/// Builds a GraphFile: the workers take the lines apart, block by block, and one of them, who is always the
/// same, puts the blocks before into the graph. Elements thus come into the graph in the order of the file,
/// but for edges that stand before their vertices.
class GraphReader {
 public:
  GraphReader(const TextBlocks& text, std::string_view name, const ReadOptions& options)
      : text_(text),
        name_(name),
        words_(options.registry ? *options.registry : default_registry(), options.renames),
        lenient_(options.lenient),
        threads_(options.threads) {}

  GraphFile read() {
    read_blocks();
    file_.lines = lines_before_;
    file_.vertices_created = file_.graph.vertex_count() == 0;
    all_known_ = true;
    for (const PendingLine& line : std::exchange(pending_, {})) take_pending(line);
    file_.vertices_created = file_.vertices_created && created_ > 0;
    add_notes();
    return std::move(file_);
  }

 private:
  void read_blocks() {
    prepare_and_consume<LineBlock>(
        text_.count(), threads_, [&](std::size_t k, LineBlock& block) { block.read(text_, k, words_); },
        [&](const LineBlock& block) { take(block); });
  }

  /// Where an edge ended a block, the rest of the file is likely to hold edges of its type.
  void make_room(std::size_t edges_before) {
    const std::size_t edges = file_.edges.size() - edges_before;
    ++blocks_taken_;
    if (neighbour_.kind != Neighbour::Kind::kEdge || edges == 0) return;
    const std::size_t expected = file_.edges.size() + edges * (text_.count() - blocks_taken_);
    if (expected <= file_.edges.capacity()) return;
    reserve(file_.edges, expected + expected / 32);
    file_.graph.reserve_edges(file_.edges.back(), expected + expected / 32);
  }

  void take(const LineBlock& block) {
    const std::size_t edges_before = file_.edges.size();
    for (Line line : block.lines()) {
      line.number += lines_before_;
      guarded(line.number, [&] { take(line); });
    }
    lines_before_ += block.line_count();
    make_room(edges_before);
  }

  void take(const Line& line) {
    switch (line.kind) {
      case Line::Kind::kElement:
        if (line.tag->kind == Tag::Kind::kEdge) {
          take_edge(line);
        } else {
          with_fields(line, [&](FieldReader& in) { read_vertex(*line.tag, in); });
        }
        break;
      case Line::Kind::kFix:
        if (!fix(line)) wait(line);
        break;
      case Line::Kind::kUnknown:
        note_unknown(line);
        [[fallthrough]];
      case Line::Kind::kComment:
        if (neighbour_.kind == Neighbour::Kind::kEdge && !pending_.empty()) {
          wait(line);
        } else {
          keep(line.text, neighbour_);
        }
    }
  }

  void take_edge(const Line& line) {
    neighbour_ = {Neighbour::Kind::kEdge};
    bool taken = false;
    if (pending_.empty()) with_fields(line, [&](FieldReader& in) { taken = read_edge(line, in); });
    if (!taken) wait(line);
  }

  void wait(const Line& line) {
    pending_.push_back({line.kind, line.tag, std::string(line.text), line.number, neighbour_});
  }

  void take_pending(const PendingLine& pending) {
    Line line;
    line.text = pending.text;
    line.number = pending.number;
    line.kind = pending.kind;
    line.tag = pending.tag;
    neighbour_ = pending.neighbour;
    guarded(line.number, [&] {
      if (line.kind == Line::Kind::kElement) {
        take_edge(line);
      } else if (line.kind == Line::Kind::kFix) {
        fix(line);
      } else {
        keep(line.text, neighbour_);
      }
    });
  }

  /// Runs one line's reader; a lenient reader notes what went wrong and goes on.
  template <class F>
  void guarded(std::int64_t number, F&& read_line) {
    try {
      read_line();
    } catch (const InputError& error) {
      if (!lenient_) throw;
      ++file_.skipped;
      file_.notes.push_back({number, without_place(error, name_), error.column(), true});
    }
  }

  /// Has the fields of a line read: from numbers where they are numbers, and again from the text where that
  /// does not succeed, so that complaints name columns.
  template <class F>
  void with_fields(const Line& line, F&& read) {
    if (line.is_numeric) {
      try {
        FieldReader in(name_, line.number, line.text, line.fields);
        read(in);
        add_note(in);
        return;
      } catch (const FieldReader::NotNumeric&) {
      } catch (const InputError&) {
      }
    }
    FieldReader in(name_, line.number, line.text);
    in.word("a word");
    read(in);
    add_note(in);
  }

  void add_note(const FieldReader& in) {
    if (!in.noted().empty()) file_.notes.push_back({in.line_number(), in.noted()});
  }

  void read_vertex(const Tag& tag, FieldReader& in) {
    const bool is_parameter = tag.kind == Tag::Kind::kParameter;
    const std::int64_t column = in.column();
    const Id id = in.integer(is_parameter ? "the id of a parameter" : "the id of a vertex");
    if (id < 0) in.fail(column, fmt::format("expected an id ≥ 0, got {}", id));
    const bool taken =
        is_parameter ? file_.graph.find_parameter(id).has_value() : file_.graph.find_vertex(id).has_value();
    if (taken)
      in.fail(column, fmt::format("expected a new id, but {} {} is defined before",
                                  is_parameter ? "parameter" : "vertex", id));
    const VertexRef added = tag.read_vertex(file_.graph, id, in);
    try {
      in.expect_end();
    } catch (...) {
      file_.graph.remove(added);
      throw;
    }
    if (!is_parameter) neighbour_ = {Neighbour::Kind::kVertex, id};
  }

  /// False where a vertex is not known yet.
  bool fix(const Line& line) {
    FieldReader in(name_, line.number, line.text);
    in.word("a word");
    vertices_.clear();
    do {
      const std::int64_t column = in.column();
      const Id id = in.integer("the id of a vertex");
      const auto vertex = file_.graph.find_vertex(id);
      if (!vertex && !all_known_) return false;
      if (!vertex) {
        in.fail(column, fmt::format("expected the id of a vertex, but there is no vertex {}{}", id,
                                    unread_line_of(id, false)));
      }
      vertices_.push_back(*vertex);
    } while (!in.at_end());
    for (const VertexRef& vertex : vertices_) file_.graph.fix(vertex);
    return true;
  }

  enum class Vertices : std::uint8_t { kKnown, kUnassigned, kNotYetKnown };

  /// A vertex of the current line that must be made.
  struct Missing {
    std::size_t place;  // in vertices_
    Id id;
    VertexRef (*create)(Graph&, Id);
  };

  /// False where a vertex is not known yet.
  bool read_edge(const Line& line, FieldReader& in) {
    const Vertices known = read_vertices_of(*line.tag, in);
    if (known == Vertices::kNotYetKnown) return false;
    if (known == Vertices::kUnassigned) {
      if (in.column() == 0) throw FieldReader::NotNumeric();  // no graph will look at its Ω: the reader must
      line.tag->check_edge(in);
      ++unassigned_;
      keep(line.text, neighbour_);
      return true;
    }
    const Tag* tag = line.tag;
    if (tag->shared_parameter && vertices_.back() == vertices_[vertices_.size() - 2]) {
      tag = tag->shared_parameter.get();
      vertices_.pop_back();
    }
    refuse_repetition(in);
    const std::int64_t column = in.column();
    try {
      const EdgeRef edge = tag->read_edge(file_.graph, vertices_, in);
      check_end(edge, in);
      file_.edges.push_back(edge);
    } catch (const InvalidArgument& error) {
      in.fail(column, error.what());
    }
    return true;
  }

  void refuse_repetition(FieldReader& in) {
    if (vertices_.size() == 2 && vertices_[0] != vertices_[1]) return;
    sorted_ = vertices_;
    std::sort(sorted_.begin(), sorted_.end());
    if (const auto twice = std::adjacent_find(sorted_.begin(), sorted_.end()); twice != sorted_.end()) {
      in.fail(1, fmt::format("expected different vertices, but {} {} appears twice",
                             is_parameter(*twice) ? "parameter" : "vertex", file_.graph.id(*twice)));
    }
  }

  bool is_parameter(VertexRef vertex) const {
    return file_.graph.vertex_pools()[vertex.pool]->parameter(vertex.slot);
  }

  void check_end(EdgeRef edge, FieldReader& in) {
    try {
      in.expect_end();
    } catch (...) {
      file_.graph.remove(edge);
      throw;
    }
  }

  /// Fills vertices_. Those that an edge of a file without vertices names first are made once all of its line
  /// is known to be good.
  Vertices read_vertices_of(const Tag& tag, FieldReader& in) {
    vertices_.clear();
    missing_.clear();
    Vertices result = Vertices::kKnown;
    const auto read_one = [&](const Tag::Argument& argument) {
      result = std::max(result, read_vertex_of(argument, in));
    };
    for (const Tag::Argument& argument : tag.arguments) {
      if (!argument.is_tail) {
        read_one(argument);
      } else {
        while (!in.accept("||")) read_one(argument);
      }
    }
    if (result != Vertices::kNotYetKnown && !missing_.empty()) create_missing(tag, in);
    return result;
  }

  void create_missing(const Tag& tag, FieldReader in) {
    if (in.column() == 0) throw FieldReader::NotNumeric();
    for (const Missing& vertex : missing_) {
      const bool again = std::any_of(missing_.begin(), missing_.end(), [&](const Missing& other) {
        return other.id == vertex.id && other.place != vertex.place;
      });
      if (again)
        in.fail(1, fmt::format("expected different vertices, but vertex {} appears twice", vertex.id));
    }
    tag.check_edge(in);
    for (const Missing& vertex : missing_) vertices_[vertex.place] = vertex.create(file_.graph, vertex.id);
    created_ += static_cast<std::int64_t>(missing_.size());
  }

  Vertices read_vertex_of(const Tag::Argument& argument, FieldReader& in) {
    Graph& graph = file_.graph;
    const char* kind = argument.is_parameter ? "parameter" : "vertex";
    const std::int64_t column = in.column();
    const Id id = in.integer(argument.is_parameter ? "the id of a parameter" : "the id of a vertex");
    if (id == -1 && !argument.is_parameter) return Vertices::kUnassigned;
    if (id < 0) in.fail(column, fmt::format("expected the id of a {}, which is ≥ 0, got {}", kind, id));
    auto found = argument.is_parameter ? graph.find_parameter(id) : graph.find_vertex(id);
    if (!found && !all_known_) return Vertices::kNotYetKnown;
    if (!found && !argument.is_parameter && id >= 0 && file_.vertices_created) {
      missing_.push_back({vertices_.size(), id, argument.create});
      vertices_.push_back({});
      return Vertices::kKnown;
    }
    if (!found) {
      in.fail(column, fmt::format("expected the id of a {}, but there is no {} {}{}", kind, kind, id,
                                  unread_line_of(id, argument.is_parameter)));
    }
    const VertexPool& pool = *graph.vertex_pools()[found->pool];
    if (std::type_index(typeid(pool)) != argument.pool) {
      in.fail(column, fmt::format("expected the id of a {} of type {}, but {} {} is a {}", kind,
                                  argument.type_name, kind, id, pool.type_name()));
    }
    vertices_.push_back(*found);
    return Vertices::kKnown;
  }

  void keep(std::string_view text, const Neighbour& neighbour) {
    while (text.ends_with('\r')) text.remove_suffix(1);
    KeptLine kept{KeptLine::Place::kBegin, 0, std::string(text)};
    if (neighbour.kind == Neighbour::Kind::kEdge) {
      kept.place = KeptLine::Place::kAfterEdge;
      kept.after = static_cast<std::int64_t>(file_.edges.size()) - 1;
    } else if (neighbour.kind == Neighbour::Kind::kVertex) {
      kept.place = KeptLine::Place::kAfterVertex;
      kept.after = neighbour.vertex;
    }
    file_.kept.push_back(std::move(kept));
  }

  void note_unknown(const Line& line) {
    FieldReader in(name_, line.number, line.text);
    const std::string_view word = in.word("a word");
    const auto entry = unknown_.try_emplace(quoted(word)).first;
    if (entry->second.count++ == 0) entry->second.first_line = line.number;
    if (word.starts_with("EDGE") || in.at_end()) return;
    const std::string_view field = in.word("an id");
    const char* const end = field.data() + field.size();
    Id id = 0;
    if (const auto [stop, error] = std::from_chars(field.data(), end, id);
        error == std::errc() && stop == end) {
      unread_[word.starts_with("PARAM")].try_emplace(id, UnreadLine{&entry->first, line.number});
    }
  }

  /// Why there is no vertex (parameter) of that id, if a line with an unknown tag has it; else nothing.
  std::string unread_line_of(Id id, bool is_parameter) const {
    const auto found = unread_[is_parameter].find(id);
    if (found == unread_[is_parameter].end()) return {};
    return fmt::format("; line {} has that id after the unknown tag {}", found->second.number,
                       *found->second.word);
  }

  void add_notes() {
    const auto plural = [](std::int64_t count) { return count == 1 ? "" : "s"; };
    for (const auto& [word, unknown] : unknown_) {
      file_.notes.push_back({unknown.first_line, fmt::format("{} line{} with the unknown word {}: kept as {}",
                                                             unknown.count, plural(unknown.count), word,
                                                             unknown.count == 1 ? "it is" : "they are")});
    }
    std::stable_sort(file_.notes.begin(), file_.notes.end(),
                     [](const auto& a, const auto& b) { return a.line < b.line; });
    if (unassigned_ > 0) {
      file_.notes.push_back(
          {0, fmt::format("{} edge{} with the unassigned vertex -1: kept as {}, but not part of "
                          "the graph",
                          unassigned_, plural(unassigned_), unassigned_ == 1 ? "it is" : "they are")});
    }
    if (file_.vertices_created) {
      file_.notes.push_back(
          {0, fmt::format("the file has edges only: {} {} created and need{} an initial guess", created_,
                          created_ == 1 ? "vertex was" : "vertices were", created_ == 1 ? "s" : "")});
    }
  }

  const TextBlocks& text_;
  std::string_view name_;
  const Words words_;
  const bool lenient_;
  const int threads_;
  GraphFile file_;
  std::int64_t lines_before_ = 0;
  std::size_t blocks_taken_ = 0;
  Neighbour neighbour_;
  std::vector<PendingLine> pending_;
  bool all_known_ = false;  // every vertex of the file is in the graph
  std::vector<VertexRef> vertices_, sorted_;
  std::vector<Missing> missing_;
  std::map<std::string, UnknownWord> unknown_;
  std::unordered_map<Id, UnreadLine> unread_[2];  // vertices, parameters: by id
  std::int64_t created_ = 0, unassigned_ = 0;
};

}  // namespace

GraphFile parse_graph(std::string_view text, const std::string& name, const ReadOptions& options) {
  return GraphReader(TextBlocks(text), name, options).read();
}

GraphFile read_graph(const std::string& path, const ReadOptions& options) {
  return GraphReader(TextBlocks::of_file(path), path, options).read();
}

}  // namespace boxplus
