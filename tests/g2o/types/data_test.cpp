// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "g2o/core/factory.h"
#include "g2o/core/sparse_optimizer.h"
#include "g2o/stuff/logger.h"
#include "g2o/types/data/types_data.h"
#include "g2o/types/slam2d/types_slam2d.h"

G2O_USE_TYPE_GROUP(slam2d);
G2O_USE_TYPE_GROUP(data);

namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr double kPi = 3.141592653589793;

/// Numbers that a float cannot hold, and angles beyond π.
constexpr const char* kLaser =
    "ROBOTLASER1 2 -1.5 3 1.5 10.1 0.01 1 3 1.1 10.1 4.2 2 0.1 7 2.1 3.3 7.1 2.3 3.1 -9.3 0.5 -0.1 0.3 0.2 "
    "1e+30 "
    "1234567890.123 robot-7 0.7\n";
constexpr const char* kRaw = "RAWLASER1 0 0 1 0.5 80 0.1 0 2 1 2 0 5.5 robot-7 6.5\n";
constexpr const char* kTag = "VERTEX_TAG kitchen 0.1 0.2 0.3 1.1 2.2 7.3 5.5 robot-7 6.5\n";
constexpr const char* kEllipse = "VERTEX_ELLIPSE 0.1 0.02 0.03 0.4 0.05 0.6 2 1.1 2.2 3.3 4.4\n";

std::string saved(const g2o::SparseOptimizer& graph) {
  std::ostringstream out;
  EXPECT_TRUE(graph.save(out));
  return out.str();
}

bool load(g2o::SparseOptimizer& graph, const std::string& text) {
  std::istringstream in(text);
  return graph.load(in);
}

/// The error messages while this object exists.
class Errors {
 public:
  Errors() {
    g2o::logging::setSink([this](g2o::logging::Level, const std::string& text) { text_ += text + '\n'; });
  }
  ~Errors() { g2o::logging::setSink({}); }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

class Sample : public g2o::RobotData {
 public:
  explicit Sample(double time) { setTimestamp(time); }
  bool read(std::istream&) override { return false; }
  bool write(std::ostream&) const override { return false; }
};

TEST(Data, FollowsItsVertexInFilesAndKeepsItsOrderAndItsNumbers) {
  const std::string text = std::string("VERTEX_SE2 0 0 0 0\n") + kLaser + kTag + kEllipse + "FIX 0\n" +
                           "VERTEX_SE2 1 1 0 0\n" + kRaw + "EDGE_SE2 0 1 1 0 0 1 0 0 1 0 1\n" + kTag;
  g2o::SparseOptimizer graph;
  ASSERT_TRUE(load(graph, text));
  EXPECT_EQ(saved(graph), text);
  const g2o::HyperGraph::Data* data = graph.vertex(0)->userData();
  EXPECT_NE(dynamic_cast<const g2o::RobotLaser*>(data), nullptr);
  EXPECT_NE(dynamic_cast<const g2o::VertexTag*>(data->next()), nullptr);
  EXPECT_NE(dynamic_cast<const g2o::VertexEllipse*>(data->next()->next()), nullptr);
  EXPECT_EQ(data->next()->next()->next(), nullptr);
  EXPECT_EQ(data->next()->dataContainer(), graph.vertex(0));
}

TEST(Data, ThatIsMalformedIsReported) {
  const Errors errors;
  g2o::SparseOptimizer graph;
  EXPECT_FALSE(
      load(graph,
           "VERTEX_SE2 0 0 0 0\nROBOTLASER1 0 0 1 1 80 0 0 2 1 x\nVERTEX_TAG a 1e300 0 0 0 0 0 0 h 0\n"
           "ROBOTLASER1 3000000000 0 1 1 80 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 h 0\nVERTEX_ELLIPSE\n"));
  EXPECT_THAT(errors.text(), HasSubstr("line 2: ROBOTLASER1: expected a range (a finite number), got 'x'"));
  EXPECT_THAT(errors.text(), HasSubstr("line 3: VERTEX_TAG: expected a number that fits a float"));
  EXPECT_THAT(errors.text(),
              HasSubstr("line 4: ROBOTLASER1: expected a number that fits an int, got 3000000000"));
  EXPECT_THAT(errors.text(), HasSubstr("line 5: VERTEX_ELLIPSE: expected"));
  EXPECT_EQ(graph.vertex(0)->userData(), nullptr);
}

TEST(RobotLaser, IsReadBackFromItsText) {
  g2o::LaserParameters parameters(3, 4, -kPi / 2, kPi / 4, 20, 0.05, 2);
  parameters.laserPose = g2o::SE2(0.5, -0.25, 0.125);
  g2o::RobotLaser laser;
  laser.setLaserParams(parameters);
  laser.setOdomPose(g2o::SE2(1, 2, kPi / 2));
  laser.setRanges({1, 2, 3.5, 20});
  laser.setRemissions({0.5, 0.25});
  laser.setTimestamp(100);
  laser.setHostname("host");
  laser.setLoggerTimestamp(200);
  std::stringstream text;
  ASSERT_TRUE(laser.write(text));
  g2o::RobotLaser again;
  ASSERT_TRUE(again.read(text));
  EXPECT_EQ(again.ranges(), laser.ranges());
  EXPECT_EQ(again.remissions(), laser.remissions());
  EXPECT_EQ(again.laserParams().type, 3);
  EXPECT_EQ(again.laserParams().firstBeamAngle, parameters.firstBeamAngle);
  EXPECT_EQ(again.laserParams().fov, kPi);
  EXPECT_EQ(again.laserParams().angularStep, parameters.angularStep);
  EXPECT_EQ(again.laserParams().maxRange, 20);
  EXPECT_EQ(again.laserParams().accuracy, 0.05);
  EXPECT_EQ(again.laserParams().remissionMode, 2);
  EXPECT_EQ(again.odomPose().toVector(), laser.odomPose().toVector());
  EXPECT_NEAR((again.laserParams().laserPose.toVector() - parameters.laserPose.toVector()).norm(), 0, 1e-15);
  EXPECT_NEAR((again.laserPose().toVector() - g2o::Vector3(1.25, 2.5, kPi / 2 + 0.125)).norm(), 0, 1e-15);
  EXPECT_EQ(again.timestamp(), 100);
  EXPECT_EQ(again.hostname(), "host");
  EXPECT_EQ(again.loggerTimestamp(), 200);
}

TEST(RobotLaser, WritesThePoseOfTheLaserAnewIfThePoseOfTheRobotHasChanged) {
  g2o::RobotLaser laser;
  std::istringstream in("0 0 1 1 80 0 0 0 0 2 3 0 1 3 0 0 0 0 0 0 5 h 6");
  ASSERT_TRUE(laser.read(in));
  laser.setOdomPose(g2o::SE2(10, 20, 0));
  std::ostringstream out;
  ASSERT_TRUE(laser.write(out));
  EXPECT_EQ(out.str(), "0 0 1 1 80 0 0 0 0 11 20 0 10 20 0 0 0 0 0 0 5 h 6");
}

TEST(RawLaser, GivesTheEndPointsOfBeamsThatHaveHitSomething) {
  g2o::RawLaser laser;
  laser.setLaserParams(g2o::LaserParameters(3, -kPi / 2, kPi / 2, 10));
  laser.setRanges({1, 10, 4});
  const auto points = laser.cartesian();
  ASSERT_EQ(points.size(), 2);
  EXPECT_NEAR((points[0] - g2o::Vector2(0, -1)).norm(), 0, 1e-15);
  EXPECT_NEAR((points[1] - g2o::Vector2(0, 4)).norm(), 0, 1e-15);
}

TEST(RawLaser, IsNotWrittenIfItCouldNotBeRead) {
  const Errors errors;
  g2o::RawLaser laser;
  std::ostringstream out;
  laser.setHostname("two words");
  EXPECT_FALSE(laser.write(out));
  laser.setHostname("host");
  laser.setRanges({std::numeric_limits<double>::quiet_NaN()});
  EXPECT_FALSE(laser.write(out));
  EXPECT_EQ(out.str(), "");
  EXPECT_THAT(errors.text(), HasSubstr("expected finite numbers"));
}

TEST(VertexTag, WritesNewPositionsWithTheDigitsOfAFloat) {
  g2o::VertexTag tag;
  std::istringstream in("kitchen 0.123456789012 2 3 0 0 0 5 h 6");
  ASSERT_TRUE(tag.read(in));
  EXPECT_FLOAT_EQ(tag.position().x(), 0.123456789F);
  tag.setPosition(g2o::Vector3F(tag.position().x(), 0.1F, 3));
  tag.setName("hall");
  std::ostringstream out;
  ASSERT_TRUE(tag.write(out));
  EXPECT_EQ(out.str(), "hall 0.123456789012 0.1 3 0 0 0 5 h 6");
}

TEST(VertexEllipse, HasTheAxesOfItsCovariance) {
  g2o::VertexEllipse ellipse;
  g2o::Matrix3F covariance = g2o::Matrix3F::Identity();
  covariance.topLeftCorner<2, 2>() << 2.5F, 1.5F, 1.5F, 2.5F;  // variances 4 along (1, 1), and 1 across
  ellipse.setCovariance(covariance);
  EXPECT_NEAR(ellipse.singularValues()[0], 4, 1e-6);
  EXPECT_NEAR(ellipse.singularValues()[1], 1, 1e-6);
  EXPECT_NEAR(std::abs(ellipse.U().col(0).sum()), std::sqrt(2), 1e-6);
  EXPECT_NEAR(ellipse.U().col(1).sum(), 0, 1e-6);
}

TEST(VertexEllipse, KeepsItsMatchingVertices) {
  g2o::VertexEllipse ellipse;
  ellipse.addMatchingVertex(1, 2.5F);
  ellipse.addMatchingVertexID(7);
  std::stringstream text;
  ASSERT_TRUE(ellipse.write(text));
  EXPECT_EQ(text.str(), "1 0 0 1 0 1 1 1 2.5");
  EXPECT_THAT(ellipse.matchingVerticesIDs(), ElementsAre(7));
  g2o::VertexEllipse again;
  ASSERT_TRUE(again.read(text));
  EXPECT_EQ(again.matchingVertices(), ellipse.matchingVertices());
  ellipse.clearMatchingVertices();
  EXPECT_TRUE(ellipse.matchingVertices().empty());
}

TEST(DataQueue, FindsDataByItsTimestamp) {
  std::vector<Sample> samples;
  for (const double time : {4., 1., 2.}) samples.emplace_back(time);
  g2o::DataQueue queue;
  for (Sample& sample : samples) queue.add(&sample);
  const auto time_of = [](const g2o::RobotData* data) { return data == nullptr ? -1 : data->timestamp(); };
  EXPECT_EQ(queue.buffer().size(), 3);
  EXPECT_EQ(time_of(queue.lastElement()), 4);
  const double times[] = {0.5, 1, 1.4, 1.5, 2.9, 3, 3.1, 4, 9};
  const double closest[] = {1, 1, 1, 1, 2, 2, 4, 4, 4}, before[] = {-1, -1, 1, 1, 2, 2, 2, 4, 4},
               after[] = {1, 2, 2, 2, 4, 4, 4, -1, -1};
  for (size_t k = 0; k < std::size(times); ++k) {
    EXPECT_EQ(time_of(queue.findClosestData(times[k])), closest[k]) << times[k];
    EXPECT_EQ(time_of(queue.before(times[k])), before[k]) << times[k];
    EXPECT_EQ(time_of(queue.after(times[k])), after[k]) << times[k];
  }
}

TEST(DataQueue, ReplacesDataWithTheSameTimestampAndRefusesDataWithoutOne) {
  const Errors errors;
  Sample first(1), second(1), without(std::numeric_limits<double>::quiet_NaN());
  g2o::DataQueue queue;
  queue.add(&first);
  queue.add(&second);
  queue.add(&without);
  queue.add(nullptr);
  EXPECT_EQ(queue.buffer().size(), 1);
  EXPECT_EQ(queue.lastElement(), &second);
  EXPECT_EQ(queue.findClosestData(without.timestamp()), nullptr);
  EXPECT_THAT(errors.text(), HasSubstr("expected data with a timestamp"));
}

TEST(DataQueue, IsEmptyAtFirst) {
  const g2o::DataQueue queue;
  EXPECT_EQ(queue.lastElement(), nullptr);
  EXPECT_EQ(queue.findClosestData(1), nullptr);
  EXPECT_EQ(queue.before(1), nullptr);
  EXPECT_EQ(queue.after(1), nullptr);
}

}  // namespace
