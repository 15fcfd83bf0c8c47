// SPDX-License-Identifier: BSD-3-Clause
// Planes and lines in space, as objects and as rows.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <string_view>

#include "boxplus/types/slam3d/line.h"
#include "boxplus/types/slam3d/plane.h"
#include "values.h"

namespace boxplus::python {

/// Throws a ValueError if files refuse the length of a normal or of a direction.
inline void require_direction(const Vector3& v, const std::string& name, std::string_view what) {
  if (v.squaredNorm() > 1e-200 && v.squaredNorm() < 1e200) return;
  throw_value_error(name, std::string(what) + " whose length is neither zero nor huge",
                    to_array(std::span(v.data(), 3)).attr("tolist")());
}

/// A row does not contain the color.
template <>
struct Value<Plane3> : ClassValue<Plane3> {
  static constexpr std::string_view kName = Plane3::kName, kLayout = "nx ny nz d";
  static constexpr int kSize = 4;
  static Plane3 from_row(const double* row, RowName name) { return checked(row, name.text()); }
  static Plane3 checked(const double* row, const std::string& name) {
    Plane3 x;
    std::copy_n(row, kSize, x.coefficients.data());
    require_direction(x.normal(), name, "a normal (nx ny nz)");
    return x;
  }
  template <class X, class S>
  static void to_row(const X& x, S* row) {
    std::copy_n(x.coefficients.data(), kSize, row);
  }
};

/// from_row() refuses the moments that files refuse.
template <>
struct Value<Line3> : ClassValue<Line3> {
  static constexpr std::string_view kName = Line3::kName, kLayout = "wx wy wz dx dy dz";
  static constexpr int kSize = 6;
  static Line3 from_row(const double* row, RowName name) { return checked(row, name.text()); }
  static Line3 checked(const double* row, const std::string& name) {
    const Line3 x{Vector3(row[0], row[1], row[2]), Vector3(row[3], row[4], row[5])};
    require_direction(x.direction, name, "a direction (dx dy dz)");
    const double along = std::abs(x.moment.dot(x.direction.normalized()));
    if (along > FileFields<Line3>::kTolerance * (x.moment.norm() + x.direction.norm()))
      throw_value_error(name, "a moment (wx wy wz) that is orthogonal to the direction (dx dy dz)",
                        to_array(std::span(row, kSize)).attr("tolist")());
    return x;
  }
  template <class X, class S>
  static void to_row(const X& x, S* row) {
    std::copy_n(x.moment.data(), 3, row);
    std::copy_n(x.direction.data(), 3, row + 3);
  }
};

}  // namespace boxplus::python
