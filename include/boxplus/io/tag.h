// SPDX-License-Identifier: BSD-3-Clause
// A tag, the first field of a line, with the functions that read and write elements of its type. Registry
// creates tags.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <tuple>
#include <typeindex>
#include <utility>
#include <vector>

#include "boxplus/base/error.h"
#include "boxplus/graph/graph.h"
#include "boxplus/io/file_fields.h"
#include "boxplus/io/image_fields.h"
#include "boxplus/io/information_fields.h"

namespace boxplus {

/// Marks a parameter among the vertex types of an edge: a shared constant of the graph (a PARAMS_ line of the
/// file).
template <class T>
struct Parameter {
  using Element = T;
};

/// A tag, and the type that it stands for. The reading functions consume the rest of the line. If they throw
/// InputError, they have added nothing to the graph.
struct Tag {
  enum class Kind : std::uint8_t { kVertex, kParameter, kEdge };
  /// A vertex of an edge.
  struct Argument {
    std::type_index pool;
    std::string_view type_name;
    bool is_parameter, is_tail;
    VertexRef (*create)(Graph&, Id);  ///< adds a vertex of the type, with the default estimate
  };

  std::string name;
  Kind kind;
  std::type_index pool;  ///< type of the pool that stores its elements
  std::vector<Argument> arguments;
  VertexRef (*read_vertex)(Graph&, Id, FieldReader&) = nullptr;
  void (*write_vertex)(const Graph&, VertexRef, FieldWriter&) = nullptr;
  void (*check_edge)(FieldReader&) = nullptr;  ///< reads measurement and Ω, and adds nothing
  EdgeRef (*read_edge)(Graph&, std::span<const VertexRef>, FieldReader&) = nullptr;
  void (*write_edge)(const Graph&, EdgeRef, FieldWriter&) = nullptr;  ///< measurement, Ω and the rest
  void (*write_rest)(const Graph&, EdgeRef,
                     FieldWriter&) = nullptr;  ///< the fields after Ω, if there are any
  bool lists_information = true;  ///< false if Ω follows from the measurement, and is not in the file
  /// The type to use if the last two parameters are the same, because an edge cannot list a vertex twice.
  std::shared_ptr<const Tag> shared_parameter = nullptr;
  bool written = true;       ///< false for an old tag that is only read
  int optional_fields = 0;   ///< at the end of a line, which may have none of them
  std::string example = {};  ///< the fields of a line (io/registry.h), or empty
};

/// As the last vertex type of an edge, stands for any number of vertices of type T.
using detail::Tail;

namespace detail {

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
  using T = detail::ElementOf<Strip<V>>;
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
    std::vector<VertexHandle<detail::ElementOf<V>>> handles;
    for (const VertexRef& ref : refs) handles.push_back(graph.typed<detail::ElementOf<V>>(ref));
    return handles;
  } else {
    const VertexRef first = refs.front();
    refs = refs.subspan(1);
    return graph.typed<V>(first);
  }
}

/// An edge that was read but not yet added.
template <class E>
struct ListedEdge {
  E edge;
  UncheckedInformation information;
};

template <class Fields, class E, class... V>
ListedEdge<E> read_listed_edge(FieldReader& in) {
  E edge = Fields::read(in);
  constexpr int kRows = detail::kRows<detail::Result<E, V...>>;
  int rows = kRows;
  if constexpr (kRows == kDynamic) rows = static_cast<int>(edge.measurement.size());
  UncheckedInformation information = [&]() -> UncheckedInformation {
    if constexpr (requires { Fields::information(edge); }) {
      return {Fields::information(edge), rows, in.place()};
    } else {
      ToUpperTriangle to_upper_triangle = nullptr;
      if constexpr (requires { &Fields::to_upper_triangle; }) to_upper_triangle = &Fields::to_upper_triangle;
      return read_unchecked_information(in, rows, to_upper_triangle);
    }
  }();
  if constexpr (requires { Fields::read_rest(edge, in); }) Fields::read_rest(edge, in);
  return {std::move(edge), std::move(information)};
}

template <class Fields, class E, class... V>
void check_edge(FieldReader& in) {
  read_listed_edge<Fields, E, V...>(in).information.check(in);
  in.expect_end();
}

template <class Fields, class E, class... V>
EdgeRef read_edge(Graph& graph, std::span<const VertexRef> refs, FieldReader& in) {
  ListedEdge<E> listed = read_listed_edge<Fields, E, V...>(in);
  if (!in.at_end()) {  // checks Ω first, because it may be the cause
    listed.information.check(in);
    in.expect_end();
  }
  const std::tuple handles{attach<V>(graph, refs)...};
  try {
    return std::apply(
        [&](const auto&... h) {
          return graph.add_edge(std::move(listed.edge), listed.information.value, h...);
        },
        handles);
  } catch (const InvalidArgument&) {
    listed.information.check(in);
    throw;
  }
}

template <class Fields, class E>
void write_edge(const Graph& graph, EdgeRef ref, FieldWriter& out) {
  const E& edge = graph.measurement(EdgeHandle<E>{ref});
  Fields::write(edge, out);
  if constexpr (requires { Fields::information(edge); }) {
    require_information(graph.information(ref), Fields::information(edge), type_name<E>());
  } else if constexpr (requires { &Fields::from_upper_triangle; }) {
    write_information(graph.information(ref), out, &Fields::from_upper_triangle);
  } else {
    write_information(graph.information(ref), out);
  }
  if constexpr (requires { Fields::write_rest(edge, out); }) Fields::write_rest(edge, out);
}

template <class Fields, class E>
void write_rest(const Graph& graph, EdgeRef ref, FieldWriter& out) {
  Fields::write_rest(graph.measurement(EdgeHandle<E>{ref}), out);
}

template <class Fields>
inline constexpr int kOptionalFields = [] {
  if constexpr (requires { Fields::kOptionalFields; }) {
    return Fields::kOptionalFields;
  } else {
    return 0;
  }
}();

template <class Fields, class T>
Tag vertex_tag(std::string name) {
  Tag tag{std::move(name), Tag::Kind::kVertex, typeid(TypedVertexPool<T>), {}};
  tag.optional_fields = kOptionalFields<Fields>;
  tag.read_vertex = [](Graph& graph, Id id, FieldReader& in) -> VertexRef {
    T value = Fields::read(in);
    in.expect_end();
    return graph.add_vertex(std::move(value), id);
  };
  if constexpr (requires(const T& x, FieldWriter& out) { Fields::write(x, out); }) {
    tag.write_vertex = [](const Graph& graph, VertexRef ref, FieldWriter& out) {
      Fields::write(graph.estimate(VertexHandle<T>{ref}), out);
    };
  }
  return tag;
}

template <class T>
Tag parameter_tag(std::string name) {
  Tag tag = vertex_tag<FileFields<T>, T>(std::move(name));
  tag.kind = Tag::Kind::kParameter;
  tag.read_vertex = [](Graph& graph, Id id, FieldReader& in) -> VertexRef {
    T value = FileFields<T>::read(in);
    in.expect_end();
    return graph.add_parameter(std::move(value), id);
  };
  return tag;
}

template <class Fields, class E, class... V>
Tag edge_tag(std::string name) {
  Tag tag{std::move(name), Tag::Kind::kEdge, typeid(TypedEdgePool<E, Strip<V>...>), {argument<V>()...}};
  tag.optional_fields = kOptionalFields<Fields>;
  tag.check_edge = &check_edge<Fields, E, Strip<V>...>;
  tag.read_edge = &read_edge<Fields, E, Strip<V>...>;
  if constexpr (requires(const E& edge, FieldWriter& out) { Fields::write(edge, out); })
    tag.write_edge = &write_edge<Fields, E>;
  tag.lists_information = !requires(const E& edge) {
    Fields::information(edge);
  };
  if constexpr (requires(const E& edge, FieldWriter& out) { Fields::write_rest(edge, out); })
    tag.write_rest = &write_rest<Fields, E>;
  return tag;
}

}  // namespace detail
}  // namespace boxplus
