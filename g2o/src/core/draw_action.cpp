// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/core/cache.h"
#include "g2o/core/hyper_graph_action.h"

namespace g2o {
namespace {

HyperGraphElementAction* draw_action() {
  return HyperGraphActionLibrary::instance()->actionByName("draw");
}

}  // namespace

DrawAction::Parameters::Parameters() = default;
DrawAction::Parameters::~Parameters() = default;

DrawAction::DrawAction(const std::string& typeName_) : HyperGraphElementAction(typeName_) {
  _name = "draw";
}
DrawAction::~DrawAction() = default;

// Looks up the properties in every call. It is not enough to compare addresses, because a new Parameters
// object may have the same address as the previous object.
bool DrawAction::refreshPropertyPtrs(HyperGraphElementAction::Parameters* params_) {
  _previousParams = dynamic_cast<Parameters*>(params_);
  if (_previousParams == nullptr || _previousParams->drawing == nullptr) return false;
  _show = _previousParams->makeProperty<BoolProperty>(_typeName + "::SHOW", true);
  return true;
}

float DrawAction::property(const std::string& name, float otherwise) {
  const auto found = _previousParams->makeProperty<FloatProperty>(_typeName + "::" + name, otherwise);
  return found == nullptr ? otherwise : found->value();
}

void DrawAction::drawCache(CacheContainer* caches, HyperGraphElementAction::Parameters* params_) {
  HyperGraphElementAction* draw = draw_action();
  if (caches == nullptr || draw == nullptr) return;
  for (const auto& [key, cache] : *caches) (*draw)(cache, params_);
}

void DrawAction::drawUserData(HyperGraph::Data* data, HyperGraphElementAction::Parameters* params_) {
  HyperGraphElementAction* draw = draw_action();
  if (draw == nullptr) return;
  for (; data != nullptr; data = data->next()) (*draw)(data, params_);
}

}  // namespace g2o
