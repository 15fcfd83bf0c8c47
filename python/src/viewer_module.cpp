// SPDX-License-Identifier: BSD-3-Clause
// The extension module boxplus._viewer: it makes viewers for _boxplus (bind_viewer.cpp).
#include <pybind11/pybind11.h>

#include <utility>

#include "viewer_interface.h"

namespace boxplus::python {
namespace {

class NativeViewer final : public ViewerInterface {
 public:
  NativeViewer(Graph& graph, const ViewerOptions& options) : viewer_(graph, options) {}
  std::string url() const override { return viewer_.url(); }
  Options watch(Options options) override { return viewer_.watch(std::move(options)); }
  void show(const Report& report) override { viewer_.show(report); }
  void show(const OutlierReport& found) override { viewer_.show(found); }
  void update() override { viewer_.update(); }
  void follow() override { viewer_.follow(); }
  void hand_over() override { viewer_.hand_over(); }
  void take_back() override { viewer_.take_back(); }

 private:
  Viewer viewer_;
};

constexpr ViewerFactory kFactory{
    [](Graph& graph, const ViewerOptions& options) -> std::unique_ptr<ViewerInterface> {
      return std::make_unique<NativeViewer>(graph, options);
    }};

}  // namespace
}  // namespace boxplus::python

PYBIND11_MODULE(_viewer, module) {
  module.attr("factory") = pybind11::capsule(&boxplus::python::kFactory);
}
