# SPDX-License-Identifier: BSD-3-Clause
# Poses and landmarks from odometry, angles and distances.

import numpy as np
import worlds

world = worlds.landmarks()

# [program]
from boxplus import SE2, BearingObservation2, Between, Graph, Range, Vector2, optimize

graph = Graph()
poses = graph.add_vertices(SE2, None, world.guess)
points = graph.add_vertices(Vector2, None, world.points_guess)
graph.fix(0)
graph.add_edges(Between, poses[:-1], poses[1:], measurements=world.odometry, informations=world.omega)
graph.add_edges(BearingObservation2, poses[world.pose], points[world.point], measurements=world.angles, informations=1 / 0.02**2)
graph.add_edges(Range, poses[world.pose], points[world.point], measurements=world.ranges, informations=1 / 0.1**2)
optimize(graph)
landmarks = graph.estimates(Vector2)[1]
# [/program]

assert np.linalg.norm(landmarks - world.points, axis=1).max() < 0.5
