// SPDX-License-Identifier: BSD-3-Clause
#include "io/json/json_element.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

#include "io/characters.h"

namespace boxplus {
namespace {

struct NamedMember {
  std::string_view name;
  JsonElement::Member member;
};

constexpr std::array kElementMembers = {NamedMember{"tag", JsonElement::kTag},
                                        NamedMember{"id", JsonElement::kId},
                                        NamedMember{"ids", JsonElement::kIds},
                                        NamedMember{"fields", JsonElement::kFields},
                                        NamedMember{"information", JsonElement::kInformation},
                                        NamedMember{"rest", JsonElement::kRest},
                                        NamedMember{"kernel", JsonElement::kKernel},
                                        NamedMember{"level", JsonElement::kLevel},
                                        NamedMember{"enabled", JsonElement::kEnabled},
                                        NamedMember{"fixed", JsonElement::kFixed},
                                        NamedMember{"fixed_directions", JsonElement::kFixedDirections},
                                        NamedMember{"bounds", JsonElement::kBounds},
                                        NamedMember{"eliminated", JsonElement::kEliminated}};

/// The names of the members in a set: "tag, id".
std::string names_of(unsigned members) {
  std::string names;
  for (const NamedMember& each : kElementMembers) {
    if ((members & each.member) != 0) names.append(names.empty() ? "" : ", ").append(each.name);
  }
  return names;
}

/// The member with this name, if it is in the set.
JsonElement::Member find(std::string_view name, unsigned members, const char* at) {
  for (const NamedMember& each : kElementMembers) {
    if (each.name == name && (members & each.member) != 0) return each.member;
  }
  refuse_meaning(at, fmt::format("one of the members {}, got {}", names_of(members), in_quotes(name)));
}

int read_int(JsonScanner& in, std::string_view what) {
  in.next();
  const char* const at = in.at();
  const std::int64_t value = in.integer(what);
  if (value < std::numeric_limits<int>::min() || value > std::numeric_limits<int>::max())
    refuse_meaning(at, fmt::format("{} (an integer of 32 bits), got {}", what, value));
  return static_cast<int>(value);
}

}  // namespace

struct JsonElement::Form {
  unsigned required, optional;
};

void JsonFields::clear() {
  values.clear();
  places.clear();
  integers = 0;
  is_numeric = true;
  begin = end = nullptr;
}

void JsonFields::read(JsonScanner& in, std::string_view what) {
  in.next();
  begin = in.at();
  in.array(what, [&] {
    if (in.next() == '"') {
      std::string memory;
      const char* const at = in.at() + 1;
      const std::string_view word = in.string(memory, "a field");
      const bool is_field = !word.empty() && word[0] != '#' && word.data() == at &&
                            std::none_of(word.begin(), word.end(), is_blank);
      if (!is_field) refuse_meaning(at - 1, "a number or a word without blanks and escape sequences");
      is_numeric = false;
      values.push_back(0);
      places.push_back(at);
    } else {
      const JsonScanner::Number number = in.number("a number");
      if (number.is_integer && integers == values.size()) ++integers;
      values.push_back(number.value);
      places.push_back(number.text);
    }
  });
  end = in.at() - 1;
}

void JsonFields::read_id(JsonScanner& in, std::string_view what) {
  constexpr std::int64_t kMost = std::int64_t{1} << 53;  // doubles contain all integers up to it
  in.next();
  const char* const at = in.at();
  const std::int64_t id = in.integer(what);
  is_numeric = is_numeric && id >= -kMost && id <= kMost;
  ++integers;
  values.push_back(static_cast<double>(id));
  places.push_back(at);
}

void JsonElement::read_vertex(JsonScanner& in) {
  read(in, {kTag | kId | kFields, kFixed | kFixedDirections | kBounds | kEliminated});
}

void JsonElement::read_edge(JsonScanner& in) {
  read(in, {kTag | kIds | kFields, kInformation | kRest | kKernel | kLevel | kEnabled});
}

void JsonElement::read(JsonScanner& in, const Form& form) {
  given = 0;
  ids.clear();
  fields.clear();
  information.clear();
  rest.clear();
  in.next();
  at = in.at();
  in.object("an element ({)", [&](std::string_view name, const char* name_at) {
    const Member member = find(name, form.required | form.optional, name_at);
    if ((given & member) != 0)
      refuse_meaning(name_at, fmt::format("the member {} only once", in_quotes(name)));
    given |= member;
    read_member(in, member);
  });
  if (const unsigned missing = form.required & ~given; missing != 0)
    refuse_meaning(at, fmt::format("an element with {}", names_of(missing)));
}

void JsonElement::read_member(JsonScanner& in, Member member) {
  switch (member) {
    case kTag:
      in.next();
      tag_at = in.at();
      tag = in.string(tag_memory_, "a tag (a string)");
      return;
    case kId:
      return ids.read_id(in, "an id");
    case kIds:
      in.next();
      ids.begin = in.at();
      in.array("a list of ids ([)", [&] { ids.read_id(in, "an id"); });
      ids.end = in.at() - 1;
      return;
    case kFields:
      return fields.read(in, "a list of fields ([)");
    case kInformation:
      return information.read(in, "the information matrix as a list ([)");
    case kRest:
      return rest.read(in, "the fields after the information matrix as a list ([)");
    case kKernel:
      return read_kernel(in);
    case kLevel:
      level = read_int(in, "a level");
      return;
    case kEnabled:
      enabled = in.boolean("whether the edge is enabled");
      return;
    case kFixed:
      fixed = in.boolean("whether the vertex is fixed");
      return;
    case kFixedDirections:
      return read_fixed_directions(in);
    case kBounds:
      return read_bounds(in);
    case kEliminated:
      eliminated = in.boolean("whether the vertex is eliminated");
      return;
  }
}

void JsonElement::read_kernel(JsonScanner& in) {
  in.next();
  kernel.at = in.at();
  bool has_name = false, has_width = false;
  in.object("a kernel ({)", [&](std::string_view name, const char* name_at) {
    const bool is_name = name == "name", is_width = name == "width";
    if (!is_name && !is_width)
      refuse_meaning(name_at, fmt::format("one of the members name, width, got {}", in_quotes(name)));
    bool& given_before = is_name ? has_name : has_width;
    if (given_before) refuse_meaning(name_at, fmt::format("the member {} only once", in_quotes(name)));
    given_before = true;
    if (is_width) return void(kernel.width = in.number("the width of the kernel").value);
    std::string memory;
    kernel.name = in.string(memory, "the name of a kernel (a string)");
  });
  if (!has_name || !has_width) refuse_meaning(kernel.at, "a kernel with name and width");
}

void JsonElement::read_fixed_directions(JsonScanner& in) {
  in.next();
  fixed_directions_at = in.at();
  fixed_directions.clear();
  in.array("a list of directions ([)", [&] { fixed_directions.push_back(read_int(in, "a direction")); });
}

void JsonElement::read_bounds(JsonScanner& in) {
  in.next();
  bounds_at = in.at();
  bounds.clear();
  in.array("a list of bounds ([)", [&] {
    in.next();
    const char* const begin = in.at();
    detail::Bound bound;
    bool has_entry = false, has_lower = false, has_upper = false;
    in.object("a bound ({)", [&](std::string_view name, const char* name_at) {
      bool* const given_before = name == "entry"   ? &has_entry
                                 : name == "lower" ? &has_lower
                                 : name == "upper" ? &has_upper
                                                   : nullptr;
      if (given_before == nullptr)
        refuse_meaning(name_at,
                       fmt::format("one of the members entry, lower, upper, got {}", in_quotes(name)));
      if (*given_before) refuse_meaning(name_at, fmt::format("the member {} only once", in_quotes(name)));
      *given_before = true;
      if (name == "entry") return void(bound.entry = read_int(in, "an entry"));
      (name == "lower" ? bound.lower : bound.upper) = in.number("a limit").value;
    });
    if (!has_entry || (!has_lower && !has_upper))
      refuse_meaning(begin, "a bound with entry, and with lower, upper or both");
    bounds.push_back(bound);
  });
}

}  // namespace boxplus
