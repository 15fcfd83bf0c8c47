// SPDX-License-Identifier: BSD-3-Clause
#include "io/json/json_element_adder.h"

#include <fmt/format.h>

#include <algorithm>

#include "boxplus/base/error.h"
#include "boxplus/robust/make_robust_kernel.h"
#include "io/characters.h"
#include "io/without_place.h"

namespace boxplus {
namespace {

/// The line of an element in a .g2o file, and the place in the JSON text of each of its fields.
class ElementLine {
 public:
  ElementLine(const JsonElement& element, const Tag& tag) {
    append(tag.name, element.tag_at);
    for (const char* place : element.ids.places)
      append(fmt::format("{}", JsonScanner(place, place).integer("an id")), place);
    if (tag.kind == Tag::Kind::kEdge && tag.arguments.back().is_tail) append("||", element.ids.end);
    append(element.fields);
    append(element.information);
    append(element.rest);
    end_ = element.rest.end          ? element.rest.end
           : element.information.end ? element.information.end
                                     : element.fields.end;
  }

  const std::string& text() const { return text_; }
  /// The place of the field that begins at a column, or of the end of the last list.
  const char* place(std::int64_t column) const {
    const auto found = std::find_if(fields_.begin(), fields_.end(),
                                    [&](const auto& field) { return field.first == column; });
    return found == fields_.end() ? end_ : found->second;
  }

 private:
  void append(std::string_view field, const char* place) {
    if (!text_.empty()) text_ += ' ';
    fields_.emplace_back(static_cast<std::int64_t>(text_.size()) + 1, place);
    text_ += field;
  }
  void append(const JsonFields& fields) {
    for (const char* place : fields.places) {
      const char* end = place[-1] == '"' ? std::find(place, fields.end, '"') : json_number_end(place);
      append({place, static_cast<std::size_t>(end - place)}, place);
    }
  }

  std::string text_;
  std::vector<std::pair<std::int64_t, const char*>> fields_;  // columns and places
  const char* end_;
};

/// A list ends where a line ends.
std::string in_terms_of_lists(std::string message) {
  constexpr std::string_view kLine = "the end of the line";
  for (std::size_t at = message.find(kLine); at != std::string::npos; at = message.find(kLine, at + 1))
    message.replace(at, kLine.size(), "the end of the list");
  return message;
}

std::string_view name_of(Tag::Kind kind) {
  return kind == Tag::Kind::kVertex ? "a vertex" : kind == Tag::Kind::kParameter ? "a parameter" : "an edge";
}

std::size_t triangle(int rows) {
  return static_cast<std::size_t>(rows) * static_cast<std::size_t>(rows + 1) / 2;
}

/// Throws JsonError if Ω does not begin after the fields of an edge, or if the reader has read more than the
/// fields without coming to Ω. A wrong number of fields shifts all values that follow, so another error may
/// be only a result of it.
void require_all_fields(const JsonElement& element, const Tag& tag, const FieldReader& in) {
  const std::size_t others = 1 + element.ids.values.size() + (tag.arguments.back().is_tail ? 1 : 0);
  const std::size_t given = element.fields.values.size(), before_information = in.fields_before_information();
  if (before_information == 0 && in.passed() > others + given) {
    refuse_meaning(element.fields.begin, fmt::format("more than {} field{}", given, given == 1 ? "" : "s"));
  } else if (before_information != 0 && before_information != others + given) {
    refuse_meaning(element.fields.begin,
                   fmt::format("{} fields, got {}", before_information - others, given));
  }
}

}  // namespace

const Tag& JsonElementAdder::tag_of(const JsonElement& element, Tag::Kind kind) {
  if (!last_tag_ || element.tag != last_name_) {
    last_name_ = element.tag;
    last_tag_ = tags_.find(last_name_);
  }
  if (!last_tag_ || last_tag_->kind != kind || !last_tag_->written) {
    refuse_meaning(element.tag_at,
                   fmt::format("the tag of {}, got {}{}", name_of(kind), in_quotes(element.tag),
                               !last_tag_                ? ", which is unknown"
                               : last_tag_->kind != kind ? ""
                                                         : ", which is a tag of old files"));
  }
  return *last_tag_;
}

/// Calls read() with a reader of the ids and fields of an element.
template <class F>
void JsonElementAdder::with_fields(const JsonElement& element, const Tag& tag, F&& read) {
  noted_.clear();
  const bool has_tail = tag.kind == Tag::Kind::kEdge && tag.arguments.back().is_tail;  // needs a field ||
  if (has_tail || !element.ids.is_numeric || !element.fields.is_numeric || !element.information.is_numeric ||
      !element.rest.is_numeric) {
    return with_text(element, tag, read);
  }
  values_.clear();
  std::size_t integers = 0;
  for (const JsonFields* list : {&element.ids, &element.fields, &element.information, &element.rest}) {
    if (integers == values_.size()) integers += list->integers;
    values_.insert(values_.end(), list->values.begin(), list->values.end());
  }
  FieldReader in({}, 0, {}, NumericFields{values_, integers});
  in.set_policy(policy_);
  try {
    read(in);
  } catch (const InputError&) {  // reads it again, for the place of the error
    return with_text(element, tag, read);
  }
  noted_ = in.noted();
  has_indefinite_ = in.has_indefinite();
}

template <class F>
void JsonElementAdder::with_text(const JsonElement& element, const Tag& tag, F&& read) {
  const ElementLine line(element, tag);
  FieldReader in({}, 0, line.text());
  in.set_policy(policy_);
  try {
    in.token("a tag");
    read(in);
  } catch (const InputError& error) {
    throw JsonError(line.place(error.column()), in_terms_of_lists(without_place(error, {})),
                    JsonError::Kind::kMeaning);
  }
  noted_ = in.noted();
  has_indefinite_ = in.has_indefinite();
}

void JsonElementAdder::add_vertex(const JsonElement& element, bool is_parameter) {
  const Tag& tag = tag_of(element, is_parameter ? Tag::Kind::kParameter : Tag::Kind::kVertex);
  Id id = 0;
  with_fields(element, tag, [&](FieldReader& in) { id = elements_.read_vertex(tag, in); });
  constexpr unsigned kAttributes =
      JsonElement::kFixed | JsonElement::kFixedDirections | JsonElement::kBounds | JsonElement::kEliminated;
  if ((element.given & kAttributes) == 0) return;
  const VertexRef vertex = is_parameter ? *graph_.find_parameter(id) : *graph_.find_vertex(id);
  if ((element.given & JsonElement::kFixed) != 0) graph_.set_fixed(vertex, element.fixed);
  if ((element.given & JsonElement::kEliminated) != 0) graph_.set_eliminated(vertex, element.eliminated);
  const char* at = element.fixed_directions_at;
  try {
    if ((element.given & JsonElement::kFixedDirections) != 0)
      graph_.fix_directions(vertex, element.fixed_directions);
    if ((element.given & JsonElement::kBounds) == 0) return;
    at = element.bounds_at;
    for (const detail::Bound& bound : element.bounds)
      graph_.set_bounds(vertex, bound.entry, bound.lower, bound.upper);
  } catch (const InvalidArgument& error) {
    graph_.remove(vertex);
    throw JsonError(at, error.what(), JsonError::Kind::kMeaning);
  }
}

std::shared_ptr<const RobustKernel> JsonElementAdder::kernel(const JsonElement::Kernel& wanted) {
  std::shared_ptr<const RobustKernel>& kernel = kernels_[{wanted.name, wanted.width}];
  if (kernel) return kernel;
  try {
    kernel = make_robust_kernel(wanted.name, wanted.width);
  } catch (const InvalidArgument& error) {
    throw JsonError(wanted.at, error.what(), JsonError::Kind::kMeaning);
  }
  return kernel;
}

EdgeRef JsonElementAdder::add_edge(const JsonElement& element) {
  const Tag& tag = tag_of(element, Tag::Kind::kEdge);
  const std::size_t arguments = tag.arguments.size(), given = element.ids.values.size();
  const bool has_tail = tag.arguments.back().is_tail;
  if (has_tail ? given + 1 < arguments : given != arguments) {
    refuse_meaning(element.ids.begin, fmt::format("{}{} ids, got {}", has_tail ? "at least " : "",
                                                  has_tail ? arguments - 1 : arguments, given));
  }
  if (((element.given & JsonElement::kInformation) != 0) != tag.lists_information) {
    refuse_meaning(element.at, tag.lists_information
                                   ? "an element with information"
                                   : "an element without information, which follows from its fields");
  }
  std::shared_ptr<const RobustKernel> wanted_kernel;
  if ((element.given & JsonElement::kKernel) != 0) wanted_kernel = kernel(element.kernel);
  EdgeRef edge;
  with_fields(element, tag, [&](FieldReader& in) {
    try {
      edge = elements_.read_edge(tag, in).added;
      require_all_fields(element, tag, in);
    } catch (const InputError&) {
      require_all_fields(element, tag, in);
      throw;
    } catch (const JsonError&) {
      if (edge != EdgeRef{}) graph_.remove(edge);
      throw;
    }
  });
  if (edge == EdgeRef{}) refuse_meaning(element.ids.begin, "the ids of vertices, got −1");
  const int rows = graph_.information(edge).rows;
  if (tag.lists_information && element.information.values.size() != triangle(rows)) {
    graph_.remove(edge);
    refuse_meaning(element.information.begin,
                   fmt::format("{} values (the upper triangle of {} × {}), got {}", triangle(rows), rows,
                               rows, element.information.values.size()));
  }
  if (wanted_kernel) graph_.set_kernel(edge, std::move(wanted_kernel));
  if ((element.given & JsonElement::kLevel) != 0) graph_.set_level(edge, element.level);
  if ((element.given & JsonElement::kEnabled) != 0) graph_.set_enabled(edge, element.enabled);
  return edge;
}

}  // namespace boxplus
