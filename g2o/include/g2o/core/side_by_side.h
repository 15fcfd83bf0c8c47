// SPDX-License-Identifier: BSD-3-Clause
// Types that bear that other threads work on other objects at the same time. Of a client's types nothing is
// known, and of his subclasses of ours neither: they stay on the thread that calls optimize(), unless the
// client says, for each type,
//
//     const g2o::SideBySide<MyEdge> kMyEdgesRunSideBySide;
#pragma once
#ifndef G2O_SIDE_BY_SIDE_H
#define G2O_SIDE_BY_SIDE_H

#include <typeinfo>

#include "g2o/core/g2o_core_api.h"

namespace g2o {
namespace internal {

G2O_CORE_API void allow_side_by_side(const std::type_info& type, bool allowed);

}  // namespace internal

/// As long as it lives, edges of type T, not of its subclasses, may be worked on by several threads at a
/// time. Their computeError() and linearizeOplus() read the edge, its vertices and its parameters, and change
/// the edge alone: numeric Jacobians, which move the vertices, do not. A robust kernel of type T is only
/// read.
template <class T>
class SideBySide {
 public:
  SideBySide() { internal::allow_side_by_side(typeid(T), true); }
  ~SideBySide() { internal::allow_side_by_side(typeid(T), false); }
  SideBySide(const SideBySide&) = delete;
  SideBySide& operator=(const SideBySide&) = delete;
};

}  // namespace g2o

#endif  // G2O_SIDE_BY_SIDE_H
