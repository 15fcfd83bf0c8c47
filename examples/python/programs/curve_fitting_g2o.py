# SPDX-License-Identifier: BSD-3-Clause
# The amplitude, decay and frequency of an oscillation, in g2o.

import worlds

world = worlds.curve()

# [program]
import g2o
import numpy as np


class Curve(g2o.VectorXVertex):
    def __init__(self):
        super().__init__()
        self.set_dimension(3)
        self.set_estimate([1, 0, 2.9])

    def oplus_impl(self, step):
        self.set_estimate(self.estimate() + step)


class Sample(g2o.VariableVectorXEdge):
    def __init__(self, curve, sample):
        super().__init__()
        self.set_dimension(1)
        self.resize(1)
        self.set_vertex(0, curve)
        self.set_measurement(sample)
        self.set_information(np.eye(1) / 0.05**2)

    def compute_error(self):
        t, y = self.measurement()
        amplitude, decay, frequency = self.vertex(0).estimate()
        return [amplitude * np.exp(-decay * t) * np.cos(frequency * t) - y]


optimizer = g2o.SparseOptimizer()
solver = g2o.BlockSolverX(g2o.LinearSolverDenseX())
optimizer.set_algorithm(g2o.OptimizationAlgorithmLevenberg(solver))
curve = Curve()
curve.set_id(0)
optimizer.add_vertex(curve)
for sample in zip(world.t, world.y):
    optimizer.add_edge(Sample(curve, sample))
optimizer.initialize_optimization()
optimizer.optimize(20)
found = curve.estimate()
# [/program]

np.testing.assert_allclose(found, world.truth, atol=0.05)
