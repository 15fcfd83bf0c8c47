// SPDX-License-Identifier: BSD-3-Clause
// Ω from standard deviations. Python takes every Ω as a number or an array.
#include "bind.h"
#include "boxplus/graph/information.h"
#include "convert.h"

namespace boxplus::python {
namespace {

Numbers se3_sigmas(py::handle translation, py::handle rotation) {
  const Information omega =
      Information::se3_sigmas(read_number(translation, "translation"), read_number(rotation, "rotation"));
  return to_array(Information::View{omega.kind(), omega.rows(), omega.values().data()}.matrix());
}

}  // namespace

void bind_information(py::module_& module) {
  module.def(
      "se3_sigmas", &se3_sigmas, py::arg("translation"), py::arg("rotation"),
      "se3_sigmas(0.1, 0.01): Ω, an array (6, 6), of an error with the tangent of SE3, such as that of "
      "Between "
      "and Prior, from the standard deviations of each coordinate of the translation (meters) and of the "
      "rotation around each axis (radians). The last three rows of the error measure half the angle, so "
      "their "
      "information is 4/σ².");
}

}  // namespace boxplus::python
