// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/io/information_fields.h"

#include <algorithm>
#include <vector>

#include "boxplus/base/thread_scratch.h"

namespace boxplus {
namespace {

/// Reads `count` values. If the values have already been converted to numbers, returns them without a copy.
std::span<const double> read_listed(FieldReader& in, std::size_t count) {
  if (const auto converted = in.converted(count); !converted.empty()) return converted;
  auto& values = detail::thread_scratch<std::vector<double>, struct ListedInformation>();
  values.resize(count);
  for (double& value : values) value = in.number("an entry of the information matrix");
  return values;
}

std::span<const double> as_upper_triangle(std::span<const double> listed,
                                          detail::ToUpperTriangle to_upper_triangle) {
  if (!to_upper_triangle) return listed;
  auto& values = detail::thread_scratch<std::vector<double>, struct UpperTriangle>();
  values.assign(listed.begin(), listed.end());
  to_upper_triangle(values);
  return values;
}

}  // namespace

void detail::UncheckedInformation::check(const FieldReader& in) const {
  if (const std::string complaint = value.complaint(rows); !complaint.empty()) in.fail(place, complaint);
}

detail::UncheckedInformation detail::read_unchecked_information(FieldReader& in, int rows,
                                                                ToUpperTriangle to_upper_triangle) {
  const FieldPlace place = in.place();
  const std::size_t count = static_cast<std::size_t>(rows) * static_cast<std::size_t>(rows + 1) / 2;
  const std::span<const double> listed = read_listed(in, count);
  if (std::all_of(listed.begin(), listed.end(), [](double value) { return value == 0; }))
    in.fail(place, "information: expected a nonzero matrix, got zeros only");
  return {Information::upper_triangle(as_upper_triangle(listed, to_upper_triangle), rows), rows, place};
}

Information read_information(FieldReader& in, int rows) {
  detail::UncheckedInformation information = detail::read_unchecked_information(in, rows, nullptr);
  information.check(in);
  return std::move(information.value);
}

void write_information(const detail::InformationView& information, FieldWriter& out) {
  for (int i = 0; i < information.rows; ++i) {
    for (int j = i; j < information.rows; ++j) out.number(information(i, j));
  }
}

}  // namespace boxplus
