// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/io/information_fields.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "base/symmetric_eigen.h"
#include "boxplus/base/error.h"
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

/// Sets the negative eigenvalues of Ω to zero. The result is in `values`, which may be `upper`.
void project(std::span<const double> upper, int rows, std::vector<double>& values) {
  Eigen::MatrixXd omega(rows, rows);
  std::size_t next = 0;
  for (int i = 0; i < rows; ++i) {
    for (int j = i; j < rows; ++j) omega(i, j) = omega(j, i) = upper[next++];
  }
  const SymmetricEigen eigen = symmetric_eigen(omega);
  omega.noalias() = eigen.vectors * eigen.values.cwiseMax(0).asDiagonal() * eigen.vectors.transpose();
  values.clear();
  for (int i = 0; i < rows; ++i) {
    for (int j = i; j < rows; ++j) values.push_back(i == j ? std::max(omega(i, i), 0.0) : omega(i, j));
  }
}

bool is_zero(std::span<const double> values) {
  return std::all_of(values.begin(), values.end(), [](double value) { return value == 0; });
}

}  // namespace

void detail::UncheckedInformation::check(const FieldReader& in) const {
  const std::string complaint = value.complaint(rows);
  if (complaint.empty()) return;
  in.fail(place, complaint +
                     " (to use the nearest positive semi-definite matrix: --information project; to keep it: "
                     "--information as-given; in a program: ReadOptions::indefinite)");
}

detail::UncheckedInformation detail::read_unchecked_information(FieldReader& in, int rows,
                                                                ToUpperTriangle to_upper_triangle) {
  in.begin_information();
  const FieldPlace place = in.place();
  const std::size_t count = static_cast<std::size_t>(rows) * static_cast<std::size_t>(rows + 1) / 2;
  const std::span<const double> listed = read_listed(in, count);
  if (is_zero(listed)) in.fail(place, "information: expected a nonzero matrix, got zeros only");
  const std::span<const double> upper = as_upper_triangle(listed, to_upper_triangle);
  Information information = Information::upper_triangle(upper, rows);
  if (in.policy() == ReadOptions::Indefinite::kRefuse || information.complaint(rows).empty())
    return {std::move(information), rows, place};
  if (in.policy() == ReadOptions::Indefinite::kAsGiven) {
    information = std::move(information).as_given();
  } else {
    std::vector<double> projected;
    project(upper, rows, projected);
    if (is_zero(projected)) {
      in.fail(
          place,
          "information: expected a matrix with a positive eigenvalue, got none (to keep it: --information "
          "as-given)");
    }
    information = Information::upper_triangle(projected, rows);
  }
  in.note_indefinite();
  return {std::move(information), rows, place};
}

void detail::require_information(const InformationView& information, const Information& computed,
                                 std::string_view edge_type) {
  const InformationView expected{computed.kind(), information.rows, computed.values().data()};
  for (int i = 0; i < information.rows; ++i) {
    for (int j = i; j < information.rows; ++j) {
      if (information(i, j) == expected(i, j)) continue;
      throw InvalidArgument(
          fmt::format("cannot write an edge of type {}: expected the information that follows from its "
                      "measurement, because "
                      "its line in a file has no information, but row {}, column {} is {} instead of {}",
                      edge_type, i + 1, j + 1, information(i, j), expected(i, j)));
    }
  }
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

void write_information(const detail::InformationView& information, FieldWriter& out,
                       void (*from_upper_triangle)(std::span<double> upper)) {
  auto& values = detail::thread_scratch<std::vector<double>, struct WrittenInformation>();
  values.clear();
  for (int i = 0; i < information.rows; ++i) {
    for (int j = i; j < information.rows; ++j) values.push_back(information(i, j));
  }
  from_upper_triangle(values);
  for (const double value : values) out.number(value);
}

}  // namespace boxplus
