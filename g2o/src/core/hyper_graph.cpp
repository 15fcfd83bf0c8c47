// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/core/hyper_graph.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "g2o/core/ownership.h"
#include "g2o/stuff/logger.h"

namespace g2o {
namespace {

/// Whether the edge has the same vertex twice. Empty positions do not count.
bool has_repetition(const HyperGraph::VertexContainer& vertices) {
  if (vertices.size() == 2) return vertices[0] != nullptr && vertices[0] == vertices[1];
  HyperGraph::VertexContainer sorted(vertices);
  std::sort(sorted.begin(), sorted.end());
  const auto first = std::find_if(sorted.begin(), sorted.end(), [](const auto* v) { return v != nullptr; });
  return std::adjacent_find(first, sorted.end()) != sorted.end();
}

}  // namespace

HyperGraph::HyperGraphElement::~HyperGraphElement() = default;

HyperGraph::Data::Data() = default;
HyperGraph::Data::~Data() = default;

HyperGraph::DataContainer::~DataContainer() {
  while (_userData != nullptr) {
    Data* next = _userData->next();
    release(_userData);
    _userData = next;
  }
}

HyperGraph::Vertex::Vertex(int id) : _id(id) {}
HyperGraph::Vertex::~Vertex() = default;

HyperGraph::Edge::Edge(int id) : _id(id) {}
HyperGraph::Edge::~Edge() = default;

void HyperGraph::Edge::resize(size_t size) {
  _vertices.resize(size, nullptr);
}

int HyperGraph::Edge::numUndefinedVertices() const {
  return static_cast<int>(std::count(_vertices.begin(), _vertices.end(), nullptr));
}

HyperGraph::HyperGraph() = default;

HyperGraph::~HyperGraph() {
  HyperGraph::clear();
}

HyperGraph::Vertex* HyperGraph::vertex(int id) {
  const auto found = _vertices.find(id);
  return found == _vertices.end() ? nullptr : found->second;
}

const HyperGraph::Vertex* HyperGraph::vertex(int id) const {
  const auto found = _vertices.find(id);
  return found == _vertices.end() ? nullptr : found->second;
}

bool HyperGraph::addVertex(Vertex* v) {
  if (v == nullptr) return false;
  return _vertices.emplace(v->id(), v).second;
}

bool HyperGraph::addEdge(Edge* e) {
  if (e == nullptr) return false;
  if (e->numUndefinedVertices() > 0) {
    G2O_ERROR("addEdge: expected a vertex at every position of the edge, but {} of {} are empty",
              e->numUndefinedVertices(), e->vertices().size());
    return false;
  }
  if (has_repetition(e->vertices())) {
    G2O_ERROR("addEdge: expected distinct vertices, but one vertex appears twice");
    return false;
  }
  if (!_edges.insert(e).second) {
    G2O_ERROR("addEdge: the edge is already in the graph");
    return false;
  }
  for (Vertex* v : e->vertices()) v->edges().insert(e);
  return true;
}

void HyperGraph::Edge::setVertex(size_t i, Vertex* v) {
  if (i < _vertices.size()) {
    _vertices[i] = v;
  } else {
    G2O_ERROR("setVertex: the edge has {} vertices, got position {}", _vertices.size(), i);
  }
}

bool HyperGraph::has(const Vertex* v, const char* caller) const {
  const bool found = v != nullptr && vertex(v->id()) == v;
  if (!found) G2O_ERROR("{}: expected a vertex of the graph", caller);
  return found;
}

bool HyperGraph::changeId(Vertex* v, int newId) {
  if (!has(v, "changeId")) return false;
  if (vertex(newId) != nullptr) {
    G2O_ERROR("changeId: the id {} is taken", newId);
    return false;
  }
  _vertices.erase(v->id());
  v->setId(newId);
  _vertices.emplace(newId, v);
  return true;
}

bool HyperGraph::setEdgeVertex(Edge* e, int pos, Vertex* v) {
  if (e == nullptr || pos < 0 || static_cast<size_t>(pos) >= e->vertices().size()) return false;
  const auto at = static_cast<size_t>(pos);
  VertexContainer changed = e->vertices();
  changed[at] = v;
  if (has_repetition(changed)) return false;
  if (Vertex* before = e->vertex(at)) before->edges().erase(e);
  e->setVertex(at, v);
  if (v != nullptr) v->edges().insert(e);
  return true;
}

// Moves the edges of `small` to `big` first, and removes edges only after that. If an edge cannot be moved,
// moves all edges back, so that a failed call changes nothing.
bool HyperGraph::mergeVertices(Vertex* big, Vertex* small, bool erase) {
  if (!has(big, "mergeVertices") || !has(small, "mergeVertices")) return false;
  if (big == small) {
    G2O_ERROR("mergeVertices: expected two different vertices, got vertex {} twice", big->id());
    return false;
  }
  std::vector<Edge*> between;
  std::vector<std::pair<Edge*, int>> moved;
  const EdgeSet edges = small->edges();
  for (Edge* e : edges) {
    const auto begin = e->vertices().begin(), end = e->vertices().end();
    const auto at = std::find(begin, end, small);
    if (at == end) continue;
    const int position = static_cast<int>(at - begin);
    if (std::find(begin, end, big) != end) {
      between.push_back(e);
    } else if (setEdgeVertex(e, position, big)) {
      moved.emplace_back(e, position);
    } else {
      for (const auto& [other, place] : moved) setEdgeVertex(other, place, small);
      return false;
    }
  }
  for (Edge* e : between) removeEdge(e);
  return !erase || removeVertex(small);
}

bool HyperGraph::detachVertex(Vertex* v) {
  if (!has(v, "detachVertex")) return false;
  const EdgeSet edges = v->edges();
  for (Edge* e : edges) {
    for (size_t i = 0; i < e->vertices().size(); ++i) {
      if (e->vertex(i) == v) setEdgeVertex(e, static_cast<int>(i), nullptr);
    }
  }
  return true;
}

bool HyperGraph::removeVertex(Vertex* v, bool detach) {
  if (!has(v, "removeVertex")) return false;
  if (detach) detachVertex(v);
  const EdgeSet edges = v->edges();
  for (Edge* e : edges) removeEdge(e);
  _vertices.erase(v->id());
  release(v);
  return true;
}

bool HyperGraph::removeEdge(Edge* e) {
  if (_edges.erase(e) == 0) {
    G2O_ERROR("removeEdge: expected an edge of the graph");
    return false;
  }
  for (Vertex* v : e->vertices()) {
    if (v != nullptr) v->edges().erase(e);
  }
  release(e);
  return true;
}

// Deletes the edges first, because the destructor of an edge may access its vertices. After that, accesses
// only vertices that are still in vertices(), because a client that owns its vertices may have deleted them
// and emptied vertices().
void HyperGraph::clear() {
  for (Edge* e : _edges) release(e);
  _edges.clear();
  for (const auto& [id, v] : _vertices) {
    v->edges().clear();
    release(v);
  }
  _vertices.clear();
}

}  // namespace g2o
