// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_BASE_MULTI_EDGE_H
#define G2O_BASE_MULTI_EDGE_H

#include "g2o/core/base_variable_sized_edge.h"

namespace g2o {

/// An older name of BaseVariableSizedEdge. The g2o document uses this name.
template <int D, typename E>
class BaseMultiEdge : public BaseVariableSizedEdge<D, E> {};

}  // namespace g2o

#endif  // G2O_BASE_MULTI_EDGE_H
