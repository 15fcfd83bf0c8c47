// SPDX-License-Identifier: BSD-3-Clause
// The class _Viewer, on which boxplus.Viewer (python/boxplus/_view.py) is written.
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "bind.h"
#include "convert.h"
#include "edge_function.h"
#include "viewer_interface.h"

namespace boxplus::python {
namespace {

const ViewerFactory& viewer_factory() {
  const auto factory = py::module_::import("boxplus._viewer").attr("factory").cast<py::capsule>();
  return *factory.get_pointer<const ViewerFactory>();
}

/// Ends a viewer. Its threads may have to call error functions of Python before they end, so the caller must
/// not keep Python's lock (GIL).
struct End {
  void operator()(ViewerInterface* viewer) const {
    std::optional<py::gil_scoped_release> release;
    if (PyGILState_Check() != 0) release.emplace();
    delete viewer;
  }
};

/// A viewer and its graph. Each function is called with Python's lock (GIL), and releases it.
class ViewerObject {
 public:
  ViewerObject(std::shared_ptr<GraphObject> graph, const ViewerOptions& options) : graph_(std::move(graph)) {
    const ViewerFactory& factory = viewer_factory();
    GraphObject::Run run(*graph_);
    {
      const py::gil_scoped_release release;
      viewer_ = std::shared_ptr<ViewerInterface>(factory.make(run.graph(), options).release(), End());
    }
    url_ = viewer_->url();
    graph_->add_viewer(viewer_);
  }
  ~ViewerObject() {
    std::exchange(viewer_, nullptr).reset();
    lent_.reset();
  }
  ViewerObject(const ViewerObject&) = delete;
  ViewerObject& operator=(const ViewerObject&) = delete;

  const std::string& url() const { return url_; }
  bool is_closed() const { return viewer_ == nullptr; }

  void close() {
    expect_no_function("close");
    std::exchange(viewer_, nullptr).reset();
    lent_.reset();
  }
  /// In the child of a fork, which has none of the viewer's threads: leaves the viewer as it is.
  void forget() {
    if (viewer_) new std::shared_ptr<ViewerInterface>(std::exchange(viewer_, nullptr));
    lent_.reset();
  }
  void update() {
    const std::shared_ptr<ViewerInterface> viewer = open_viewer();
    const GraphObject::Run run(*graph_);
    const py::gil_scoped_release release;
    viewer->update();
  }
  void hand_over() {
    const std::shared_ptr<ViewerInterface> viewer = open_viewer();
    if (lent_) return;
    lent_.emplace(*graph_, GraphObject::Use::kLent);
    try {
      const py::gil_scoped_release release;
      viewer->hand_over();
    } catch (...) {
      lent_.reset();
      throw;
    }
  }
  void take_back() {
    const std::shared_ptr<ViewerInterface> viewer = open_viewer();
    if (!lent_) return;
    expect_no_function("take_back");
    {
      const py::gil_scoped_release release;
      viewer->take_back();
    }
    lent_.reset();
  }

 private:
  /// A run of a page cannot end while it waits for its own error function.
  void expect_no_function(const char* name) const {
    if (lent_ && EdgeFunction::is_called())
      throw InvalidArgument(std::string("Viewer: an error function cannot call ") + name +
                            "() while pages may optimize the graph");
  }
  std::shared_ptr<ViewerInterface> open_viewer() const {
    if (!viewer_) throw InvalidArgument("Viewer: this viewer is closed");
    return viewer_;
  }

  std::shared_ptr<GraphObject> graph_;
  std::shared_ptr<ViewerInterface> viewer_;  // null: closed
  std::optional<GraphObject::Run> lent_;     // while pages may change the graph
  std::string url_;
};

std::unique_ptr<ViewerObject> open(std::shared_ptr<GraphObject> graph, const std::string& name,
                                   const std::string& host, py::handle port) {
  const int number = read_int(port, "port");
  if (number < 0 || number > 65535) throw_value_error("port", "a port from 0 to 65535", port);
  if (host.empty() || host.find('\0') != std::string::npos)
    throw_value_error("host", "an address", py::str(host));
  return std::make_unique<ViewerObject>(std::move(graph),
                                        ViewerOptions{.name = name, .host = host, .port = number});
}

}  // namespace

void bind_viewer(py::module_& module) {
  py::class_<ViewerObject>(module, "_Viewer", "The native part of boxplus.Viewer.")
      .def(py::init(&open), py::arg("graph").none(false), py::arg("name"), py::arg("host"), py::arg("port"))
      .def("url", &ViewerObject::url)
      .def("is_closed", &ViewerObject::is_closed)
      .def("close", &ViewerObject::close)
      .def("forget", &ViewerObject::forget)
      .def("update", &ViewerObject::update)
      .def("hand_over", &ViewerObject::hand_over)
      .def("take_back", &ViewerObject::take_back);
}

}  // namespace boxplus::python
