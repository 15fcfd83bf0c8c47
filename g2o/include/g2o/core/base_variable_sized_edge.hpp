// SPDX-License-Identifier: BSD-3-Clause
// A header under the name that it also has in g2o.
#pragma once

#include "g2o/core/base_variable_sized_edge.h"
