// SPDX-License-Identifier: BSD-3-Clause
#include "edge_function.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace boxplus::python {
namespace {

using detail::JacobianSource;

py::module_ helpers() {
  return py::module_::import("boxplus._batched");
}

std::size_t count_of(const Batch& batch) {
  return static_cast<std::size_t>(batch.estimates.front().shape(0));
}

py::tuple arguments_of(const Batch& batch) {
  py::tuple arguments(batch.estimates.size() + (batch.has_measurements ? 1 : 0));
  std::size_t i = 0;
  for (const Numbers& rows : batch.estimates) arguments[i++] = rows;
  if (batch.has_measurements) arguments[i] = batch.measurements;
  return arguments;
}

/// seeds(i): ∂ row(x ⊞ δ) / ∂δ of argument i, as an array (n, size, dim).
py::cpp_function seeds_of(const Batch& batch, const std::vector<const VertexKind*>& kinds) {
  return py::cpp_function([&batch, &kinds](std::size_t i) {
    const VertexKind& kind = *kinds.at(i);
    const Numbers& rows = batch.estimates[i];
    Numbers seeds({rows.shape(0), py::ssize_t{kind.size}, py::ssize_t{kind.dim}});
    const auto block = static_cast<py::ssize_t>(kind.size) * kind.dim;
    for (py::ssize_t k = 0; k < rows.shape(0); ++k)
      kind.step_derivative(rows.data() + k * kind.size, seeds.mutable_data() + k * block);
    return seeds;
  });
}

/// moved(i, d, h): the rows of argument i after steps in direction d of the tangent space; h has a step per
/// row.
py::cpp_function moved_of(const Batch& batch, const std::vector<const VertexKind*>& kinds) {
  return py::cpp_function([&batch, &kinds](std::size_t i, std::size_t direction, const Numbers& steps) {
    const VertexKind& kind = *kinds.at(i);
    const Numbers& rows = batch.estimates[i];
    Numbers moved({rows.shape(0), py::ssize_t{kind.size}});
    std::vector<double> delta(static_cast<std::size_t>(kind.dim), 0.0);
    for (py::ssize_t k = 0; k < rows.shape(0); ++k) {
      delta.at(direction) = steps.at(k);
      kind.step(rows.data() + k * kind.size, delta.data(), moved.mutable_data() + k * kind.size);
    }
    return moved;
  });
}

/// objects(i, rows): the estimates of argument i as objects.
py::cpp_function objects_of(const std::vector<const VertexKind*>& kinds) {
  return py::cpp_function([&kinds](std::size_t i, const Numbers& rows) {
    const VertexKind& kind = *kinds.at(i);
    py::list objects;
    for (py::ssize_t k = 0; k < rows.shape(0); ++k)
      objects.append(kind.object_of_row(rows.data() + k * kind.size));
    return objects;
  });
}

/// Copies an array (n, rows, dim) of each argument to blocks of rows × cols.
void stack(const py::list& blocks, std::size_t count, int rows, const std::vector<const VertexKind*>& kinds,
           std::vector<double>& out) {
  int cols = 0;
  for (const VertexKind* kind : kinds) cols += kind->dim;
  out.resize(count * static_cast<std::size_t>(rows * cols));
  int first = 0;
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    const auto block = blocks[i].cast<Numbers>();
    const int dim = kinds[i]->dim;
    const double* value = block.data();
    for (std::size_t k = 0; k < count; ++k) {
      double* jacobian = out.data() + k * static_cast<std::size_t>(rows * cols);
      for (int r = 0; r < rows; ++r) {
        for (int d = 0; d < dim; ++d) jacobian[(first + d) * rows + r] = *value++;
      }
    }
    first += dim;
  }
}

}  // namespace

EdgeFunction::EdgeFunction(py::handle edge, std::vector<const VertexKind*> kinds) : kinds_(std::move(kinds)) {
  const py::tuple facts = helpers().attr("describe")(edge);
  name_ = facts[0].cast<std::string>();
  source_ = facts[1].cast<bool>()   ? JacobianSource::kAnalytic
            : facts[2].cast<bool>() ? JacobianSource::kAutomatic
                                    : JacobianSource::kNumeric;
}

BatchResult EdgeFunction::operator()(py::handle edge, const Batch& batch, int rows, Want want) {
  const auto begin = std::chrono::steady_clock::now();
  const std::size_t count = count_of(batch);
  const py::tuple arguments = arguments_of(batch);
  py::list dims;
  for (const VertexKind* kind : kinds_) dims.append(kind->dim);
  struct Depth {
    explicit Depth(int& count) : count_(count) { ++count_; }
    ~Depth() { --count_; }
    int& count_;
  };
  const Depth depth(depth_);
  const py::tuple answer =
      helpers().attr("evaluate")(edge, arguments, dims, rows, static_cast<int>(want), seeds_of(batch, kinds_),
                                 moved_of(batch, kinds_), objects_of(kinds_));
  const auto errors = answer[0].cast<Numbers>();
  BatchResult result;
  result.rows = static_cast<int>(errors.shape(1));
  result.errors.assign(errors.data(), errors.data() + errors.size());
  if (want != Want::kErrors) {
    stack(answer[1].cast<py::list>(), count, result.rows, kinds_, result.jacobians);
    if (want == Want::kJacobians && answer[2].cast<bool>()) source_ = JacobianSource::kNumeric;
  }
  ++calls_;
  edges_ += static_cast<std::int64_t>(count);
  seconds_ = seconds_ + std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return result;
}

}  // namespace boxplus::python
