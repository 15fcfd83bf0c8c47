// SPDX-License-Identifier: BSD-3-Clause
// TORO's .graph: lines like those of .g2o, with tags of their own. It is only read.
#pragma once

#include "boxplus/io/file_format.h"

namespace boxplus {

FileFormat toro_format();

}  // namespace boxplus
