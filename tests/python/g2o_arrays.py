# SPDX-License-Identifier: BSD-3-Clause
"""Reads the pose graph of a .g2o file into arrays, without boxplus, and makes a graph of these arrays."""

import boxplus
import numpy as np

# The tags of a pose graph: the class of its vertices, and the rows of their errors.
TAGS = {"VERTEX_SE2": (boxplus.SE2, 3), "VERTEX_SE3:QUAT": (boxplus.SE3, 6)}
EDGE_TAGS = ("EDGE_SE2", "EDGE_SE3:QUAT")


def full_matrices(triangles, rows):
    """The symmetric matrices whose upper triangles are listed row by row."""
    matrices = np.zeros((len(triangles), rows, rows))
    upper = np.triu_indices(rows)
    matrices[:, upper[0], upper[1]] = triangles
    matrices[:, upper[1], upper[0]] = triangles
    return matrices


def parse_g2o(text):
    """(class, ids, estimates, fixed ids, ids of the edges' vertices, measurements, informations)"""
    lines = [line.split() for line in text.splitlines() if line.strip()]
    vertices = [line for line in lines if line[0] in TAGS]
    edges = [line for line in lines if line[0] in EDGE_TAGS]
    kind, rows = TAGS[vertices[0][0]]
    fixed = [int(vertex) for line in lines if line[0] == "FIX" for vertex in line[1:]]
    numbers = np.array([[float(field) for field in line[3:]] for line in edges])
    size = numbers.shape[1] - rows * (rows + 1) // 2
    ids = np.array([[int(line[1]), int(line[2])] for line in edges])
    return (kind, np.array([int(line[1]) for line in vertices]),
            np.array([[float(field) for field in line[2:]] for line in vertices]), fixed, ids, numbers[:, :size],
            full_matrices(numbers[:, size:], rows))


def graph_from_arrays(arrays):
    kind, ids, estimates, fixed, ends, measurements, informations = arrays
    graph = boxplus.Graph()
    graph.add_vertices(kind, ids, estimates)
    for vertex in fixed:
        graph.fix(vertex)
    graph.add_edges(boxplus.Between, ends[:, 0], ends[:, 1], measurements=measurements, informations=informations)
    return graph
