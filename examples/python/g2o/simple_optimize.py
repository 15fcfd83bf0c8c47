# SPDX-License-Identifier: BSD-3-Clause
# Optimizes a .g2o file: simple_optimize.py [INPUT [-n ITERATIONS] [-o OUTPUT]]. As a program for g2o's Python bindings.

import argparse
import pathlib

import g2o

parser = argparse.ArgumentParser()
parser.add_argument("input", nargs="?", default=pathlib.Path(__file__).resolve().parents[3] / "data/01_town.g2o")
parser.add_argument("-n", "--iterations", type=int, default=10)
parser.add_argument("-o", "--output")
arguments = parser.parse_args()

# [optimize]
optimizer = g2o.SparseOptimizer()
solver = g2o.BlockSolverX(g2o.LinearSolverEigenX())
optimizer.set_algorithm(g2o.OptimizationAlgorithmLevenberg(solver))
optimizer.set_verbose(True)
assert optimizer.load(str(arguments.input))
print(f"{len(optimizer.vertices())} vertices, {len(optimizer.edges())} edges")

optimizer.vertex(min(optimizer.vertices())).set_fixed(True)
optimizer.initialize_optimization()
before = optimizer.active_chi2()
iterations = optimizer.optimize(arguments.iterations)
print(f"chi2 {before:.6g} -> {optimizer.active_chi2():.6g} in {iterations} iterations")
if arguments.output:
    optimizer.save(arguments.output)
# [/optimize]

assert iterations > 0 and optimizer.active_chi2() <= before
