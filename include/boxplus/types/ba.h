// SPDX-License-Identifier: BSD-3-Clause
// Cameras and reprojection errors, for bundle adjustment.
#pragma once

#include "boxplus/types/ba/pools.h"
