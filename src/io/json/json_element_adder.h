// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "boxplus/io/graph_file.h"
#include "io/g2o/element_reader.h"
#include "io/g2o/line_block.h"
#include "io/json/json_element.h"

namespace boxplus {

/// Adds the elements of a JSON text to a graph. The fields of an element are the fields of its line in a .g2o
/// file, so the same functions read them. Each function throws JsonError if the element is wrong; then the
/// graph has not changed.
class JsonElementAdder {
 public:
  /// `tags` must outlive this object.
  JsonElementAdder(Graph& graph, const TagLookup& tags, ReadOptions::Indefinite policy)
      : graph_(graph), tags_(tags), elements_(graph, unknown_, tags.registry()), policy_(policy) {}

  /// Adds a vertex or a parameter.
  void add_vertex(const JsonElement& element, bool is_parameter);
  /// Call this before the first call of add_edge().
  void end_of_vertices() { elements_.end_of_vertices(false); }
  EdgeRef add_edge(const JsonElement& element);
  /// Something unusual about the last element that is not an error; empty if there is nothing.
  const std::string& noted() const { return noted_; }
  /// Whether the Ω of the last edge was indefinite, and was replaced or kept.
  bool has_indefinite() const { return has_indefinite_; }

 private:
  const Tag& tag_of(const JsonElement& element, Tag::Kind kind);
  template <class F>
  void with_fields(const JsonElement& element, const Tag& tag, F&& read);
  template <class F>
  void with_text(const JsonElement& element, const Tag& tag, F&& read);
  std::shared_ptr<const RobustKernel> kernel(const JsonElement::Kernel& wanted);

  Graph& graph_;
  const TagLookup& tags_;
  const UnknownTags unknown_;
  ElementReader elements_;
  ReadOptions::Indefinite policy_;
  bool has_indefinite_ = false;
  std::string last_name_, noted_;
  const Tag* last_tag_ = nullptr;  // the tag with the name last_name_
  std::vector<double> values_;     // of the current element
  std::map<std::pair<std::string, double>, std::shared_ptr<const RobustKernel>> kernels_;
};

}  // namespace boxplus
