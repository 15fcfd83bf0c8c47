// SPDX-License-Identifier: BSD-3-Clause
// The class Graph of Python: a graph, the parts of its file that a Graph does not contain, and the state of a
// run that uses it.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "boxplus/base/function_ref.h"
#include "boxplus/io/graph_file.h"

namespace boxplus::python {

namespace py = pybind11;

/// Forgets the results of the error functions of Python, which may give other results than before.
void forget_results(const Graph& graph);
/// Calls f with the reference of each pool of a graph to an error function of Python.
void for_each_error_function(const Graph& graph, detail::FunctionRef<void(py::object&)> f);

class ViewerInterface;

/// A run releases Python's lock (GIL). Other Python threads cannot touch the graph meanwhile: read() and
/// write() throw InvalidArgument. The callback of a run may read the graph and exchange kernels.
class GraphObject : public std::enable_shared_from_this<GraphObject> {
 public:
  enum class Use { kFree, kRun, kCallback, kLent };

  GraphObject() = default;
  explicit GraphObject(GraphFile file) : file_(std::move(file)) {}
  /// A deep copy. Throws InvalidArgument if `other` is in a run.
  GraphObject(const GraphObject& other) : enable_shared_from_this(), file_(other.file()) {}
  GraphObject& operator=(const GraphObject&) = delete;

  const Graph& read() const { return file().graph; }
  Graph& write() {
    require(use_ == Use::kFree);
    require_no_readers();
    return file_.graph;
  }
  /// For changes that the callback of a run may make, too: kernels.
  Graph& write_kernels() {
    require(is_readable());
    require_no_readers();
    return file_.graph;
  }
  const GraphFile& file() const {
    require(is_readable());
    return file_;
  }

  /// For the garbage collector: calls f with each error function. It must not see those of a graph that runs,
  /// or that something else than its object of Python keeps.
  template <class Function>
  void for_each_reference(const Function& f) {
    if (use_ == Use::kFree && weak_from_this().use_count() == 1) for_each_error_function(file_.graph, f);
  }

  void add_viewer(const std::shared_ptr<ViewerInterface>& viewer) {
    std::erase_if(viewers_, [](const auto& other) { return other.expired(); });
    viewers_.push_back(viewer);
  }
  /// The viewers that are open.
  std::vector<std::shared_ptr<ViewerInterface>> viewers() const {
    std::vector<std::shared_ptr<ViewerInterface>> open;
    for (const auto& viewer : viewers_) {
      if (auto shared = viewer.lock()) open.push_back(std::move(shared));
    }
    return open;
  }

  /// Destroys a thing that changes the graph in its destructor: now, or at the end of the run.
  void destroy(std::shared_ptr<void> thing) {
    if (use_ != Use::kFree) destroyed_later_.push_back(std::move(thing));
  }

  /// While it exists, nobody may change the graph. For functions that evaluate edges, because error functions
  /// of Python could change it.
  class Reading {
   public:
    explicit Reading(const GraphObject& graph) : graph_(&graph) { ++graph.readers_; }
    ~Reading() { --graph_->readers_; }
    Reading(const Reading&) = delete;
    Reading& operator=(const Reading&) = delete;

   private:
    const GraphObject* graph_;
  };

  /// Begins a run, and ends it when it is destroyed. Only a thread that has the GIL may begin and end runs.
  /// While the pages of a viewer may change the graph, the use is kLent.
  class Run {
   public:
    explicit Run(GraphObject& graph, Use use = Use::kRun) : graph_(&graph), native_(&graph.write()) {
      graph.use_ = use;
      forget_results(*native_);
    }
    ~Run() {
      graph_->use_ = Use::kFree;
      graph_->destroyed_later_.clear();
    }
    Run(const Run&) = delete;
    Run& operator=(const Run&) = delete;
    Graph& graph() { return *native_; }
    /// Called at the beginning and at the end of the callback.
    void set_in_callback(bool is_in_callback) { graph_->use_ = is_in_callback ? Use::kCallback : Use::kRun; }

   private:
    GraphObject* graph_;
    Graph* native_;
  };

 private:
  bool is_readable() const { return use_ == Use::kFree || use_ == Use::kCallback; }
  void require(bool allowed) const {
    if (allowed) return;
    if (use_ == Use::kLent)
      throw InvalidArgument("Graph: the pages of a viewer may change this graph; call its take_back() first");
    throw InvalidArgument(
        "Graph: this graph is being optimized; until the run ends, only its callback may read the graph or "
        "set kernels");
  }

  void require_no_readers() const {
    if (readers_ > 0)
      throw InvalidArgument("Graph: an error function of this graph is being called, so it must not change");
  }

  GraphFile file_;
  std::vector<std::weak_ptr<ViewerInterface>> viewers_;
  std::vector<std::shared_ptr<void>> destroyed_later_;
  Use use_ = Use::kFree;
  mutable int readers_ = 0;  // only threads with the GIL change it
};

/// The vertex with that id, or the vertex of a VertexRef. Throws InvalidArgument if there is no such vertex,
/// and TypeError if the object is neither of the two.
VertexRef vertex_of(const Graph& graph, py::handle vertex, std::string_view name);
/// The vertices of a sequence.
std::vector<VertexRef> vertices_of(const Graph& graph, py::handle vertices, std::string_view name);
/// An EdgeRef.
EdgeRef edge_of(py::handle edge, std::string_view name);

}  // namespace boxplus::python
