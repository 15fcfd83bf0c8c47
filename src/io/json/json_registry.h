// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "boxplus/io/registry.h"

namespace boxplus {

/// The tags of default_registry(), and those of bundle adjustment and inertial sensors, which .g2o files do
/// not have.
const Registry& json_registry();

}  // namespace boxplus
