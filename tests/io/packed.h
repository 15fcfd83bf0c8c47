// SPDX-License-Identifier: BSD-3-Clause
// Text in the gzip format.
#pragma once

#include <string>
#include <string_view>

#include "io/gzip.h"

namespace boxplus {

/// Packs a text that comes in two pieces.
inline std::string packed(std::string_view text) {
  std::string result;
  const auto sink = [&](std::string_view piece) { result += piece; };
  GzipPacker packer(sink);
  packer.write(text.substr(0, text.size() / 3));
  packer.write(text.substr(text.size() / 3));
  packer.finish();
  return result;
}

}  // namespace boxplus
