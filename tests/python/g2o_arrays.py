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


def graph_from_arrays(text):
    lines = [line.split() for line in text.splitlines() if line.strip()]
    vertices = [line for line in lines if line[0] in TAGS]
    edges = [line for line in lines if line[0] in EDGE_TAGS]
    kind, rows = TAGS[vertices[0][0]]
    graph = boxplus.Graph()
    graph.add_vertices(kind, np.array([int(line[1]) for line in vertices]),
                       np.array([[float(field) for field in line[2:]] for line in vertices]))
    for line in lines:
        for vertex in line[1:] if line[0] == "FIX" else []:
            graph.fix(int(vertex))
    numbers = np.array([[float(field) for field in line[3:]] for line in edges])
    size = numbers.shape[1] - rows * (rows + 1) // 2
    ids = np.array([[int(line[1]), int(line[2])] for line in edges])
    graph.add_edges(boxplus.Between, ids[:, 0], ids[:, 1], measurements=numbers[:, :size],
                    informations=full_matrices(numbers[:, size:], rows))
    return graph
