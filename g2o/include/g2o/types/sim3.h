// SPDX-License-Identifier: BSD-3-Clause
// Where older clients look for it.
#pragma once

#include "g2o/types/sim3/sim3.h"
