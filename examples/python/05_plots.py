# SPDX-License-Identifier: BSD-3-Clause
# Draws a graph with landmarks and false loop closures, its covariances and the convergence of its optimization, with
# Matplotlib.

import numpy as np
from boxplus import SE2, Between, Graph, PointObservation2, Vector2, find_outliers, marginal_covariances, optimize

# [script]
# `05_plots.py FILE` also saves the picture, whose format follows from the extension of FILE.
import sys

try:
    import matplotlib
except ImportError as error:
    print(f"SKIPPED: Matplotlib cannot be imported: {error}")
    sys.exit(77)
# [/script]

# The truth: 160 poses on two rounds of an eight, and 12 landmarks. The robot sees landmarks within 5 m.
random = np.random.default_rng(5)
count = 160
t = np.linspace(0, 4 * np.pi, count, endpoint=False)
width = np.where(t < 2 * np.pi, 14, 11)  # the second round is narrower
truth = np.c_[width * np.sin(t), 7 * np.sin(2 * t), np.arctan2(14 * np.cos(2 * t), width * np.cos(t))]
landmarks = random.uniform([-15, -9], [15, 9], (12, 2))


def relative(a, b):
    """The poses or points b (n, 3 or 2) relative to the poses a (n, 3)."""
    d, c, s = b[:, :2] - a[:, :2], np.cos(a[:, 2]), np.sin(a[:, 2])
    return np.c_[c * d[:, 0] + s * d[:, 1], c * d[:, 1] - s * d[:, 0], b[:, 2:] - a[:, 2:b.shape[1]]]


sigmas = np.array([0.05, 0.05, 0.01])  # meters, meters, radians
steps = np.arange(count - 1)
odometry = relative(truth[:-1], truth[1:]) + sigmas * random.normal(size=(count - 1, 3))
early = np.arange(0, count // 2, 3)
late = early + count // 2
closures = relative(truth[early], truth[late]) + sigmas * random.normal(size=(len(early), 3))
is_false = np.arange(len(early)) % 4 == 2
late[is_false] = random.integers(count // 2, count, is_false.sum())
seen_from, seen = np.nonzero(np.linalg.norm(truth[:, None, :2] - landmarks, axis=2) < 5)
observations = relative(truth[seen_from], landmarks[seen]) + 0.2 * random.normal(size=(len(seen), 2))

graph = Graph()
graph.add_vertices(SE2, np.arange(count), np.tile(truth[0], (count, 1)))
graph.add_vertices(Vector2, 1000 + np.arange(12), np.zeros((12, 2)))
graph.fix(0)
graph.add_edges(Between, steps, steps + 1, measurements=odometry, informations=np.diag(1 / sigmas**2))
graph.add_edges(Between, early, late, measurements=closures, informations=np.diag(1 / sigmas**2))
graph.add_edges(PointObservation2, seen_from, 1000 + seen, measurements=observations, informations=1 / 0.2**2)
found = find_outliers(graph, start="odometry")
for edge in found.edges("outlier"):
    graph.set_enabled(edge, False)
guess = truth + random.normal(size=truth.shape) * [1, 1, 0.3]

# [plots]
from boxplus import plot
from matplotlib import pyplot

figure, ((graph_ax, closures_ax), (ellipses_ax, chi2_ax)) = pyplot.subplots(2, 2, figsize=(11, 7.5), layout="constrained")
plot.trajectory(graph, graph_ax, truth=truth)
plot.closures(graph, closures_ax, found=found)  # without found=…, the color is the chi2 of each closure

covariance = marginal_covariances(graph, graph.all_vertices())
plot.trajectory(graph, ellipses_ax, edges=False)
plot.covariances(graph, range(0, count, 4), covariance, sigmas=3, ax=ellipses_ax)

for algorithm in ("gauss-newton", "levenberg-marquardt", "dogleg"):
    graph.set_estimates(SE2, np.arange(count), guess)  # a poor guess
    plot.convergence(optimize(graph, algorithm=algorithm), chi2_ax, label=algorithm)
# [/plots]

# [script]
if len(sys.argv) > 1:
    figure.savefig(sys.argv[1], dpi=75)
# [/script]
assert found.edges("outlier") == [verdict.edge for verdict, false in zip(found.verdicts, is_false) if false]
assert len(chi2_ax.get_lines()) == 3 and len(ellipses_ax.collections[0].get_paths()) == count // 4
