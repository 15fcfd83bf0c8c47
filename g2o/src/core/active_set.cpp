// SPDX-License-Identifier: BSD-3-Clause
// The active vertices and edges of a SparseOptimizer, and their numbering.
#include <algorithm>

#include "g2o/core/optimization_algorithm.h"
#include "g2o/core/sparse_optimizer.h"
#include "g2o/stuff/logger.h"

namespace g2o {
namespace {

OptimizableGraph::Vertex* as_vertex(HyperGraph::Vertex* v) {
  return static_cast<OptimizableGraph::Vertex*>(v);
}

bool takes_part(const OptimizableGraph::Edge& edge, int level) {
  return (level < 0 || edge.level() == level) && edge.numUndefinedVertices() == 0 && !edge.allVerticesFixed();
}

}  // namespace

bool SparseOptimizer::buildIndexMapping(SparseOptimizer::VertexContainer& vlist) {
  ++structure_revision_;
  _ivMap.clear();
  for (const bool marginalized : {false, true}) {
    for (OptimizableGraph::Vertex* v : vlist) {
      if (v->fixed()) {
        v->setHessianIndex(-1);
      } else if (v->marginalized() == marginalized) {
        v->setHessianIndex(static_cast<int>(_ivMap.size()));
        _ivMap.push_back(v);
      }
    }
  }
  return !_ivMap.empty();
}

void SparseOptimizer::clearIndexMapping() {
  ++structure_revision_;
  for (OptimizableGraph::Vertex* v : _ivMap) v->setHessianIndex(-1);
  _ivMap.clear();
}

/// Unmaps the Hessian blocks of the active vertices, because the next structure may store H elsewhere, and
/// may not contain all of these vertices.
void SparseOptimizer::forgetInitialization() {
  clearIndexMapping();
  for (OptimizableGraph::Vertex* v : _activeVertices) v->mapHessianMemory(nullptr);
  _activeVertices.clear();
  _activeEdges.clear();
}

/// Deactivates edges that lost a vertex through setVertex() or vertices(), which do not notify the optimizer.
void SparseOptimizer::dropIncompleteEdges() {
  const auto is_incomplete = [](const Edge* e) { return e->numUndefinedVertices() > 0; };
  const auto incomplete = std::find_if(_activeEdges.begin(), _activeEdges.end(), is_incomplete);
  if (incomplete == _activeEdges.end()) return;
  G2O_ERROR("number of edges that lost a vertex and are no longer active: {}",
            std::count_if(incomplete, _activeEdges.end(), is_incomplete));
  _activeEdges.erase(std::remove_if(incomplete, _activeEdges.end(), is_incomplete), _activeEdges.end());
  ++structure_revision_;
}

void SparseOptimizer::sortVectorContainers() {
  std::sort(_activeVertices.begin(), _activeVertices.end(), VertexIDCompare());
  std::sort(_activeEdges.begin(), _activeEdges.end(), EdgeIDCompare());
}

/// Makes the workspace large enough for all active edges. After an edge was added, setVertex() may have
/// replaced its vertices by vertices of larger dimension.
void SparseOptimizer::sizeWorkspace() {
  for (const OptimizableGraph::Edge* e : _activeEdges) _jacobianWorkspace.updateSize(e);
  _jacobianWorkspace.allocate();
}

/// The last step of each initializeOptimization(). It runs when the active vertices and edges are known.
bool SparseOptimizer::startOptimization() {
  sortVectorContainers();
  sizeWorkspace();
  const bool ok = buildIndexMapping(_activeVertices);
  postIteration(-1);
  return ok;
}

bool SparseOptimizer::initializeOptimization(HyperGraph::EdgeSet& eset) {
  preIteration(-1);
  forgetInitialization();
  std::set<OptimizableGraph::Vertex*> touched;
  for (HyperGraph::Edge* e : eset) {
    if (e == nullptr || e->numUndefinedVertices() > 0) continue;
    _activeEdges.push_back(static_cast<OptimizableGraph::Edge*>(e));
    for (HyperGraph::Vertex* v : e->vertices()) touched.insert(as_vertex(v));
  }
  _activeVertices.assign(touched.begin(), touched.end());
  return startOptimization();
}

bool SparseOptimizer::initializeOptimization(HyperGraph::VertexSet& vset, int level) {
  preIteration(-1);
  forgetInitialization();
  HyperGraph::EdgeSet edges;
  for (HyperGraph::Vertex* v : vset) {
    if (v == nullptr) continue;
    bool is_active = false;
    for (HyperGraph::Edge* e : v->edges()) {
      const auto in_set = [&](HyperGraph::Vertex* u) { return vset.count(u) > 0; };
      if (!takes_part(*static_cast<OptimizableGraph::Edge*>(e), level)) continue;
      if (!std::all_of(e->vertices().begin(), e->vertices().end(), in_set)) continue;
      is_active = true;
      if (edges.insert(e).second) _activeEdges.push_back(static_cast<OptimizableGraph::Edge*>(e));
    }
    if (is_active) _activeVertices.push_back(as_vertex(v));
  }
  return startOptimization();
}

/// Has the same effect as initializeOptimization() with the set of all vertices, but is faster, because it
/// looks up no vertices in a set.
bool SparseOptimizer::initializeOptimization(int level) {
  if (edges().empty()) {
    G2O_WARN("initializeOptimization: the graph has no edges");
    forgetInitialization();
    return false;
  }
  preIteration(-1);
  forgetInitialization();
  for (HyperGraph::Edge* e : edges()) {
    auto* edge = static_cast<OptimizableGraph::Edge*>(e);
    if (takes_part(*edge, level)) _activeEdges.push_back(edge);
  }
  for (OptimizableGraph::Edge* edge : _activeEdges) {
    for (HyperGraph::Vertex* v : edge->vertices()) _activeVertices.push_back(as_vertex(v));
  }
  std::sort(_activeVertices.begin(), _activeVertices.end(), VertexIDCompare());
  _activeVertices.erase(std::unique(_activeVertices.begin(), _activeVertices.end()), _activeVertices.end());
  return startOptimization();
}

bool SparseOptimizer::updateInitialization(HyperGraph::VertexSet& vset, HyperGraph::EdgeSet& eset) {
  std::vector<HyperGraph::Vertex*> added;
  for (HyperGraph::Vertex* u : vset) {
    const OptimizableGraph::Vertex* v = as_vertex(u);
    if (findActiveVertex(v) != _activeVertices.end()) continue;
    if (!v->fixed() && v->marginalized()) {
      G2O_ERROR("updateInitialization: vertex {} is marginalized; call initializeOptimization() instead",
                v->id());
      return false;
    }
    added.push_back(u);
  }
  for (HyperGraph::Edge* e : eset) {
    auto* edge = static_cast<OptimizableGraph::Edge*>(e);
    if (edge->numUndefinedVertices() == 0 && !edge->allVerticesFixed()) _activeEdges.push_back(edge);
  }
  std::sort(_activeEdges.begin(), _activeEdges.end(), EdgeIDCompare());
  _activeEdges.erase(std::unique(_activeEdges.begin(), _activeEdges.end()), _activeEdges.end());
  std::sort(added.begin(), added.end(),
            [](HyperGraph::Vertex* a, HyperGraph::Vertex* b) { return a->id() < b->id(); });
  const bool renumber = !_ivMap.empty() && _ivMap.back()->marginalized();  // marginalized vertices come last
  for (HyperGraph::Vertex* u : added) {
    OptimizableGraph::Vertex* v = as_vertex(u);
    _activeVertices.push_back(v);
    v->setHessianIndex(v->fixed() ? -1 : static_cast<int>(_ivMap.size()));
    if (!v->fixed()) _ivMap.push_back(v);
  }
  sortVectorContainers();
  if (renumber) buildIndexMapping(_activeVertices);
  ++structure_revision_;
  sizeWorkspace();
  return _algorithm == nullptr || _algorithm->updateStructure(added, eset);
}

bool SparseOptimizer::removeVertex(HyperGraph::Vertex* v, bool detach) {
  if (v != nullptr && vertex(v->id()) == v) {
    const auto* vertex = static_cast<OptimizableGraph::Vertex*>(v);
    const auto active = std::find(_activeVertices.begin(), _activeVertices.end(), vertex);
    if (active != _activeVertices.end()) _activeVertices.erase(active);
    clearIndexMapping();
  }
  return HyperGraph::removeVertex(v, detach);
}

bool SparseOptimizer::removeEdge(HyperGraph::Edge* e) {
  if (edges().count(e) > 0) {
    const auto active = findActiveEdge(static_cast<OptimizableGraph::Edge*>(e));
    if (active != _activeEdges.end()) _activeEdges.erase(active);
  }
  return HyperGraph::removeEdge(e);
}

bool SparseOptimizer::changeId(HyperGraph::Vertex* v, int newId) {
  if (!OptimizableGraph::changeId(v, newId)) return false;
  std::sort(_activeVertices.begin(), _activeVertices.end(), VertexIDCompare());
  return true;
}

// Deactivates an active edge that loses a vertex. An edge that gets another vertex contributes to another
// block of H, so the structure changes.
bool SparseOptimizer::setEdgeVertex(HyperGraph::Edge* e, int pos, HyperGraph::Vertex* v) {
  if (!OptimizableGraph::setEdgeVertex(e, pos, v)) return false;
  const auto active = findActiveEdge(static_cast<OptimizableGraph::Edge*>(e));
  if (active == _activeEdges.end()) return true;
  ++structure_revision_;
  if (v == nullptr) _activeEdges.erase(active);
  _jacobianWorkspace.allocate();
  return true;
}

SparseOptimizer::VertexContainer::const_iterator SparseOptimizer::findActiveVertex(
    const OptimizableGraph::Vertex* v) const {
  const auto at = std::lower_bound(_activeVertices.begin(), _activeVertices.end(), v, VertexIDCompare());
  return at != _activeVertices.end() && *at == v ? at : _activeVertices.end();
}

SparseOptimizer::EdgeContainer::const_iterator SparseOptimizer::findActiveEdge(
    const OptimizableGraph::Edge* e) const {
  const auto at =
      std::lower_bound(_activeEdges.begin(), _activeEdges.end(), e,
                       [](const Edge* a, const Edge* b) { return a->internalId() < b->internalId(); });
  return at != _activeEdges.end() && *at == e ? at : _activeEdges.end();
}

}  // namespace g2o
