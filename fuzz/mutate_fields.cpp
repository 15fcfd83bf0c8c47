// SPDX-License-Identifier: BSD-3-Clause
// A mutator for libFuzzer that changes whole lines and fields of a graph file. Most mutated inputs are still
// graph files, so the reader does not stop at the first line. The built-in mutator of libFuzzer mutates one
// input in four instead.
#include <algorithm>
#include <cstdint>
#include <random>
#include <string>
#include <string_view>
#include <vector>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

namespace {

using Parts = std::vector<std::string>;
using Random = std::minstd_rand;

/// Values for fields that are special cases of arithmetic or of the parser.
constexpr const char* kNumbers[] = {"0",
                                    "-0",
                                    "1",
                                    "-1",
                                    "2",
                                    "0.5",
                                    "3.141592653589793",
                                    "-3.141592653589793",
                                    "1e-300",
                                    "1e",
                                    "nan",
                                    "1e308",
                                    "-1e308",
                                    "1e-9",
                                    "1e16",
                                    "0.70710678118654757",
                                    "0.7071",
                                    "5e-324",
                                    "||",
                                    "#",
                                    "1.0005",
                                    "+1",
                                    "0.9999",
                                    "1000001",
                                    "9223372036854775807",
                                    "9223372036854775808"};

Parts split(std::string_view text, char separator) {
  Parts parts(1);
  for (const char c : text) {
    if (c == separator) {
      parts.emplace_back();
    } else {
      parts.back().push_back(c);
    }
  }
  return parts;
}

std::string join(const Parts& parts, char separator) {
  std::string text;
  for (const std::string& part : parts) (text += part) += separator;
  text.pop_back();
  return text;
}

std::size_t below(std::size_t count, Random& random) {
  return random() % count;
}

/// Returns `text` with one character replaced by a random digit.
std::string nudged(std::string text, Random& random) {
  if (!text.empty()) text[below(text.size(), random)] = static_cast<char>('0' + below(10, random));
  return text;
}

std::string any_field(const std::string& line, Random& random) {
  const Parts fields = split(line, ' ');
  return fields[below(fields.size(), random)];
}

/// Changes, inserts or removes one field of a line. May copy a field from the line `other`.
void mutate_field(std::string& line, const std::string& other, Random& random) {
  Parts fields = split(line, ' ');
  std::string& field = fields[below(fields.size(), random)];
  switch (below(5, random)) {
    case 0:
      field = kNumbers[below(std::size(kNumbers), random)];
      break;
    case 1:
      field = nudged(field, random);
      break;
    case 2:
      field = any_field(other, random);
      break;
    case 3:
      fields.insert(fields.begin() + static_cast<std::ptrdiff_t>(below(fields.size(), random)),
                    kNumbers[below(std::size(kNumbers), random)]);
      break;
    default:
      fields.erase(fields.begin() + static_cast<std::ptrdiff_t>(below(fields.size(), random)));
      if (fields.empty()) fields.emplace_back();
  }
  line = join(fields, ' ');
}

void mutate_lines(Parts& lines, Random& random) {
  const std::size_t a = below(lines.size(), random), b = below(lines.size(), random);
  switch (below(8, random)) {
    case 0:
      std::swap(lines[a], lines[b]);
      break;
    case 1:
      lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(a), std::string(lines[b]));
      break;
    case 2:
      if (lines.size() > 1) lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(a));
      break;
    default:
      mutate_field(lines[a], std::string(lines[b]), random);
  }
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                               unsigned seed) {
  Random random(seed);
  if (below(4, random) == 0) return LLVMFuzzerMutate(data, size, max_size);
  Parts lines = split({reinterpret_cast<const char*>(data), size}, '\n');
  for (std::size_t count = 1 + below(3, random); count > 0; --count) mutate_lines(lines, random);
  const std::string text = join(lines, '\n');
  const std::size_t length = std::min(text.size(), max_size);
  std::copy_n(text.begin(), length, data);
  return length;
}
