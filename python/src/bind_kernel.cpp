// SPDX-License-Identifier: BSD-3-Clause
// Robust kernels by name.
#include <memory>
#include <tuple>

#include "bind.h"
#include "boxplus/robust/default_width.h"
#include "boxplus/robust/make_robust_kernel.h"

namespace boxplus::python {

void bind_kernel(py::module_& module) {
  py::class_<RobustKernel, std::shared_ptr<RobustKernel>>(
      module, "RobustKernel", "An edge contributes ρ(e²) instead of e² = eᵀΩe, so that outliers count less.")
      .def("name", &RobustKernel::name)
      .def("delta", &RobustKernel::delta, "The width.")
      .def(
          "__call__",
          [](const RobustKernel& kernel, double e2) {
            const RobustKernel::Rho rho = kernel(e2);
            return std::tuple(rho.value, rho.first, rho.second);
          },
          py::arg("e2"), "(ρ, ρ′, ρ″) of the squared error.")
      .def("__repr__", [](const RobustKernel& kernel) {
        return py::str("make_robust_kernel('{}', {})").format(kernel.name(), kernel.delta());
      });
  module.def(
      "make_robust_kernel",
      [](std::string_view name, double delta) {
        return std::shared_ptr<RobustKernel>(make_robust_kernel(name, delta));
      },
      py::arg("name"), py::arg("delta"), "The kernel with this name (\"Huber\") and width.");
  module.def(
      "make_default_kernel",
      [](std::string_view name, int rows) {
        return std::shared_ptr<RobustKernel>(make_default_kernel(name, rows));
      },
      py::arg("name"), py::arg("rows"), "The kernel with the default width for errors of `rows` rows.");
  module.def("default_width", &default_width, py::arg("rows"),
             "The width below which 95 % of inliers with `rows` rows have their whitened error.");
}

}  // namespace boxplus::python
