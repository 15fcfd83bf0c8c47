// SPDX-License-Identifier: BSD-3-Clause
#include "io/g2o/unknown_tags.h"

#include <fmt/format.h>

#include <charconv>
#include <system_error>

#include "boxplus/io/field_reader.h"
#include "io/characters.h"

namespace boxplus {

void UnknownTags::add(std::string_view line, std::int64_t number) {
  FieldReader in({}, number, line);
  const std::string_view tag = in.token("a tag");
  const auto entry = tags_.try_emplace(in_quotes(tag)).first;
  if (entry->second.count++ == 0) entry->second.first_line = number;
  if (tag.starts_with("EDGE") || in.at_end()) return;
  const std::string_view field = in.token("an id");
  const char* const end = field.data() + field.size();
  Id id = 0;
  if (const auto [stop, error] = std::from_chars(field.data(), end, id); error == std::errc() && stop == end)
    lines_of_ids_[tag.starts_with("PARAM")].try_emplace(id, IdLine{&entry->first, number});
}

std::string UnknownTags::reason_for_missing(Id id, bool is_parameter) const {
  const auto found = lines_of_ids_[is_parameter].find(id);
  if (found == lines_of_ids_[is_parameter].end()) return {};
  return fmt::format("; line {} has that id after the unknown tag {}", found->second.number,
                     *found->second.tag);
}

void UnknownTags::append_notes(std::vector<GraphFile::Note>& notes) const {
  for (const auto& [tag, lines] : tags_) {
    const bool is_one = lines.count == 1;
    notes.push_back(
        {lines.first_line, fmt::format("{} line{} with the unknown tag {}: kept as {}", lines.count,
                                       is_one ? "" : "s", tag, is_one ? "it is" : "they are")});
  }
}

}  // namespace boxplus
