# SPDX-License-Identifier: BSD-3-Clause
# The pose of a sensor on a robot, from landmarks that it sees from known poses.

import numpy as np
import worlds

world = worlds.sensor()

# [program]
from boxplus import SE2, Graph, OffsetPointObservation2, Vector2, optimize

graph = Graph()
poses = graph.add_vertices(SE2, None, world.poses)
points = graph.add_vertices(Vector2, None, world.points_guess)
sensor = graph.add_vertex(SE2())
for pose in poses:
    graph.fix(pose)
graph.add_edges(OffsetPointObservation2, poses[world.pose], points[world.point], sensor, measurements=world.seen)
optimize(graph)
found = graph.estimate(sensor)
# [/program]

np.testing.assert_allclose(found.vector(), world.truth, atol=0.02)
