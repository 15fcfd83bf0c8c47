// SPDX-License-Identifier: BSD-3-Clause
// Reads the decimal numbers that are common in graph files: up to 19 digits, no exponent. The function is in
// a header, so that the compiler can inline it into the loop that reads a line.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace boxplus {

struct Decimal {
  double value = 0;
  /// Points past the last digit. If it is nullptr, no number was read, and the other members are meaningless.
  const char* end = nullptr;
  bool is_integer = false;
};

/// The largest number of characters that read_decimal(at) reads, starting with *at.
inline constexpr std::ptrdiff_t kDecimalRoom = 56;

namespace decimal {

#if defined(__SIZEOF_INT128__)
inline constexpr bool kHasWideIntegers = true;
__extension__ using Wide = unsigned __int128;
#else
inline constexpr bool kHasWideIntegers = false;
using Wide = std::uint64_t;
#endif

inline constexpr int kLanes = 8;          // the number of characters in a word
inline constexpr int kMostDecimals = 27;  // the largest k for which 5^k fits into a word

template <int Base, int Most>
inline constexpr auto kPowers = [] {
  std::array<std::uint64_t, Most + 1> powers{1};
  for (std::size_t k = 1; k < powers.size(); ++k) powers[k] = Base * powers[k - 1];
  return powers;
}();

inline constexpr std::uint64_t in_all_lanes(std::uint64_t byte) {
  return byte * 0x0101'0101'0101'0101;
}

/// Eight characters, one per lane. The first one is in the lowest lane. A digit is replaced by its value 0
/// … 9.
inline std::uint64_t load(const char* at) {
  std::uint64_t word = 0;
  std::memcpy(&word, at, sizeof word);
  return word ^ in_all_lanes('0');
}

/// Sets the top bit of each lane that is not a digit, so the result is 0 if all lanes are digits. Above the
/// first lane that is not a digit, the result may be wrong.
inline std::uint64_t not_digits(std::uint64_t word) {
  return ((word + in_all_lanes(0x80 - 10)) | word) & in_all_lanes(0x80);
}

inline int count_before(std::uint64_t lane_bits) {
  return std::countr_zero(lane_bits) / 8;
}

/// The number that consists of these eight digits. Joins the digits to pairs, the pairs to groups of four,
/// and the two groups to one number.
inline std::uint64_t joined(std::uint64_t word) {
  word = (word * 10 + (word >> 8)) & 0x00FF'00FF'00FF'00FF;
  word = (word * 100 + (word >> 16)) & 0x0000'FFFF'0000'FFFF;
  return (word * 10000 + (word >> 32)) & 0xFFFF'FFFF;
}

/// The number that consists of the first `count` digits. Shifts the digits up, so that zeros come before
/// them.
inline std::uint64_t joined(std::uint64_t word, int count) {
  return count == 0 ? 0 : joined(word << (8 * (kLanes - count)));
}

/// w ← w · 10^count + digits. Returns false if the result is too large for w.
inline bool append(std::uint64_t& w, int count, std::uint64_t digits) {
  const std::uint64_t power = kPowers<10, kLanes>[count];
  return !__builtin_mul_overflow(w, power, &w) && !__builtin_add_overflow(w, digits, &w);
}

/// w / 10^k, correctly rounded.
inline double rounded_quotient(std::uint64_t w, int k) {
  if (w == 0) return 0;
  // Shifts w and 5^k up until their top bits are set. Then the quotient has 62 or 63 bits, which is more than
  // a double can represent. If there is a remainder, the lowest bit of the quotient is set, so that the
  // conversion to double rounds correctly.
  constexpr int kShift = 62, kBias = 1023, kFractionBits = 52;
  const std::uint64_t five = kPowers<5, kMostDecimals>[k];
  const int shift_w = std::countl_zero(w), shift_five = std::countl_zero(five);
  const Wide dividend = Wide{w << shift_w} << kShift;
  const std::uint64_t divisor = five << shift_five;
  const auto quotient = static_cast<std::uint64_t>(dividend / divisor);
  const bool has_remainder = static_cast<std::uint64_t>(dividend) != quotient * divisor;
  const auto rounded = static_cast<double>(static_cast<std::int64_t>(quotient | has_remainder));
  const int exponent = shift_five - shift_w - kShift - k;
  return rounded * std::bit_cast<double>(static_cast<std::uint64_t>(kBias + exponent) << kFractionBits);
}

inline double with_sign(double magnitude, bool is_negative) {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(magnitude) | std::uint64_t{is_negative} << 63);
}

}  // namespace decimal

/// The number of the form -?d+(.d+)? that begins at `at`, correctly rounded to the nearest double. If no such
/// number begins there, or if it has more than seven digits before the point or too many after it, the result
/// has no `end`, and the caller must use a general reader.
///
/// Digits are read eight at a time, in the lanes of one word (Lamport, Multiple byte processing with
/// full-word instructions, 1975). The integer that the digits form is divided by a power of five in integer
/// arithmetic, and the remainder determines the rounding. The code is the same for all numbers, because
/// branches would be hard to predict.
inline Decimal read_decimal(const char* at) {
  using namespace decimal;
  if constexpr (!kHasWideIntegers || std::endian::native != std::endian::little) return {};
  const auto first = static_cast<unsigned char>(*at - '0');
  if (first <= 9 && at[1] == ' ') return {static_cast<double>(first), at + 1, true};  // such as a 0 in Ω
  const bool is_negative = *at == '-';
  at += is_negative;
  std::uint64_t word = load(at), others = not_digits(word);
  if (others == 0) return {};
  int count = count_before(others);
  if (count == 0) return {};
  std::uint64_t w = joined(word, count);
  at += count;
  if (*at != '.') return {with_sign(static_cast<double>(w), is_negative), at, true};
  const char* const decimals = ++at;
  for (word = load(at); (others = not_digits(word)) == 0; word = load(at)) {
    if (!append(w, kLanes, joined(word)) || at - decimals > kMostDecimals) return {};
    at += kLanes;  // a constant, so that the next word is loaded before the length of this word is known
  }
  count = count_before(others);
  if (!append(w, count, joined(word, count))) return {};
  at += count;
  const std::ptrdiff_t decimal_count = at - decimals;
  if (decimal_count == 0 || decimal_count > kMostDecimals) return {};
  return {with_sign(rounded_quotient(w, static_cast<int>(decimal_count)), is_negative), at, false};
}

}  // namespace boxplus
