// SPDX-License-Identifier: BSD-3-Clause
// Compression for PNG and PDF.
#pragma once

#include <string>
#include <string_view>

namespace boxplus::app {

/// Returns `bytes` in the zlib format (RFC 1950).
std::string zlib_compressed(std::string_view bytes);

}  // namespace boxplus::app
