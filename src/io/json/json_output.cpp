// SPDX-License-Identifier: BSD-3-Clause
#include "io/json/json_output.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "boxplus/base/error.h"
#include "io/characters.h"
#include "io/json/json_scanner.h"
#include "io/json/utf8.h"

namespace boxplus {
namespace {

bool is_plain_word(std::string_view word) {
  const auto is_plain = [](char c) { return c > ' ' && c < 0x7F && c != '"' && c != '\\'; };
  return !word.empty() && word[0] != '#' && std::all_of(word.begin(), word.end(), is_plain);
}

/// Whether `field` is a number of JSON. Another character must follow the field.
bool is_json_number(std::string_view field) {
  return json_number_end(field.data()) == field.data() + field.size();
}

void append_field(std::string_view field, std::string& out) {
  if (is_json_number(field)) {
    out += field;
    return;
  }
  if (field == "nan" || field == "-nan" || field == "inf" || field == "-inf")
    throw InvalidArgument(fmt::format("cannot write {}: JSON has finite numbers only", field));
  if (!is_plain_word(field)) throw InvalidArgument("cannot write the field " + in_quotes(field) + " as JSON");
  fmt::format_to(std::back_inserter(out), "\"{}\"", field);
}

}  // namespace

void append_json_string(std::string_view text, std::string& out) {
  out += '"';
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      out += {'\\', c};
    } else if (static_cast<unsigned char>(c) < 0x20) {
      fmt::format_to(std::back_inserter(out), "\\u{:04x}", static_cast<unsigned>(c));
    } else {
      out += c;
    }
  }
  out += '"';
}

void append_json_text(std::string_view text, std::string& out) {
  if (is_utf8(text)) {
    out += "\"text\": ";
    append_json_string(text, out);
    return;
  }
  out += "\"bytes\": [";
  for (std::size_t i = 0; i < text.size(); ++i)
    fmt::format_to(std::back_inserter(out), "{}{}", i == 0 ? "" : ", ",
                   static_cast<unsigned>(static_cast<unsigned char>(text[i])));
  out += ']';
}

void append_json_fields(std::string_view fields, std::string& out) {
  for (bool is_first = true; !fields.empty(); is_first = false) {
    const std::size_t blank = std::min(fields.find(' '), fields.size());
    if (!is_first) out += ", ";
    append_field(fields.substr(0, blank), out);
    fields.remove_prefix(std::min(blank + 1, fields.size()));
  }
}

std::size_t last_fields(std::string_view fields, int count) {
  std::size_t begin = fields.size();
  for (int i = 0; i < count && begin > 0; ++i) {
    const std::size_t blank = begin < 2 ? std::string_view::npos : fields.rfind(' ', begin - 2);
    begin = blank == std::string_view::npos ? 0 : blank + 1;
  }
  return begin;
}

}  // namespace boxplus
