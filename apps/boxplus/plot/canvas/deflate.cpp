// SPDX-License-Identifier: BSD-3-Clause
#include "plot/canvas/deflate.h"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>
#include <vector>

namespace boxplus::app {
namespace {

/// Writes bits to a string of bytes. The bits fill each byte from its lowest bit to its highest bit.
class BitWriter {
 public:
  void bits(std::uint32_t value, int count) {
    buffer_ |= std::uint64_t{value} << used_;
    for (used_ += count; used_ >= 8; used_ -= 8, buffer_ >>= 8)
      bytes_.push_back(static_cast<char>(buffer_ & 0xFF));
  }
  /// Writes a Huffman code, beginning with its highest bit.
  void code(std::uint32_t value, int count) {
    std::uint32_t reversed = 0;
    for (int i = 0; i < count; ++i) reversed |= ((value >> i) & 1u) << (count - 1 - i);
    bits(reversed, count);
  }
  std::string take() {
    if (used_ > 0) bits(0, 8 - used_);
    return std::move(bytes_);
  }

 private:
  std::string bytes_;
  std::uint64_t buffer_ = 0;
  int used_ = 0;
};

/// Writes a symbol in the fixed Huffman code (RFC 1951, section 3.2.6). Symbols below 256 are literals, 256
/// is the end of the block, and larger symbols are lengths.
void write_symbol(BitWriter& out, std::uint32_t symbol) {
  if (symbol < 144) {
    out.code(0x30 + symbol, 8);
  } else if (symbol < 256) {
    out.code(0x190 + symbol - 144, 9);
  } else if (symbol < 280) {
    out.code(symbol - 256, 7);
  } else {
    out.code(0xC0 + symbol - 280, 8);
  }
}

/// The code of a match length minus 3, or of a match distance minus 1 (RFC 1951, section 3.2.5). The values
/// are divided into ranges, whose size doubles after every 2^`shift` ranges. The symbol is the index of the
/// range, and the extra bits are the position of the value in the range.
struct Ranged {
  std::uint32_t symbol, extra;
  int extra_bits;
};
Ranged ranged(std::uint32_t offset, int shift) {
  if (offset < (2u << shift)) return {offset, 0, 0};
  const int bits = static_cast<int>(std::bit_width(offset)) - 1 - shift;
  return {static_cast<std::uint32_t>(bits << shift) + (offset >> bits), offset & ((1u << bits) - 1), bits};
}

constexpr std::size_t kWindow = 32768, kShortest = 3, kLongest = 258;

void write_match(BitWriter& out, std::size_t length, std::size_t distance) {
  const Ranged l = ranged(static_cast<std::uint32_t>(length - kShortest), 2);
  const bool is_longest = length == kLongest;  // the longest match has its own symbol
  write_symbol(out, 257 + (is_longest ? 28 : l.symbol));
  if (!is_longest) out.bits(l.extra, l.extra_bits);
  const Ranged d = ranged(static_cast<std::uint32_t>(distance - 1), 1);
  out.code(d.symbol, 5);
  out.bits(d.extra, d.extra_bits);
}

/// Finds earlier positions with the same three bytes, and the longest match among them.
class Matches {
 public:
  explicit Matches(std::string_view bytes)
      : bytes_(bytes), heads_(kHeads, kNone), previous_(bytes.size(), kNone) {}

  struct Match {
    std::size_t length = 0, distance = 0;
  };
  Match longest(std::size_t at) const {
    Match best;
    if (at + kShortest > bytes_.size()) return best;
    const std::size_t most = std::min(kLongest, bytes_.size() - at);
    std::uint32_t candidate = heads_[hash(at)];
    for (int tries = 0; tries < kTries && candidate != kNone && at - candidate <= kWindow; ++tries) {
      std::size_t length = 0;
      while (length < most && bytes_[candidate + length] == bytes_[at + length]) ++length;
      if (length > best.length) best = {length, at - candidate};
      if (length == most) break;
      candidate = previous_[candidate];
    }
    return best.length >= kShortest ? best : Match{};
  }
  void insert(std::size_t at) {
    if (at + kShortest > bytes_.size()) return;
    previous_[at] = std::exchange(heads_[hash(at)], static_cast<std::uint32_t>(at));
  }

 private:
  static constexpr std::size_t kHeads = std::size_t{1} << 15;
  static constexpr std::uint32_t kNone = 0xFFFFFFFF;
  static constexpr int kTries = 32;

  std::size_t hash(std::size_t at) const {
    const auto byte = [&](std::size_t i) {
      return static_cast<std::uint32_t>(static_cast<unsigned char>(bytes_[at + i]));
    };
    return ((byte(0) | byte(1) << 8 | byte(2) << 16) * 2654435761u) >> 17;
  }

  std::string_view bytes_;
  std::vector<std::uint32_t> heads_, previous_;
};

std::uint32_t adler32(std::string_view bytes) {
  constexpr std::uint32_t kModulus = 65521;
  std::uint32_t a = 1, b = 0;
  for (const char byte : bytes) {
    a = (a + static_cast<unsigned char>(byte)) % kModulus;
    b = (b + a) % kModulus;
  }
  return b << 16 | a;
}

}  // namespace

std::string zlib_compressed(std::string_view bytes) {
  BitWriter out;
  out.bits(0x0178, 16);  // the bytes 78 01: deflate with a window of 32 KiB
  out.bits(1, 1);        // the block that follows is the last one
  out.bits(1, 2);        // the block has the fixed Huffman codes
  Matches matches(bytes);
  for (std::size_t at = 0; at < bytes.size();) {
    const Matches::Match match = matches.longest(at);
    if (match.length > 0) {
      write_match(out, match.length, match.distance);
    } else {
      write_symbol(out, static_cast<unsigned char>(bytes[at]));
    }
    for (const std::size_t end = at + std::max<std::size_t>(1, match.length); at < end; ++at)
      matches.insert(at);
  }
  write_symbol(out, 256);
  std::string result = out.take();
  const std::uint32_t sum = adler32(bytes);
  for (int shift = 24; shift >= 0; shift -= 8) result.push_back(static_cast<char>(sum >> shift & 0xFF));
  return result;
}

std::uint32_t crc32(std::string_view bytes) {
  static const std::array<std::uint32_t, 256> kTable = [] {
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t i = 0; i < 256; ++i) {
      table[i] = i;
      for (int bit = 0; bit < 8; ++bit) table[i] = table[i] >> 1 ^ (table[i] & 1 ? 0xEDB88320u : 0);
    }
    return table;
  }();
  std::uint32_t sum = 0xFFFFFFFF;
  for (const char byte : bytes) sum = kTable[(sum ^ static_cast<unsigned char>(byte)) & 0xFF] ^ sum >> 8;
  return ~sum;
}

}  // namespace boxplus::app
