// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/scene/truth.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "boxplus/base/error.h"
#include "boxplus/manifold/se2.h"

namespace boxplus::viewer {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

/// The truth is the graph after a rotation by 90° and a translation by (100, 200).
constexpr const char* kGraph =
    "VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 2 0 0\nVERTEX_SE2 2 2 3 1\nVERTEX_XY 5 1 1\nVERTEX_XY 6 1 1\n";
constexpr const char* kTruth =
    "VERTEX_SE2 0 100 200 1.5707963267948966\nVERTEX_SE2 1 100 202 1.5707963267948966\n"
    "VERTEX_SE2 2 97 202 2.5707963267948966\nVERTEX_XY 5 98 201\n";

class TruthOfGraph : public testing::Test {
 protected:
  TruthOfGraph() { truth_.match(file_.graph, &file_, "graph.g2o"); }

  /// The truth of a vertex of the structure, moved onto the positions of a frame.
  std::array<double, 3> moved(const TruthPlaces& places, const TruthFit& fit, std::size_t vertex) const {
    std::array<double, 3> result = fit.translation;
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t column = 0; column < 3; ++column)
        result[row] += fit.rotation[3 * row + column] * places[3 * vertex + column];
      result[row] += structure_.center[row];
    }
    return result;
  }

  GraphFile file_ = parse_graph(kGraph, "graph.g2o");
  Structure structure_ = make_structure(file_.graph);
  Truth truth_ = parse_truth("truth.g2o", kTruth);
};

TEST_F(TruthOfGraph, IsMovedOntoTheEstimates) {
  const TruthPlaces places = truth_.place(file_.graph, structure_);
  const std::optional<TruthFit> fit = truth_.fit(file_.graph, structure_);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->ate, 0, 1e-12);
  EXPECT_NEAR(fit->rpe_translation, 0, 1e-12);
  EXPECT_EQ(fit->motions, 2U);
  // The structure has poses before points.
  const double expected[4][2] = {{0, 0}, {2, 0}, {2, 3}, {1, 2}};
  for (std::size_t vertex = 0; vertex < 4; ++vertex) {
    const std::array<double, 3> place = moved(places, *fit, vertex);
    EXPECT_NEAR(place[0], expected[vertex][0], 1e-5) << vertex;
    EXPECT_NEAR(place[1], expected[vertex][1], 1e-5) << vertex;
  }
  ASSERT_EQ(places.size(), 15U);
  EXPECT_TRUE(std::isnan(places[12]));  // vertex 6
}

TEST_F(TruthOfGraph, IsNotComparedWithEstimatesThatAreNotFinite) {
  truth_.place(file_.graph, structure_);
  const auto vertex = file_.graph.vertex<SE2>(1);
  file_.graph.set_estimate(vertex, SE2(std::numeric_limits<double>::quiet_NaN(), 0, 0));
  EXPECT_FALSE(truth_.fit(file_.graph, structure_));
}

TEST_F(TruthOfGraph, ForgetsVerticesThatTheGraphHasLost) {
  file_.graph.remove(*file_.graph.find_vertex(1));
  structure_ = make_structure(file_.graph);
  EXPECT_EQ(truth_.place(file_.graph, structure_).size(), 12U);
  EXPECT_EQ(truth_.fit(file_.graph, structure_)->motions, 1U);
  for (const Id id : {0, 2}) file_.graph.remove(*file_.graph.find_vertex(id));
  structure_ = make_structure(file_.graph);
  truth_.place(file_.graph, structure_);
  EXPECT_FALSE(truth_.fit(file_.graph, structure_));
}

TEST(Truth, OfAnotherDimensionIsRefusedWithTheNamesOfBothFiles) {
  const GraphFile file = parse_graph(kGraph, "graph.g2o");
  Truth truth = parse_truth("space.g2o", "VERTEX_SE3:QUAT 0 0 0 0 0 0 0 1\n");
  EXPECT_THAT([&] { truth.match(file.graph, &file, "graph.g2o"); },
              ThrowsMessage<FileError>(HasSubstr(
                  "space.g2o: expected a truth for graph.g2o, which has poses in the plane, but it has poses "
                  "in space")));
}

TEST(Truth, OfAGraphWithoutACommonPoseIsRefused) {
  const GraphFile file = parse_graph(kGraph, "graph.g2o");
  Truth truth = parse_truth("truth.g2o", "VERTEX_SE2 9 0 0 0\nVERTEX_XY 5 1 1\n");
  EXPECT_THAT([&] { truth.match(file.graph, &file, "graph.g2o"); },
              ThrowsMessage<FileError>(
                  HasSubstr("truth.g2o: expected poses that match graph.g2o by id, found none")));
}

}  // namespace
}  // namespace boxplus::viewer
