// SPDX-License-Identifier: BSD-3-Clause
// The estimates and measurements that Python knows: as objects (poses, rotations, NumPy arrays for points,
// float), and as rows of numbers in arrays.
#pragma once

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <initializer_list>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>

#include "boxplus/io/file_fields.h"
#include "boxplus/manifold/product.h"
#include "boxplus/manifold/s2.h"
#include "boxplus/manifold/se2.h"
#include "boxplus/manifold/se3.h"
#include "boxplus/manifold/sim3.h"
#include "boxplus/manifold/so2.h"
#include "boxplus/manifold/so3.h"
#include "convert.h"

namespace boxplus::python {

/// Value<T> has
///   kName, kLayout   the name of the type, and the meaning of the numbers of a row
///   kSize            the number of numbers in a row
///   from_row()       throws a ValueError with the name of the row if the numbers are no T
///   to_row()         also for the values over dual numbers
///   is(), from_python(), to_python()
template <class T>
struct Value;

/// "an SE2", "a Sim3"
inline std::string with_article(std::string_view name) {
  const bool is_spelled = name.size() > 1 && (std::isupper(name[1]) != 0 || std::isdigit(name[1]) != 0);
  return (is_spelled || std::string_view("AEIOU").find(name[0]) != std::string_view::npos ? "an " : "a ") +
         std::string(name);
}

inline std::string joined(std::initializer_list<std::string_view> names, const char* separator) {
  std::string text;
  for (const std::string_view name : names) text += (text.empty() ? "" : separator) + std::string(name);
  return text;
}

/// A type of boxplus that is a Python class.
template <class T>
struct ClassValue {
  static bool is(py::handle value) { return py::isinstance<T>(value); }
  static T from_python(py::handle value, std::string_view name) {
    if (!is(value)) throw_type_error(name, with_article(Value<T>::kName), value);
    return value.cast<const T&>();
  }
  static py::object to_python(const T& value) { return py::cast(value); }
};

/// Throws a ValueError unless the length of a quaternion or vector is 1 up to the digits of a file.
inline void require_unit(const double* numbers, std::size_t count, RowName name, std::string_view expected) {
  double n2 = 0;
  for (std::size_t i = 0; i < count; ++i) n2 += numbers[i] * numbers[i];
  if (std::abs(std::sqrt(n2) - 1) <= FileFields<SE3>::kNormTolerance) return;
  throw_value_error(name.text(), expected, to_array(std::span(numbers, count)).attr("tolist")());
}
inline void require_unit_quaternion(const double* q, RowName name) {
  require_unit(q, 4, name, "a quaternion (qx qy qz qw) of length 1");
}

template <>
struct Value<SO2> : ClassValue<SO2> {
  static constexpr std::string_view kName = "SO2", kLayout = "angle";
  static constexpr int kSize = 1;
  static SO2 from_row(const double* row, RowName) { return SO2(row[0]); }
  template <class X, class S>
  static void to_row(const X& x, S* row) {
    std::copy_n(x.data(), kSize, row);
  }
};

template <>
struct Value<SO3> : ClassValue<SO3> {
  static constexpr std::string_view kName = "SO3", kLayout = "qx qy qz qw";
  static constexpr int kSize = 4;
  static SO3 from_row(const double* row, RowName name) {
    require_unit_quaternion(row, name);
    return SO3(SO3::Quaternion{row[0], row[1], row[2], row[3]});
  }
  template <class X, class S>
  static void to_row(const X& x, S* row) {
    std::copy_n(x.data(), kSize, row);
  }
};

template <>
struct Value<S2> : ClassValue<S2> {
  static constexpr std::string_view kName = "S2", kLayout = "x y z";
  static constexpr int kSize = 3;
  static S2 from_row(const double* row, RowName name) {
    require_unit(row, 3, name, "a vector of length 1");
    return S2(Vector3(row[0], row[1], row[2]));
  }
  template <class X, class S>
  static void to_row(const X& x, S* row) {
    std::copy_n(x.data(), kSize, row);
  }
};

template <>
struct Value<Sim3> : ClassValue<Sim3> {
  static constexpr std::string_view kName = "Sim3", kLayout = "x y z qx qy qz qw scale";
  static constexpr int kSize = 8;
  static Sim3 from_row(const double* row, RowName name) {
    require_unit_quaternion(row + 3, name);
    if (!(row[7] > 0)) throw_value_error(name.text(), "a positive scale", py::float_(row[7]));
    return Sim3(Sim3::Quaternion{row[3], row[4], row[5], row[6]}, Vector3(row[0], row[1], row[2]), row[7]);
  }
  template <class X, class S>
  static void to_row(const X& x, S* row) {
    std::copy_n(x.data(), kSize, row);
  }
};

template <>
struct Value<SE2> : ClassValue<SE2> {
  static constexpr std::string_view kName = "SE2", kLayout = "x y theta";
  static constexpr int kSize = 3;
  static SE2 from_row(const double* row, RowName) { return {row[0], row[1], row[2]}; }
  template <class X, class S>
  static void to_row(const X& x, S* row) {
    std::copy_n(x.data(), kSize, row);
  }
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
    require_unit_quaternion(row + 3, name);
    return std::abs(std::sqrt(q.squared_norm()) - 1) <= FileFields<SE3>::kRounding ? SE3::from_unit(t, q)
                                                                                   : SE3(t, q);
  }
  template <class X, class S>
  static void to_row(const X& x, S* row) {
    std::copy_n(x.data(), kSize, row);
  }
};

inline constexpr std::string_view kVectorNames[] = {"Vector1", "Vector2",  "Vector3",  "Vector4",
                                                    "Vector5", "Vector6",  "Vector7",  "Vector8",
                                                    "Vector9", "Vector10", "Vector11", "Vector12"};

/// Points are NumPy arrays.
template <int N>
struct Value<Vector<double, N>> {
  static constexpr std::string_view kName = kVectorNames[N - 1];
  static constexpr std::string_view kLayout = N == 2 ? "x y" : N == 3 ? "x y z" : "its numbers";
  static constexpr int kSize = N;
  static bool is(py::handle value) {
    const py::array array = py::array::ensure(value);
    if (!array || array.ndim() != 1 || array.size() != N) return false;
    return !py::isinstance<py::tuple>(value) || array.dtype().kind() != 'O';  // a tuple of poses is no vector
  }
  static Vector<double, N> from_row(const double* row, RowName) {
    return Eigen::Map<const Vector<double, N>>(row);
  }
  template <class X, class S>
  static void to_row(const X& x, S* row) {
    std::copy_n(x.data(), kSize, row);
  }
  static Vector<double, N> from_python(py::handle value, std::string_view name) {
    return Eigen::Map<const Vector<double, N>>(read_vector(value, N, name, kLayout).data());
  }
  static py::object to_python(const Vector<double, N>& x) {
    return to_array(std::span(x.data(), std::size_t{N}));
  }
};

/// Several values in one vertex: a tuple. Rows and names are those of the parts, one after the other.
template <class... Parts>
struct Value<Product<Parts...>> {
  using T = Product<Parts...>;
  static constexpr int kSize = (Value<Parts>::kSize + ...);
  static inline const std::string kName = "(" + joined({Value<Parts>::kName...}, ", ") + ")";
  static inline const std::string kLayout = joined({Value<Parts>::kLayout...}, " ");

  static T from_row(const double* row, RowName name) {
    T value;
    for_each_part(value, [&]<class Part>(Part& part) {
      part = Value<Part>::from_row(row, name);
      row += Value<Part>::kSize;
    });
    return value;
  }
  template <class X, class S>
  static void to_row(const X& x, S* row) {
    [&]<std::size_t... I>(std::index_sequence<I...>) {
      ((Value<Parts>::to_row(std::get<I>(x.parts), row), row += Value<Parts>::kSize), ...);
    }
    (std::index_sequence_for<Parts...>());
  }
  static bool is(py::handle value) {
    if (!py::isinstance<py::tuple>(value) || py::len(value) != sizeof...(Parts)) return false;
    std::size_t i = 0;
    return (Value<Parts>::is(py::reinterpret_borrow<py::tuple>(value)[i++]) && ...);
  }
  static T from_python(py::handle value, std::string_view name) {
    if (!is(value)) throw_type_error(name, "a tuple " + kName, value);
    T result;
    std::size_t i = 0;
    for_each_part(result, [&]<class Part>(Part& part) {
      part = Value<Part>::from_python(py::reinterpret_borrow<py::tuple>(value)[i++], name);
    });
    return result;
  }
  static py::object to_python(const T& x) {
    return std::apply([](const Parts&... part) { return py::make_tuple(Value<Parts>::to_python(part)...); },
                      x.parts);
  }

 private:
  template <class F>
  static void for_each_part(T& x, const F& f) {
    std::apply([&](Parts&... part) { (f(part), ...); }, x.parts);
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
