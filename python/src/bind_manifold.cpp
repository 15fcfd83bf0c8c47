// SPDX-License-Identifier: BSD-3-Clause
// Rotations and poses. Points are NumPy arrays.
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "bind.h"
#include "boxplus/manifold/se2.h"
#include "boxplus/manifold/se3.h"
#include "boxplus/manifold/so2.h"
#include "boxplus/manifold/so3.h"
#include "convert.h"

namespace boxplus::python {
namespace {

template <int N>
Vector<double, N> vector_of(py::handle value, const char* name, const char* layout) {
  return Eigen::Map<const Vector<double, N>>(read_vector(value, N, name, layout).data());
}
Vector2 point2(py::handle value) {
  return vector_of<2>(value, "point", "x y");
}
Vector3 point3(py::handle value) {
  return vector_of<3>(value, "point", "x y z");
}
Vector3 translation3(py::handle value) {
  return vector_of<3>(value, "translation", "x y z");
}

SO3::Quaternion quaternion_of(py::handle value, const char* name) {
  const std::vector<double> q = read_vector(value, 4, name, "qx qy qz qw");
  if (std::all_of(q.begin(), q.end(), [](double x) { return x == 0; }))
    throw_value_error(name, "a quaternion that is not zero", value);
  return {q[0], q[1], q[2], q[3]};
}

/// A rotation from a quaternion (qx qy qz qw) or a rotation matrix.
SO3 rotation_of(py::handle value) {
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
Numbers array_of(const SO3::Quaternion& q) {
  return to_array(std::array{q.x, q.y, q.z, q.w});
}

double finite(double value, const char* name) {
  if (!std::isfinite(value)) throw_value_error(name, "a finite number", py::float_(value));
  return value;
}

/// ⊞ and ⊟, the inverse, the product, comparison and pickling. `size`: the numbers of data().
template <class T, int kSize>
void bind_common(py::class_<T>& type, T (*from_data)(const double*)) {
  constexpr int kDim = Manifold<T>::kDim;
  type.def("inverse", &T::inverse)
      .def(
          "__mul__", [](const T& a, const T& b) -> T { return a * b; }, py::is_operator())
      .def(
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
          "__eq__", [](const T& a, const T& b) { return std::equal(a.data(), a.data() + kSize, b.data()); },
          py::is_operator())
      .def("__copy__", [](const T& x) { return x; })
      .def("__deepcopy__", [](const T& x, const py::dict&) { return x; })
      .def(py::pickle([](const T& x) { return to_array(std::span(x.data(), std::size_t{kSize})); },
                      [from_data](const Numbers& data) { return from_data(data.data()); }))
      .def("__repr__", [](const T& x) {
        std::string text;
        for (int i = 0; i < kSize; ++i)
          text += (i == 0 ? "" : ", ") + std::string(py::str(py::str("{:.9g}").format(x.data()[i])));
        // The values that the constructor or from_vector() takes.
        const bool is_listed = kSize != 1 && kSize != 3;
        return std::string(T::kName) + (is_listed ? ".from_vector([" + text + "])" : "(" + text + ")");
      });
}

void bind_plane(py::module_& module) {
  py::class_<SO2> so2(module, "SO2", "A rotation in the plane by an angle (radians) in (−π, π].");
  so2.def(py::init<>())
      .def(py::init([](double angle) { return SO2(finite(angle, "angle")); }), py::arg("angle"))
      .def("angle", [](const SO2& x) { return x.angle(); })
      .def("rotation", [](const SO2& x) { return to_array(Eigen::MatrixXd(x.rotation())); });
  bind_common<SO2, 1>(so2, [](const double* data) { return SO2(data[0]); });
  so2.def("__mul__", [](const SO2& x, py::handle p) { return array_of(x * point2(p)); });

  py::class_<SE2> se2(
      module, "SE2",
      "A pose (x, y, theta) in the plane: meters, radians in (−π, π]. T_world_body * p_body = "
      "p_world. Tangent: (Δx, Δy, Δθ) in the body frame.");
  se2.def(py::init<>())
      .def(py::init([](double x, double y, double theta) {
             return SE2(finite(x, "x"), finite(y, "y"), finite(theta, "theta"));
           }),
           py::arg("x"), py::arg("y"), py::arg("theta"))
      .def(py::init([](py::handle translation, double theta) {
             return SE2(vector_of<2>(translation, "translation", "x y"), finite(theta, "theta"));
           }),
           py::arg("translation"), py::arg("theta"))
      .def_static(
          "from_vector",
          [](py::handle v) { return SE2::from_vector(vector_of<3>(v, "vector", "x y theta")); },
          py::arg("vector"), "The pose (x, y, theta).")
      .def_static(
          "exp", [](py::handle v) { return SE2::exp(vector_of<3>(v, "tangent", "m/s m/s rad/s")); },
          py::arg("tangent"), "The pose after one second at a constant velocity in the body frame.")
      .def(
          "log", [](const SE2& x) { return array_of(x.log()); }, "The inverse of exp().")
      .def("x", [](const SE2& x) { return x.x(); })
      .def("y", [](const SE2& x) { return x.y(); })
      .def("theta", [](const SE2& x) { return x.theta(); })
      .def(
          "vector", [](const SE2& x) { return array_of(x.vector()); }, "x y theta")
      .def("translation", [](const SE2& x) { return array_of(x.translation()); })
      .def("rotation", [](const SE2& x) { return to_array(Eigen::MatrixXd(x.rotation())); })
      .def("inverse_times", [](const SE2& a, const SE2& b) -> SE2 { return a.inverse_times(b); })
      .def("inverse_times", [](const SE2& a, py::handle p) { return array_of(a.inverse_times(point2(p))); });
  bind_common<SE2, 3>(se2, [](const double* data) { return SE2(data[0], data[1], data[2]); });
  se2.def("__mul__", [](const SE2& x, py::handle p) { return array_of(x * point2(p)); });
}

void bind_space(py::module_& module) {
  py::class_<SO3> so3(module, "SO3",
                      "A rotation in space: a unit quaternion. Tangent: the vector part of a quaternion.");
  so3.def(py::init<>())
      .def(py::init(&rotation_of), py::arg("rotation"), "From a quaternion (qx qy qz qw) or a matrix.")
      .def_static(
          "from_rotation_vector",
          [](py::handle v) {
            return SO3::from_rotation_vector(vector_of<3>(v, "rotation_vector", "radians around the axes"));
          },
          py::arg("rotation_vector"), "The rotation by |ω| radians around ω: the exponential map.")
      .def_static(
          "from_vector", [](py::handle v) { return SO3(quaternion_of(v, "vector")); }, py::arg("vector"))
      .def(
          "quaternion", [](const SO3& x) { return array_of(x.quaternion()); }, "qx qy qz qw")
      .def("rotation", [](const SO3& x) { return to_array(Eigen::MatrixXd(x.rotation())); })
      .def(
          "rotation_vector", [](const SO3& x) { return array_of(x.rotation_vector()); },
          "The inverse of from_rotation_vector(): the logarithm.")
      .def(
          "minimal", [](const SO3& x) { return array_of(x.minimal()); },
          "The vector part of the quaternion with w ≥ 0.");
  bind_common<SO3, 4>(so3, [](const double* q) { return SO3::from_unit({q[0], q[1], q[2], q[3]}); });
  so3.def("__mul__", [](const SO3& x, py::handle p) { return array_of(x * point3(p)); });

  py::class_<SE3> se3(
      module, "SE3",
      "A pose in space: translation (meters) and unit quaternion. T_world_body * p_body = p_world. "
      "Tangent: (Δt, vector part of a quaternion) in the body frame.");
  se3.def(py::init<>())
      .def(py::init([](py::handle translation, py::handle rotation) {
             return SE3(translation3(translation), rotation_of(rotation));
           }),
           py::arg("translation"), py::arg("rotation"),
           "The rotation is an SO3, a quaternion (qx qy qz qw) or a matrix.")
      .def_static(
          "from_vector",
          [](py::handle vector) {
            const std::vector<double> v = read_vector(vector, 7, "vector", "x y z qx qy qz qw");
            const Numbers q = to_array(std::span(v).subspan(3));
            return SE3(Vector3(v[0], v[1], v[2]), quaternion_of(q, "the quaternion of vector"));
          },
          py::arg("vector"), "From x y z qx qy qz qw.")
      .def_static(
          "from_minimal",
          [](py::handle v) {
            return SE3::from_minimal(vector_of<6>(v, "minimal", "x y z and the vector part of a quaternion"));
          },
          py::arg("minimal"), "The inverse of minimal().")
      .def("translation", [](const SE3& x) { return array_of(x.translation()); })
      .def(
          "quaternion", [](const SE3& x) { return array_of(x.quaternion()); }, "qx qy qz qw")
      .def_static(
          "exp",
          [](py::handle v) { return SE3::exp(vector_of<6>(v, "tangent", "m/s m/s m/s rad/s rad/s rad/s")); },
          py::arg("tangent"), "The pose after one second at a constant velocity in the body frame.")
      .def(
          "log", [](const SE3& x) { return array_of(x.log()); }, "The inverse of exp().")
      .def("so3", &SE3::so3)
      .def("rotation", [](const SE3& x) { return to_array(Eigen::MatrixXd(x.rotation())); })
      .def(
          "vector", [](const SE3& x) { return array_of(x.vector()); }, "x y z qx qy qz qw")
      .def(
          "minimal", [](const SE3& x) { return array_of(x.minimal()); },
          "The translation, and the vector part of the quaternion with w ≥ 0.")
      .def("inverse_times", [](const SE3& a, const SE3& b) -> SE3 { return a.inverse_times(b); })
      .def("inverse_times", [](const SE3& a, py::handle p) { return array_of(a.inverse_times(point3(p))); });
  bind_common<SE3, 7>(se3, [](const double* x) {
    return SE3::from_unit(Vector3(x[0], x[1], x[2]), {x[3], x[4], x[5], x[6]});
  });
  se3.def("__mul__", [](const SE3& x, py::handle p) { return array_of(x * point3(p)); });
}

}  // namespace

void bind_manifold(py::module_& module) {
  bind_plane(module);
  bind_space(module);
}

}  // namespace boxplus::python
