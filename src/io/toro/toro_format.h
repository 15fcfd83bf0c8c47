// SPDX-License-Identifier: BSD-3-Clause
// TORO's .graph: lines like those of .g2o, with other tags. The format is read-only.
#pragma once

#include "boxplus/io/file_format.h"

namespace boxplus {

FileFormat toro_format();

}  // namespace boxplus
