// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "boxplus/base/error.h"
#include "boxplus/io/registry.h"
#include "io/edges_to_write.h"
#include "io/g2o/g2o_format.h"
#include "io/pipeline.h"

namespace boxplus {
namespace {

/// Writes a graph in pieces. The workers format the pieces, and the calling thread writes the pieces in
/// order.
class GraphWriter {
 public:
  GraphWriter(const GraphFileView& file, const Registry& registry)
      : graph_(file.graph),
        registry_(registry),
        parameters_(graph_.all_parameters()),
        vertices_(graph_.all_vertices()),
        edges_(edges_to_write(file)) {
    for (const GraphFile::KeptLine& line : file.kept)
      kept_.emplace(std::pair(line.place, line.after), &line.text);
  }

  void write(TextSink sink) const {
    constexpr std::size_t kPiece = 1024;
    const auto format_piece = [&](std::size_t k, std::string& text) {
      text.clear();
      for (std::size_t i = k * kPiece; i < std::min((k + 1) * kPiece, items()); ++i) format(i, text);
    };
    prepare_and_consume<std::string>((items() + kPiece - 1) / kPiece, 0, format_piece, sink);
  }

 private:
  /// The number of items to write, in this order: the parameters, the kept lines at the beginning (one item),
  /// the vertices, the kept lines before the first edge (one item), and the edges.
  std::size_t items() const { return parameters_.size() + vertices_.size() + edges_.size() + 2; }

  void format(std::size_t item, std::string& out) const {
    if (item < parameters_.size()) return format_vertex(parameters_[item], out);
    item -= parameters_.size();
    if (item == 0) return format_kept(GraphFile::KeptLine::Place::kBegin, 0, out);
    item -= 1;
    if (item < vertices_.size()) return format_vertex(vertices_[item], out);
    item -= vertices_.size();
    if (item > 0) format_edge(edges_[item - 1], out);
    format_kept(GraphFile::KeptLine::Place::kAfterEdge, static_cast<std::int64_t>(item) - 1, out);
  }

  void format_vertex(VertexRef vertex, std::string& text) const {
    const Tag* tag = registry_.tag_of(graph_, vertex);
    const detail::VertexPool& pool = *graph_.vertex_pools()[vertex.pool];
    if (!tag) throw_no_tag("vertices", pool.type_name());
    const Id id = graph_.id(vertex);
    FieldWriter out(text);
    out.token(tag->name);
    out.integer(id);
    tag->write_vertex(graph_, vertex, out);
    out.end_line();
    if (pool.parameter(vertex.slot)) return;
    if (graph_.is_fixed(vertex)) {
      out.token("FIX");
      out.integer(id);
      out.end_line();
    }
    format_kept(GraphFile::KeptLine::Place::kAfterVertex, id, text);
  }

  void format_edge(EdgeRef edge, std::string& text) const {
    if (edge == EdgeRef{}) return;
    const Tag* tag = registry_.tag_of(graph_, edge);
    if (!tag) throw_no_tag("edges", graph_.edge_pools()[edge.pool]->type_name());
    FieldWriter out(text);
    out.token(tag->name);
    const std::vector<VertexRef> vertices = graph_.vertices(edge);
    for (const VertexRef& vertex : vertices) out.integer(graph_.id(vertex));
    const Tag* named = registry_.find(tag->name);
    if (named != tag && named->shared_parameter.get() == tag) out.integer(graph_.id(vertices.back()));
    if (tag->arguments.back().is_tail) out.token("||");
    tag->write_edge(graph_, edge, out);
    out.end_line();
  }

  void format_kept(GraphFile::KeptLine::Place place, std::int64_t after, std::string& out) const {
    if (kept_.empty()) return;
    const auto [first, last] = kept_.equal_range({place, after});
    for (auto line = first; line != last; ++line) {
      out += *line->second;
      out += '\n';
    }
  }

  [[noreturn]] static void throw_no_tag(const char* what, std::string_view type) {
    throw InvalidArgument(
        fmt::format("cannot write {} of type {}: no tag is registered for them", what, type));
  }

  const Graph& graph_;
  const Registry& registry_;
  std::vector<VertexRef> parameters_, vertices_;
  std::vector<EdgeRef> edges_;
  std::multimap<std::pair<GraphFile::KeptLine::Place, std::int64_t>, const std::string*> kept_;
};

}  // namespace

void write_tagged_lines(const GraphFileView& file, const WriteOptions& options, TextSink sink) {
  GraphWriter(file, options.registry ? *options.registry : default_registry()).write(sink);
}

}  // namespace boxplus
