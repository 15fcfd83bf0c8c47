// SPDX-License-Identifier: BSD-3-Clause
// Everything that a program needs: graph, ready-made types, robust kernels, optimize(), files.
#pragma once

// IWYU pragma: begin_exports
#include "boxplus/base/error.h"
#include "boxplus/graph/graph.h"
#include "boxplus/io/graph_file.h"
#include "boxplus/io/registry.h"
#include "boxplus/manifold/product.h"
#include "boxplus/manifold/rn.h"
#include "boxplus/manifold/s2.h"
#include "boxplus/manifold/se2.h"
#include "boxplus/manifold/se3.h"
#include "boxplus/manifold/sim3.h"
#include "boxplus/manifold/so2.h"
#include "boxplus/manifold/so3.h"
#include "boxplus/optimize/covariance.h"
#include "boxplus/optimize/optimizer.h"
#include "boxplus/robust/barron.h"
#include "boxplus/robust/default_width.h"
#include "boxplus/robust/huber.h"
#include "boxplus/robust/make_robust_kernel.h"
#include "boxplus/robust/redescending.h"
#include "boxplus/types/dense_prior.h"
#include "boxplus/types/slam2d.h"
#include "boxplus/types/slam3d.h"
// IWYU pragma: end_exports
