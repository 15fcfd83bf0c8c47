// SPDX-License-Identifier: BSD-3-Clause
#include "io/json/json_format.h"

#include "io/characters.h"

namespace boxplus {
namespace {

/// Whether a text begins as a JSON object does. No line of another format begins with a brace.
bool begins_with_object(std::string_view text) {
  constexpr std::string_view kBlanks = " \n\t\r";
  text = without_byte_order_mark(text);
  const std::size_t brace = text.find_first_not_of(kBlanks);
  if (brace == std::string_view::npos || text[brace] != '{') return false;
  const std::size_t after = text.find_first_not_of(kBlanks, brace + 1);
  return after == std::string_view::npos || text[after] == '"' || text[after] == '}';
}

}  // namespace

FileFormat json_format() {
  return {.name = "json",
          .extension = ".json",
          .recognize = begins_with_object,
          .read = read_json,
          .write = write_json,
          .keeps_everything = true};
}

}  // namespace boxplus
