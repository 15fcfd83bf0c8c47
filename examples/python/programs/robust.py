# SPDX-License-Identifier: BSD-3-Clause
# A pose graph with false loop closures.

import worlds

world = worlds.pose_graph(false_closures=4)

# [program]
from boxplus import SE2, Between, Graph, optimize

graph = Graph()
graph.add_vertices(SE2, None, world.guess)
graph.fix(0)
edges = graph.add_edges(Between, world.i, world.j, measurements=world.z, informations=world.omega)
graph.set_kernel(edges[world.odometry:], "GemanMcClure", 10)
optimize(graph)
poses = graph.estimates(SE2)[1]
# [/program]

assert abs(poses - world.truth)[:, :2].max() < 0.5
