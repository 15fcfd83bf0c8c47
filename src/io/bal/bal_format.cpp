// SPDX-License-Identifier: BSD-3-Clause
#include "io/bal/bal_format.h"

#include <algorithm>
#include <array>

#include "io/number_field.h"

namespace boxplus {
namespace {

/// The first line of `text` that is not blank. Removes it and all lines before it from `text`.
std::string_view take_line(std::string_view& text) {
  std::string_view line;
  while (!text.empty() && std::all_of(line.begin(), line.end(), is_blank)) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return line;
}

/// Reads the leading integers of a line, at most as many as `values` can hold. Returns their number, or −1 if
/// a field is left that is no integer, or one too many.
int read_integers(std::string_view line, std::span<double> values, bool may_go_on) {
  const char* at = line.data();
  const char* const end = at + line.size();
  for (int count = 0;; ++count) {
    at = std::find_if_not(at, end, is_blank);
    if (at == end) return count;
    if (count == static_cast<int>(values.size())) return may_go_on ? count : -1;
    const Decimal number = read_number_field(at, end);
    if (!number.end || !number.is_integer) return -1;
    values[count] = number.value;
    at = number.end;
  }
}

/// Whether a line begins with a number, whatever comes after it.
bool begins_with_number(std::string_view line) {
  const char* const end = line.data() + line.size();
  const char* const at = std::find_if_not(line.data(), end, is_blank);
  return at != end && read_number_field(at, end).end;
}

/// The first line has three integers ≥ 0. If there are observations, the next line begins with two integers,
/// otherwise with a number. There may be no next line.
bool begins_like_bal(std::string_view text) {
  text = without_byte_order_mark(text);
  std::array<double, 3> counts{};
  const std::string_view header = take_line(text);
  if (read_integers(header, counts, false) != 3) return false;
  if (std::any_of(counts.begin(), counts.end(), [](double count) { return count < 0; })) return false;
  const std::string_view next = take_line(text);
  std::array<double, 2> indices{};
  return next.empty() ||
         (counts[2] == 0 ? begins_with_number(next) : read_integers(next, indices, true) == 2);
}

}  // namespace

FileFormat bal_format() {
  return {.name = "BAL",
          .extension = ".bal",
          .recognize = begins_like_bal,
          .read = read_bal,
          .write = write_bal,
          .losses = bal_losses};
}

}  // namespace boxplus
