#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Models operations, bytes and messages of boxplus-mpi per process and iteration, and compares them with runs.

    scale_model.py [--check] FOLDER_OF_PROGRAMS MPIRUN...

Runs simulated streets with 1, 2 and 4 processes, fits the model to their times, and evaluates it for a cluster. With
--check, runs one small street. Fails if a run sends other numbers of bytes than the model says, by more than 10 %.
"""

import dataclasses
import itertools
import json
import math
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile

CAMERA = 9  # scalars of a BAL camera
PIECE = 1 << 14  # numbers in one message of a sum (Communicator::add_up())
SMALL_SUMS = 16  # sums and maxima of one number, per iteration
TOLERANCE = 0.1


@dataclasses.dataclass
class Problem:
    """The sizes on which all costs depend. `pairs` are the pairs of cameras that see a common point."""

    observations: int
    points: int
    cameras: int
    pairs: int

    @property
    def scalars(self):
        """The rows of S."""
        return CAMERA * self.cameras

    @property
    def values(self):
        """The numbers in S: the blocks of its lower triangle and of its diagonal."""
        return CAMERA**2 * (self.cameras + self.pairs)

    @property
    def flops(self):
        """The operations that are divided: Jacobians, H and the Schur complement of tracks of average length."""
        track = self.observations / self.points
        return self.observations * (600 + 2 * 3 * CAMERA**2 * (track + 1) / 2)


def read_problem(path):
    with open(path, encoding="ascii") as file:
        cameras, points, observations = map(int, file.readline().split())
        tracks = [[] for _ in range(points)]
        for line in itertools.islice(file, observations):
            camera, point, _, _ = line.split()
            tracks[int(point)].append(int(camera))
    pairs = {pair for track in tracks for pair in itertools.combinations(sorted(track), 2)}
    return Problem(observations, points, cameras, len(pairs))


def summed(problem):
    """The sizes of the vectors that an iteration with one step adds up over all processes."""
    each_try = [problem.values + problem.scalars, problem.scalars, problem.scalars]  # S and λD, its right-hand side, the step
    return [*each_try, 2 * problem.scalars]  # the gradient and the diagonal of H


def sent_bytes(problem, processes, tries=1):
    """The bytes that all processes send in an iteration that tries this many steps."""
    *each_try, once = summed(problem)
    sums = 2 * (processes - 1) * 8 * (tries * sum(each_try) + once)
    return sums + SMALL_SUMS * 8 * processes * (processes - 1)


def start_bytes(problem, processes):
    """The bytes that all processes send before the first iteration: the cameras, and the pattern of S."""
    return (processes - 1) * (32 * problem.cameras * processes + 8 * problem.pairs)


def messages(problem, processes):
    """The messages that a process sends in an iteration."""
    pieces = sum(math.ceil(size / PIECE) for size in summed(problem))
    return 2 * pieces + 3 * SMALL_SUMS * math.ceil(math.log2(processes)) if processes > 1 else 0


@dataclasses.dataclass
class Run:
    problem: Problem
    processes: int
    sent: float
    modeled: float
    seconds: float  # per iteration
    load: float


def run(folder, mpirun, path, problem, processes):
    report = path.with_suffix(".json")
    command = [*mpirun, "-n", str(processes), folder / "boxplus-mpi", "optimize", path, "--quiet", "--threads", "1",
               "--iterations", "8", "--json", report]
    done = subprocess.run(list(map(str, command)), capture_output=True, encoding="utf-8", check=False, timeout=600)
    if done.returncode not in (0, 1):
        sys.exit(done.stderr)
    result = json.loads(report.read_text(encoding="utf-8"))
    records, distribution = result["records"], result["distribution"]
    tries = statistics.mean(record["tries"] for record in records)
    modeled = sent_bytes(problem, processes, tries) + start_bytes(problem, processes) / len(records)
    ends = [record["time_s"] for record in records]
    seconds = min(b - a for a, b in zip(ends, ends[1:]))  # the iteration that other programs disturbed least
    return Run(problem, processes, distribution["sent_bytes_per_iteration"], modeled, seconds, result["time_s"]["load"])


def runs_of_streets(folder, mpirun, streets, numbers, repetitions):
    with tempfile.TemporaryDirectory() as name:
        for cameras, points in streets:
            path = pathlib.Path(name) / "street.bal"
            subprocess.run([folder / "boxplus", "simulate", "ba", "--shape", "street", "--cameras", str(cameras), "--points",
                            str(points), "-o", path], check=True, capture_output=True)
            problem = read_problem(path)
            for processes in numbers:
                tries = [run(folder, mpirun, path, problem, processes) for _ in range(repetitions)]
                yield min(tries, key=lambda one: one.seconds)


def fit(runs, cores):
    """Seconds per divided operation and per number of the replicated S, by least squares of relative errors."""
    rows = []
    for one in runs:
        at_once = min(one.processes, cores)
        rows.append((one.problem.flops / at_once / one.seconds, one.problem.values * one.processes / at_once / one.seconds))
    a = [[sum(row[i] * row[j] for row in rows) for j in (0, 1)] for i in (0, 1)]
    b = [sum(row[i] for row in rows) for i in (0, 1)]
    determinant = a[0][0] * a[1][1] - a[0][1] * a[1][0]
    return [(b[0] * a[1][1] - b[1] * a[0][1]) / determinant, (a[0][0] * b[1] - a[1][0] * b[0]) / determinant]


def predict(problem, processes, costs, latency=2e-6, bandwidth=10e9):
    """Seconds of the parts of an iteration on a cluster where each process has a core and this network."""
    pieces = sum(math.ceil(size / PIECE) for size in summed(problem))
    ring = 2 * (pieces + processes) * (latency + 8 * PIECE / bandwidth)
    small = 3 * SMALL_SUMS * math.ceil(math.log2(processes)) * latency
    return {"divided": costs[0] * problem.flops / processes, "replicated": costs[1] * problem.values, "network": ring + small}


def street_of(observations, cameras, like):
    scale = cameras / like.cameras
    return Problem(observations, round(observations * like.points / like.observations), cameras, round(scale * like.pairs))


def print_cluster(runs, costs):
    like = max((one.problem for one in runs), key=lambda problem: problem.cameras)
    print("\nPredicted seconds per iteration (10 GB/s, 2 µs):\n")
    print("| Observations | Cameras | Processes | Divided | Replicated | Network | S in GB per process | Messages | Sent in GB per process |")
    print("|---|---|---|---|---|---|---|---|---|")
    for cameras in (20_000, 500_000):
        problem = street_of(10**9, cameras, like)
        for processes in (10, 100, 1000):
            parts = predict(problem, processes, costs)
            print(f"| 1e9 | {cameras} | {processes} | {parts['divided']:.2f} | {parts['replicated']:.2f} | {parts['network']:.2f} | "
                  f"{8e-9 * problem.values:.2f} | {messages(problem, processes)} | "
                  f"{1e-9 * sent_bytes(problem, processes) / processes:.2f} |")


def main():
    words = sys.argv[1:]
    is_check = words[0] == "--check"
    folder, *mpirun = words[is_check:]
    streets = [(60, 3000)] if is_check else [(100, 20_000), (100, 80_000), (400, 20_000), (400, 80_000)]
    runs = []
    print("| Cameras | Observations | Pairs | Processes | Sent per iteration | Model | Seconds per iteration | Seconds to load |")
    print("|---|---|---|---|---|---|---|---|")
    numbers, repetitions = ((2, 4), 1) if is_check else ((1, 2, 4), 5)
    for one in runs_of_streets(pathlib.Path(folder), mpirun, streets, numbers, repetitions):
        runs.append(one)
        print(f"| {one.problem.cameras} | {one.problem.observations} | {one.problem.pairs} | {one.processes} | {one.sent} | "
              f"{one.modeled:.0f} | {one.seconds:.4f} | {one.load:.2f} |", flush=True)
    if not is_check:
        costs = fit(runs, os.cpu_count())
        print(f"\n{1e-9 / costs[0]:.2f} GFlop/s in what is divided; {1e9 * costs[1]:.2f} ns per number of S in what is not.")
        print_cluster(runs, costs)
    worst = max(abs(one.sent - one.modeled) / max(one.modeled, 1) for one in runs)
    print(f"\nThe bytes differ from the model by at most {100 * worst:.2f} %.")
    return worst > TOLERANCE


if __name__ == "__main__":
    sys.exit(main())
