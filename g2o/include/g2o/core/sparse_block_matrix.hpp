// SPDX-License-Identifier: BSD-3-Clause
// This header exists because g2o has a header with this name. The definitions are in the .h file.
#pragma once

#include "g2o/core/sparse_block_matrix.h"
