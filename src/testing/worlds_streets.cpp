// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "testing/plane_cells.h"
#include "testing/simulator.h"
#include "testing/street_network.h"
#include "testing/worlds.h"

namespace boxplus {
namespace {

/// Drives the route, and repeats it until there are `poses` poses. Calls arrived(leg, position) at each pose.
template <class Arrived>
void drive(Simulator<SE2>& simulator, const StreetNetwork& network, int poses, Arrived&& arrived) {
  const std::vector<Leg> route = network.route(simulator.random);
  for (std::size_t k = 0; simulator.size() < poses; ++k) {
    const Leg leg = route[k % route.size()];
    const int steps = network.street(leg).steps;
    for (int step = k == 0 ? 0 : 1; step <= steps && simulator.size() < poses; ++step) {
      const int position = leg.forward ? step : steps - step;
      simulator.drive_to(network.pose(leg, position));
      arrived(leg, position);
    }
  }
}

/// Adds loop closures when the robot returns to a street or a crossing.
class PlaceMemory {
 public:
  PlaceMemory(const StreetNetwork& network, Simulator<SE2>& simulator)
      : network_(network),
        simulator_(simulator),
        passes_(network.streets().size()),
        visited_(network.crossings().size(), kNever) {}

  void arrive(const Leg& leg, int position) {
    const Street& street = network_.street(leg);
    if (position == 0) {
      arrive_at_crossing(street.from);
    } else if (position == street.steps) {
      arrive_at_crossing(street.to);
    } else {
      arrive_in_street(leg, position);
    }
  }

 private:
  static constexpr int kNever = -1;
  /// One drive along a street. `first_pose` is the pose at the crossing at the beginning of the drive.
  struct Pass {
    int first_pose;
    bool forward;
  };

  void arrive_at_crossing(int crossing) {
    int& last = visited_[crossing];
    if (last != kNever) simulator_.recognize(last, simulator_.size() - 1);
    last = simulator_.size() - 1;
  }

  /// For each earlier pass along this street, adds edges to three of its poses: one behind, one beside and
  /// one ahead of the current pose.
  void arrive_in_street(const Leg& leg, int position) {
    constexpr int kSightings[] = {-2, 0, 2};
    const int steps = network_.street(leg).steps, pose = simulator_.size() - 1;
    std::vector<Pass>& passes = passes_[leg.street];
    if (position == (leg.forward ? 1 : steps - 1)) passes.push_back({pose - 1, leg.forward});
    for (std::size_t k = 0; k + 1 < passes.size(); ++k) {
      for (int sighting : kSightings) {
        const int at = position + sighting;
        if (at <= 0 || at >= steps) continue;
        simulator_.recognize(passes[k].first_pose + (passes[k].forward ? at : steps - at), pose);
      }
    }
  }

  const StreetNetwork& network_;
  Simulator<SE2>& simulator_;
  std::vector<std::vector<Pass>> passes_;  // the passes along each street
  std::vector<int> visited_;               // the last pose at each crossing
};

/// Calls `found(point)` for the lampposts and the front corners of the houses along a street.
template <class Found>
void furnish(const StreetNetwork& network, const Street& street, RandomNumbers& random, Found&& found) {
  constexpr double kKerb = 3.5, kFacade = 6, kCorner = 6, kLamppostSpacing = 10;
  const int lampposts =
      static_cast<int>(std::floor((street.steps - 2 * kCorner) / (kLamppostSpacing / 2))) + 1;
  for (int k = 0; k < lampposts; ++k) {
    const double side = k % 2 == 0 ? 1 : -1;
    found(network.beside(street, kCorner + k * (kLamppostSpacing / 2), side * kKerb));
  }
  for (double facade : {kFacade, -kFacade}) {
    double begin = kCorner + random.uniform(0, 3);
    while (true) {
      const double end = begin + random.uniform(6, 10);
      if (end > street.steps - kCorner) break;
      found(network.beside(street, begin, facade));
      found(network.beside(street, end, facade));
      begin = end + random.uniform(3, 6);
    }
  }
}

}  // namespace

Simulation simulate_streets(const SimulationOptions& options) {
  constexpr int kBlock = 140;
  Simulator<SE2> simulator(options, {0.03, 0.002});
  const StreetNetwork network(options.poses, kBlock, simulator.random);
  PlaceMemory memory(network, simulator);
  drive(simulator, network, options.poses,
        [&](const Leg& leg, int position) { memory.arrive(leg, position); });
  return simulator.take();
}

Simulation simulate_city(const SimulationOptions& options) {
  constexpr int kBlock = 40;
  constexpr double kRange = 12, kHalfView = 70 * kPi / 180, kDeviation = 0.1;
  Simulator<SE2> simulator(options, {0.05, 0.01});
  const StreetNetwork network(options.poses, kBlock, simulator.random);
  PlaneCells cells(kRange);
  for (const Street& street : network.streets()) {
    furnish(network, street, simulator.random,
            [&](const Vector2& point) { cells.add(point, simulator.add_landmark(point)); });
  }
  drive(simulator, network, options.poses, [&](const Leg&, int) {
    const SE2& pose = simulator.truth(simulator.size() - 1);
    cells.around(pose.translation(), kRange, [&](int landmark) {
      const Vector2 seen = pose.inverse_times(simulator.landmark(landmark));
      if (seen.norm() < kRange && std::abs(std::atan2(seen[1], seen[0])) < kHalfView) {
        simulator.observe(landmark, kDeviation);
      }
    });
  });
  return simulator.take();
}

}  // namespace boxplus
