// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/core/cache.h"

#include <memory>

#include "g2o/core/factory.h"
#include "g2o/core/ownership.h"
#include "g2o/stuff/logger.h"

namespace g2o {

Cache::CacheKey::CacheKey() = default;

Cache::CacheKey::CacheKey(const std::string& type, const ParameterVector& parameters)
    : _type(type), _parameters(parameters) {}

bool Cache::CacheKey::operator<(const Cache::CacheKey& c) const {
  return _type != c._type ? _type < c._type : _parameters < c._parameters;
}

Cache::Cache(CacheContainer* container, const ParameterVector& parameters)
    : _parameters(parameters), _container(container) {}
Cache::~Cache() = default;

OptimizableGraph::Vertex* Cache::vertex() {
  return container() == nullptr ? nullptr : container()->vertex();
}

OptimizableGraph* Cache::graph() {
  return container() == nullptr ? nullptr : container()->graph();
}

CacheContainer* Cache::container() {
  return _container;
}

ParameterVector& Cache::parameters() {
  return _parameters;
}

Cache::CacheKey Cache::key() const {
  return {Factory::instance()->tag(this), _parameters};
}

void Cache::update() {
  if (!_updateNeeded) return;
  for (Cache* parent : _parentCaches) parent->update();
  updateImpl();
  _updateNeeded = false;
}

Cache* Cache::installDependency(const std::string& type, const std::vector<int>& parameterIndices) {
  ParameterVector chosen;
  for (int i : parameterIndices) {
    if (i < 0 || i >= static_cast<int>(_parameters.size())) return nullptr;
    chosen.push_back(_parameters[static_cast<size_t>(i)]);
  }
  const CacheKey wanted(type, chosen);
  Cache* cache = container()->findCache(wanted);
  if (cache == nullptr) cache = container()->createCache(wanted);
  if (cache != nullptr) _parentCaches.push_back(cache);
  return cache;
}

bool Cache::resolveDependencies() {
  return true;
}

CacheContainer::CacheContainer(OptimizableGraph::Vertex* vertex) : _vertex(vertex) {}

CacheContainer::~CacheContainer() {
  for (const auto& [key, cache] : *this) release(cache);
}

OptimizableGraph::Vertex* CacheContainer::vertex() {
  return _vertex;
}

const OptimizableGraph::Vertex* CacheContainer::vertex() const {
  return _vertex;
}

OptimizableGraph* CacheContainer::graph() {
  return _vertex == nullptr ? nullptr : _vertex->graph();
}

Cache* CacheContainer::findCache(const Cache::CacheKey& key) {
  const auto found = find(key);
  return found == end() ? nullptr : found->second;
}

Cache* CacheContainer::createCache(const Cache::CacheKey& key) {
  std::unique_ptr<HyperGraph::HyperGraphElement> element(Factory::instance()->construct(key.type()));
  auto* cache = dynamic_cast<Cache*>(element.get());
  if (cache == nullptr) {
    G2O_ERROR("expected {} to be the registered tag of a cache", key.type());
    return nullptr;
  }
  cache->_container = this;
  cache->_parameters = key._parameters;
  if (!cache->resolveDependencies()) {
    G2O_ERROR("the parameters do not fit the cache {}", key.type());
    return nullptr;
  }
  static_cast<void>(element.release());
  emplace(key, cache);
  cache->update();
  return cache;
}

void CacheContainer::setUpdateNeeded(bool needUpdate) {
  _updateNeeded = needUpdate;
  for (const auto& [key, cache] : *this) cache->_updateNeeded = needUpdate;
}

void CacheContainer::update() {
  if (!_updateNeeded) return;
  for (const auto& [key, cache] : *this) cache->update();
  _updateNeeded = false;
}

}  // namespace g2o
