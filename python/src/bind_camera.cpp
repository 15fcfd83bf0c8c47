// SPDX-License-Identifier: BSD-3-Clause
// The classes of cameras.
#include <string>
#include <vector>

#include "camera_values.h"
#include "manifold_class.h"

namespace boxplus::python {
namespace {

/// The parameters in their order, by position or by name.
template <class Camera>
Camera camera_of(const py::args& values, const py::kwargs& named) {
  using V = Value<Camera>;
  const auto& names = Camera::Model::kParameters;
  if (values.empty() && named.empty()) return Camera();
  py::list numbers(names.size());
  std::size_t given = 0;
  const auto set = [&](std::size_t i, py::handle value) {
    numbers[i] = py::float_(read_number(value, names[i]));
    ++given;
  };
  for (std::size_t i = 0; i < std::min(values.size(), names.size()); ++i) set(i, values[i]);
  for (std::size_t i = values.size(); i < names.size(); ++i) {
    const py::str name{std::string(names[i])};
    if (named.contains(name)) set(i, named[name]);
  }
  if (given != names.size() || values.size() + named.size() != names.size())
    throw py::type_error(
        std::string(V::kName) + ": expected the parameters " + std::string(V::kLayout) + ", got " +
        std::to_string(values.size()) + " numbers" +
        (named.empty() ? "" : " and " + std::string(py::str(py::list(named.attr("keys")())))));
  return V::from_row(read_vector(numbers, V::kSize, "parameters", V::kLayout).data(), {});
}

/// f(point) for one point or for each row of an array of points, as an array of `size` numbers or of rows.
template <class Function>
Numbers for_each_point(py::handle points, py::ssize_t size, const Function& f) {
  const Numbers numbers = read_numbers(points, "point");
  const bool is_one = numbers.ndim() == 1;
  const Numbers rows =
      is_one ? to_array(read_vector(points, 3, "point", "x y z")) : read_rows(numbers, 3, "points", "x y z");
  const py::ssize_t count = is_one ? 1 : rows.shape(0);
  Numbers result(is_one ? std::vector<py::ssize_t>{size} : std::vector<py::ssize_t>{count, size});
  for (py::ssize_t i = 0; i < count; ++i) f(Vector3(rows.data() + 3 * i), result.mutable_data() + size * i);
  return result;
}

template <class Camera>
void bind(py::module_& module) {
  using V = Value<Camera>;
  const std::string doc = "A camera of the model " + std::string(Camera::kName) +
                          ". Parameters: " + std::string(V::kLayout) + ". Tangent: added to them.";
  py::class_<Camera> type(module, std::string(V::kName).c_str(), doc.c_str());
  py::list names;
  for (const std::string_view name : Camera::Model::kParameters) names.append(std::string(name));
  type.attr("parameter_names") = py::tuple(names);
  type.def(py::init(&camera_of<Camera>))
      .def_static(
          "from_vector",
          [](py::handle vector) {
            return V::from_row(read_vector(vector, V::kSize, "vector", V::kLayout).data(), {});
          },
          py::arg("vector"))
      .def_property_readonly(
          "parameters", [](const Camera& x) { return to_array(row_of(x)); }, "A copy of the parameters.")
      .def(
          "project",
          [](const Camera& camera, py::handle points) {
            return for_each_point(points, 2, [&](const Vector3& point, double* pixel) {
              Vector2::Map(pixel) = camera.project(point);
            });
          },
          py::arg("point"),
          "The pixel of a point (x, y, z) in the frame of the camera, or the pixels (n, 2) of points (n, 3).")
      .def(
          "sees",
          [](const Camera& camera, py::handle point) {
            return camera.sees(Vector3(vector_of<3>(point, "point", "x y z")));
          },
          py::arg("point"), "Whether the model describes the pixel of a point.");
  bind_manifold_class<Camera>(type, [](const double* row) { return V::from_row(row, {}); });
}

}  // namespace

void bind_camera(py::module_& module) {
  detail::CameraList::for_each([&]<class Camera>() { bind<Camera>(module); });
}

}  // namespace boxplus::python
