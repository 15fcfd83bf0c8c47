// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/core/hyper_graph_action.h"

#include <algorithm>
#include <vector>

#include "g2o/core/optimizable_graph.h"

namespace g2o {

HyperGraphAction::Parameters::~Parameters() = default;
HyperGraphAction::ParametersIteration::ParametersIteration(int iter) : iteration(iter) {}
HyperGraphAction::ParametersIteration::~ParametersIteration() = default;
HyperGraphAction::~HyperGraphAction() = default;

HyperGraphAction* HyperGraphAction::operator()(const HyperGraph*, Parameters*) {
  return nullptr;
}

HyperGraphElementAction::Parameters::~Parameters() = default;
HyperGraphElementAction::HyperGraphElementAction(const std::string& typeName_) : _typeName(typeName_) {}
HyperGraphElementAction::~HyperGraphElementAction() = default;

HyperGraphElementAction* HyperGraphElementAction::operator()(HyperGraph::HyperGraphElement*, Parameters*) {
  return nullptr;
}

HyperGraphElementAction* HyperGraphElementAction::operator()(const HyperGraph::HyperGraphElement*,
                                                             Parameters*) {
  return nullptr;
}

void HyperGraphElementAction::setTypeName(const std::string& typeName_) {
  _typeName = typeName_;
}

HyperGraphElementActionCollection::HyperGraphElementActionCollection(const std::string& name_) {
  _name = name_;
}

HyperGraphElementAction* HyperGraphElementActionCollection::operator()(HyperGraph::HyperGraphElement* element,
                                                                       Parameters* parameters) {
  if (element == nullptr) return nullptr;
  const auto found = _actionMap.find(typeid(*element).name());
  return found == _actionMap.end() ? nullptr : (*found->second)(element, parameters);
}

HyperGraphElementAction* HyperGraphElementActionCollection::operator()(
    const HyperGraph::HyperGraphElement* element, Parameters* parameters) {
  if (element == nullptr) return nullptr;
  const auto found = _actionMap.find(typeid(*element).name());
  return found == _actionMap.end() ? nullptr : (*found->second)(element, parameters);
}

bool HyperGraphElementActionCollection::registerAction(const HyperGraphElementActionPtr& action) {
  if (action == nullptr || action->name() != name()) return false;
  shadowed_.replace(action->typeName(), _actionMap[action->typeName()], action);
  return true;
}

bool HyperGraphElementActionCollection::unregisterAction(const HyperGraphElementActionPtr& action) {
  if (action == nullptr) return false;
  const auto found = _actionMap.find(action->typeName());
  if (found == _actionMap.end()) return false;
  const bool taken = shadowed_.take_back(action->typeName(), found->second, action);
  if (found->second == nullptr) _actionMap.erase(found);
  return taken;
}

namespace {

HyperGraphActionLibrary*& library_slot() {
  static HyperGraphActionLibrary* slot = nullptr;
  return slot;
}

}  // namespace

HyperGraphActionLibrary::HyperGraphActionLibrary() = default;
HyperGraphActionLibrary::~HyperGraphActionLibrary() = default;

HyperGraphActionLibrary* HyperGraphActionLibrary::instance() {
  if (library_slot() == nullptr) library_slot() = new HyperGraphActionLibrary;
  return library_slot();
}

void HyperGraphActionLibrary::destroy() {
  delete library_slot();
  library_slot() = nullptr;
}

HyperGraphElementAction* HyperGraphActionLibrary::actionByName(const std::string& name) {
  const auto found = _actionMap.find(name);
  return found == _actionMap.end() ? nullptr : found->second.get();
}

bool HyperGraphActionLibrary::registerAction(const HyperGraphElementActionPtr& action) {
  if (action == nullptr) return false;
  HyperGraphElementActionPtr& collection = _actionMap[action->name()];
  if (collection == nullptr) collection = std::make_shared<HyperGraphElementActionCollection>(action->name());
  return std::static_pointer_cast<HyperGraphElementActionCollection>(collection)->registerAction(action);
}

bool HyperGraphActionLibrary::unregisterAction(const HyperGraphElementActionPtr& action) {
  if (action == nullptr) return false;
  const auto found = _actionMap.find(action->name());
  return found != _actionMap.end() &&
         std::static_pointer_cast<HyperGraphElementActionCollection>(found->second)->unregisterAction(action);
}

// Visits vertices in the order of ids and edges in the order in which they were added, so that the output
// does not depend on addresses.
void applyAction(HyperGraph* graph, HyperGraphElementAction* action,
                 HyperGraphElementAction::Parameters* parameters, const std::string& typeName) {
  if (graph == nullptr || action == nullptr) return;
  std::vector<HyperGraph::Vertex*> vertices;
  for (const auto& [id, v] : graph->vertices()) vertices.push_back(v);
  std::sort(vertices.begin(), vertices.end(), [](const auto* a, const auto* b) { return a->id() < b->id(); });
  for (HyperGraph::Vertex* v : vertices) {
    if (typeName.empty() || typeid(*v).name() == typeName) (*action)(v, parameters);
  }
  std::vector<HyperGraph::Edge*> edges(graph->edges().begin(), graph->edges().end());
  const auto added = [](const HyperGraph::Edge* e) {
    const auto* optimizable = dynamic_cast<const OptimizableGraph::Edge*>(e);
    return optimizable == nullptr ? -1LL : optimizable->internalId();
  };
  std::stable_sort(edges.begin(), edges.end(),
                   [&](const auto* a, const auto* b) { return added(a) < added(b); });
  for (HyperGraph::Edge* e : edges) {
    if (typeName.empty() || typeid(*e).name() == typeName) (*action)(e, parameters);
  }
}

WriteGnuplotAction::WriteGnuplotAction(const std::string& typeName_) : HyperGraphElementAction(typeName_) {
  _name = "writeGnuplot";
}

}  // namespace g2o
