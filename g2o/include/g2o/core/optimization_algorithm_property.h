// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_OPTIMIZATION_ALGORITHM_PROPERTY_H
#define G2O_OPTIMIZATION_ALGORITHM_PROPERTY_H

#include <string>
#include <utility>

#include "g2o/core/g2o_core_api.h"

namespace g2o {

/// Describes an algorithm of the factory and the dimensions of the vertices that it supports (−1: any).
struct G2O_CORE_API OptimizationAlgorithmProperty {
  std::string name;
  std::string desc;
  std::string type;
  bool requiresMarginalize = false;
  int poseDim = -1;
  int landmarkDim = -1;

  OptimizationAlgorithmProperty() = default;
  OptimizationAlgorithmProperty(std::string name_, std::string desc_, std::string type_,
                                bool requiresMarginalize_, int poseDim_, int landmarkDim_)
      : name(std::move(name_)),
        desc(std::move(desc_)),
        type(std::move(type_)),
        requiresMarginalize(requiresMarginalize_),
        poseDim(poseDim_),
        landmarkDim(landmarkDim_) {}
};

}  // namespace g2o

#endif  // G2O_OPTIMIZATION_ALGORITHM_PROPERTY_H
