// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <iterator>
#include <map>

#include "boxplus/io/data.h"
#include "boxplus/io/registry.h"
#include "io/edges_to_write.h"
#include "io/g2o/g2o_format.h"
#include "io/pipeline.h"
#include "io/tagged_elements.h"

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
  using Lines = std::multimap<std::pair<GraphFile::KeptLine::Place, std::int64_t>, const std::string*>;

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
    const Tag& tag = tag_to_write(registry_, graph_, vertex);
    const detail::VertexPool& pool = *graph_.vertex_pools()[vertex.pool];
    const Id id = graph_.id(vertex);
    FieldWriter out(text);
    out.token(tag.name);
    out.integer(id);
    tag.write_vertex(graph_, vertex, out);
    out.end_line();
    if (pool.parameter(vertex.slot)) return;
    const auto [first, last] = kept_.equal_range({GraphFile::KeptLine::Place::kAfterVertex, id});
    const Lines::const_iterator fix = graph_.is_fixed(vertex) ? end_of_data(first, last) : first;
    append(first, fix, text);
    if (graph_.is_fixed(vertex)) {
      out.token("FIX");
      out.integer(id);
      out.end_line();
    }
    append(fix, last, text);
  }

  /// The line after the last line of data. A vertex is fixed after its data, as g2o does it.
  static Lines::const_iterator end_of_data(Lines::const_iterator first, Lines::const_iterator last) {
    Lines::const_iterator end = first;
    for (auto line = first; line != last; ++line) {
      if (!data_tag_of(*line->second).empty()) end = std::next(line);
    }
    return end;
  }

  static void append(Lines::const_iterator first, Lines::const_iterator last, std::string& out) {
    for (auto line = first; line != last; ++line) {
      out += *line->second;
      out += '\n';
    }
  }

  void format_edge(EdgeRef edge, std::string& text) const {
    if (edge == EdgeRef{}) return;
    const Tag& tag = tag_to_write(registry_, graph_, edge);
    FieldWriter out(text);
    out.token(tag.name);
    for (const Id id : ids_to_write(registry_, graph_, tag, edge)) out.integer(id);
    if (tag.arguments.back().is_tail) out.token("||");
    tag.write_edge(graph_, edge, out);
    out.end_line();
  }

  void format_kept(GraphFile::KeptLine::Place place, std::int64_t after, std::string& out) const {
    if (kept_.empty()) return;
    const auto [first, last] = kept_.equal_range({place, after});
    append(first, last, out);
  }

  const Graph& graph_;
  const Registry& registry_;
  std::vector<VertexRef> parameters_, vertices_;
  std::vector<EdgeRef> edges_;
  Lines kept_;
};

}  // namespace

void write_tagged_lines(const GraphFileView& file, const WriteOptions& options, TextSink sink) {
  GraphWriter(file, options.registry ? *options.registry : default_registry()).write(sink);
}

}  // namespace boxplus
