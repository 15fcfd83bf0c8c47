// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/core/hyper_graph.h"

#include <algorithm>

#include "g2o/core/ownership.h"
#include "g2o/stuff/logger.h"

namespace g2o {
namespace {

/// Whether the edge lists a vertex twice; positions without a vertex do not count.
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
    G2O_ERROR("addEdge: expected a vertex in every place of the edge, {} of {} have none",
              e->numUndefinedVertices(), e->vertices().size());
    return false;
  }
  if (has_repetition(e->vertices())) {
    G2O_ERROR("addEdge: expected distinct vertices, one appears twice");
    return false;
  }
  if (!_edges.insert(e).second) {
    G2O_ERROR("addEdge: the edge is in the graph already");
    return false;
  }
  for (Vertex* v : e->vertices()) v->edges().insert(e);
  return true;
}

bool HyperGraph::changeId(Vertex* v, int newId) {
  if (v == nullptr || vertex(v->id()) != v || vertex(newId) != nullptr) return false;
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

bool HyperGraph::mergeVertices(Vertex* big, Vertex* small, bool erase) {
  if (big == nullptr || small == nullptr || big == small) return false;
  if (vertex(big->id()) != big || vertex(small->id()) != small) return false;
  const EdgeSet edges = small->edges();
  for (Edge* e : edges) {
    const auto at = std::find(e->vertices().begin(), e->vertices().end(), small);
    if (at == e->vertices().end()) continue;
    if (!setEdgeVertex(e, static_cast<int>(at - e->vertices().begin()), big)) removeEdge(e);
  }
  return !erase || removeVertex(small);
}

bool HyperGraph::detachVertex(Vertex* v) {
  if (v == nullptr || vertex(v->id()) != v) return false;
  const EdgeSet edges = v->edges();
  for (Edge* e : edges) {
    for (size_t i = 0; i < e->vertices().size(); ++i) {
      if (e->vertex(i) == v) setEdgeVertex(e, static_cast<int>(i), nullptr);
    }
  }
  return true;
}

bool HyperGraph::removeVertex(Vertex* v, bool detach) {
  if (v == nullptr || vertex(v->id()) != v) return false;
  if (detach) detachVertex(v);
  const EdgeSet edges = v->edges();
  for (Edge* e : edges) removeEdge(e);
  _vertices.erase(v->id());
  release(v);
  return true;
}

bool HyperGraph::removeEdge(Edge* e) {
  if (_edges.erase(e) == 0) return false;
  for (Vertex* v : e->vertices()) {
    if (v != nullptr) v->edges().erase(e);
  }
  release(e);
  return true;
}

// Edges go first, so that their destructors still find their vertices. Only the vertices that are still
// listed are looked into: a client may own its vertices, and have emptied vertices() before.
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
