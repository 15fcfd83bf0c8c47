// SPDX-License-Identifier: BSD-3-Clause
// Tracks two targets with two radars. Each target moves with a nearly constant velocity; each radar measures
// the distance and the direction of both targets. Nobody surveyed the second radar: its pose is estimated
// along with the tracks, because it sees the targets that the first radar sees, too.
#include <boxplus/boxplus.h>
#include <boxplus/types/slam2d.h>

#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

using namespace boxplus;

constexpr double kSeconds = 1, kAcceleration = 0.3;      // time of a step; power of the acceleration, m²/s³
constexpr double kRangeNoise = 5, kBearingNoise = 0.02;  // standard deviations in m and rad
const SE2 kFirstRadar(0, 0, 0.5), kSecondRadar(900, -200, 2.6);

/// Constant velocity, disturbed by white noise of the acceleration (Bar-Shalom, Li and Kirubarajan,
/// "Estimation with Applications to Tracking and Navigation", 2001, section 6.2.2). Vertices: position and
/// velocity, and both again one step later. Error: the changes that the velocity does not explain.
struct ConstantVelocity {
  double seconds;

  template <class P>
  auto error(const P& position, const P& velocity, const P& next_position, const P& next_velocity) const {
    Vector<typename P::Scalar, 4> e;
    e << next_position - position - velocity * seconds, next_velocity - velocity;
    return e;
  }

  /// The inverse covariance of the error, for noise of power q in each direction.
  Matrix<double, 4, 4> information(double q) const {
    const double t = seconds;
    const Matrix<double, 2, 2> unit = Matrix<double, 2, 2>::Identity();
    Matrix<double, 4, 4> omega;
    omega << 12 / (t * t * t) * unit, -6 / (t * t) * unit, -6 / (t * t) * unit, 4 / t * unit;
    return omega / q;
  }
};

struct State {
  Vector2 position, velocity;
};

class Noise {
 public:
  double operator()(double sigma) { return sigma * normal_(random_); }
  Vector2 pair(double sigma) {
    const double x = (*this)(sigma), y = (*this)(sigma);
    return {x, y};
  }

 private:
  std::mt19937 random_{7};
  std::normal_distribution<double> normal_;
};

/// The state one step later. The two noises have the covariance whose inverse is information().
State moved(const State& state, Noise& noise) {
  const Vector2 gain = noise.pair(std::sqrt(kAcceleration * kSeconds));
  const Vector2 sway = noise.pair(std::sqrt(kAcceleration * kSeconds / 12) * kSeconds);
  return {state.position + kSeconds * (state.velocity + gain / 2) + sway, state.velocity + gain};
}

int main() {
  Noise noise;
  Graph graph;
  const auto first = graph.add_vertex(kFirstRadar);
  graph.fix(first);
  const auto second = graph.add_vertex(kSecondRadar * SE2(80, 50, 0.2));  // a rough guess
  std::vector<State> truth;
  std::vector<VertexHandle<Vector2>> positions, velocities;
  double raw_squares = 0;  // of the errors of what the first radar measures

  for (State state : {State{{200, 300}, {15, -5}}, State{{900, 500}, {-12, -8}}}) {
    for (int step = 0; step < 60; ++step) {
      if (step > 0) state = moved(state, noise);
      truth.push_back(state);
      const auto measured = [&](const SE2& radar) {
        const Vector2 seen = radar.inverse() * state.position;
        return std::pair{seen.norm() + noise(kRangeNoise),
                         std::atan2(seen[1], seen[0]) + noise(kBearingNoise)};
      };
      const auto [range, bearing] = measured(kFirstRadar);
      const Vector2 start = kFirstRadar * Vector2(range * std::cos(bearing), range * std::sin(bearing));
      raw_squares += (start - state.position).squaredNorm();
      const auto position = graph.add_vertex(start), velocity = graph.add_vertex(Vector2(0, 0));
      const auto observe = [&](VertexHandle<SE2> radar, double z_range, double z_bearing) {
        graph.add_edge(Range(z_range), 1 / (kRangeNoise * kRangeNoise), radar, position);
        graph.add_edge(BearingObservation2(z_bearing), 1 / (kBearingNoise * kBearingNoise), radar, position);
      };
      observe(first, range, bearing);
      const auto [other_range, other_bearing] = measured(kSecondRadar);
      observe(second, other_range, other_bearing);
      if (step > 0) {
        const ConstantVelocity motion{kSeconds};
        graph.add_edge(motion, motion.information(kAcceleration), positions.back(), velocities.back(),
                       position, velocity);
      }
      positions.push_back(position);
      velocities.push_back(velocity);
    }
  }
  const Report report = optimize(graph);

  double squares = 0, speed_squares = 0;
  for (std::size_t k = 0; k < truth.size(); ++k) {
    squares += (graph.estimate(positions[k]) - truth[k].position).squaredNorm();
    speed_squares += (graph.estimate(velocities[k]) - truth[k].velocity).squaredNorm();
  }
  const auto rms = [&](double sum) { return std::sqrt(sum / static_cast<double>(truth.size())); };
  const SE2 offset = kSecondRadar.inverse() * graph.estimate(second);
  std::printf("two targets in %zu scans; chi2 per degree of freedom %.2f\n", truth.size() / 2,
              report.chi2_per_degree());
  std::printf("error of the positions: %.1f m from the first radar alone, %.1f m on the tracks (RMS)\n",
              rms(raw_squares), rms(squares));
  std::printf("error of the velocities: %.2f m/s\n", rms(speed_squares));
  std::printf("error of the second radar: %.1f m and %.4f rad (94 m and 0.2 rad at the start)\n",
              std::hypot(offset.x(), offset.y()), std::abs(offset.theta()));
  const bool is_consistent = std::abs(report.chi2_per_degree() - 1) < 0.2;
  const bool is_right = rms(squares) < 5 && rms(speed_squares) < 1.5 &&
                        std::hypot(offset.x(), offset.y()) < 20 && std::abs(offset.theta()) < 0.04;
  return report.converged() && is_consistent && is_right ? 0 : 1;
}
