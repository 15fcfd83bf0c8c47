// SPDX-License-Identifier: BSD-3-Clause
// One function per simulated world.
#pragma once

namespace boxplus {

struct Simulation;
struct SimulationOptions;

Simulation simulate_sphere(const SimulationOptions& options);
Simulation simulate_torus(const SimulationOptions& options);
Simulation simulate_grid(const SimulationOptions& options);
Simulation simulate_manhattan(const SimulationOptions& options);
Simulation simulate_streets(const SimulationOptions& options);
Simulation simulate_city(const SimulationOptions& options);
Simulation simulate_planes(const SimulationOptions& options);
Simulation simulate_lines(const SimulationOptions& options);

}  // namespace boxplus
