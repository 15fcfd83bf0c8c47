// SPDX-License-Identifier: BSD-3-Clause
// The covariances of a fixed lag say how large its errors are: over many runs, the mean of the normalized
// errors squared is within its 95 % bounds (Bar-Shalom, Li and Kirubarajan, "Estimation with applications to
// tracking and navigation", 2001, chapter 5.4).
#include <gtest/gtest.h>

#include <cmath>
#include <unordered_map>

#include "boxplus/testing/simulate_inertial.h"
#include "boxplus/types/inertial.h"
#include "boxplus/types/slam3d.h"
#include "incremental/road.h"
#include "sanitized.h"
#include "testing/random_numbers.h"

namespace boxplus {
namespace {

constexpr int kRuns = kSanitized ? 5 : 20;

/// The sum of `count` normalized errors squared has a χ² distribution, which is nearly normal.
void expect_consistent(double sum, int count, int dim, const char* what) {
  const double freedom = dim * count, spread = 1.96 * std::sqrt(2 * freedom);
  EXPECT_GT(sum, freedom - spread) << what << ": " << sum / count;
  EXPECT_LT(sum, freedom + spread) << what << ": " << sum / count;
}

TEST(SmootherConsistency, HoldsOnARoadWithLandmarks) {
  double sum = 0;
  for (unsigned seed = 1; seed <= kRuns; ++seed) {
    Road road(seed, 20);
    for (int k = 0; k < 150; ++k) ASSERT_TRUE(road.step().converged());
    sum += road.nees_of_pose();
  }
  expect_consistent(sum, kRuns, 3, "pose");
}

/// A body that flies with an IMU and a camera that also measures depth.
class Flight {
 public:
  explicit Flight(unsigned seed)
      : data_(simulate_inertial({.seconds = 40, .landmarks = 200, .seed = seed})),
        random_(seed),
        mount_(graph_.add_parameter(data_.camera_pose)),
        smoother_(graph_, {.lag_s = 5}) {
    const InertialState& first = data_.keyframes[0].true_state;
    constexpr double kVelocity = 0.2;
    Vector3 velocity = first.velocity;
    for (double& v : velocity) v += kVelocity * random_.normal();
    add_state(0, {first.pose, velocity}, ImuBias::Zero());
    graph_.add_edge(Prior(first.pose), 1e8, pose_);
    graph_.add_edge(Prior(velocity), 1 / (kVelocity * kVelocity), velocity_);
    const InertialOptions drawn;
    const double gyroscope = 1 / (drawn.gyroscope_bias * drawn.gyroscope_bias);
    const double accelerometer = 1 / (drawn.accelerometer_bias * drawn.accelerometer_bias);
    const double weights[] = {gyroscope, gyroscope, gyroscope, accelerometer, accelerometer, accelerometer};
    graph_.add_edge(Prior(ImuBias(ImuBias::Zero())), Information::diagonal(weights), bias_);
  }

  void fly() {
    for (std::size_t k = 0; k < data_.keyframes.size(); ++k) {
      const auto& keyframe = data_.keyframes[k];
      if (k > 0) add_motion(data_.keyframes[k - 1], keyframe);
      for (const auto& sighting : keyframe.sightings)
        add_sighting(sighting.landmark, keyframe.true_state.pose);
      const SmootherReport report = smoother_.update();
      ASSERT_TRUE(report.converged()) << report.message;
    }
  }

  double nees_of_pose() const { return nees(graph_, smoother_, pose_, end().true_state.pose); }
  double nees_of_velocity() const { return nees(graph_, smoother_, velocity_, end().true_state.velocity); }
  double nees_of_bias() const { return nees(graph_, smoother_, bias_, end().true_bias); }

 private:
  static constexpr double kSeen = 0.1;  // meters

  const InertialSimulation::Keyframe& end() const { return data_.keyframes.back(); }

  void add_state(double seconds, const InertialState& state, const ImuBias& bias_guess) {
    pose_ = graph_.add_vertex(state.pose);
    velocity_ = graph_.add_vertex(state.velocity);
    bias_ = graph_.add_vertex(bias_guess);
    for (const VertexRef vertex : {VertexRef(pose_), VertexRef(velocity_), VertexRef(bias_)})
      smoother_.set_time(vertex, seconds);
  }

  void add_motion(const InertialSimulation::Keyframe& begin, const InertialSimulation::Keyframe& end) {
    const auto pose = pose_;
    const auto velocity = velocity_;
    const auto bias = bias_;
    Preintegration sum(ImuNoise{}, graph_.estimate(bias));
    for (int k = begin.next_sample; k < end.next_sample; ++k) {
      const auto& [angular_velocity, specific_force] = data_.samples[static_cast<std::size_t>(k)];
      sum.integrate(angular_velocity, specific_force, data_.sample_seconds);
    }
    const InertialMotion& motion = sum.motion();
    const InertialState next =
        motion.predict(graph_.estimate(pose), graph_.estimate(velocity), motion.bias, data_.gravity);
    add_state(end.time, next, motion.bias);
    graph_.add_edge(InertialBetween(motion, data_.gravity), sum.information(), pose, velocity, bias, pose_,
                    velocity_, bias_);
  }

  /// A landmark that has left the lag is a new vertex when it is seen again.
  void add_sighting(int landmark, const SE3& true_pose) {
    Vector3 seen = (true_pose * data_.camera_pose)
                       .inverse_times(data_.true_landmarks[static_cast<std::size_t>(landmark)]);
    for (double& coordinate : seen) coordinate += kSeen * random_.normal();
    auto known = landmarks_.find(landmark);
    if (known == landmarks_.end() || !graph_.contains(known->second)) {
      const Vector3 guess = graph_.estimate(pose_) * data_.camera_pose * seen;
      known = landmarks_.insert_or_assign(landmark, graph_.add_vertex(guess)).first;
    }
    graph_.add_edge(OffsetPointObservation3(seen), 1 / (kSeen * kSeen), pose_, known->second, mount_);
  }

  const InertialSimulation data_;
  RandomNumbers random_;
  Graph graph_;
  VertexHandle<SE3> mount_;
  Smoother smoother_;
  VertexHandle<SE3> pose_;
  VertexHandle<Vector3> velocity_;
  VertexHandle<ImuBias> bias_;
  std::unordered_map<int, VertexHandle<Vector3>> landmarks_;
};

TEST(SmootherConsistency, HoldsInAFlightWithAnImu) {
  double pose = 0, velocity = 0, bias = 0;
  for (unsigned seed = 1; seed <= kRuns; ++seed) {
    Flight flight(seed);
    flight.fly();
    pose += flight.nees_of_pose();
    velocity += flight.nees_of_velocity();
    bias += flight.nees_of_bias();
  }
  expect_consistent(pose, kRuns, 6, "pose");
  expect_consistent(velocity, kRuns, 3, "velocity");
  expect_consistent(bias, kRuns, 6, "biases");
}

}  // namespace
}  // namespace boxplus
