// SPDX-License-Identifier: BSD-3-Clause
// The estimates and measurements that Python knows: as objects (SE2, SE3, NumPy arrays for points, float),
// and as rows of numbers in arrays.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>

#include "boxplus/io/file_fields.h"
#include "boxplus/manifold/se2.h"
#include "boxplus/manifold/se3.h"
#include "convert.h"

namespace boxplus::python {

/// Value<T> has
///   kName, kLayout   the name of the type, and the meaning of the numbers of a row
///   kSize            the number of numbers in a row
///   from_row()       throws a ValueError with the name of the row if the numbers are no T
///   to_row()
///   is(), from_python(), to_python()
template <class T>
struct Value;

/// A type of boxplus that is a Python class.
template <class T>
struct ClassValue {
  static bool is(py::handle value) { return py::isinstance<T>(value); }
  static T from_python(py::handle value, std::string_view name) {
    if (!is(value)) throw_type_error(name, "an " + std::string(T::kName), value);
    return value.cast<const T&>();
  }
  static py::object to_python(const T& value) { return py::cast(value); }
};

template <>
struct Value<SE2> : ClassValue<SE2> {
  static constexpr std::string_view kName = "SE2", kLayout = "x y theta";
  static constexpr int kSize = 3;
  static SE2 from_row(const double* row, RowName) { return {row[0], row[1], row[2]}; }
  static void to_row(const SE2& x, double* row) { std::copy_n(x.data(), kSize, row); }
};

/// As FileFields<SE3>, from_row() keeps the bits of a quaternion whose length is 1 up to the digits of a
/// file, and normalizes it if its length differs by up to kNormTolerance.
template <>
struct Value<SE3> : ClassValue<SE3> {
  static constexpr std::string_view kName = "SE3", kLayout = "x y z qx qy qz qw";
  static constexpr int kSize = 7;
  static SE3 from_row(const double* row, RowName name) {
    const Vector3 t(row[0], row[1], row[2]);
    const SE3::Quaternion q{row[3], row[4], row[5], row[6]};
    const double excess = std::abs(std::sqrt(q.squared_norm()) - 1);
    if (!(excess <= FileFields<SE3>::kNormTolerance)) {
      throw_value_error(name.text(), "a quaternion (qx qy qz qw) of length 1",
                        to_array(std::span(row + 3, 4)).attr("tolist")());
    }
    return excess <= FileFields<SE3>::kRounding ? SE3::from_unit(t, q) : SE3(t, q);
  }
  static void to_row(const SE3& x, double* row) { std::copy_n(x.data(), kSize, row); }
};

/// Points are NumPy arrays.
template <int N>
struct Value<Vector<double, N>> {
  static constexpr std::string_view kNames[] = {"Vector1", "Vector2",  "Vector3",  "Vector4",
                                                "Vector5", "Vector6",  "Vector7",  "Vector8",
                                                "Vector9", "Vector10", "Vector11", "Vector12"};
  static constexpr std::string_view kName = kNames[N - 1];
  static constexpr std::string_view kLayout = N == 2 ? "x y" : N == 3 ? "x y z" : "its numbers";
  static constexpr int kSize = N;
  static bool is(py::handle value) {
    const py::array array = py::array::ensure(value);
    return array && array.ndim() == 1 && array.size() == N;
  }
  static Vector<double, N> from_row(const double* row, RowName) {
    return Eigen::Map<const Vector<double, N>>(row);
  }
  static void to_row(const Vector<double, N>& x, double* row) { std::copy_n(x.data(), N, row); }
  static Vector<double, N> from_python(py::handle value, std::string_view name) {
    return Eigen::Map<const Vector<double, N>>(read_vector(value, N, name, kLayout).data());
  }
  static py::object to_python(const Vector<double, N>& x) {
    return to_array(std::span(x.data(), std::size_t{N}));
  }
};

template <>
struct Value<double> {
  static constexpr std::string_view kName = "float", kLayout = "value";
  static constexpr int kSize = 1;
  static double from_row(const double* row, RowName) { return row[0]; }
  static void to_row(double x, double* row) { row[0] = x; }
  static double from_python(py::handle value, std::string_view name) { return read_number(value, name); }
  static py::object to_python(double x) { return py::float_(x); }
};

}  // namespace boxplus::python
