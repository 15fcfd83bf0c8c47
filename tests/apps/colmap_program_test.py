#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tests that the program COLMAP reads what boxplus writes, and agrees with it. Is skipped if COLMAP is not installed (exit code 77)."""

import json
import os
import re
import shutil
import subprocess
import sys

from colmap_test import model
from command_case import CommandCase, main, run

def colmap(*words):
    """Runs a command of COLMAP, and returns its output. Newer versions print to stderr."""
    done = subprocess.run(["colmap", *map(str, words)], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, encoding="utf-8",
                          check=False, timeout=100, env={**os.environ, "QT_QPA_PLATFORM": "offscreen"})
    if done.returncode != 0:
        raise AssertionError(done.stdout)
    return done.stdout

def costs(output):
    """The costs that bundle_adjuster prints, one for each iteration. Each of them has seven digits."""
    return [float(cost) for cost in re.findall(r"^ +\d+ +(\S+)(?: +\S+){8}$", output, re.MULTILINE)]

def rotated(quaternion, point):
    w, x, y, z = quaternion
    rows = ((1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)),
            (2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)),
            (2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)))
    return [sum(a * b for a, b in zip(row, point, strict=True)) for row in rows]

def radial(parameters, point):
    """The pixel of a camera of COLMAP's model RADIAL, or SIMPLE_RADIAL."""
    f, cx, cy, k1, k2 = (*parameters, 0)[:5]
    u, v = point[0] / point[2], point[1] / point[2]
    scale = f * (1 + k1 * (u * u + v * v) + k2 * (u * u + v * v) ** 2)
    return scale * u + cx, scale * v + cy

class ColmapProgramTest(CommandCase):
    def setUp(self):
        super().setUp()
        self.start, self.binary, self.text = self.path / "start", self.path / "binary", self.path / "text"
        done = run("simulate", "ba", "--shape", "ring", "--cameras", 12, "--points", 800, "-o", f"{self.start}/")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.report = self.optimized(self.start, self.binary)
        self.convert(self.binary, self.text)

    def optimized(self, folder, out, *words):
        done = run("optimize", folder, "-o", f"{out}/", "--start", "current", "--iterations", 50, "-q", "--json", "-", *words)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return json.loads(done.stdout)

    def convert(self, folder, out):
        self.assertEqual(run("convert", folder, out, "--format", "colmap" if out == self.binary else "colmap-text").returncode, 0)

    def chi2(self, folder):
        return json.loads(run("info", folder, "--json", "-").stdout)["chi2"]

    def bundle_adjuster(self, folder, out, iterations=50):
        out.mkdir(exist_ok=True)
        return costs(colmap("bundle_adjuster", "--input_path", folder, "--output_path", out,
                            "--BundleAdjustment.max_num_iterations", iterations))

    def mean_error(self, folder):
        """The mean over all points of the mean distance of a point's pixels from those of its images, from files as text."""
        def lines(name):
            return [line.split() for line in (folder / name).read_text(encoding="utf-8").splitlines() if not line.startswith("#")]
        cameras = {line[0]: [float(x) for x in line[4:]] for line in lines("cameras.txt")}
        points = {line[0]: [float(x) for x in line[1:4]] for line in lines("points3D.txt")}
        errors = {}
        images = lines("images.txt")
        for image, features in zip(images[::2], images[1::2], strict=True):
            pose = [float(x) for x in image[1:8]]
            for u, v, point in zip(features[::3], features[1::3], features[2::3], strict=True):
                if point != "-1":
                    seen = [a + b for a, b in zip(rotated(pose[:4], points[point]), pose[4:], strict=True)]
                    x, y = radial(cameras[image[8]], seen)
                    errors.setdefault(point, []).append(((x - float(u)) ** 2 + (y - float(v)) ** 2) ** 0.5)
        return sum(sum(of_point) / len(of_point) for of_point in errors.values()) / len(errors)

    def assert_mean_error(self, folder, expected):
        output = colmap("model_analyzer", "--path", folder)
        self.assertAlmostEqual(float(re.search(r"Mean reprojection error: ([\d.]+)px", output).group(1)), expected, delta=1e-6)

    def test_the_mean_reprojection_error_is_that_of_our_result_in_binary_and_in_text(self):
        expected = self.mean_error(self.text)
        self.assertLess(expected, 2)  # it was 14 at the start
        for folder in (self.binary, self.text):
            self.assert_mean_error(folder, expected)

    def test_the_optimum_is_that_of_bundle_adjuster(self):
        cost = self.bundle_adjuster(self.start, self.path / "out")
        self.assertAlmostEqual(2 * cost[0] / self.report["chi2_initial"], 1, delta=1e-6)
        self.assertAlmostEqual(2 * min(cost) / self.report["chi2_final"], 1, delta=1e-6)
        self.assertAlmostEqual(self.chi2(self.path / "out") / self.report["chi2_final"], 1, delta=1e-8)

    def test_the_optimum_with_principal_points_is_that_of_bundle_adjuster(self):
        report = self.optimized(self.binary, self.path / "ours", "--free", "principal-points")
        (self.path / "out").mkdir()
        cost = costs(colmap("bundle_adjuster", "--input_path", self.binary, "--output_path", self.path / "out",
                            "--BundleAdjustment.refine_principal_point", 1, "--BundleAdjustment.max_num_iterations", 50))
        self.assertLess(report["chi2_final"], self.report["chi2_final"])
        self.assertAlmostEqual(2 * min(cost) / report["chi2_final"], 1, delta=1e-6)

    def test_bundle_adjuster_stays_at_our_optimum(self):
        for folder in (self.binary, self.text):
            cost = self.bundle_adjuster(folder, self.path / "out", iterations=5)
            self.assertAlmostEqual(2 * cost[0] / self.report["chi2_final"], 1, delta=1e-6)
            self.assertAlmostEqual(min(cost) / cost[0], 1, delta=1e-6)
            self.assertAlmostEqual(self.chi2(self.path / "out") / self.report["chi2_final"], 1, delta=1e-8)

    def test_the_errors_of_points_are_new_even_if_nothing_moves(self):
        # bundle_adjuster of COLMAP 3.8 leaves the errors of its start in the model.
        self.bundle_adjuster(self.start, self.path / "out")
        self.assertLess(self.optimized(self.path / "out", self.binary)["iterations"], 3)
        self.assert_mean_error(self.binary, self.mean_error(self.text))

    def test_its_converter_reads_both_forms_and_we_read_what_it_writes(self):
        for folder, form in ((self.binary, "TXT"), (self.text, "BIN")):
            out = self.path / form
            out.mkdir()
            colmap("model_converter", "--input_path", folder, "--output_path", out, "--output_type", form)
            self.assertAlmostEqual(self.chi2(out) / self.report["chi2_final"], 1, delta=1e-9)

    def test_rigs_do_not_disturb_a_version_that_does_not_know_them(self):
        self.start = self.path / "rig"
        self.start.mkdir()
        texts = model()
        texts["cameras.txt"] += "5 SIMPLE_RADIAL 640 480 480 320 240 0\n"
        images = texts["images.txt"].splitlines()
        images[2] = images[2].replace(" 4 photos", " 5 photos")
        texts["images.txt"] = "\n".join(images) + "\n"
        texts["rigs.txt"] = "1 2 CAMERA 4 CAMERA 5 1 1 0 0 0 -1 0 0\n"  # camera 5 is right of camera 4
        poses = [" ".join(image.split()[1:8]) for image in images[::2]]
        texts["frames.txt"] = f"1 1 {poses[0]} 2 CAMERA 4 1 CAMERA 5 2\n2 1 {poses[2]} 1 CAMERA 4 3\n"
        for name, text in texts.items():
            (self.start / name).write_text(text, encoding="utf-8")
        out = self.path / "out"
        self.optimized(self.start, out, "--hold", "points,intrinsics")
        self.assertGreater(self.mean_error(out), 0.1)
        shutil.rmtree(self.binary)
        self.convert(out, self.binary)
        self.assertTrue((self.binary / "rigs.bin").exists())
        for folder in (out, self.binary):
            self.assert_mean_error(folder, self.mean_error(out))

if __name__ == "__main__":
    if not shutil.which("colmap"):
        print("SKIPPED: COLMAP is not installed")
        sys.exit(77)
    main()
