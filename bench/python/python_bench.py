# SPDX-License-Identifier: BSD-3-Clause
"""Measures the Python module against the command, and error functions of Python against the native ones. Prints a section of
RESULTS.md.

    PYTHONPATH=build/bench/python python3 bench/python/python_bench.py PATH_TO_BOXPLUS DATA_FOLDER
"""

import json
import pathlib
import statistics
import subprocess
import sys
import time

import numpy as np

import boxplus

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "python"))
from g2o_arrays import graph_from_arrays, parse_g2o  # noqa: E402

REPETITIONS = 5
THREADS = 1


class Reprojection(boxplus.BatchedEdge):
    """BAL's camera: a rotation vector, a translation, f, k1, k2."""

    def error(self, camera, point, pixel):
        rotation = camera[:, :3]
        angle = np.sqrt((rotation * rotation).sum(axis=1, keepdims=True) + 1e-300)
        axis = rotation / angle
        cosine, sine = np.cos(angle), np.sin(angle)
        x = (cosine * point + sine * np.cross(axis, point)
             + (1 - cosine) * (axis * point).sum(axis=1, keepdims=True) * axis + camera[:, 3:6])
        image = -x[:, :2] / x[:, 2:]
        r2 = (image * image).sum(axis=1, keepdims=True)
        return camera[:, 6:7] * (1 + r2 * (camera[:, 7:8] + camera[:, 8:9] * r2)) * image - pixel


class ReprojectionWithJacobians(Reprojection):
    def jacobians(self, camera, point, pixel):
        """With one array per number: NumPy is slow for stacks of small matrices."""
        w0, w1, w2, t0, t1, t2, f, k1, k2 = np.ascontiguousarray(camera.T)
        p0, p1, p2 = np.ascontiguousarray(point.T)
        theta2 = w0 * w0 + w1 * w1 + w2 * w2 + 1e-300
        theta = np.sqrt(theta2)
        c, s = np.cos(theta), np.sin(theta)
        a0, a1, a2 = w0 / theta, w1 / theta, w2 / theta
        v = 1 - c
        rotation = [[c + v * a0 * a0, v * a0 * a1 - s * a2, v * a0 * a2 + s * a1],
                    [v * a0 * a1 + s * a2, c + v * a1 * a1, v * a1 * a2 - s * a0],
                    [v * a0 * a2 - s * a1, v * a1 * a2 + s * a0, c + v * a2 * a2]]
        q = [row[0] * p0 + row[1] * p1 + row[2] * p2 for row in rotation]
        x, y, z = q[0] + t0, q[1] + t1, q[2] + t2
        # d(R p)/dw = -[R p]x Jl with the left Jacobian Jl = s/theta I + v/theta [a]x + (1 - s/theta) a a'
        g, h, k = s / theta, v / theta, 1 - s / theta
        left = [[g + k * a0 * a0, k * a0 * a1 - h * a2, k * a0 * a2 + h * a1],
                [k * a0 * a1 + h * a2, g + k * a1 * a1, k * a1 * a2 - h * a0],
                [k * a0 * a2 - h * a1, k * a1 * a2 + h * a0, g + k * a2 * a2]]
        by_w = [[q[2] * left[1][j] - q[1] * left[2][j], q[0] * left[2][j] - q[2] * left[0][j],
                 q[1] * left[0][j] - q[0] * left[1][j]] for j in range(3)]  # by_w[j]: the derivative by w_j
        inverse = -1 / z
        u, v = x * inverse, y * inverse
        r2 = u * u + v * v
        d = 1 + r2 * (k1 + k2 * r2)
        e = 2 * f * (k1 + 2 * k2 * r2)
        uu, uv, vv = f * d + e * u * u, e * u * v, f * d + e * v * v
        # by (x, y, z): du = (dx + u dz) / -z, dv = (dy + v dz) / -z
        by_x = [[uu * inverse, uv * inverse], [uv * inverse, vv * inverse]]
        by_x.append([u * by_x[0][0] + v * by_x[1][0], u * by_x[0][1] + v * by_x[1][1]])
        of_camera, of_point = np.empty((len(f), 2, 9)), np.empty((len(f), 2, 3))
        for row in range(2):
            m0, m1, m2 = by_x[0][row], by_x[1][row], by_x[2][row]
            for j in range(3):
                of_camera[:, row, j] = m0 * by_w[j][0] + m1 * by_w[j][1] + m2 * by_w[j][2]
                of_point[:, row, j] = m0 * rotation[0][j] + m1 * rotation[1][j] + m2 * rotation[2][j]
            of_camera[:, row, 3], of_camera[:, row, 4], of_camera[:, row, 5] = m0, m1, m2
            image = v if row else u
            of_camera[:, row, 6], of_camera[:, row, 7], of_camera[:, row, 8] = d * image, f * r2 * image, f * r2 * r2 * image
        return [of_camera, of_point]


def read_bal(path):
    """cameras (m, 9), points (k, 3), indices (n, 2), pixels (n, 2)"""
    fields = np.array(path.read_text(encoding="ascii").split(), dtype=float)
    cameras, points, observations = (int(x) for x in fields[:3])
    rows = fields[3:3 + 4 * observations].reshape(-1, 4)
    rest = fields[3 + 4 * observations:]
    return (rest[:9 * cameras].reshape(-1, 9), rest[9 * cameras:].reshape(-1, 3)[:points], rows[:, :2].astype(int), rows[:, 2:])


def bundle_graph(path, edge):
    cameras, points, indices, pixels = read_bal(path)
    graph = boxplus.Graph()
    graph.add_vertices(boxplus.Vector9, np.arange(len(cameras)), cameras)
    first = len(cameras)
    graph.add_vertices(boxplus.Vector3, first + np.arange(len(points)), points)
    graph.add_edges(edge, indices[:, 0], first + indices[:, 1], measurements=pixels)
    for point in range(first, first + len(points)):
        graph.set_eliminated(point, True)
    return graph


def timed(action):
    begin = time.perf_counter()
    result = action()
    return time.perf_counter() - begin, result


def command_seconds(boxplus_path, path):
    report = json.loads(subprocess.run([boxplus_path, "optimize", path, "-o", "/dev/null", "--threads", str(THREADS), "--json", "-"],
                                       capture_output=True, text=True, check=True).stdout)
    return report["time_s"]["optimize"], report["chi2_final"]


def pose_graph_row(boxplus_path, path):
    text = path.read_text(encoding="utf-8")
    arrays = parse_g2o(text)
    command, module, both = [], [], []
    for _ in range(REPETITIONS):
        command.append(command_seconds(boxplus_path, path)[0])
        construction, graph = timed(lambda: graph_from_arrays(arrays))
        run, report = timed(lambda: boxplus.optimize(graph, threads=THREADS))
        module.append(run)
        both.append(run + construction)
    c, m, b = (statistics.median(x) for x in (command, module, both))
    return (f"| {path.stem} | {1e3 * c:.2f} | {1e3 * m:.2f} | {m / c:.2f} | {1e3 * b:.2f} | {b / c:.2f} | "
            f"{report.chi2_final:.9g} |")


def bundle_rows(path):
    rows = []
    native = []
    for _ in range(REPETITIONS):
        graph = boxplus.load(path)
        seconds, expected = timed(lambda: boxplus.optimize(graph, threads=THREADS))
        native.append(seconds / max(expected.iterations, 1))
    rows.append(f"| native | {1e3 * statistics.median(native):.1f} | 1 | {expected.iterations} | {expected.chi2_final:.9g} |")
    for name, edge in (("NumPy, with Jacobians", ReprojectionWithJacobians()), ("NumPy, dual numbers", Reprojection())):
        times = []
        for _ in range(REPETITIONS):
            graph = bundle_graph(path, edge)
            seconds, report = timed(lambda: boxplus.optimize(graph, threads=THREADS))
            times.append(seconds / max(report.iterations, 1))
        ratio = statistics.median(times) / statistics.median(native)
        rows.append(f"| {name} | {1e3 * statistics.median(times):.1f} | {ratio:.2f} | {report.iterations} | {report.chi2_final:.9g} |")
    return rows


def main(boxplus_path, data):
    data = pathlib.Path(data)
    print("\n## Python\n\nOne thread; medians of", REPETITIONS, "runs, in ms. The graphs of the module are made from NumPy arrays.\n")
    print("| file | command | module | × | with construction | × | chi2 |\n|---|--:|--:|--:|--:|--:|--:|")
    for name in ("posegraph2d/M3500.g2o", "posegraph3d/sphere2500.g2o"):
        print(pose_graph_row(boxplus_path, data / name), flush=True)
    print("\nBundle adjustment of problem-21-11315 with error functions in Python, per iteration.\n")
    print("| error function | ms | × | iterations | chi2 |\n|---|--:|--:|--:|--:|")
    for row in bundle_rows(data / "bal" / "problem-21-11315-pre.txt"):
        print(row, flush=True)


if __name__ == "__main__":
    main(*sys.argv[1:])
