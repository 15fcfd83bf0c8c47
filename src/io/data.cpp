// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/io/data.h"

#include <algorithm>
#include <array>
#include <utility>

#include "io/characters.h"

namespace boxplus {
namespace {

template <class... T>
constexpr std::array<std::string_view, sizeof...(T)> tags_of(std::variant<T...>*) {
  return {T::kTag...};
}
constexpr auto kTags = tags_of(static_cast<Data*>(nullptr));

/// Reads the alternative of Data whose tag has this index.
template <std::size_t... k>
Data read_alternative(std::size_t index, FieldReader& in, std::index_sequence<k...>) {
  using Read = Data (*)(FieldReader&);
  constexpr Read kRead[] = {
      [](FieldReader& fields) -> Data { return std::variant_alternative_t<k, Data>::read(fields); }...};
  return kRead[index](in);
}

}  // namespace

std::span<const std::string_view> data_tags() {
  return kTags;
}

std::string_view data_tag_of(std::string_view line) {
  line = without_byte_order_mark(line);
  const auto begin = std::find_if_not(line.begin(), line.end(), is_blank);
  const auto end = std::find_if(begin, line.end(), is_blank);
  const auto found = std::find(kTags.begin(), kTags.end(), std::string_view(begin, end));
  return found == kTags.end() ? std::string_view() : *found;
}

std::optional<Data> parse_data(const GraphFile::KeptLine& line, const std::string& name) {
  const std::string_view tag = data_tag_of(line.text);
  if (tag.empty()) return {};
  FieldReader in(name, line.line, line.text);
  in.token("a tag");
  const auto index = static_cast<std::size_t>(std::find(kTags.begin(), kTags.end(), tag) - kTags.begin());
  return read_alternative(index, in, std::make_index_sequence<kTags.size()>());
}

std::string format_data(const Data& data) {
  std::string line;
  FieldWriter out(line);
  std::visit(
      [&](const auto& each) {
        out.token(each.kTag);
        each.write(out);
      },
      data);
  return line;
}

std::vector<AttachedData> read_data(const GraphFile& file, const std::string& name) {
  std::vector<AttachedData> all;
  for (const GraphFile::KeptLine& line : file.kept) {
    if (std::optional<Data> data = parse_data(line, name))
      all.push_back({line.place, line.after, *std::move(data)});
  }
  return all;
}

}  // namespace boxplus
