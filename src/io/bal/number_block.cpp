// SPDX-License-Identifier: BSD-3-Clause
#include "io/bal/number_block.h"

#include <algorithm>

#include "io/number_field.h"

namespace boxplus {
namespace {

bool is_between_fields(char c) {
  return is_blank(c) || c == '\n';
}

}  // namespace

void NumberBlock::read(const TextSource& source, std::size_t k) {
  text_ = k == 0 ? without_byte_order_mark(source.block(k, memory_)) : source.block(k, memory_);
  values_.clear();
  is_integer_.clear();
  line_count_ = 0;
  ends_with_another_field_ = false;
  for (std::string_view rest = text_; !rest.empty();) {
    const std::size_t newline = std::min(rest.find('\n'), rest.size());
    const char* at = rest.data();
    const char* const end = at + newline;
    rest.remove_prefix(std::min(newline + 1, rest.size()));
    ++line_count_;
    for (;;) {
      while (at != end && is_blank(*at)) ++at;
      if (at == end) break;
      const bool has_plus = *at == '+' && end - at > 1 && at[1] != '-';
      const Decimal number = read_number_field(at + has_plus, end);
      if (!number.end) {
        ends_with_another_field_ = true;
        return;
      }
      values_.push_back(number.value);
      is_integer_.push_back(static_cast<char>(number.is_integer));
      at = number.end;
    }
  }
}

NumberBlock::Field NumberBlock::field(std::size_t index) const {
  const auto begin = text_.begin(), end = text_.end();
  auto at = std::find_if_not(begin, end, is_between_fields);
  auto last = std::find_if(at, end, is_between_fields);
  for (; index > 0 && at != end; --index) {
    at = std::find_if_not(last, end, is_between_fields);
    last = std::find_if(at, end, is_between_fields);
  }
  const std::string_view before = text_.substr(0, static_cast<std::size_t>(at - begin));
  const std::size_t newline = before.rfind('\n');
  const std::size_t line_begin = newline == std::string_view::npos ? 0 : newline + 1;
  return {std::count(before.begin(), before.end(), '\n'),
          static_cast<std::int64_t>(before.size() - line_begin) + 1,
          text_.substr(before.size(), static_cast<std::size_t>(last - at))};
}

}  // namespace boxplus
