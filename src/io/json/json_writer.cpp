// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <typeinfo>

#include "boxplus/base/error.h"
#include "boxplus/io/registry.h"
#include "boxplus/robust/barron.h"
#include "boxplus/robust/make_robust_kernel.h"
#include "io/edges_to_write.h"
#include "io/json/json_format.h"
#include "io/json/json_output.h"
#include "io/json/json_registry.h"
#include "io/pipeline.h"
#include "io/tagged_elements.h"

namespace boxplus {
namespace {

using KeptLine = GraphFile::KeptLine;

/// The name with which make_robust_kernel() makes the same kernel. Throws InvalidArgument if there is none.
std::string name_to_make(const RobustKernel& kernel) {
  std::string name(kernel.name());
  if (const auto* barron = dynamic_cast<const Barron*>(&kernel)) name += fmt::format(":{}", barron->shape());
  const auto is_same = [&] {
    try {
      const auto made = make_robust_kernel(name, kernel.delta());
      const RobustKernel& same = *made;
      return typeid(same) == typeid(kernel);
    } catch (const InvalidArgument&) {
      return false;
    }
  };
  if (!is_same())
    throw InvalidArgument("cannot write the robust kernel " + name + ", which is not boxplus's own");
  return name;
}

/// Writes a graph in pieces. The workers format the pieces, and the calling thread writes them in order.
class JsonWriter {
 public:
  JsonWriter(const GraphFileView& file, const Registry& registry)
      : graph_(file.graph),
        registry_(registry),
        parameters_(graph_.all_parameters()),
        vertices_(graph_.all_vertices()),
        edges_(edges_to_write(file)),
        kept_(file.kept.begin(), file.kept.end()) {
    place_kept();
    std::erase(edges_, EdgeRef{});
  }

  void write(TextSink sink) const {
    sink(fmt::format("{{\"format\": \"{}\", \"version\": {},\n", kJsonFormat, kJsonVersion));
    list("parameters", parameters_, sink, [&](VertexRef vertex, std::string& out) { append(vertex, out); });
    sink(",\n");
    list("vertices", vertices_, sink, [&](VertexRef vertex, std::string& out) { append(vertex, out); });
    sink(",\n");
    list("edges", edges_, sink, [&](EdgeRef edge, std::string& out) { append(edge, out); });
    sink(",\n");
    list("kept", kept_, sink, [&](const KeptLine& line, std::string& out) { append(line, out); });
    sink("}\n");
  }

 private:
  /// Sorts the kept lines by place, drops those whose vertex is gone, and counts positions without edges that
  /// are gone.
  void place_kept() {
    const auto is_gone = [&](const KeptLine& line) {
      return line.place == KeptLine::Place::kAfterVertex ? !graph_.find_vertex(line.after)
             : line.place == KeptLine::Place::kAfterEdge
                 ? line.after < -1 || line.after >= static_cast<std::int64_t>(edges_.size())
                 : false;
    };
    std::erase_if(kept_, is_gone);
    std::stable_sort(kept_.begin(), kept_.end(), [](const KeptLine& a, const KeptLine& b) {
      return std::pair(a.place, a.after) < std::pair(b.place, b.after);
    });
    std::int64_t counted = 0, gone = 0;  // the edges that have been counted, and those of them that are gone
    for (KeptLine& line : kept_) {
      if (line.place != KeptLine::Place::kAfterEdge) continue;
      for (; counted <= line.after; ++counted) gone += edges_[counted] == EdgeRef{};
      line.after -= gone;
    }
  }

  template <class T, class F>
  static void list(std::string_view name, const std::vector<T>& items, TextSink sink, F&& append) {
    constexpr std::size_t kPiece = 1024;
    sink(fmt::format("\"{}\": [", name));
    const auto format_piece = [&](std::size_t k, std::string& text) {
      text.clear();
      for (std::size_t i = k * kPiece; i < std::min((k + 1) * kPiece, items.size()); ++i) {
        text += i == 0 ? "\n" : ",\n";
        append(items[i], text);
      }
    };
    prepare_and_consume<std::string>((items.size() + kPiece - 1) / kPiece, 0, format_piece, sink);
    sink(items.empty() ? "]" : "\n]");
  }

  void append(VertexRef vertex, std::string& out) const {
    const Tag& tag = tag_to_write(registry_, graph_, vertex);
    const detail::VertexPool& pool = *graph_.vertex_pools()[vertex.pool];
    std::string fields;
    FieldWriter field_writer(fields);
    tag.write_vertex(graph_, vertex, field_writer);
    fmt::format_to(std::back_inserter(out), "{{\"tag\": \"{}\", \"id\": {}, \"fields\": [", tag.name,
                   graph_.id(vertex));
    append_json_fields(fields, out);
    out += ']';
    if (graph_.is_fixed(vertex) != pool.parameter(vertex.slot))
      out += graph_.is_fixed(vertex) ? ", \"fixed\": true" : ", \"fixed\": false";
    if (const auto directions = graph_.fixed_directions(vertex); !directions.empty())
      fmt::format_to(std::back_inserter(out), ", \"fixed_directions\": [{}]", fmt::join(directions, ", "));
    append(graph_.bounds(vertex), out);
    if (graph_.is_eliminated(vertex)) out += ", \"eliminated\": true";
    out += '}';
  }

  static void append(std::span<const detail::Bound> bounds, std::string& out) {
    if (bounds.empty()) return;
    std::string_view separator = ", \"bounds\": [";
    for (const detail::Bound& bound : bounds) {
      fmt::format_to(std::back_inserter(out), "{}{{\"entry\": {}", separator, bound.entry);
      if (std::isfinite(bound.lower)) fmt::format_to(std::back_inserter(out), ", \"lower\": {}", bound.lower);
      if (std::isfinite(bound.upper)) fmt::format_to(std::back_inserter(out), ", \"upper\": {}", bound.upper);
      out += '}';
      separator = ", ";
    }
    out += ']';
  }

  void append(EdgeRef edge, std::string& out) const {
    const Tag& tag = tag_to_write(registry_, graph_, edge);
    fmt::format_to(std::back_inserter(out), "{{\"tag\": \"{}\", \"ids\": [{}", tag.name,
                   fmt::join(ids_to_write(registry_, graph_, tag, edge), ", "));
    std::string fields;
    FieldWriter field_writer(fields);
    tag.write_edge(graph_, edge, field_writer);
    std::string rest;
    FieldWriter rest_writer(rest);
    if (tag.write_rest != nullptr) tag.write_rest(graph_, edge, rest_writer);
    fields.resize(fields.size() - rest.size());
    while (fields.ends_with(' ')) fields.pop_back();
    const int rows = tag.lists_information ? graph_.information(edge).rows : 0;
    const std::size_t information = last_fields(fields, rows * (rows + 1) / 2);
    out += "], \"fields\": [";
    append_json_fields(std::string_view(fields).substr(0, information), out);
    if (tag.lists_information) {
      out += "], \"information\": [";
      append_json_fields(std::string_view(fields).substr(information), out);
    }
    if (!rest.empty()) {
      out += "], \"rest\": [";
      append_json_fields(rest, out);
    }
    out += ']';
    append_attributes(edge, out);
    out += '}';
  }

  void append_attributes(EdgeRef edge, std::string& out) const {
    if (const RobustKernel* kernel = graph_.kernel(edge)) {
      out += ", \"kernel\": {\"name\": ";
      append_json_string(name_to_make(*kernel), out);
      fmt::format_to(std::back_inserter(out), ", \"width\": {}}}", kernel->delta());
    }
    if (const int level = graph_.level(edge); level != 0)
      fmt::format_to(std::back_inserter(out), ", \"level\": {}", level);
    if (!graph_.is_enabled(edge)) out += ", \"enabled\": false";
  }

  static void append(const KeptLine& line, std::string& out) {
    out += '{';
    if (line.place != KeptLine::Place::kBegin) {
      const char* name = line.place == KeptLine::Place::kAfterVertex ? "after_vertex" : "after_edge";
      fmt::format_to(std::back_inserter(out), "\"{}\": {}, ", name, line.after);
    }
    append_json_text(line.text, out);
    out += '}';
  }

  const Graph& graph_;
  const Registry& registry_;
  std::vector<VertexRef> parameters_, vertices_;
  std::vector<EdgeRef> edges_;
  std::vector<KeptLine> kept_;
};

}  // namespace

void write_json(const GraphFileView& file, const WriteOptions& options, TextSink sink) {
  JsonWriter(file, options.registry ? *options.registry : json_registry()).write(sink);
}

}  // namespace boxplus
