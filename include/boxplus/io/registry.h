// SPDX-License-Identifier: BSD-3-Clause
// Which words of a file stand for which types. A new type is one line:
//
//     Registry registry = default_registry();
//     registry.vertex<Pose>("VERTEX_POSE");
//     registry.edge<MyEdge, Pose, Pose>("EDGE_MINE");
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <typeindex>
#include <vector>

#include "boxplus/graph/graph.h"
#include "boxplus/io/file_fields.h"

namespace boxplus {

/// Stands in the vertex types of an edge for a shared constant of the graph (a PARAMS_ line of the file).
template <class T>
struct Parameter {
  using Element = T;
};

/// What a word at the beginning of a line stands for.
struct Tag {
  enum class Kind : std::uint8_t { kVertex, kParameter, kEdge };
  /// A vertex of an edge.
  struct Argument {
    std::type_index pool;
    std::string_view type_name;
    bool is_parameter, is_tail;
    VertexRef (*create)(Graph&, Id);  ///< adds a vertex of the type, at its default value
  };

  std::string name;
  Kind kind;
  std::type_index pool;  ///< of its elements
  std::vector<Argument> arguments;
  VertexRef (*read_vertex)(Graph&, Id, FieldReader&) = nullptr;
  void (*write_vertex)(const Graph&, VertexRef, FieldWriter&) = nullptr;
  void (*check_edge)(FieldReader&) = nullptr;  ///< reads measurement and Ω for nothing
  EdgeRef (*read_edge)(Graph&, std::span<const VertexRef>, FieldReader&) = nullptr;
  void (*write_edge)(const Graph&, EdgeRef, FieldWriter&) = nullptr;  ///< measurement and Ω
  /// What to use where the last two parameters are one and the same (an edge lists no vertex twice).
  std::shared_ptr<const Tag> shared_parameter = nullptr;
  bool written = true;  ///< false: an old word that is read only
};

/// Ω as the n(n+1)/2 numbers of its upper triangle by rows: 11 12 … 1n 22 … Throws InputError where it is
/// indefinite or zero.
Information read_information(FieldReader& in, int rows);
/// The numbers alone, in the order of the file. They last until the next call on this thread, and the line.
std::span<const double> read_triangle(FieldReader& in, int rows);
/// The Ω of an upper triangle that began at `column`. Throws InputError as above.
Information checked_information(FieldReader& in, std::int64_t column, std::span<const double> triangle,
                                int rows);
void write_information(const InformationView& information, FieldWriter& out);

/// How an edge stands in a file: its measurement, then Ω. Old formats have layouts of their own.
template <class E>
struct EdgeLayout {
  static E read(FieldReader& in) { return EdgeFields<E>::read(in); }
  static Information read_information(FieldReader& in, int rows) {
    return boxplus::read_information(in, rows);
  }
};

namespace io {

template <class V>
struct Stripped {
  using Type = V;
};
template <class T>
struct Stripped<Parameter<T>> {
  using Type = T;
};
template <class V>
using Strip = typename Stripped<V>::Type;
template <class V>
inline constexpr bool kIsParameter = !std::is_same_v<V, Strip<V>>;

template <class V>
Tag::Argument argument() {
  using T = edge::ElementOf<Strip<V>>;
  const auto create = [](Graph& graph, Id id) -> VertexRef {
    T value{};
    if constexpr (requires { value.setZero(); }) value.setZero();
    return graph.add_vertex(std::move(value), id);
  };
  return {typeid(TypedVertexPool<T>), type_name<T>(), kIsParameter<V>, kIsTail<V>, create};
}

template <class V>
auto attach(const Graph& graph, std::span<const VertexRef>& refs) {
  if constexpr (kIsTail<V>) {
    std::vector<VertexHandle<edge::ElementOf<V>>> handles;
    for (const VertexRef& ref : refs) handles.push_back(graph.typed<edge::ElementOf<V>>(ref));
    return handles;
  } else {
    const VertexRef first = refs.front();
    refs = refs.subspan(1);
    return graph.typed<V>(first);
  }
}

/// The measurement and Ω of an edge.
template <class Layout, class E, class... V>
std::pair<E, Information> read_measurement(FieldReader& in) {
  E edge = Layout::read(in);
  constexpr int kRows = edge::kRows<edge::Result<E, V...>>;
  int rows = kRows;
  if constexpr (kRows == kDynamic) rows = static_cast<int>(edge.measurement.size());
  Information information = Layout::read_information(in, rows);
  return {std::move(edge), std::move(information)};
}

template <class Layout, class E, class... V>
void check_edge(FieldReader& in) {
  read_measurement<Layout, E, V...>(in);
  in.expect_end();
}

template <class Layout, class E, class... V>
EdgeRef read_edge(Graph& graph, std::span<const VertexRef> refs, FieldReader& in) {
  std::pair<E, Information> read = read_measurement<Layout, E, V...>(in);
  const std::tuple handles{attach<V>(graph, refs)...};
  return std::apply(
      [&](const auto&... h) { return graph.add_edge(std::move(read.first), read.second, h...); }, handles);
}

template <class E>
void write_edge(const Graph& graph, EdgeRef ref, FieldWriter& out) {
  EdgeFields<E>::write(graph.measurement(EdgeHandle<E>{ref}), out);
  write_information(graph.information(ref), out);
}

}  // namespace io

/// Maps words to types and types to words. Where several words stand for one type, the first is written.
class Registry {
 public:
  template <class T>
  void vertex(std::string name) {
    add(vertex_tag<T, false>(std::move(name)));
  }
  template <class T>
  void parameter(std::string name) {
    add(vertex_tag<T, true>(std::move(name)));
  }
  /// V: a vertex type, Tail<T> in the last place, or Parameter<T> after all vertices.
  template <class E, class... V>
  void edge(std::string name) {
    add(edge_tag<EdgeLayout<E>, E, V...>(std::move(name)));
  }
  /// How the edge with that word, whose last two parameters are one and the same, is kept: V names it once.
  template <class E, class... V>
  void edge_with_shared_parameter(const std::string& name) {
    add_shared(name, edge_tag<EdgeLayout<E>, E, V...>(name));
  }
  /// An old word for vertices (edges) that are written under another, with a layout of its own (see
  /// EdgeLayout).
  template <class T, class Fields = FileFields<T>>
  void old_vertex(std::string name) {
    Tag tag = vertex_tag<T, false, Fields>(std::move(name));
    tag.written = false;
    add(std::move(tag));
  }
  template <class Layout, class E, class... V>
  void old_edge(std::string name) {
    Tag tag = edge_tag<Layout, E, V...>(std::move(name));
    tag.written = false;
    add(std::move(tag));
  }

  /// nullptr where the word is unknown.
  const Tag* find(std::string_view name) const;
  /// The word under which an element is written, or nullptr.
  const Tag* tag_of(const Graph& graph, VertexRef vertex) const;
  const Tag* tag_of(const Graph& graph, EdgeRef edge) const;

 private:
  template <class T, bool IsParameter, class Fields = FileFields<T>>
  static Tag vertex_tag(std::string name) {
    Tag tag{std::move(name),
            IsParameter ? Tag::Kind::kParameter : Tag::Kind::kVertex,
            typeid(TypedVertexPool<T>),
            {}};
    tag.read_vertex = [](Graph& graph, Id id, FieldReader& in) -> VertexRef {
      if constexpr (IsParameter) {
        return graph.add_parameter(Fields::read(in), id);
      } else {
        return graph.add_vertex(Fields::read(in), id);
      }
    };
    tag.write_vertex = [](const Graph& graph, VertexRef ref, FieldWriter& out) {
      FileFields<T>::write(graph.estimate(VertexHandle<T>{ref}), out);
    };
    return tag;
  }

  template <class Layout, class E, class... V>
  static Tag edge_tag(std::string name) {
    Tag tag{
        std::move(name), Tag::Kind::kEdge, typeid(TypedEdgePool<E, io::Strip<V>...>), {io::argument<V>()...}};
    tag.check_edge = &io::check_edge<Layout, E, io::Strip<V>...>;
    tag.read_edge = &io::read_edge<Layout, E, io::Strip<V>...>;
    tag.write_edge = &io::write_edge<E>;
    return tag;
  }

  /// Throws InvalidArgument where the word is taken or is no word.
  void add(Tag tag);
  void add_shared(const std::string& name, Tag tag);
  void index(const Tag& tag);

  std::map<std::string, std::shared_ptr<const Tag>, std::less<>> tags_;
  std::multimap<std::type_index, std::shared_ptr<const Tag>> by_pool_;
};

/// The words of .g2o files for the ready-made types, and the words of TORO.
void register_slam2d(Registry& registry);
void register_slam3d(Registry& registry);
void register_toro(Registry& registry);
/// All of the above.
const Registry& default_registry();

}  // namespace boxplus
