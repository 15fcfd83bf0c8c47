#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""For each camera model of COLMAP, `boxplus optimize` finds the true camera of a simulated model, whose pixels are computed here."""

import json
import math
import random

from command_case import CommandCase, main, run

WIDE, NARROW = 1.1, 0.6  # how far points are from the axis, in radians

def fisheye(x, y, z):
    r = math.hypot(x, y)
    scale = math.atan2(r, z) / r if r > 0 else 1 / z
    return scale * x, scale * y

def radial(u, v, *ks):
    factor = 1 + sum(k * (u * u + v * v) ** (i + 1) for i, k in enumerate(ks))
    return u * factor, v * factor

def tangential(u, v, p1, p2):
    r2 = u * u + v * v
    return 2 * p1 * u * v + p2 * (r2 + 2 * u * u), 2 * p2 * u * v + p1 * (r2 + 2 * v * v)

def sums(*pairs):
    return tuple(map(sum, zip(*pairs)))

def full_opencv(x, y, z, k1, k2, p1, p2, k3, k4, k5, k6):
    u, v = x / z, y / z
    r2 = u * u + v * v
    above, below = 1 + k1 * r2 + k2 * r2**2 + k3 * r2**3, 1 + k4 * r2 + k5 * r2**2 + k6 * r2**3
    return sums((u * above / below, v * above / below), tangential(u, v, p1, p2))

def fov(x, y, z, omega):
    r = math.hypot(x, y) / z
    scale = math.atan(2 * r * math.tan(omega / 2)) / (omega * r)
    return scale * x / z, scale * y / z

def thin_prism(x, y, z, k1, k2, p1, p2, k3, k4, sx1, sy1):
    u, v = fisheye(x, y, z)
    r2 = u * u + v * v
    return sums(radial(u, v, k1, k2, k3, k4), tangential(u, v, p1, p2), (sx1 * r2, sy1 * r2))

def aria(x, y, z, k0, k1, k2, k3, k4, k5, p0, p1, s0, s1, s2, s3):
    u, v = radial(*fisheye(x, y, z), k0, k1, k2, k3, k4, k5)
    r2 = u * u + v * v
    return sums((u, v), tangential(u, v, p1, p0), (s0 * r2 + s1 * r2**2, s2 * r2 + s3 * r2**2))

def division(x, y, z, k):
    scale = 2 / (z + math.sqrt(z * z - 4 * k * (x * x + y * y)))
    return scale * x, scale * y

def eucm(x, y, z, alpha, beta):
    scale = 1 / (alpha * math.sqrt(beta * (x * x + y * y) + z * z) + (1 - alpha) * z)
    return scale * x, scale * y

def plane(x, y, z, *ks):
    return radial(x / z, y / z, *ks)

def equidistant(x, y, z, *ks):
    return radial(*fisheye(x, y, z), *ks)

# The model: its number of focal lengths, the image of a point for focal length 1, and the true parameters of the image.
MODELS = {
    "SIMPLE_PINHOLE": (1, NARROW, plane, []),
    "PINHOLE": (2, NARROW, plane, []),
    "SIMPLE_RADIAL": (1, NARROW, plane, [-0.1]),
    "RADIAL": (1, NARROW, plane, [-0.1, 0.03]),
    "OPENCV": (2, NARROW, lambda x, y, z, k1, k2, p1, p2: sums(plane(x, y, z, k1, k2), tangential(x / z, y / z, p1, p2)),
               [-0.1, 0.03, 2e-3, -3e-3]),
    "OPENCV_FISHEYE": (2, WIDE, equidistant, [-0.04, 0.02, 0.01, -0.005]),
    "FULL_OPENCV": (2, NARROW, full_opencv, [-0.1, 0.03, 2e-3, -3e-3, 0.01, 0.02, 0.05, -0.01]),
    "FOV": (2, NARROW, fov, [0.9]),
    "SIMPLE_RADIAL_FISHEYE": (1, WIDE, equidistant, [-0.04]),
    "RADIAL_FISHEYE": (1, WIDE, equidistant, [-0.04, 0.02]),
    "THIN_PRISM_FISHEYE": (2, WIDE, thin_prism, [-0.04, 0.02, 2e-3, -3e-3, 0.01, -0.005, 1e-3, -2e-3]),
    "RAD_TAN_THIN_PRISM_FISHEYE": (2, WIDE, aria, [-0.04, 0.02, 0.01, -0.005, 0.004, -0.002, 2e-3, -3e-3, 1e-3, -2e-3, 3e-3, 1e-3]),
    "SIMPLE_DIVISION": (1, WIDE, division, [-0.2]),
    "DIVISION": (2, WIDE, division, [-0.2]),
    "SIMPLE_FISHEYE": (1, WIDE, equidistant, []),
    "FISHEYE": (2, WIDE, equidistant, []),
    "EUCM": (2, WIDE, eucm, [0.6, 1.1]),
}

def turned(q, x):
    """The vector x, turned by the quaternion (w, x, y, z)."""
    w, (a, b, c) = q[0], q[1:]
    t = [2 * (b * x[2] - c * x[1]), 2 * (c * x[0] - a * x[2]), 2 * (a * x[1] - b * x[0])]
    return [x[0] + w * t[0] + b * t[2] - c * t[1], x[1] + w * t[1] + c * t[0] - a * t[2], x[2] + w * t[2] + a * t[1] - b * t[0]]

def pixel(name, parameters, point):
    focal_lengths, _, image, _ = MODELS[name]
    u, v = image(*point, *parameters[focal_lengths + 2:])
    return parameters[0] * u + parameters[focal_lengths], parameters[focal_lengths - 1] * v + parameters[focal_lengths + 1]

def true_parameters(name):
    focal_lengths, _, _, distortion = MODELS[name]
    return [500, 510][:focal_lengths] + [320.25, 240.5] + distortion

def model(name):
    """The texts of a model with exact pixels. Poses, points, focal lengths and distortion begin beside the truth."""
    numbers, truth, width = random.Random(5), true_parameters(name), MODELS[name][1]
    points = []
    for _ in range(150):
        angle, direction, depth = width * math.sqrt(numbers.random()), 2 * math.pi * numbers.random(), numbers.uniform(3, 6)
        points.append([depth * math.tan(angle) * math.cos(direction), depth * math.tan(angle) * math.sin(direction), depth])
    images = []
    for i in range(6):
        half = [0.05 * numbers.uniform(-1, 1) for _ in range(3)]
        q = [math.sqrt(1 - sum(x * x for x in half)), *half]
        t = [numbers.uniform(-0.6, 0.6), numbers.uniform(-0.6, 0.6), numbers.uniform(-0.3, 0.3)]
        start = [x + 0.01 * numbers.gauss(0, 1) for x in t]
        images.append(" ".join(map(repr, [i + 1, *q, *start, 4])) + f" {i}.jpg")
        features = [pixel(name, truth, [a + b for a, b in zip(turned(q, point), t)]) for point in points]
        images.append(" ".join(f"{u!r} {v!r} {k + 1}" for k, (u, v) in enumerate(features)))
    focal_lengths = MODELS[name][0]
    start = [0.98 * f for f in truth[:focal_lengths]] + truth[focal_lengths:focal_lengths + 2]
    start += [0.8 * x for x in truth[focal_lengths + 2:]]
    lines = [" ".join(map(repr, [k + 1, *(x + 0.02 * numbers.gauss(0, 1) for x in point), 0, 0, 0, -1])) for k, point in enumerate(points)]
    return {"cameras.txt": f"4 {name} 640 480 {' '.join(map(repr, start))}\n", "images.txt": "\n".join(images) + "\n",
            "points3D.txt": "\n".join(lines) + "\n"}

class ColmapCamerasTest(CommandCase):
    def test_every_model_is_optimized_to_the_truth(self):
        for name in MODELS:
            folder, out, text = self.path / name, self.path / f"{name}_out", self.path / f"{name}_text"
            folder.mkdir()
            for file, content in model(name).items():
                (folder / file).write_text(content, encoding="utf-8")
            with self.subTest(name):
                # The binary files have the number of the model instead of its name.
                self.assertEqual(run("convert", folder, out, "--format", "colmap").returncode, 0)
                done = run("optimize", out, "-o", out, "--json", "-", "--iterations", 300)
                self.assertEqual(done.returncode, 0, done.stderr)
                report = json.loads(done.stdout)
                self.assertGreater(report["chi2_initial"], 1000)
                self.assertLess(report["chi2_final"], 1e-6)
                run("convert", out, text, "--format", "colmap-text")
                lines = (text / "cameras.txt").read_text(encoding="utf-8").splitlines()
                fields = next(line.split() for line in lines if not line.startswith("#"))
                self.assertEqual(fields[:4], ["4", name, "640", "480"])
                found, truth = list(map(float, fields[4:])), true_parameters(name)
                for angle in (0.05, 0.3, 0.5):
                    point = [math.sin(angle) * 0.6, math.sin(angle) * -0.8, math.cos(angle)]
                    for a, b in zip(pixel(name, found, point), pixel(name, truth, point), strict=True):
                        self.assertAlmostEqual(a, b, delta=1e-4)

    def test_the_table_has_all_models_that_boxplus_knows(self):
        for file, content in {**model("PINHOLE"), "cameras.txt": "4 NONE 640 480 1\n"}.items():
            self.written(file, content)
        self.assert_refused(run("info", self.path), f"expected a camera model ({', '.join(MODELS)})")

if __name__ == "__main__":
    main()
