# SPDX-License-Identifier: BSD-3-Clause
# A vertex and an edge that are written in Python, as a program for g2o's Python bindings: fits a damped oscillation.

import g2o
import numpy as np


class Oscillation(g2o.VectorXVertex):
    """Amplitude, decay and frequency."""

    def __init__(self):
        super().__init__()
        self.set_dimension(3)
        self.set_estimate([1, 0, 2.9])

    def oplus_impl(self, step):
        self.set_estimate(self.estimate() + step)


class Sample(g2o.VariableVectorXEdge):
    def __init__(self, curve, time, value):
        super().__init__()
        self.set_dimension(1)
        self.resize(1)
        self.set_vertex(0, curve)
        self.set_measurement([time, value])
        self.set_information(np.eye(1) / 0.05**2)
        self.set_robust_kernel(g2o.RobustKernelHuber(1.345))

    def compute_error(self):
        time, value = self.measurement()
        amplitude, decay, frequency = self.vertex(0).estimate()
        return [amplitude * np.exp(-decay * time) * np.cos(frequency * time) - value]


random = np.random.default_rng(4)
times = np.linspace(0, 10, 200)
values = 2 * np.exp(-0.2 * times) * np.cos(3 * times) + 0.05 * random.normal(size=200)
values[::20] += 1  # outliers

optimizer = g2o.SparseOptimizer()
solver = g2o.BlockSolverX(g2o.LinearSolverDenseX())
optimizer.set_algorithm(g2o.OptimizationAlgorithmLevenberg(solver))
curve = Oscillation()
curve.set_id(0)
optimizer.add_vertex(curve)
for time, value in zip(times, values):
    optimizer.add_edge(Sample(curve, time, value))

optimizer.initialize_optimization()
optimizer.optimize(30)
ok, covariance = optimizer.compute_marginals(curve)
print(curve.estimate(), np.sqrt(np.diag(covariance.block(0, 0))))
assert ok
np.testing.assert_allclose(curve.estimate(), [2, 0.2, 3], atol=0.05)
