# SPDX-License-Identifier: BSD-3-Clause
# A pose graph that grows, with an estimate after each motion.

import worlds

world = worlds.online()

# [program]
from boxplus import SE2, Between, Graph, Optimizer

graph = Graph()
graph.add_vertex(SE2())
graph.fix(0)
optimizer = Optimizer(graph, max_iterations=3)
for k, z in enumerate(world.odometry, 1):
    graph.add_vertex(graph.estimate(k - 1) * SE2(*z))
    for i, measured in [(k - 1, z), *world.closures.get(k, ())]:
        graph.add_edge(Between(SE2(*measured)), i, k, information=world.omega)
    optimizer.run()
poses = graph.estimates(SE2)[1]
# [/program]

assert abs(poses - world.truth)[:, :2].max() < 0.4
