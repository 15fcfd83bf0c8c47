// SPDX-License-Identifier: BSD-3-Clause
// boxplus.h alone declares every manifold, kernel and function that a program needs.
#include "boxplus/boxplus.h"

using namespace boxplus;

static_assert(ManifoldType<Product<SE3, Vector3>>);
static_assert(ManifoldType<S2> && ManifoldType<Sim3> && ManifoldType<SO2> && ManifoldType<SO3>);
static_assert(ManifoldType<SE2> && ManifoldType<SE3> && ManifoldType<Vector2> && ManifoldType<double>);
static_assert(std::derived_from<Barron, RobustKernel> && std::derived_from<DCS, RobustKernel>);
static_assert(requires { default_width(3); });
