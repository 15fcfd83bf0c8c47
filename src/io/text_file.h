// SPDX-License-Identifier: BSD-3-Clause
// Whole files in one piece.
#pragma once

#include <string>

namespace boxplus {

/// The bytes of a file. Throws FileError.
std::string read_file(const std::string& path);

}  // namespace boxplus
