// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/core/optimizable_graph.h"

#include <algorithm>

#include "core/findings.h"
#include "g2o/core/cache.h"
#include "g2o/core/optimization_algorithm_property.h"
#include "g2o/core/ownership.h"
#include "g2o/core/robust_kernel.h"
#include "g2o/stuff/logger.h"

namespace g2o {
namespace {

OptimizableGraph::Vertex* as_vertex(HyperGraph::Vertex* v) {
  return static_cast<OptimizableGraph::Vertex*>(v);
}

}  // namespace

OptimizableGraph::Vertex::Vertex() = default;
OptimizableGraph::Vertex::~Vertex() = default;

void OptimizableGraph::Vertex::oplusImpl(const double* v) {
  oplusImpl(const_cast<double*>(v));
}

void OptimizableGraph::Vertex::oplusImpl(double*) {
  G2O_ERROR("vertex {}: its type overrides neither oplusImpl(const double*) nor oplusImpl(double*)", id());
}

CacheContainer* OptimizableGraph::Vertex::cacheContainer() {
  if (_cacheContainer == nullptr) _cacheContainer = std::make_unique<CacheContainer>(this);
  return _cacheContainer.get();
}

void OptimizableGraph::Vertex::updateCache() {
  if (_cacheContainer == nullptr) return;
  _cacheContainer->setUpdateNeeded();
  _cacheContainer->update();
}

bool OptimizableGraph::Vertex::setEstimateData(const double* estimate) {
  const bool ok = setEstimateDataImpl(estimate);
  updateCache();
  return ok;
}

bool OptimizableGraph::Vertex::getEstimateData(double*) const {
  return false;
}

int OptimizableGraph::Vertex::estimateDimension() const {
  return -1;
}

bool OptimizableGraph::Vertex::setMinimalEstimateData(const double* estimate) {
  const bool ok = setMinimalEstimateDataImpl(estimate);
  updateCache();
  return ok;
}

bool OptimizableGraph::Vertex::getMinimalEstimateData(double*) const {
  return false;
}

int OptimizableGraph::Vertex::minimalEstimateDimension() const {
  return -1;
}

OptimizableGraph::Edge::Edge() = default;

OptimizableGraph::Edge::~Edge() {
  release(_robustKernel);
}

OptimizableGraph* OptimizableGraph::Edge::graph() {
  if (_vertices.empty() || _vertices[0] == nullptr) return nullptr;
  return as_vertex(_vertices[0])->graph();
}

const OptimizableGraph* OptimizableGraph::Edge::graph() const {
  return const_cast<Edge*>(this)->graph();
}

bool OptimizableGraph::Edge::setParameterId(int argNum, int paramId) {
  if (argNum < 0 || static_cast<size_t>(argNum) >= _parameters.size() || paramId < 0) {
    G2O_ERROR(
        "setParameterId: expected an index below {} (the number of parameters) and an id of at least 0, got "
        "{} and {}",
        _parameters.size(), argNum, paramId);
    return false;
  }
  _parameterIds[static_cast<size_t>(argNum)] = paramId;
  return true;
}

void OptimizableGraph::Edge::resizeParameters(size_t newSize) {
  _parameters.resize(newSize, nullptr);
  _parameterIds.resize(newSize, -1);
  _parameterTypes.resize(newSize, typeid(void*).name());
  _parameterSetters.resize(newSize, nullptr);
}

bool OptimizableGraph::Edge::resolveParameters() {
  for (size_t i = 0; i < _parameters.size(); ++i) {
    Parameter* p = graph() == nullptr ? nullptr : graph()->parameter(_parameterIds[i]);
    if (p == nullptr || _parameterSetters[i] == nullptr) {
      G2O_ERROR("addEdge: the edge needs parameter {}, which does not exist", _parameterIds[i]);
      return false;
    }
    if (!_parameterSetters[i](_parameters[i], p)) {
      G2O_ERROR("addEdge: parameter {} does not have the type that the edge needs", _parameterIds[i]);
      return false;
    }
  }
  return true;
}

bool OptimizableGraph::Edge::resolveCaches() {
  return true;
}

void OptimizableGraph::Edge::setRobustKernel(RobustKernel* ptr) {
  if (_robustKernel == ptr) return;
  release(_robustKernel);
  _robustKernel = ptr;
}

bool OptimizableGraph::Edge::setMeasurementData(const double*) {
  return false;
}

bool OptimizableGraph::Edge::getMeasurementData(double*) const {
  return false;
}

int OptimizableGraph::Edge::measurementDimension() const {
  return -1;
}

bool OptimizableGraph::Edge::setMeasurementFromState() {
  return false;
}

OptimizableGraph::OptimizableGraph() {
  _graphActions.resize(AT_NUM_ELEMENTS);
}

// Deletes the vertices and edges first, and then the parameters that they use.
OptimizableGraph::~OptimizableGraph() {
  HyperGraph::clear();
  _parameters.clear();
}

bool OptimizableGraph::addVertex(OptimizableGraph::Vertex* v, Data* userData) {
  if (v == nullptr) {
    G2O_ERROR("addVertex: expected a vertex, got nullptr");
    return false;
  }
  if (v->graph() != nullptr && v->graph() != this) {
    G2O_ERROR("addVertex: vertex {} is already in another graph", v->id());
    return false;
  }
  if (v->graph() == this && vertex(v->addedAs_) == v) {
    G2O_ERROR("addVertex: vertex {} is already in the graph, with id {}", v->id(), v->addedAs_);
    return false;
  }
  if (v->id() < 0) G2O_WARN("addVertex: a vertex has id {}; files cannot hold negative ids", v->id());
  if (!HyperGraph::addVertex(v)) {
    G2O_WARN("addVertex: the id {} is taken", v->id());
    return false;
  }
  if (userData != nullptr) v->addUserData(userData);
  v->_graph = this;
  v->addedAs_ = v->id();
  return true;
}

bool OptimizableGraph::addVertex(HyperGraph::Vertex* v, Data* userData) {
  auto* vertex = dynamic_cast<OptimizableGraph::Vertex*>(v);
  if (vertex == nullptr) {
    G2O_ERROR("addVertex: expected an OptimizableGraph::Vertex");
    return false;
  }
  return addVertex(vertex, userData);
}

bool OptimizableGraph::addVertex(HyperGraph::Vertex* v) {
  return addVertex(v, nullptr);
}

bool OptimizableGraph::addEdge(HyperGraph::Edge* e) {
  auto* edge = dynamic_cast<OptimizableGraph::Edge*>(e);
  if (edge == nullptr) {
    G2O_ERROR("addEdge: expected an OptimizableGraph::Edge");
    return false;
  }
  return addEdge(edge);
}

bool OptimizableGraph::addEdge(OptimizableGraph::Edge* e) {
  if (e == nullptr || _edges.count(e) > 0 || e->numUndefinedVertices() > 0) return HyperGraph::addEdge(e);
  for (const HyperGraph::Vertex* v : e->vertices()) {
    if (vertex(v->id()) == v) continue;
    G2O_ERROR("addEdge: vertex {} is not in the graph", v->id());
    return false;
  }
  if (!e->verticesFit()) {
    G2O_ERROR("addEdge: the vertices do not have the types that the edge expects");
    return false;
  }
  if (!e->resolveParameters() || !HyperGraph::addEdge(e)) return false;
  if (!e->resolveCaches()) {
    G2O_ERROR("addEdge: the caches of the edge cannot be created");
    _edges.erase(e);
    for (HyperGraph::Vertex* v : e->vertices()) v->edges().erase(e);
    return false;
  }
  e->_internalId = _nextEdgeId++;
  _jacobianWorkspace.updateSize(e);
  return true;
}

bool OptimizableGraph::addUnassignedEdge(OptimizableGraph::Edge* e) {
  if (e == nullptr || e->numUndefinedVertices() == 0) return addEdge(e);
  VertexContainer assigned;
  for (HyperGraph::Vertex* v : e->vertices()) {
    if (v != nullptr) assigned.push_back(as_vertex(v));
  }
  for (const OptimizableGraph::Vertex* v : assigned) {
    if (vertex(v->id()) == v && std::count(assigned.begin(), assigned.end(), v) == 1) continue;
    G2O_ERROR(
        "addUnassignedEdge: expected distinct vertices of the graph, but vertex {} is not in the graph or "
        "appears twice",
        v->id());
    return false;
  }
  if (!e->verticesFit()) {
    G2O_ERROR("addUnassignedEdge: the vertices do not have the types that the edge expects");
    return false;
  }
  if (!_edges.insert(e).second) return false;
  for (OptimizableGraph::Vertex* v : assigned) v->edges().insert(e);
  e->_internalId = _nextEdgeId++;
  return true;
}

bool OptimizableGraph::changeId(HyperGraph::Vertex* v, int newId) {
  if (!HyperGraph::changeId(v, newId)) return false;
  as_vertex(v)->addedAs_ = newId;
  if (newId < 0) G2O_WARN("changeId: a vertex has id {}; files cannot hold negative ids", newId);
  return true;
}

bool OptimizableGraph::setEdgeVertex(HyperGraph::Edge* e, int pos, HyperGraph::Vertex* v) {
  if (e == nullptr || pos < 0 || static_cast<size_t>(pos) >= e->vertices().size()) {
    G2O_ERROR("setEdgeVertex: expected an edge and a position in it, got position {}", pos);
    return false;
  }
  if (v != nullptr && vertex(v->id()) != v) {
    G2O_ERROR("setEdgeVertex: vertex {} is not in the graph", v->id());
    return false;
  }
  HyperGraph::Vertex* before = e->vertex(static_cast<size_t>(pos));
  if (!HyperGraph::setEdgeVertex(e, pos, v)) return false;
  auto* edge = static_cast<OptimizableGraph::Edge*>(e);
  const bool fits = edge->verticesFit();
  if (!fits) G2O_ERROR("setEdgeVertex: the vertices do not have the types that the edge expects");
  if (fits && edge->numUndefinedVertices() > 0) return true;
  if (fits && edge->resolveParameters() && edge->resolveCaches()) {
    _jacobianWorkspace.updateSize(edge);
    return true;
  }
  HyperGraph::setEdgeVertex(e, pos, before);
  if (edge->numUndefinedVertices() == 0) edge->resolveCaches();
  return false;
}

double OptimizableGraph::chi2() const {
  std::vector<const Edge*> sorted;
  sorted.reserve(_edges.size());
  for (const HyperGraph::Edge* e : _edges) sorted.push_back(static_cast<const Edge*>(e));
  std::sort(sorted.begin(), sorted.end(), EdgeIDCompare());
  double sum = 0;
  for (const Edge* e : sorted) sum += e->chi2();
  return sum;
}

int OptimizableGraph::maxDimension() const {
  int largest = 0;
  for (const auto& [id, v] : vertices()) largest = std::max(largest, as_vertex(v)->dimension());
  return largest;
}

std::set<int> OptimizableGraph::dimensions() const {
  std::set<int> result;
  for (const auto& [id, v] : vertices()) result.insert(as_vertex(v)->dimension());
  return result;
}

int OptimizableGraph::optimize(int, bool) {
  return 0;
}

void OptimizableGraph::preIteration(int iter) {
  HyperGraphAction::ParametersIteration parameters(iter);
  callActions(AT_PREITERATION, &parameters);
}

void OptimizableGraph::postIteration(int iter) {
  HyperGraphAction::ParametersIteration parameters(iter);
  callActions(AT_POSTITERATION, &parameters);
}

void OptimizableGraph::callActions(int type, HyperGraphAction::Parameters* parameters) {
  const HyperGraphActionSet& actions = _graphActions[static_cast<size_t>(type)];
  if (actions.empty()) return;
  const HyperGraphActionSet before = actions;
  for (HyperGraphAction* action : before) {
    if (actions.count(action) > 0) (*action)(this, parameters);
  }
}

bool OptimizableGraph::addPreIterationAction(HyperGraphAction* action) {
  return addAction(AT_PREITERATION, action);
}

bool OptimizableGraph::addPostIterationAction(HyperGraphAction* action) {
  return addAction(AT_POSTITERATION, action);
}

bool OptimizableGraph::addAction(int type, HyperGraphAction* action) {
  if (action != nullptr) return _graphActions[static_cast<size_t>(type)].insert(action).second;
  G2O_ERROR("expected an action, got nullptr");
  return false;
}

bool OptimizableGraph::removePreIterationAction(HyperGraphAction* action) {
  return _graphActions[AT_PREITERATION].erase(action) > 0;
}

bool OptimizableGraph::removePostIterationAction(HyperGraphAction* action) {
  return _graphActions[AT_POSTITERATION].erase(action) > 0;
}

void OptimizableGraph::forEachVertex(const std::function<void(OptimizableGraph::Vertex*)>& fn) {
  for (const auto& [id, v] : _vertices) fn(as_vertex(v));
}

void OptimizableGraph::forEachVertex(HyperGraph::VertexSet& vset,
                                     const std::function<void(OptimizableGraph::Vertex*)>& fn) {
  for (HyperGraph::Vertex* v : vset) fn(as_vertex(v));
}

void OptimizableGraph::push() {
  forEachVertex([](Vertex* v) { v->push(); });
}

void OptimizableGraph::pop() {
  forEachVertex([](Vertex* v) { v->pop(); });
}

void OptimizableGraph::discardTop() {
  forEachVertex([](Vertex* v) { v->discardTop(); });
}

void OptimizableGraph::push(HyperGraph::VertexSet& vset) {
  forEachVertex(vset, [](Vertex* v) { v->push(); });
}

void OptimizableGraph::pop(HyperGraph::VertexSet& vset) {
  forEachVertex(vset, [](Vertex* v) { v->pop(); });
}

void OptimizableGraph::discardTop(HyperGraph::VertexSet& vset) {
  forEachVertex(vset, [](Vertex* v) { v->discardTop(); });
}

void OptimizableGraph::setFixed(HyperGraph::VertexSet& vset, bool fixed) {
  forEachVertex(vset, [fixed](Vertex* v) { v->setFixed(fixed); });
}

void OptimizableGraph::clearParameters() {
  clear();
  _parameters.clear();
}

void OptimizableGraph::recomputeJacobianWorkspaceSize() {
  _jacobianWorkspace.updateSize(*this, true);
}

bool OptimizableGraph::initMultiThreading() {
  return true;
}

// An algorithm that requires marginalization is for graphs with poses and landmarks, which have different
// dimensions. All other algorithms are for vertices of one dimension or, if the dimension is −1, for vertices
// of any dimensions.
bool OptimizableGraph::isSolverSuitable(const OptimizationAlgorithmProperty& solverProperty,
                                        const std::set<int>& vertDims_) const {
  const std::set<int> dims = vertDims_.empty() ? dimensions() : vertDims_;
  const auto fits = [](int wanted, int dim) { return wanted == -1 || wanted == dim; };
  if (dims.size() == 2 && solverProperty.requiresMarginalize)
    return fits(solverProperty.poseDim, *dims.rbegin()) && fits(solverProperty.landmarkDim, *dims.begin());
  if (dims.size() == 1 && !solverProperty.requiresMarginalize)
    return fits(solverProperty.poseDim, *dims.begin());
  if (dims.size() == 1) return solverProperty.poseDim == *dims.begin();
  return !solverProperty.requiresMarginalize && solverProperty.poseDim == -1;
}

bool OptimizableGraph::verifyInformationMatrices(bool verbose) const {
  bool ok = true;
  for (const HyperGraph::Edge* u : _edges) {
    const auto* e = static_cast<const Edge*>(u);
    const internal::InformationCheck check = internal::checkInformation(*e);
    if (check.definite) continue;
    ok = false;
    if (!verbose) break;
    std::string ids;
    for (const HyperGraph::Vertex* v : e->vertices()) ids += " " + (v ? std::to_string(v->id()) : "none");
    G2O_WARN("the information matrix of the edge over{} is not {}", ids,
             check.symmetric ? "positive semi-definite" : "symmetric");
  }
  return ok;
}

}  // namespace g2o
