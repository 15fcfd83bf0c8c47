// SPDX-License-Identifier: BSD-3-Clause
// Checks that every edge type and every file tag must pass.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "g2o/core/base_edge.h"
#include "g2o/core/factory.h"
#include "g2o/core/sparse_optimizer.h"

namespace edge_checks {

inline g2o::OptimizableGraph::Vertex& vertex(g2o::OptimizableGraph::Edge& e, size_t i) {
  return *static_cast<g2o::OptimizableGraph::Vertex*>(e.vertices()[i]);
}

inline double error_norm(g2o::OptimizableGraph::Edge& e) {
  e.computeError();
  return Eigen::Map<const g2o::VectorX>(e.errorData(), e.dimension()).norm();
}

/// Checks that the Jacobians that linearizeOplus() computes match central differences.
inline void expect_exact_jacobians(g2o::OptimizableGraph::Edge& e) {
  g2o::JacobianWorkspace workspace;
  workspace.updateSize(&e);
  ASSERT_TRUE(workspace.allocate());
  for (size_t i = 0; i < e.vertices().size(); ++i)
    std::fill_n(workspace.workspaceForVertex(static_cast<int>(i)), e.dimension() * vertex(e, i).dimension(),
                77.);
  e.computeError();
  e.linearizeOplus(workspace);
  for (size_t i = 0; i < e.vertices().size(); ++i) {
    g2o::MatrixX numeric(e.dimension(), vertex(e, i).dimension());
    g2o::internal::numericJacobian(e, vertex(e, i), numeric.data());
    const Eigen::Map<const g2o::MatrixX> filled(workspace.workspaceForVertex(static_cast<int>(i)),
                                                numeric.rows(), numeric.cols());
    EXPECT_LT((filled - numeric).cwiseAbs().maxCoeff(), 1e-7 * std::max(1., numeric.cwiseAbs().maxCoeff()))
        << "vertex " << i << "\n"
        << filled << "\n\nnumeric\n"
        << numeric;
  }
}

/// Checks that constructQuadraticForm() adds JᵀΩJ to the Hessian blocks and −JᵀΩe to the right-hand side. If
/// `transposed` is true, the edge must write the transposed block of each pair of vertices. `fixed` is the
/// index of the only fixed vertex, whose blocks must not change. If `fixed` is the number of vertices, no
/// vertex is fixed.
inline void expect_quadratic_form(g2o::OptimizableGraph::Edge& e, bool transposed, size_t fixed) {
  SCOPED_TRACE(testing::Message() << "transposed " << transposed << ", fixed " << fixed);
  g2o::JacobianWorkspace workspace;
  workspace.updateSize(&e);
  ASSERT_TRUE(workspace.allocate());
  const size_t n = e.vertices().size();
  std::vector<g2o::MatrixX> diagonal(n), pairs;
  for (size_t i = 0; i < n; ++i) {
    const int dim = vertex(e, i).dimension();
    vertex(e, i).setFixed(i == fixed);
    diagonal[i] = g2o::MatrixX::Constant(dim, dim, 3);
    vertex(e, i).mapHessianMemory(diagonal[i].data());
    vertex(e, i).clearQuadraticForm();
    diagonal[i].setConstant(3);
  }
  for (size_t j = 1; j < n; ++j) {
    for (size_t i = 0; i < j; ++i) {
      const int rows = vertex(e, i).dimension(), cols = vertex(e, j).dimension();
      pairs.push_back(g2o::MatrixX::Constant(transposed ? cols : rows, transposed ? rows : cols, 5));
    }
  }
  size_t at = 0;
  for (size_t j = 1; j < n; ++j) {
    for (size_t i = 0; i < j; ++i)
      e.mapHessianMemory(pairs[at++].data(), static_cast<int>(i), static_cast<int>(j), transposed);
  }
  e.computeError();
  e.linearizeOplus(workspace);
  e.constructQuadraticForm();
  const int rows = e.dimension();
  const Eigen::Map<const g2o::MatrixX> omega(e.informationData(), rows, rows);
  const Eigen::Map<const g2o::VectorX> error(e.errorData(), rows);
  const auto jacobian = [&](size_t i) -> g2o::MatrixX {
    const int cols = vertex(e, i).dimension();
    if (i == fixed) return g2o::MatrixX::Zero(rows, cols);
    return Eigen::Map<const g2o::MatrixX>(workspace.workspaceForVertex(static_cast<int>(i)), rows, cols);
  };
  const auto expect_sum = [](const g2o::MatrixX& sum, double before, const g2o::MatrixX& added) {
    EXPECT_LE(((sum.array() - before).matrix() - added).norm(), 1e-13 * (before + added.norm())) << sum;
  };
  at = 0;
  for (size_t j = 0; j < n; ++j) {
    const g2o::MatrixX J = jacobian(j);
    expect_sum(diagonal[j], 3, J.transpose() * omega * J);
    const Eigen::Map<const g2o::VectorX> b(vertex(e, j).bData(), J.cols());
    expect_sum(b, 0, -J.transpose() * omega * error);
    for (size_t i = 0; i < j; ++i, ++at) {
      const g2o::MatrixX shared = jacobian(i).transpose() * omega * J;
      expect_sum(transposed ? g2o::MatrixX(pairs[at].transpose()) : pairs[at], 5, shared);
    }
  }
  for (size_t j = 0; j < n; ++j) {
    vertex(e, j).setFixed(false);
    vertex(e, j).mapHessianMemory(nullptr);
    for (size_t i = 0; i < j; ++i)
      e.mapHessianMemory(nullptr, static_cast<int>(i), static_cast<int>(j), false);
  }
}

/// Checks that the error stays the same if the measurement is set to its current value, and that the error is
/// zero if the measurement is computed from the estimates.
inline void expect_measurement_laws(g2o::OptimizableGraph::Edge& e) {
  const double before = error_norm(e);
  if (e.measurementDimension() > 0) {
    std::vector<double> data(static_cast<size_t>(e.measurementDimension()));
    ASSERT_TRUE(e.getMeasurementData(data.data()));
    ASSERT_TRUE(e.setMeasurementData(data.data()));
    EXPECT_NEAR(error_norm(e), before, 1e-12 * std::max(1., before));
  }
  if (e.setMeasurementFromState()) {
    EXPECT_LT(error_norm(e), 1e-12);
  }
}

/// Checks initialEstimate(): if an edge can compute the estimate of a vertex from its other vertices, the
/// error of the edge is zero afterwards.
inline void expect_guesses(g2o::OptimizableGraph::Edge& e) {
  for (size_t i = 0; i < e.vertices().size(); ++i) {
    g2o::OptimizableGraph::VertexSet from(e.vertices().begin(), e.vertices().end());
    from.erase(e.vertices()[i]);
    if (e.initialEstimatePossible(from, &vertex(e, i)) <= 0) continue;
    vertex(e, i).push();
    vertex(e, i).oplus(std::vector<double>(static_cast<size_t>(vertex(e, i).dimension()), 0.1).data());
    e.initialEstimate(from, &vertex(e, i));
    EXPECT_LT(error_norm(e), 1e-12) << "vertex " << i;
    vertex(e, i).pop();
  }
}

/// Checks that both texts have the same words. Numbers may differ by rounding errors.
inline void expect_same_words(const std::string& expected, const std::string& actual) {
  std::istringstream a(expected), b(actual);
  for (std::string x, y; a >> x;) {
    ASSERT_TRUE(b >> y) << "the text ends before " << x << " of\n" << expected;
    if (x == y) continue;
    char *end_x = nullptr, *end_y = nullptr;
    const double p = std::strtod(x.c_str(), &end_x), q = std::strtod(y.c_str(), &end_y);
    ASSERT_TRUE(*end_x == '\0' && *end_y == '\0') << x << " became " << y;
    EXPECT_NEAR(p, q, 1e-12 * std::max(1., std::abs(p)));
  }
  std::string rest;
  EXPECT_FALSE(b >> rest) << "unexpected: " << rest;
}

/// Loads a graph from text and checks that no message is logged.
inline void load(g2o::SparseOptimizer& optimizer, const std::string& text) {
  std::string messages;
  g2o::logging::setSink([&](g2o::logging::Level, const std::string& message) { messages += message + "\n"; });
  std::istringstream in(text);
  EXPECT_TRUE(optimizer.load(in));
  g2o::logging::setSink({});
  ASSERT_EQ(messages, "");
}

/// Loads a graph whose lines are in the order in which save() writes them. Checks that save() writes the same
/// text again, that all edges pass the checks above, and that the estimate of each vertex stays the same if
/// it is read as an array and set from this array.
inline void expect_laws_of_file(const std::string& text) {
  g2o::SparseOptimizer optimizer;
  ASSERT_NO_FATAL_FAILURE(load(optimizer, text));
  std::ostringstream out;
  ASSERT_TRUE(optimizer.save(out));
  expect_same_words(text, out.str());
  for (g2o::HyperGraph::Edge* u : optimizer.edges()) {
    auto& e = *static_cast<g2o::OptimizableGraph::Edge*>(u);
    SCOPED_TRACE(g2o::Factory::instance()->tag(&e));
    EXPECT_GT(error_norm(e), 1e-3)
        << "the error must not be zero, because a zero error would hide wrong signs";
    expect_exact_jacobians(e);
    for (size_t fixed = 0; fixed <= e.vertices().size(); ++fixed) {
      expect_quadratic_form(e, false, fixed);
      expect_quadratic_form(e, true, fixed);
      if (e.dimension() == 1) continue;
      double& lower = e.informationData()[1];
      const double before = std::exchange(lower, lower + 0.25);  // Ω is deliberately not symmetric
      expect_quadratic_form(e, false, fixed);
      lower = before;
    }
    expect_measurement_laws(e);
    expect_guesses(e);
  }
  for (const auto& [id, v] : optimizer.vertices()) {
    auto& vertex = *static_cast<g2o::OptimizableGraph::Vertex*>(v);
    SCOPED_TRACE(g2o::Factory::instance()->tag(&vertex));
    std::vector<double> data;
    if (!vertex.getEstimateData(data)) continue;
    std::ostringstream before, after;
    vertex.write(before);
    vertex.setToOrigin();
    ASSERT_TRUE(vertex.setEstimateData(data));
    vertex.write(after);
    expect_same_words(before.str(), after.str());
    if (!vertex.getMinimalEstimateData(data)) continue;
    ASSERT_TRUE(vertex.setMinimalEstimateData(data));
    std::ostringstream minimal;
    vertex.write(minimal);
    expect_same_words(before.str(), minimal.str());
  }
}

/// Loads a graph with one edge for each tag, and compares the error of each edge with the expected error for
/// its tag.
inline void expect_errors(const std::string& text,
                          const std::map<std::string, std::vector<double>>& expected) {
  g2o::SparseOptimizer optimizer;
  ASSERT_NO_FATAL_FAILURE(load(optimizer, text));
  EXPECT_EQ(optimizer.edges().size(), expected.size());
  for (g2o::HyperGraph::Edge* u : optimizer.edges()) {
    auto& e = *static_cast<g2o::OptimizableGraph::Edge*>(u);
    const std::string& word = g2o::Factory::instance()->tag(&e);
    SCOPED_TRACE(word);
    const std::vector<double>& error = expected.at(word);
    ASSERT_EQ(static_cast<size_t>(e.dimension()), error.size());
    e.computeError();
    for (size_t i = 0; i < error.size(); ++i) EXPECT_NEAR(e.errorData()[i], error[i], 1e-12) << "row " << i;
  }
}

/// The information matrix 2 I in the format of .g2o files: the upper triangle, row by row.
inline std::string omega(int rows) {
  std::string text;
  for (int i = 0; i < rows; ++i) {
    for (int j = i; j < rows; ++j) text += i == j ? " 2" : " 0";
  }
  return text;
}

}  // namespace edge_checks
