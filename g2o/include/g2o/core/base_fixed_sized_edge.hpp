// SPDX-License-Identifier: BSD-3-Clause
// g2o also has this header. The definitions are in the .h file.
#pragma once

#include "g2o/core/base_fixed_sized_edge.h"
