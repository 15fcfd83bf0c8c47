// SPDX-License-Identifier: BSD-3-Clause
// The tags of a file, and the types that they stand for. One line adds a new type:
//
//     Registry registry = default_registry();
//     registry.vertex<Pose>("VERTEX_POSE");
//     registry.edge<MyEdge, Pose, Pose>("EDGE_MINE");
//
// A tag may have an example: the fields of a line with this tag, from the ids to Ω. The tests and the fuzz
// targets of all tags are made from their examples.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <typeindex>
#include <vector>

#include "boxplus/io/tag.h"

namespace boxplus {

/// Maps tags to types and types to tags. The class Fields reads and writes the fields of a line; another
/// class than the default one is for a second layout of the same type. If several tags stand for one type,
/// the first tag is written. All functions that add a tag throw InvalidArgument if the tag is taken or is not
/// valid in a file.
class Registry {
 public:
  template <class T, class Fields = FileFields<T>>
  void vertex(std::string name, const std::string& example = {}) {
    add(detail::vertex_tag<Fields, T>(std::move(name)), example);
  }
  template <class T>
  void parameter(std::string name, const std::string& example = {}) {
    add(detail::parameter_tag<T>(std::move(name)), example);
  }
  /// Each V is a vertex type, Tail<T> (in the last place), or Parameter<T> (after all vertices).
  template <class E, class... V>
  void edge(std::string name, const std::string& example = {}) {
    add(detail::edge_tag<EdgeFields<E>, E, V...>(std::move(name)), example);
  }
  template <class Fields, class E, class... V>
  void edge_with_fields(std::string name, const std::string& example = {}) {
    add(detail::edge_tag<Fields, E, V...>(std::move(name)), example);
  }
  /// Adds the type of the edges whose lines have this tag and end with the same parameter twice. V… lists
  /// this parameter once.
  template <class E, class... V>
  void edge_with_shared_parameter(const std::string& name, const std::string& example = {}) {
    add_shared(detail::edge_tag<EdgeFields<E>, E, V...>(name), example);
  }
  /// Adds an old tag of vertices (edges). The tag is only read; the vertices (edges) are written with another
  /// tag, so Fields needs no write().
  template <class T, class Fields = FileFields<T>>
  void old_vertex(std::string name, const std::string& example = {}) {
    add_old(detail::vertex_tag<Fields, T>(std::move(name)), example);
  }
  template <class Fields, class E, class... V>
  void old_edge(std::string name, const std::string& example = {}) {
    add_old(detail::edge_tag<Fields, E, V...>(std::move(name)), example);
  }

  /// nullptr if the tag is unknown.
  const Tag* find(std::string_view name) const;
  /// The tag under which an element is written, or nullptr.
  const Tag* tag_of(const Graph& graph, VertexRef vertex) const;
  const Tag* tag_of(const Graph& graph, EdgeRef edge) const;
  /// All tags, sorted.
  std::vector<std::string> names() const;
  /// A small file: the example of the tag (and of its edges with a shared parameter), after a line for each
  /// vertex and parameter that it refers to, made from the examples of their tags. Throws InvalidArgument if
  /// the tag is unknown or one of these examples is missing.
  std::string example(const std::string& name) const;

 private:
  void add(Tag tag, std::string example);
  void add_old(Tag tag, std::string example);
  void add_shared(Tag tag, std::string example);
  const Tag& get(const std::string& name) const;
  std::string example_of(const Tag::Argument& argument, Id id) const;

  std::map<std::string, std::shared_ptr<const Tag>, std::less<>> tags_;
  std::multimap<std::type_index, std::shared_ptr<const Tag>> by_pool_;
};

/// The tags of .g2o files for the ready-made types, and the tags of TORO.
void register_slam2d(Registry& registry);
void register_slam3d(Registry& registry);
void register_ba(Registry& registry);
void register_toro(Registry& registry);
/// A registry with the tags of all of these functions.
const Registry& default_registry();

}  // namespace boxplus
