// SPDX-License-Identifier: BSD-3-Clause
// Client edges that weight their terms of H and b themselves.
#include "g2o/core/base_fixed_sized_edge.h"

#include <gtest/gtest.h>

#include "g2o/core/base_vertex.h"
#include "g2o/types/edge_checks.h"

namespace {

template <int D>
class Numbers : public g2o::BaseVertex<D, g2o::VectorN<D>> {
 public:
  void setToOriginImpl() override { this->_estimate.setZero(); }
  void oplusImpl(const double* step) override { this->_estimate += Eigen::Map<const g2o::VectorN<D>>(step); }
  bool read(std::istream&) override { return false; }
  bool write(std::ostream&) const override { return false; }
};

/// An edge whose information matrix is scaled by a weight when the edge adds its terms to H and b.
class WeightedEdge : public g2o::BaseFixedSizedEdge<2, g2o::Vector2, Numbers<2>, Numbers<1>, Numbers<3>> {
 public:
  void computeError() override {
    const g2o::Vector2& x = vertexXn<0>()->estimate();
    const double scale = vertexXn<1>()->estimate()[0];
    const g2o::Vector3& y = vertexXn<2>()->estimate();
    _error = scale * x + g2o::Vector2(y[0] * y[1], y[2]) - _measurement;
  }
  void constructQuadraticForm() override {
    constructQuadraticFormNs(weight * _information, weight * (_information * -_error),
                             std::make_index_sequence<_nr_of_vertices>());
  }
  bool read(std::istream&) override { return false; }
  bool write(std::ostream&) const override { return false; }

  double weight = 1;
};

class ClientWeights : public testing::Test {
 protected:
  void SetUp() override {
    a.setEstimate({1, -2});
    b.setEstimate(g2o::VectorN<1>(1.5));
    c.setEstimate({0.3, -0.7, 2});
    edge.setVertex(0, &a);
    edge.setVertex(1, &b);
    edge.setVertex(2, &c);
    edge.setMeasurement({0.1, 0.2});
    g2o::Matrix2 omega;
    omega << 3, 1, 1, 2;
    edge.setInformation(omega);
  }
  Numbers<2> a;
  Numbers<1> b;
  Numbers<3> c;
  WeightedEdge edge;
};

TEST_F(ClientWeights, TheTermsOfAllVerticesCanBeAddedByOneCall) {
  for (const bool transposed : {false, true}) {
    for (size_t fixed = 0; fixed <= 3; ++fixed) edge_checks::expect_quadratic_form(edge, transposed, fixed);
  }
}

TEST_F(ClientWeights, ScaleTheTerms) {
  g2o::MatrixX H[2], Hs(2, 2);
  g2o::VectorX rhs[2];
  for (const int i : {0, 1}) {
    edge.weight = i == 0 ? 1 : 0.25;
    g2o::JacobianWorkspace workspace;
    workspace.updateSize(&edge);
    ASSERT_TRUE(workspace.allocate());
    Hs.setZero();
    a.mapHessianMemory(Hs.data());
    a.clearQuadraticForm();
    edge.computeError();
    edge.linearizeOplus(workspace);
    edge.constructQuadraticForm();
    H[i] = Hs;
    rhs[i] = Eigen::Map<const g2o::VectorX>(a.bData(), 2);
  }
  EXPECT_GT(H[0].norm(), 1);
  EXPECT_LT((H[1] - 0.25 * H[0]).norm(), 1e-12);
  EXPECT_LT((rhs[1] - 0.25 * rhs[0]).norm(), 1e-12);
}

}  // namespace
