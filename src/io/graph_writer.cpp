// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "boxplus/io/graph_file.h"
#include "boxplus/io/registry.h"

namespace boxplus {
namespace {

class GraphWriter {
 public:
  GraphWriter(const Graph& graph, const std::vector<EdgeRef>& edges, const std::vector<KeptLine>& kept,
              const Registry* registry)
      : graph_(graph), edges_(edges), kept_(kept), registry_(registry ? *registry : default_registry()) {}

  std::string text() {
    next_kept_ = kept_.begin();
    for (const VertexRef& parameter : graph_.all_parameters()) write_vertex(parameter);
    write_kept(KeptLine::Place::kBegin);
    for (const VertexRef& vertex : graph_.all_vertices()) {
      write_vertex(vertex);
      if (graph_.is_fixed(vertex)) write_fix(vertex);
      write_kept_after_vertex(graph_.id(vertex));
    }
    write_edges();
    return std::move(text_);
  }

 private:
  void write_vertex(VertexRef vertex) {
    const Tag* tag = registry_.tag_of(graph_, vertex);
    if (!tag) throw_no_word("vertices", graph_.vertex_pools()[vertex.pool]->type_name());
    out_.word(tag->name);
    out_.integer(graph_.id(vertex));
    tag->write_vertex(graph_, vertex, out_);
    out_.end_line();
  }

  void write_fix(VertexRef vertex) {
    out_.word("FIX");
    out_.integer(graph_.id(vertex));
    out_.end_line();
  }

  /// Those of the file in its order, then the others.
  void write_edges() {
    std::set<EdgeRef> written;
    for (std::size_t k = 0; k < edges_.size(); ++k) {
      if (graph_.contains(edges_[k]) && written.insert(edges_[k]).second) write_edge(edges_[k]);
      write_kept_after_edge(static_cast<std::int64_t>(k));
    }
    for (const EdgeRef& edge : graph_.all_edges()) {
      if (!written.contains(edge)) write_edge(edge);
    }
  }

  void write_edge(EdgeRef edge) {
    const Tag* tag = registry_.tag_of(graph_, edge);
    if (!tag) throw_no_word("edges", graph_.edge_pools()[edge.pool]->type_name());
    out_.word(tag->name);
    const std::vector<VertexRef> vertices = graph_.vertices(edge);
    for (const VertexRef& vertex : vertices) out_.integer(graph_.id(vertex));
    const Tag* named = registry_.find(tag->name);
    if (named != tag && named->shared_parameter.get() == tag) out_.integer(graph_.id(vertices.back()));
    if (tag->arguments.back().is_tail) out_.word("||");
    tag->write_edge(graph_, edge, out_);
    out_.end_line();
  }

  void write_line(const KeptLine& line) {
    text_ += line.text;
    out_.end_line();
  }
  void write_kept(KeptLine::Place place) {
    for (const KeptLine& line : kept_) {
      if (line.place == place) write_line(line);
    }
  }
  void write_kept_after_vertex(Id id) {
    if (kept_after_vertex_.empty()) {
      for (const KeptLine& line : kept_) {
        if (line.place == KeptLine::Place::kAfterVertex) kept_after_vertex_.emplace(line.after, &line);
      }
    }
    const auto [first, last] = kept_after_vertex_.equal_range(id);
    for (auto entry = first; entry != last; ++entry) write_line(*entry->second);
  }
  /// Lines that follow edges stand in the order of the edges.
  void write_kept_after_edge(std::int64_t position) {
    const auto belongs = [&](const KeptLine& line) {
      return line.place == KeptLine::Place::kAfterEdge && line.after <= position;
    };
    for (; next_kept_ != kept_.end(); ++next_kept_) {
      if (next_kept_->place != KeptLine::Place::kAfterEdge) continue;
      if (!belongs(*next_kept_)) return;
      write_line(*next_kept_);
    }
  }

  [[noreturn]] static void throw_no_word(const char* what, std::string_view type) {
    throw InvalidArgument(
        fmt::format("cannot write {} of type {}: no word of a file is registered for them", what, type));
  }

  const Graph& graph_;
  const std::vector<EdgeRef>& edges_;
  const std::vector<KeptLine>& kept_;
  const Registry& registry_;
  std::string text_;
  FieldWriter out_{text_};
  std::multimap<Id, const KeptLine*> kept_after_vertex_;
  std::vector<KeptLine>::const_iterator next_kept_;
};

}  // namespace

std::string format_graph(const GraphFile& file, const Registry* registry) {
  return GraphWriter(file.graph, file.edges, file.kept, registry).text();
}

void write_graph(const std::string& path, const GraphFile& file, const Registry* registry) {
  write_file(path, format_graph(file, registry));
}

void write_graph(const std::string& path, const Graph& graph, const Registry* registry) {
  write_file(path, GraphWriter(graph, {}, {}, registry).text());
}

}  // namespace boxplus
