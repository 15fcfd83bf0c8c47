// SPDX-License-Identifier: BSD-3-Clause
// What the module _boxplus knows of a viewer. The viewer itself is in the module _viewer, which view()
// imports: so boxplus can be imported without the libraries of the server.
#pragma once

#include <memory>
#include <string>

#include "boxplus/viewer/viewer.h"

namespace boxplus::python {

/// The functions of boxplus::Viewer. Call them without Python's lock (GIL): they wait for other threads,
/// which may call error functions of Python.
class ViewerInterface {
 public:
  virtual ~ViewerInterface() = default;
  virtual std::string url() const = 0;
  virtual Options watch(Options options) = 0;
  virtual void show(const Report& report) = 0;
  virtual void show(const OutlierReport& found) = 0;
  virtual void update() = 0;
  virtual void follow() = 0;
  virtual void hand_over() = 0;
  virtual void take_back() = 0;
};

/// The attribute `factory` of the module _viewer is a capsule with a pointer to this.
struct ViewerFactory {
  std::unique_ptr<ViewerInterface> (*make)(Graph&, const ViewerOptions&);
};

}  // namespace boxplus::python
