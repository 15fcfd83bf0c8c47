// SPDX-License-Identifier: BSD-3-Clause
// Caches of vertices. A cache stores a quantity that depends on a vertex and on parameters, for example the
// pose of a sensor. Several edges can share a cache. The quantity is computed only once per estimate of the
// vertex.
#pragma once
#ifndef G2O_CACHE_HH_
#define G2O_CACHE_HH_

#include <map>
#include <string>
#include <vector>

#include "g2o/core/optimizable_graph.h"

namespace g2o {

class CacheContainer;

class G2O_CORE_API Cache : public HyperGraph::HyperGraphElement {
 public:
  friend class CacheContainer;

  /// Identifies a cache of a vertex by the tag of its type and by its parameters.
  class G2O_CORE_API CacheKey {
   public:
    friend class CacheContainer;
    CacheKey();
    CacheKey(const std::string& type, const ParameterVector& parameters);
    bool operator<(const CacheKey& c) const;
    const std::string& type() const { return _type; }
    const ParameterVector& parameters() const { return _parameters; }

   protected:
    std::string _type;
    ParameterVector _parameters;
  };

  explicit Cache(CacheContainer* container = nullptr, const ParameterVector& parameters = ParameterVector());
  ~Cache() override;

  CacheKey key() const;
  OptimizableGraph::Vertex* vertex();
  OptimizableGraph* graph();
  CacheContainer* container();
  ParameterVector& parameters();
  /// If the estimate has changed, updates the caches that this cache depends on and calls updateImpl().
  void update();
  HyperGraph::HyperGraphElementType elementType() const override { return HyperGraph::HGET_CACHE; }

 protected:
  virtual void updateImpl() = 0;
  /// Returns another cache of the same vertex, creates it if necessary, and makes this cache depend on it.
  /// `parameterIndices` selects the parameters of the other cache from the parameters of this cache.
  Cache* installDependency(const std::string& type, const std::vector<int>& parameterIndices);
  /// Called after the parameters and the vertex are set. Returns false if they do not have the types that the
  /// cache needs.
  virtual bool resolveDependencies();

  bool _updateNeeded = true;
  ParameterVector _parameters;
  std::vector<Cache*> _parentCaches;
  CacheContainer* _container = nullptr;
};

/// Owns the caches of a vertex.
class G2O_CORE_API CacheContainer : public std::map<Cache::CacheKey, Cache*> {
 public:
  explicit CacheContainer(OptimizableGraph::Vertex* vertex);
  CacheContainer(const CacheContainer&) = delete;
  CacheContainer& operator=(const CacheContainer&) = delete;
  virtual ~CacheContainer();

  OptimizableGraph::Vertex* vertex();
  const OptimizableGraph::Vertex* vertex() const;
  OptimizableGraph* graph();
  Cache* findCache(const Cache::CacheKey& key);
  /// Returns a new cache. Returns nullptr if the tag is not registered, or if resolveDependencies() returns
  /// false.
  Cache* createCache(const Cache::CacheKey& key);
  void setUpdateNeeded(bool needUpdate = true);
  void update();

 protected:
  OptimizableGraph::Vertex* _vertex;
  bool _updateNeeded = true;
};

template <typename CacheType>
void OptimizableGraph::Edge::resolveCache(CacheType*& cache, OptimizableGraph::Vertex* v,
                                          const std::string& type, const ParameterVector& parameters) {
  cache = nullptr;
  CacheContainer* container = v->cacheContainer();
  const Cache::CacheKey key(type, parameters);
  Cache* found = container->findCache(key);
  if (found == nullptr) found = container->createCache(key);
  cache = dynamic_cast<CacheType*>(found);
}

}  // namespace g2o

#endif  // G2O_CACHE_HH_
