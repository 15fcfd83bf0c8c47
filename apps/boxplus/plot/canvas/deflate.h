// SPDX-License-Identifier: BSD-3-Clause
// Compression for PNG and PDF, written here because it is small, so that the command needs no library for it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace boxplus::app {

/// `bytes` in the zlib format (RFC 1950): Lempel-Ziv matches over 32 KiB, fixed Huffman codes (RFC 1951).
/// Pictures of `boxplus plot` become about 20 times smaller. O(n).
std::string zlib_compressed(std::string_view bytes);

/// The checksum of PNG chunks (ISO 3309).
std::uint32_t crc32(std::string_view bytes);

}  // namespace boxplus::app
