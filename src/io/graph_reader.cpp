// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <utility>

#include "boxplus/io/graph_file.h"
#include "boxplus/io/registry.h"
#include "io/text_file.h"

namespace boxplus {
namespace {

/// A line whose turn comes after all vertices are known.
struct PendingLine {
  const Tag* tag;  ///< nullptr: a FIX line, or one to keep
  std::string_view text;
  std::int64_t number;
};

/// A word that stands for nothing, and where it came first.
struct UnknownWord {
  std::int64_t count = 0, first_line = 0;
};

/// Builds a GraphFile in two passes: vertices and parameters, then everything that refers to them.
class GraphReader {
 public:
  GraphReader(std::string_view text, std::string_view name, const ReadOptions& options)
      : text_(text),
        name_(name),
        registry_(options.registry ? *options.registry : default_registry()),
        renames_(options.renames),
        lenient_(options.lenient) {}

  GraphFile read() {
    read_vertices();
    file_.vertices_created = file_.graph.vertex_count() == 0;
    for (const PendingLine& line : pending_) guarded(line, [&] { read_pending(line); });
    file_.vertices_created = file_.vertices_created && created_ > 0;
    add_notes();
    return std::move(file_);
  }

 private:
  /// First pass.
  void read_vertices() {
    std::int64_t number = 0;
    for (std::size_t begin = 0; begin < text_.size();) {
      const auto* newline =
          static_cast<const char*>(std::memchr(text_.data() + begin, '\n', text_.size() - begin));
      const std::size_t end = newline ? static_cast<std::size_t>(newline - text_.data()) : text_.size();
      const std::string_view line = text_.substr(begin, end - begin);
      begin = end + 1;
      FieldReader in(name_, ++number, line);
      if (in.at_end()) continue;
      const std::string_view word = in.word("a word");
      const Tag* tag = find_tag(word);
      if (tag && tag->kind != Tag::Kind::kEdge) {
        guarded({tag, line, number}, [&] { read_vertex(*tag, in); });
      } else {
        if (!tag && word != "FIX") note_unknown(word, number);
        pending_.push_back({tag, line, number});
        if (!tag && word != "FIX") keep_place_.emplace_back(last_vertex_);
      }
    }
  }

  const Tag* find_tag(std::string_view word) const {
    const auto renamed = renames_.find(word);
    return registry_.find(renamed == renames_.end() ? word : renamed->second);
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
    } catch (const InputError&) {
      file_.graph.remove(added);
      throw;
    }
    if (!is_parameter) last_vertex_ = id;
  }

  void read_pending(const PendingLine& line) {
    FieldReader in(name_, line.number, line.text);
    const std::string_view word = in.word("a word");
    if (line.tag) {
      read_edge(*line.tag, in, line.text);
    } else if (word == "FIX") {
      fix(in);
    } else {
      const std::optional<Id> vertex = keep_place_[next_kept_++];
      keep(line.text, vertex);
    }
  }

  void keep(std::string_view text, std::optional<Id> vertex) {
    while (!text.empty() && text.back() == '\r') text.remove_suffix(1);
    KeptLine kept{KeptLine::Place::kBegin, 0, std::string(text)};
    if (!file_.edges.empty()) {
      kept.place = KeptLine::Place::kAfterEdge;
      kept.after = static_cast<std::int64_t>(file_.edges.size()) - 1;
    } else if (vertex) {
      kept.place = KeptLine::Place::kAfterVertex;
      kept.after = *vertex;
    }
    file_.kept.push_back(std::move(kept));
  }

  void fix(FieldReader& in) {
    do {
      const std::int64_t column = in.column();
      const Id id = in.integer("the id of a vertex");
      const auto vertex = file_.graph.find_vertex(id);
      if (!vertex) in.fail(column, fmt::format("expected the id of a vertex, but there is no vertex {}", id));
      file_.graph.fix(*vertex);
    } while (!in.at_end());
  }

  void read_edge(const Tag& tag, FieldReader& in, std::string_view text) {
    std::vector<VertexRef> vertices;
    if (!read_vertices_of(tag, in, vertices)) {
      ++unassigned_;
      keep(text, std::nullopt);
      return;
    }
    const Tag* chosen = &tag;
    if (tag.shared_parameter && vertices.back() == vertices[vertices.size() - 2]) {
      chosen = tag.shared_parameter.get();
      vertices.pop_back();
    }
    std::vector<VertexRef> sorted = vertices;
    std::sort(sorted.begin(), sorted.end());
    if (const auto twice = std::adjacent_find(sorted.begin(), sorted.end()); twice != sorted.end()) {
      in.fail(
          1, fmt::format("expected different vertices, but vertex {} appears twice", file_.graph.id(*twice)));
    }
    const std::int64_t column = in.column();
    try {
      const EdgeRef edge = chosen->read_edge(file_.graph, vertices, in);
      check_end(edge, in);
      file_.edges.push_back(edge);
    } catch (const InvalidArgument& error) {
      in.fail(column, error.what());
    }
  }

  void check_end(EdgeRef edge, FieldReader& in) {
    try {
      in.expect_end();
    } catch (const InputError&) {
      file_.graph.remove(edge);
      throw;
    }
  }

  /// False where one of the ids is −1: an edge whose vertex is not known.
  bool read_vertices_of(const Tag& tag, FieldReader& in, std::vector<VertexRef>& vertices) {
    bool assigned = true;
    for (const Tag::Argument& argument : tag.arguments) {
      if (!argument.is_tail) {
        assigned = read_vertex_of(argument, in, vertices) && assigned;
        continue;
      }
      while (!in.accept("||")) assigned = read_vertex_of(argument, in, vertices) && assigned;
    }
    return assigned;
  }

  bool read_vertex_of(const Tag::Argument& argument, FieldReader& in, std::vector<VertexRef>& vertices) {
    Graph& graph = file_.graph;
    const char* kind = argument.is_parameter ? "parameter" : "vertex";
    const std::int64_t column = in.column();
    const Id id = in.integer(argument.is_parameter ? "the id of a parameter" : "the id of a vertex");
    if (id == -1 && !argument.is_parameter) return false;
    auto found = argument.is_parameter ? graph.find_parameter(id) : graph.find_vertex(id);
    if (!found && !argument.is_parameter && id >= 0 && file_.vertices_created) {
      found = argument.create(graph, id);
      ++created_;
    }
    if (!found)
      in.fail(column, fmt::format("expected the id of a {}, but there is no {} {}", kind, kind, id));
    const VertexPool& pool = *graph.vertex_pools()[found->pool];
    if (std::type_index(typeid(pool)) != argument.pool) {
      in.fail(column, fmt::format("expected the id of a {} of type {}, but {} {} is a {}", kind,
                                  argument.type_name, kind, id, pool.type_name()));
    }
    vertices.push_back(*found);
    return true;
  }

  /// Runs one line's reader; a lenient reader notes what went wrong and goes on.
  template <class F>
  void guarded(const PendingLine& line, F&& read_line) {
    try {
      read_line();
    } catch (const InputError& error) {
      if (!lenient_) throw;
      ++file_.skipped;
      file_.notes.push_back({line.number, std::string("skipped: ") + error.what()});
    }
  }

  void note_unknown(std::string_view word, std::int64_t number) {
    UnknownWord& unknown = unknown_[std::string(word)];
    if (unknown.count++ == 0) unknown.first_line = number;
  }

  void add_notes() {
    for (const auto& [word, unknown] : unknown_) {
      file_.notes.push_back(
          {unknown.first_line,
           fmt::format("{} line{} with the unknown word {}, kept as {} (the first is line {})", unknown.count,
                       unknown.count == 1 ? "" : "s", word, unknown.count == 1 ? "it is" : "they are",
                       unknown.first_line)});
    }
    if (unassigned_ > 0) {
      file_.notes.push_back(
          {0, fmt::format("{} edge{} with the unassigned vertex -1 left out, kept as they are", unassigned_,
                          unassigned_ == 1 ? "" : "s")});
    }
    if (file_.vertices_created) {
      file_.notes.push_back(
          {0, fmt::format("the file has edges only: {} vertices were created and need an initial guess",
                          created_)});
    }
  }

  std::string_view text_, name_;
  const Registry& registry_;
  const std::map<std::string, std::string, std::less<>>& renames_;
  bool lenient_;
  GraphFile file_;
  std::vector<PendingLine> pending_;
  std::optional<Id> last_vertex_;
  std::vector<std::optional<Id>> keep_place_;  // per kept line: the vertex before it
  std::size_t next_kept_ = 0;
  std::map<std::string, UnknownWord> unknown_;
  std::int64_t created_ = 0, unassigned_ = 0;
};

}  // namespace

GraphFile parse_graph(std::string_view text, const std::string& name, const ReadOptions& options) {
  return GraphReader(text, name, options).read();
}

GraphFile read_graph(const std::string& path, const ReadOptions& options) {
  return parse_graph(read_file(path), path, options);
}

}  // namespace boxplus
