// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_BASE_DYNAMIC_VERTEX_H
#define G2O_BASE_DYNAMIC_VERTEX_H

#include "g2o/core/base_vertex.h"
#include "g2o/stuff/logger.h"

namespace g2o {

/// A vertex whose number of dimensions is chosen at run time and can change later.
template <typename T>
class BaseDynamicVertex : public BaseVertex<Eigen::Dynamic, T> {
 public:
  /// Changes the number of dimensions and calls setDimensionImpl() to resize the estimate. After this, call
  /// initializeOptimization() before the next optimize().
  bool setDimension(int newDimension) {
    if (newDimension < 0) return false;
    const int before = this->_dimension;
    this->_dimension = newDimension;
    if (!setDimensionImpl(newDimension)) {
      this->_dimension = before;
      G2O_ERROR("setDimension: the vertex does not accept {} dimensions", newDimension);
      return false;
    }
    this->_b.setZero(newDimension);
    this->mapHessianMemory(nullptr);
    if (this->graph() != nullptr && newDimension > before) {
      for (HyperGraph::Edge* e : this->edges()) this->graph()->jacobianWorkspace().updateSize(e);
      this->graph()->jacobianWorkspace().allocate();
    }
    return true;
  }

 protected:
  /// Resizes the estimate. Returns false if the estimate cannot have that size.
  virtual bool setDimensionImpl(int newDimension) = 0;
};

}  // namespace g2o

#endif  // G2O_BASE_DYNAMIC_VERTEX_H
