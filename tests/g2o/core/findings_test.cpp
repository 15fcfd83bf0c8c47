// SPDX-License-Identifier: BSD-3-Clause
// What a failed run of a verbose optimizer says about its causes.
#include <gmock/gmock.h>

#include <iostream>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "g2o/core/factory.h"
#include "g2o/core/small_graph.h"
#include "g2o/stuff/logger.h"

G2O_USE_TYPE_GROUP(slam2d);

namespace {

using small_graph::add_motion;
using small_graph::add_pose;
using small_graph::add_square;
using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;

/// Collects the findings of runs of Gauss-Newton.
class Findings : public testing::Test {
 protected:
  void SetUp() override {
    g2o::logging::setSink([this](g2o::logging::Level, const std::string& text) {
      if (text.find("finding: ") == 0) findings_.push_back(text.substr(9));
    });
    before_ = std::cerr.rdbuf(verbose_lines_.rdbuf());
  }
  void TearDown() override {
    g2o::logging::setSink({});
    std::cerr.rdbuf(before_);
  }
  int run(bool verbose = true) {
    optimizer_.setVerbose(verbose);
    optimizer_.setAlgorithm(new g2o::OptimizationAlgorithmGaussNewton(small_graph::make_solver()));
    optimizer_.initializeOptimization();
    return optimizer_.optimize(3);
  }

  g2o::SparseOptimizer optimizer_;
  std::vector<std::string> findings_;

 private:
  std::ostringstream verbose_lines_;
  std::streambuf* before_ = nullptr;
};

TEST_F(Findings, AreNotReportedForAGraphThatIsSolved) {
  add_square(optimizer_);
  EXPECT_EQ(run(), 3);
  EXPECT_THAT(findings_, IsEmpty());
}

TEST_F(Findings, AreNotReportedUnlessTheOptimizerIsVerbose) {
  add_square(optimizer_);
  optimizer_.vertex(0)->setFixed(false);
  EXPECT_EQ(run(false), 0);
  EXPECT_THAT(findings_, IsEmpty());
}

TEST_F(Findings, NameThePartsOfAGraphThatNothingHolds) {
  add_square(optimizer_);
  add_pose(optimizer_, 7, 0, 0, 0);
  add_pose(optimizer_, 9, 1, 0, 0);
  add_motion(optimizer_, 7, 9, g2o::SE2(1, 0, 0));
  EXPECT_EQ(run(), 0);
  EXPECT_THAT(findings_, ElementsAre("parts of the graph without a fixed vertex and without an edge to a "
                                     "single vertex: 2 vertices with ids from 7 to 9"));
}

TEST_F(Findings, NameAnInformationMatrixAndItsFault) {
  add_square(optimizer_);
  add_motion(optimizer_, 1, 3, g2o::SE2(-1.2, 0.8, 3))
      ->setInformation(Eigen::Vector3d(1, -50, 1).asDiagonal());
  EXPECT_EQ(run(), 0);
  EXPECT_THAT(findings_, ElementsAre("faulty information matrices: EDGE_SE2 1 3 (indefinite, with the "
                                     "eigenvalue -50.000000)"));
}

TEST_F(Findings, NameAnErrorThatIsNotFinite) {
  add_square(optimizer_);
  add_motion(optimizer_, 1, 3, g2o::SE2(std::numeric_limits<double>::quiet_NaN(), 0, 0));
  EXPECT_EQ(run(), 0);
  EXPECT_THAT(findings_, ElementsAre("errors that are not finite: EDGE_SE2 1 3"));
}

TEST_F(Findings, NameDirectionsThatChangeNoError) {
  add_pose(optimizer_, 0, 0, 0, 0);
  auto* e = new g2o::EdgeSE2XYPrior;
  e->setVertex(0, optimizer_.vertex(0));
  e->setMeasurement({1, 2});
  e->setInformation(Eigen::Matrix2d::Identity());
  ASSERT_TRUE(optimizer_.addEdge(e));
  EXPECT_EQ(run(), 0);
  EXPECT_THAT(findings_, ElementsAre("directions that change no error: vertex 0 (2 of 3)"));
}

/// One entry of its Jacobian has the wrong sign.
class WrongEdge : public g2o::EdgeSE2 {
 public:
  void linearizeOplus() override {
    g2o::EdgeSE2::linearizeOplus();
    _jacobianOplusXj(0, 1) *= -1;
  }
};

TEST_F(Findings, NameTheEntryOfAWrongJacobian) {
  add_square(optimizer_);
  for (const int to : {2, 3}) {
    auto* e = new WrongEdge;
    e->setVertex(0, optimizer_.vertex(1));
    e->setVertex(1, optimizer_.vertex(to));
    e->setMeasurement(g2o::SE2(0, 0, 0));
    // Makes the run fail, and is not what is looked for.
    e->setInformation(Eigen::Vector3d(1, 1, to == 3 ? -50 : 1).asDiagonal());
    ASSERT_TRUE(optimizer_.addEdge(e));
  }
  EXPECT_EQ(run(), 0);
  EXPECT_THAT(findings_, Contains(testing::ContainsRegex(
                             "wrong Jacobians: .*WrongEdge.* 1 2: row 1, column 2 for vertex 2 is -1.000000, "
                             "central differences give 1.000000")));
}

TEST_F(Findings, NameThreeElementsAndCountTheOthers) {
  add_square(optimizer_);
  for (int k = 0; k < 5; ++k) add_motion(optimizer_, 1, 3, g2o::SE2(0, 0, 0), -50);
  EXPECT_EQ(run(), 0);
  EXPECT_THAT(findings_, Contains(testing::EndsWith("; EDGE_SE2 1 3 (indefinite, with the eigenvalue "
                                                    "-50.000000) and 2 more")));
}

}  // namespace
