// SPDX-License-Identifier: BSD-3-Clause
// Planes and lines in space.
#include <algorithm>
#include <array>

#include "landmark_values.h"
#include "manifold_class.h"

namespace boxplus::python {
namespace {

template <class T>
T value_of(py::handle numbers, const char* name) {
  using V = Value<T>;
  return V::checked(read_vector(numbers, V::kSize, name, V::kLayout).data(), name);
}

std::array<double, 3> color_of(py::handle value) {
  const Vector3 color = vector_of<3>(value, "color", "red green blue");
  return {color[0], color[1], color[2]};
}

void bind_planes(py::module_& module) {
  py::class_<Plane3> plane(
      module, "Plane3",
      "The points p in space with n·p + d = 0, for the coefficients (nx, ny, nz, d) in any scale. A plane "
      "has "
      "a front: (n, d) and (−n, −d) are different. Tangent: (azimuth, elevation, distance): two angles "
      "(radians) turn the normal, and the distance from the origin is in meters.");
  plane.def(py::init<>())
      .def(py::init([](py::handle coefficients, const py::object& color) {
             Plane3 x = value_of<Plane3>(coefficients, "coefficients");
             if (!color.is_none()) x.color = color_of(color);
             return x;
           }),
           py::arg("coefficients"), py::arg("color") = py::none(),
           "The coefficients nx ny nz d, and a color for drawings: red, green and blue in [0, 1].")
      .def_static(
          "from_vector", [](py::handle v) { return value_of<Plane3>(v, "vector"); }, py::arg("vector"),
          "From nx ny nz d.")
      .def_property_readonly(
          "coefficients", [](const Plane3& x) { return array_of(x.coefficients); },
          "A copy of nx ny nz d, in the scale in which they were given.")
      .def_property(
          "color", [](const Plane3& x) { return to_array(x.color); },
          [](Plane3& x, py::handle color) { x.color = color_of(color); },
          "A copy of red, green and blue, which no error depends on.")
      .def(
          "vector", [](const Plane3& x) { return to_array(row_of(x)); }, "nx ny nz d")
      .def("unit", &Plane3::unit, "The same plane with a normal of length 1.")
      .def(
          "normal", [](const Plane3& x) { return array_of(x.normal()); },
          "nx ny nz, in the scale of the coefficients.")
      .def(
          "seen_from", [](const Plane3& x, const SE3& pose) { return x.seen_from(pose); }, py::arg("pose"),
          "The plane in the frame of a pose.");
  bind_manifold_class<Plane3>(
      plane,
      [](const double* x) {
        return Plane3{Vector<double, 4>(x[0], x[1], x[2], x[3]), {x[4], x[5], x[6]}};
      },
      [](const Plane3& x) {
        std::array<double, 7> numbers;
        std::copy(x.color.begin(), x.color.end(), std::copy_n(x.coefficients.data(), 4, numbers.begin()));
        return to_array(numbers);
      });
}

void bind_lines(py::module_& module) {
  py::class_<Line3> line(
      module, "Line3",
      "An infinite line in space in Plücker coordinates, in any scale: the moment w = p × d for each of its "
      "points p, and the direction d. (w, d) and (−w, −d) are different. Tangent: 3 half angles and the "
      "angle "
      "φ of the orthonormal representation.");
  line.def(py::init<>())
      .def(py::init([](py::handle moment, py::handle direction) {
             const Vector3 w = vector_of<3>(moment, "moment", "x y z");
             const Vector3 d = vector_of<3>(direction, "direction", "x y z");
             require_direction(d, "direction", "a vector");
             return value_of<Line3>(to_array(std::array{w[0], w[1], w[2], d[0], d[1], d[2]}), "moment");
           }),
           py::arg("moment"), py::arg("direction"))
      .def_static(
          "from_vector", [](py::handle v) { return value_of<Line3>(v, "vector"); }, py::arg("vector"),
          "From wx wy wz dx dy dz.")
      .def_static(
          "through",
          [](py::handle point, py::handle direction) {
            const Vector3 d = vector_of<3>(direction, "direction", "x y z");
            require_direction(d, "direction", "a vector");
            return Line3::through(point3(point), d);
          },
          py::arg("point"), py::arg("direction"), "The line through a point.")
      .def_property_readonly(
          "moment", [](const Line3& x) { return array_of(x.moment); }, "A copy of w.")
      .def_property_readonly(
          "direction", [](const Line3& x) { return array_of(x.direction); }, "A copy of d.")
      .def(
          "vector", [](const Line3& x) { return to_array(row_of(x)); }, "wx wy wz dx dy dz")
      .def(
          "nearest_point", [](const Line3& x) { return array_of(x.nearest_point()); },
          "The point of the line that is nearest to the origin.")
      .def(
          "seen_from", [](const Line3& x, const SE3& pose) { return x.seen_from(pose); }, py::arg("pose"),
          "The line in the frame of a pose.");
  bind_manifold_class<Line3>(line, [](const double* row) {
    return Line3{Vector3(row[0], row[1], row[2]), Vector3(row[3], row[4], row[5])};
  });
}

}  // namespace

void bind_landmarks(py::module_& module) {
  bind_planes(module);
  bind_lines(module);
}

}  // namespace boxplus::python
