# SPDX-License-Identifier: BSD-3-Clause
# Bundle adjustment with known intrinsics.

import worlds

world = worlds.bundle()

# [program]
from boxplus import SE3, BatchedEdge, Graph, Vector3, optimize, rows


class Reprojection(BatchedEdge):
    def error(self, camera, point, pixel):
        p = rows.inverse_times(camera, point)
        return world.focal * p[:, :2] / p[:, 2:] + world.center - pixel


graph = Graph()
cameras = graph.add_vertices(SE3, None, world.cameras_guess)
points = graph.add_vertices(Vector3, None, world.points_guess)
for camera in (0, 1):
    graph.fix(camera)
edges = graph.add_edges(Reprojection(), cameras[world.camera], points[world.point], measurements=world.pixels)
graph.set_kernel(edges, "Huber", 2)
optimize(graph)
found = graph.estimates(Vector3)[1]
# [/program]

assert abs(found - world.points).max() < 0.05
