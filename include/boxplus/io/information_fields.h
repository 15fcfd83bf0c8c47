// SPDX-License-Identifier: BSD-3-Clause
// The information matrix Ω of an edge in a file: the n(n+1)/2 values of its upper triangle by rows, Ω11 Ω12 …
// Ω1n Ω22 …
#pragma once

#include <span>

#include "boxplus/graph/information.h"
#include "boxplus/io/field_reader.h"

namespace boxplus {

/// Throws InputError if Ω is zero, or if it is indefinite and the reader does not project it.
Information read_information(FieldReader& in, int rows);
void write_information(const detail::InformationView& information, FieldWriter& out);
/// `from_upper_triangle` converts the values to those that the file lists.
void write_information(const detail::InformationView& information, FieldWriter& out,
                       void (*from_upper_triangle)(std::span<double> upper));

namespace detail {

/// An Ω that was read but not checked. The graph checks it when the edge is added; another check here would
/// take longer than reading it.
struct UncheckedInformation {
  Information value;
  int rows;
  FieldPlace place;

  /// Throws InputError if Ω is indefinite.
  void check(const FieldReader& in) const;
};

/// Converts the values of Ω, as a file lists them, to the upper triangle by rows.
using ToUpperTriangle = void (*)(std::span<double> listed);

/// `to_upper_triangle`: nullptr if the file lists the upper triangle. If the reader projects an indefinite Ω,
/// the result is the nearest positive semi-definite matrix in the Frobenius norm: negative eigenvalues become
/// zero (Higham, "Computing a nearest symmetric positive semidefinite matrix", 1988, theorem 2.1). Throws
/// InputError if Ω is zero, or if nothing of it is left.
UncheckedInformation read_unchecked_information(FieldReader& in, int rows, ToUpperTriangle to_upper_triangle);

/// Throws InvalidArgument, because a line cannot contain Ω, unless Ω has the value that a reader computes.
void require_information(const InformationView& information, const Information& computed,
                         std::string_view edge_type);

}  // namespace detail
}  // namespace boxplus
