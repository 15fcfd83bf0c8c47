// SPDX-License-Identifier: BSD-3-Clause
// The types and algorithms that the programs contain.
#include "g2o/core/factory.h"
#include "g2o/core/optimization_algorithm_factory.h"

G2O_USE_TYPE_GROUP(slam2d)
G2O_USE_TYPE_GROUP(slam3d)
G2O_USE_OPTIMIZATION_LIBRARY(eigen)
G2O_USE_OPTIMIZATION_LIBRARY(dense)
G2O_USE_OPTIMIZATION_LIBRARY(pcg)
G2O_USE_OPTIMIZATION_LIBRARY(structure_only)
G2O_USE_OPTIMIZATION_LIBRARY(slam2d_linear)
// The library of an algorithm, because solver_eigen also has weak symbols for these two libraries.
G2O_USE_OPTIMIZATION_ALGORITHM(lm_var_cholmod)
G2O_USE_OPTIMIZATION_ALGORITHM(lm_var_csparse)
