// SPDX-License-Identifier: BSD-3-Clause
// Rotations and poses. Points are NumPy arrays.
#include <cmath>
#include <span>
#include <vector>

#include "manifold_class.h"

namespace boxplus::python {
namespace {

S2 direction_of(py::handle value) {
  const Vector3 v = vector_of<3>(value, "vector", "x y z");
  if (v.isZero(0)) throw_value_error("vector", "a vector that is not zero", value);
  return S2(v / v.lpNorm<Eigen::Infinity>());  // the square of a tiny or huge vector would not be finite
}
double positive(double value, const char* name) {
  if (!(value > 0) || !std::isfinite(value)) throw_value_error(name, "a positive number", py::float_(value));
  return value;
}

void bind_plane(py::module_& module) {
  py::class_<SO2> so2(module, "SO2", "A rotation in the plane by an angle (radians) in (−π, π].");
  so2.def(py::init<>())
      .def(py::init([](double angle) { return SO2(finite(angle, "angle")); }), py::arg("angle"))
      .def("angle", [](const SO2& x) { return x.angle(); })
      .def("rotation", [](const SO2& x) { return to_array(Eigen::MatrixXd(x.rotation())); });
  bind_group(so2);
  bind_manifold_class<SO2>(so2, [](const double* row) { return SO2(row[0]); });
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
  bind_group(se2);
  bind_manifold_class<SE2>(se2, [](const double* row) { return SE2(row[0], row[1], row[2]); });
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
  bind_group(so3);
  bind_manifold_class<SO3>(so3, [](const double* q) { return SO3::from_unit({q[0], q[1], q[2], q[3]}); });
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
  bind_group(se3);
  bind_manifold_class<SE3>(se3, [](const double* x) {
    return SE3::from_unit(Vector3(x[0], x[1], x[2]), {x[3], x[4], x[5], x[6]});
  });
  se3.def("__mul__", [](const SE3& x, py::handle p) { return array_of(x * point3(p)); });
}

void bind_directions(py::module_& module) {
  py::class_<S2> s2(module, "S2",
                    "A direction in space: a unit vector. Tangent: two rotation angles in radians.");
  s2.def(py::init<>())
      .def(py::init(&direction_of), py::arg("vector"), "The direction of a vector that is not zero.")
      .def_static("from_vector", &direction_of, py::arg("vector"))
      .def(
          "vector", [](const S2& x) { return array_of(x.vector()); }, "x y z, of length 1");
  bind_manifold_class<S2>(s2, [](const double* x) { return S2::from_unit(x[0], x[1], x[2]); });
}

void bind_similarities(py::module_& module) {
  py::class_<Sim3> sim3(
      module, "Sim3",
      "A similarity p ↦ s R p + t in space. Tangent: (ω, υ, σ), the logarithm of a similarity: "
      "rotation vector, translation and log scale.");
  sim3.def(py::init<>())
      .def(py::init([](py::handle rotation, py::handle translation, double scale) {
             return Sim3(rotation_of(rotation).quaternion(), translation3(translation),
                         positive(scale, "scale"));
           }),
           py::arg("rotation"), py::arg("translation"), py::arg("scale"),
           "The rotation is an SO3, a quaternion (qx qy qz qw) or a matrix.")
      .def_static(
          "from_vector",
          [](py::handle vector) {
            return Value<Sim3>::from_row(
                read_vector(vector, Value<Sim3>::kSize, "vector", Value<Sim3>::kLayout).data(),
                {"vector", 0});
          },
          py::arg("vector"), "From x y z qx qy qz qw scale.")
      .def_static(
          "exp", [](py::handle v) { return Sim3::exp(vector_of<7>(v, "tangent", "the tangent")); },
          py::arg("tangent"), "The similarity with the logarithm (ω, υ, σ).")
      .def(
          "log", [](const Sim3& x) { return array_of(x.log()); }, "The inverse of exp().")
      .def("translation", [](const Sim3& x) { return array_of(x.translation()); })
      .def(
          "quaternion", [](const Sim3& x) { return array_of(x.quaternion()); }, "qx qy qz qw")
      .def("rotation", [](const Sim3& x) { return to_array(Eigen::MatrixXd(x.rotation())); })
      .def("scale", [](const Sim3& x) { return x.scale(); })
      .def(
          "vector", [](const Sim3& x) { return to_array(row_of(x)); }, "x y z qx qy qz qw scale");
  bind_group(sim3);
  bind_manifold_class<Sim3>(sim3, [](const double* x) {
    return Sim3::from_unit({x[3], x[4], x[5], x[6]}, Vector3(x[0], x[1], x[2]), x[7]);
  });
  sim3.def("__mul__", [](const Sim3& x, py::handle p) { return array_of(x * point3(p)); });
}

}  // namespace

void bind_manifold(py::module_& module) {
  bind_plane(module);
  bind_space(module);
  bind_directions(module);
  bind_similarities(module);
}

}  // namespace boxplus::python
