# SPDX-License-Identifier: BSD-3-Clause
# A trajectory with loop closures, of which some are false: graphs from NumPy arrays, and robust kernels.

import numpy as np

# The truth: 200 poses on two rounds of a circle.
count, radius = 200, 10.0
angles = np.linspace(0, 4 * np.pi, count)
truth = np.c_[radius * np.sin(angles), radius - radius * np.cos(angles), (angles + np.pi) % (2 * np.pi) - np.pi]


def relative(a, b):
    """The poses b (n, 3) relative to the poses a."""
    d, c, s = b - a, np.cos(a[:, 2]), np.sin(a[:, 2])
    return np.c_[c * d[:, 0] + s * d[:, 1], c * d[:, 1] - s * d[:, 0], d[:, 2]]


random = np.random.default_rng(1)
sigmas = np.array([0.02, 0.02, 0.002])  # meters, meters, radians
steps = np.arange(count - 1)
odometry = relative(truth[:-1], truth[1:]) + sigmas * random.normal(size=(count - 1, 3))
early, late = np.arange(0, 100, 5), np.arange(0, 100, 5) + 99
closures = relative(truth[early], truth[late]) + sigmas * random.normal(size=(20, 3))
closures[::7] += [3, -2, 1]  # three false closures

# [graph]
from boxplus import SE2, Between, Graph, optimize

graph = Graph()
graph.add_vertices(SE2, np.arange(count), np.zeros((count, 3)))  # a row per vertex: x, y, theta
graph.fix(0)
information = np.diag(1 / sigmas**2)  # one for all edges, or an array of shape (n, 3, 3)
graph.add_edges(Between, steps, steps + 1, measurements=odometry, informations=information)
loops = graph.add_edges(Between, early, late, measurements=closures, informations=information)
graph.set_kernel(loops, "Cauchy")  # with the default width for errors of 3 rows
report = optimize(graph, start="odometry", max_iterations=50)

ids, poses = graph.estimates(SE2)  # arrays of shape (n,) and (n, 3)
rejected = [edge for edge in loops if graph.weight(edge) < 0.1]
# [/graph]

# [run]
history = []


def watch(record):
    history.append(record.chi2)
    return record.iteration < 20  # False stops the run; None and True go on


optimize(graph, callback=watch, time_limit_s=1.0)
# [/run]

# [outliers]
from boxplus import diagnose, find_outliers

print(diagnose(graph))  # a line per finding: "warning: 3 of 219 edges Between<SE2> have a chi2 above …"
found = find_outliers(graph)
verdicts = found.arrays()
is_false = verdicts["verdict"] == "outlier"
print(np.c_[verdicts["from"], verdicts["to"]][is_false])  # the ids of their poses
# [/outliers]

distances = np.hypot(*(poses - truth)[:, :2].T)
print(f"{report.iterations} iterations, {len(rejected)} closures rejected, largest error {distances.max():.2f} m")
assert found.edges("outlier") == rejected
assert report.converged() and len(rejected) == 3 and distances.max() < 0.3
