// SPDX-License-Identifier: BSD-3-Clause
// Quantities that many edges derive from one vertex and some parameters: computed once per estimate.
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

  /// The word of a cache in the Factory, and its parameters.
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
  /// Computes what updateImpl() computes, after the caches that it builds on; once per estimate.
  void update();
  HyperGraph::HyperGraphElementType elementType() const override { return HyperGraph::HGET_CACHE; }

 protected:
  virtual void updateImpl() = 0;
  /// The cache of the same vertex that this one builds on; `parameterIndices` choose its parameters of ours.
  Cache* installDependency(const std::string& type, const std::vector<int>& parameterIndices);
  /// Called when parameters and container are known; false where they do not fit.
  virtual bool resolveDependencies();

  bool _updateNeeded = true;
  ParameterVector _parameters;
  std::vector<Cache*> _parentCaches;
  CacheContainer* _container = nullptr;
};

/// The caches of a vertex; owns them.
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
  /// A new cache, or nullptr where the Factory does not know the word or the parameters do not fit.
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
