// SPDX-License-Identifier: BSD-3-Clause
// What the Python classes of rotations, poses and other manifolds have in common.
#pragma once

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "bind.h"
#include "convert.h"
#include "values.h"

namespace boxplus::python {

template <int N>
Vector<double, N> vector_of(py::handle value, const char* name, const char* layout) {
  return Eigen::Map<const Vector<double, N>>(read_vector(value, N, name, layout).data());
}
inline Vector2 point2(py::handle value) {
  return vector_of<2>(value, "point", "x y");
}
inline Vector3 point3(py::handle value) {
  return vector_of<3>(value, "point", "x y z");
}
inline Vector3 translation3(py::handle value) {
  return vector_of<3>(value, "translation", "x y z");
}

inline SO3::Quaternion quaternion_of(py::handle value, const char* name) {
  const std::vector<double> q = read_vector(value, 4, name, "qx qy qz qw");
  if (std::all_of(q.begin(), q.end(), [](double x) { return x == 0; }))
    throw_value_error(name, "a quaternion that is not zero", value);
  return {q[0], q[1], q[2], q[3]};
}

/// A rotation from a quaternion (qx qy qz qw) or a rotation matrix.
inline SO3 rotation_of(py::handle value) {
  if (py::isinstance<SO3>(value)) return value.cast<SO3>();
  const Numbers numbers = read_numbers(value, "rotation");
  if (numbers.ndim() == 1) return SO3(quaternion_of(numbers, "rotation"));
  if (numbers.ndim() != 2 || numbers.shape(0) != 3 || numbers.shape(1) != 3)
    throw_value_error("rotation", "an SO3, a quaternion (qx qy qz qw), or a matrix of shape (3, 3)", numbers);
  Matrix<double, 3, 3> matrix;
  for (int i = 0; i < 9; ++i) matrix(i / 3, i % 3) = numbers.data()[i];
  if (!(matrix * matrix.transpose()).isIdentity(1e-6) || matrix.determinant() < 0)
    throw_value_error("rotation", "a rotation matrix (orthogonal, with the determinant 1)",
                      value.attr("tolist")());
  return SO3(matrix);
}

template <class M>
Numbers array_of(const M& vector) {
  return to_array(std::span(vector.data(), static_cast<std::size_t>(vector.size())));
}
inline Numbers array_of(const SO3::Quaternion& q) {
  return to_array(std::array{q.x, q.y, q.z, q.w});
}

inline double finite(double value, const char* name) {
  if (!std::isfinite(value)) throw_value_error(name, "a finite number", py::float_(value));
  return value;
}

template <class T>
std::array<double, std::size_t{Value<T>::kSize}> row_of(const T& x) {
  std::array<double, std::size_t{Value<T>::kSize}> row;
  Value<T>::to_row(x, row.data());
  return row;
}

/// Whether T has a constructor for the numbers of a row.
template <class T, std::size_t... I>
constexpr bool takes_numbers(std::index_sequence<I...>) {
  return std::is_constructible_v<T, decltype(static_cast<double>(I))...>;
}

template <class T>
Numbers row_array(const T& x) {
  return to_array(row_of(x));
}

/// ⊞ and ⊟, comparison, copies, pickling and the text. unpickled() makes a value of the bits of pickled(),
/// which is the row if nothing else is said.
template <class T>
void bind_manifold_class(py::class_<T>& type, T (*unpickled)(const double*),
                         Numbers (*pickled)(const T&) = &row_array<T>) {
  constexpr int kDim = Manifold<T>::kDim, kSize = Value<T>::kSize;
  type.def(
          "oplus",
          [](const T& x, py::handle delta) -> T {
            return Manifold<T>::oplus(x, read_vector(delta, kDim, "delta", "the tangent").data());
          },
          py::arg("delta"), "x ⊞ delta: the value that a step in the tangent space leads to.")
      .def(
          "ominus",
          [](const T& y, const T& x) {
            std::array<double, kDim> delta;
            Manifold<T>::ominus(y, x, delta.data());
            return to_array(delta);
          },
          py::arg("x"), "y ⊟ x: the step that leads from x to y.")
      .def(
          "__eq__", [](const T& a, const T& b) { return row_of(a) == row_of(b); }, py::is_operator())
      .def("__copy__", [](const T& x) { return x; })
      .def("__deepcopy__", [](const T& x, const py::dict&) { return x; })
      .def(py::pickle([pickled](const T& x) { return pickled(x); },
                      [unpickled](const Numbers& numbers) { return unpickled(numbers.data()); }))
      .def("__repr__", [](const T& x) {
        std::string text;
        for (const double number : row_of(x))
          text += (text.empty() ? "" : ", ") + std::string(py::str(py::str("{:.9g}").format(number)));
        // The values that the constructor or from_vector() takes.
        constexpr bool kTakesNumbers = takes_numbers<T>(std::make_index_sequence<std::size_t{kSize}>());
        return std::string(Value<T>::kName) +
               (kTakesNumbers ? "(" + text + ")" : ".from_vector([" + text + "])");
      });
}

/// The inverse and the product.
template <class T>
void bind_group(py::class_<T>& type) {
  type.def("inverse", &T::inverse)
      .def(
          "__mul__", [](const T& a, const T& b) -> T { return a * b; }, py::is_operator());
}

}  // namespace boxplus::python
