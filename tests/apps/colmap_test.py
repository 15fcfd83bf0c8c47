#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tests that every sub-command that reads graphs works with COLMAP's sparse models, and that all of them can be drawn."""

import json
import os
import pathlib
import re
import resource
import shutil
import signal
import subprocess
import sys
import unittest
import xml.etree.ElementTree as xml

from command_case import BOXPLUS, CommandCase, main, run

CENTERS = [(0, 0), (1, 0), (0, 1)]
POINTS = [(x, y, 8 + x * y) for x in (-2, -1, 1, 2) for y in (-1, 0, 1)]

def model():
    """The texts of three images of one camera, which look along z from known places. The first estimates are off."""
    points = [f"{k + 1} {x} {y} {z + 0.1} 10 20 30 -1 " + " ".join(f"{i + 1} {k}" for i in range(len(CENTERS)))
              for k, (x, y, z) in enumerate(POINTS)]
    images = []
    for i, (cx, cy) in enumerate(CENTERS):
        images.append(f"{i + 1} 1 0.001 0 0 {-cx} {-cy + 0.05} 0 4 photos/{i}.jpg")
        images.append(" ".join(f"{500 * (x - cx) / z + 320!r} {500 * (y - cy) / z + 240!r} {k + 1}"
                               for k, (x, y, z) in enumerate(POINTS)))
    return {"cameras.txt": "4 SIMPLE_RADIAL 640 480 480 320 240 0\n",
            "images.txt": "\n".join(images) + "\n", "points3D.txt": "\n".join(points) + "\n"}

class ColmapTest(CommandCase):
    def setUp(self):
        super().setUp()
        self.folder = self.path / "sparse"
        self.folder.mkdir()
        for name, text in model().items():
            (self.folder / name).write_text(text, encoding="utf-8")

    def lines(self, folder, name):
        text = (folder / name).read_text(encoding="utf-8")
        return [line.split() for line in text.splitlines() if not line.startswith("#")]

    def test_a_model_is_optimized_with_its_intrinsics(self):
        out = self.path / "out" / "0"
        done = run("optimize", self.folder, "-o", out, "--json", self.path / "report.json")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("eliminated      12 vertices", done.stdout)
        report = json.loads((self.path / "report.json").read_text(encoding="utf-8"))
        self.assertLess(report["chi2_final"], 1e-6)
        camera = self.lines(out, "cameras.txt")[0]
        self.assertEqual(camera[:4] + camera[5:7], ["4", "SIMPLE_RADIAL", "640", "480", "320", "240"])
        self.assertNotEqual(camera[4], "480")
        images = self.lines(out, "images.txt")
        self.assertEqual([line[9] for line in images[::2]], ["photos/0.jpg", "photos/1.jpg", "photos/2.jpg"])
        features = self.lines(self.folder, "images.txt")[1]
        self.assertEqual([float(x) for x in images[1]], [float(x) for x in features])
        for point in self.lines(out, "points3D.txt"):
            self.assertEqual(point[4:7], ["10", "20", "30"])
            self.assertLess(float(point[7]), 1e-3)

    def priors(self, rows, columns="image,x,y,z,sigma"):
        path = self.path / "priors.csv"
        path.write_text("\n".join([columns, *(",".join(map(str, row)) for row in rows)]) + "\n", encoding="utf-8")
        return path

    def centers(self, folder):
        """The positions of the cameras of a model, by the name of the image."""
        found = {}
        for line in self.lines(folder, "images.txt")[::2]:
            w, x, y, z, *translation = map(float, line[1:8])
            back = [[1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)],
                    [2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)],
                    [2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)]]
            found[line[9]] = [-sum(a * t for a, t in zip(row, translation, strict=True)) for row in back]
        return found

    def test_measured_positions_move_the_model(self):
        measured = {f"photos/{i}.jpg": (100 - 2 * cy, 200 + 2 * cx, 30) for i, (cx, cy) in enumerate(CENTERS)}
        file = self.priors([(name, *position, 0.001) for name, position in measured.items()] + [("photos/9.jpg", 1, 2, 3, 1)])
        out = self.path / "out"
        done = run("optimize", self.folder, "-o", out, "--position-priors", file, "--json", "-", "--hold", "intrinsics")
        self.assertIn("priors.csv: 1 row names no image of the graph", done.stderr)
        report = json.loads(done.stdout)
        priors = report["position_priors"]
        self.assertEqual((priors["positions"], priors["directions"], priors["unknown_images"]), (3, 0, 1))
        self.assertAlmostEqual(priors["scale"], 2, 2)
        for name, center in self.centers(out).items():
            for found, expected in zip(center, measured[name], strict=True):
                self.assertAlmostEqual(found, expected, 3)

    def test_one_wrong_position_does_not_move_the_model(self):
        centers = [(0, 0), (1, 0), (0, 1), (1, 1), (2, 0), (2, 1)]
        images = []
        for i, (cx, cy) in enumerate(centers):
            images.append(f"{i + 1} 1 0 0 0 {-cx} {-cy} 0 4 photos/{i}.jpg")
            images.append(" ".join(f"{480 * (x - cx) / z + 320!r} {480 * (y - cy) / z + 240!r} {k + 1}"
                                   for k, (x, y, z) in enumerate(POINTS)))
        points = [f"{k + 1} {x} {y} {z} 10 20 30 -1 " + " ".join(f"{i + 1} {k}" for i in range(len(centers)))
                  for k, (x, y, z) in enumerate(POINTS)]
        for name, lines in (("images.txt", images), ("points3D.txt", points)):
            (self.folder / name).write_text("\n".join(lines) + "\n", encoding="utf-8")
        rows = [(f"photos/{i}.jpg", 2 * cx, 2 * cy + 0.001 * i, 0, 0.01) for i, (cx, cy) in enumerate(centers)]
        rows[5] = ("photos/5.jpg", 100, 200, 300, 0.01)
        done = run("optimize", self.folder, "-o", self.path / "out", "--position-priors", self.priors(rows), "--kernel", "Cauchy",
                   "--json", "-")
        self.assertIn("1 position is far from the model", done.stderr)
        self.assertAlmostEqual(json.loads(done.stdout)["position_priors"]["scale"], 2, 2)
        for found, expected in zip(self.centers(self.path / "out")["photos/4.jpg"], (4, 0, 0), strict=True):
            self.assertAlmostEqual(found, expected, 1)

    def test_gravity_turns_the_model_upright(self):
        rows = [(f"photos/{i}.jpg", "", "", "", 0, 1, 0) for i in range(3)]  # down is +y of a camera that looks ahead
        file = self.priors(rows, "image,x,y,z,gx,gy,gz")
        out = self.path / "out"
        done = run("optimize", self.folder, "-o", out, "--position-priors", file, "--json", "-")
        self.assertEqual((done.returncode, json.loads(done.stdout)["position_priors"]["directions"]), (0, 3))
        centers = [self.centers(out)[f"photos/{i}.jpg"] for i in range(3)]
        self.assertAlmostEqual(centers[0][2], centers[1][2], 2)  # the first two are beside each other
        self.assertLess(centers[2][2], centers[0][2] - 0.5)  # and the last one is below

    def test_wrong_priors_are_refused_with_their_place(self):
        for text, complaint in (("", "expected a row with the names of columns"),
                                ("image,x,y\n", "priors.csv:1:1: expected a column 'z'"),
                                ("name,x,y,z\n", "priors.csv:1:1: expected one of the columns image, x, y"),
                                ("image,x,x,z\n", "priors.csv:1:9: expected each column once, got 'x' again"),
                                ("image,x,y,z\na,1,2\n", "expected 4 fields, as in the first row, got 3"),
                                ("image,x,y,z\na,,2,3\n", "priors.csv:2:3: expected x, got ''"),
                                ("image,x,y,z\na,1,two,3\n", "priors.csv:2:5: expected y, got 'two'"),
                                ("image,x,y,z,sigma\na,1,2,3,0\n", "priors.csv:2:9: expected sigma above 0, got 0"),
                                ("image,x,y,z,gx,gy,gz\na,1,2,3,0,0,0\n", "expected a direction, got zeros"),
                                ("\ufeffimage,x,y,z\nb,1,2,3\nb,1,2,3\n", "priors.csv:3:1: expected each image once, got the image of line 2"),
                                ("image,x,y,z\nphotos/1.jpg,1,2,3\n", "expected positions of three images")):
            path = self.path / "priors.csv"
            path.write_text(text, encoding="utf-8")
            self.assert_refused(run("optimize", self.folder, "--position-priors", path), complaint)

    def test_the_cameras_of_a_rig_move_together(self):
        offset = 0.3  # camera 5 is right of camera 4
        images, frames = [], []
        for i, (cx, cy) in enumerate(CENTERS):
            start = -cx + 0.02 * i
            pose = f"1 0.001 0 0 {start!r} {-cy + 0.05} 0"
            frames.append(f"{i + 1} 1 {pose} 2 CAMERA 4 {2 * i + 1} CAMERA 5 {2 * i + 2}")
            for k, shift in enumerate((0, offset)):
                images.append(f"{2 * i + 1 + k} 1 0.001 0 0 {start - shift!r} {-cy + 0.05} 0 {4 + k} {i}/{k}.jpg")
                images.append(" ".join(f"{500 * (x - cx - shift) / z + 320!r} {500 * (y - cy) / z + 240!r} {j + 1}"
                                       for j, (x, y, z) in enumerate(POINTS)))
        texts = {"cameras.txt": "4 SIMPLE_RADIAL 640 480 480 320 240 0\n5 SIMPLE_PINHOLE 640 480 490 320 240\n",
                 "images.txt": "\n".join(images) + "\n", "frames.txt": "\n".join(frames) + "\n",
                 "points3D.txt": "".join(f"{j + 1} {x} {y} {z + 0.1} 10 20 30 -1 " +
                                         " ".join(f"{k} {j}" for k in range(1, 2 * len(CENTERS) + 1)) + "\n"
                                         for j, (x, y, z) in enumerate(POINTS)),
                 "rigs.txt": f"1 2 CAMERA 4 CAMERA 5 1 1 0 0 0 {-offset} 0 0\n"}
        for name, text in texts.items():
            (self.folder / name).write_text(text, encoding="utf-8")
        out = self.path / "out"
        done = run("optimize", self.folder, "-o", out, "--json", self.path / "report.json", "--free", "poses")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertLess(json.loads((self.path / "report.json").read_text(encoding="utf-8"))["chi2_final"], 1e-6)
        self.assertEqual(self.lines(out, "rigs.txt"), self.lines(self.folder, "rigs.txt"))
        moved = {line[0]: [float(x) for x in line[1:8]] for line in self.lines(out, "images.txt")[::2]}
        for frame in self.lines(out, "frames.txt"):
            pose = [float(x) for x in frame[2:9]]
            self.assertEqual(moved[frame[12]], pose)
            for value, other, shift in zip(pose, moved[frame[15]], [0] * 4 + [-offset, 0, 0], strict=True):
                self.assertAlmostEqual(value + shift, other, 12)
        self.assertEqual(run("info", out).returncode, 0)
        rows = [(f"{i}/1.jpg", 2 * (cx + offset), 2 * cy, 0, 0.01) for i, (cx, cy) in enumerate(CENTERS)]
        done = run("optimize", out, "-o", self.path / "moved", "--position-priors", self.priors(rows), "--json", "-")
        self.assertEqual((done.returncode, json.loads(done.stdout)["position_priors"]["positions"]), (0, 3), done.stderr)
        centers = self.centers(self.path / "moved")
        for name, x, y, _, _ in rows:
            self.assertAlmostEqual(centers[name][0], x, 3)
            self.assertAlmostEqual(centers[name][1], y, 3)
        self.assertAlmostEqual(centers["1/1.jpg"][0] - centers["1/0.jpg"][0], 2 * offset, 3)
        self.assertEqual(run("convert", out, self.path / "rig.json").returncode, 0)
        chi2 = [json.loads(run("info", graph, "--json", "-").stdout)["chi2"] for graph in (out, self.path / "rig.json")]
        self.assertAlmostEqual(*chi2, 12)
        (out / "frames.txt").write_text(texts["frames.txt"], encoding="utf-8")
        self.assert_refused(run("info", out), "frames.txt:2:41: expected frame 2 where image 3 is, got a pose that differs")

    def test_parts_are_held_and_freed_for_one_run(self):
        out = self.path / "out"
        for words, kept in ((["--hold", "intrinsics"], {4, 5, 6, 7}), (["--hold", "focal-lengths"], {4, 5, 6}),
                            (["--free", "principal-points"], set()),
                            (["--hold", "focal-lengths,distortion", "--free", "principal-points"], {4, 7})):
            done = run("optimize", self.folder, "-o", out, *words)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            before, after = self.lines(self.folder, "cameras.txt")[0], self.lines(out, "cameras.txt")[0]
            self.assertEqual({k for k in range(4, 8) if float(before[k]) == float(after[k])}, kept, words)
        self.assert_refused(run("optimize", self.folder, "--hold", "lens"), "got 'lens'")
        graph = self.written("graph.g2o", "VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 1 0 0\nEDGE_SE2 0 1 1 0 0 1 0 0 1 0 1\n")
        self.assert_refused(run("optimize", graph, "--hold", "points"), "--hold: expected a graph of bundle adjustment with points")
        self.assert_refused(run("optimize", self.folder, "--hold", "points", "--free", "points"), "different parts, got points")

    def test_the_noise_of_pixels_scales_chi2_and_is_not_written(self):
        chi2 = {}
        for sigma in ("1", "0.5"):
            done = run("optimize", self.folder, "-o", self.path / "out", "--pixel-sigma", sigma, "--json", "-")
            self.assertEqual(done.returncode, 0, done.stderr)
            chi2[sigma] = json.loads(done.stdout)["chi2_initial"]
            expected = "" if sigma == "1" else "the format does not keep the information of 36 edges"
            self.assertIn(expected, done.stderr)
        self.assertAlmostEqual(chi2["0.5"] / chi2["1"], 4, places=9)

    def test_a_model_can_be_converted_to_binary_and_back(self):
        binary, text = self.path / "binary", self.path / "text"
        done = run("convert", self.folder, binary, "--format", "colmap")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("15 vertices, 36 edges, 1 parameter", done.stdout)
        self.assertEqual(sorted(file.name for file in binary.iterdir()), ["cameras.bin", "images.bin", "points3D.bin"])
        self.assertEqual(run("convert", binary, text, "--format", "colmap-text").returncode, 0)
        for name in model():
            self.assertEqual([[float(x) if re.fullmatch(r"[-\d.e]+", x) else x for x in line]
                              for line in self.lines(text, name)],
                             [[float(x) if re.fullmatch(r"[-\d.e]+", x) else x for x in line]
                              for line in self.lines(self.folder, name)], name)

    def test_a_model_becomes_bal_and_bal_becomes_a_model(self):
        bal, again = self.path / "out.bal", self.path / "again"
        self.assertEqual(run("convert", self.folder, bal).returncode, 0)
        again.mkdir()
        self.assertEqual(run("convert", bal, again).returncode, 0)
        chi2 = [json.loads(run("info", graph, "--json", "-").stdout)["chi2"] for graph in (self.folder, bal, again)]
        self.assertAlmostEqual(chi2[1] / chi2[0], 1, places=9)
        self.assertAlmostEqual(chi2[2] / chi2[0], 1, places=9)

    def test_what_only_json_keeps_is_named(self):
        graph = self.path / "graph.json"
        self.assertEqual(run("convert", self.folder, graph).returncode, 0)
        content = json.loads(graph.read_text(encoding="utf-8"))
        content["edges"][0]["level"] = 2
        graph.write_text(json.dumps(content), encoding="utf-8")
        done = run("convert", graph, f"{self.path / 'out'}/")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("only JSON keeps that 1 edges have another level than 0", done.stderr)

    def test_a_model_becomes_a_point_cloud(self):
        out = self.path / "cloud.ply"
        self.assertEqual(run("convert", self.folder, out).returncode, 0)
        content = out.read_bytes()
        header = content[:content.index(b"end_header\n") + 11]
        self.assertIn(b"element vertex 27\n", header)
        self.assertEqual(len(content) - len(header), 27 * 27 + 24 * 8)
        self.assert_refused(run("info", out), "got .ply, which boxplus can only write")

    def test_a_model_can_be_inspected(self):
        done = run("info", self.folder)
        self.assertRegex(done.stdout, r"worst edges +chi2 +share +between\n")
        self.assertNotIn("?", done.stdout)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("Reprojection<SIMPLE_RADIAL>", done.stdout)
        self.assertIn("unknowns      50 ", done.stdout)  # 2 poses (1 pose is held), 12 points, f and k

    def test_models_can_be_compared(self):
        out = self.path / "out"
        self.assertEqual(run("optimize", self.folder, "-o", out).returncode, 0)
        done = run("compare", out, self.folder)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("3 poses", done.stdout)

    def test_a_free_scale_is_mentioned_if_it_explains_the_error(self):
        larger = self.path / "larger"
        shutil.copytree(self.folder, larger)
        images = (larger / "images.txt").read_text(encoding="utf-8").splitlines()
        for k in (0, 2, 4):
            fields = images[k].split()
            images[k] = " ".join(fields[:5] + [str(3 * float(x)) for x in fields[5:8]] + fields[8:])
        (larger / "images.txt").write_text("\n".join(images) + "\n", encoding="utf-8")
        self.assertIn("with --scale, the RMSE of the ATE is", run("compare", larger, self.folder).stdout)
        compared = json.loads(run("compare", larger, self.folder, "--json", "-").stdout)
        self.assertLess(compared["ate_rmse_m_with_scale"], 0.5 * compared["ate_m"]["rmse"])
        self.assertNotIn("--scale", run("compare", larger, self.folder, "--scale").stdout)
        self.assertNotIn("--scale", run("compare", self.folder, self.folder).stdout)
        done = run("plot", self.folder, "-o", "-", "--format", "svg", "--truth", larger)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("#f2d06b", done.stdout)
        self.assertIn(">truth<", done.stdout)

    def test_a_model_can_be_drawn_with_cameras_as_pyramids(self):
        out = self.path / "out.svg"
        done = run("plot", self.folder, "-o", out)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        text = out.read_text(encoding="utf-8")
        xml.fromstring(text)
        self.assertIn("3 cameras, 12 points, 36 observations", text)
        self.assertIn(">cameras<", text)

    def test_far_points_do_not_make_the_picture_tiny(self):
        lines = (self.folder / "points3D.txt").read_text(encoding="utf-8").splitlines()
        near = [f"{k + 100} {k % 10} {k // 10} 9 0 0 0 -1" for k in range(100)]
        (self.folder / "points3D.txt").write_text(
            "\n".join([*lines, *near, "999 1e6 1e6 1e6 0 0 0 -1"]) + "\n", encoding="utf-8")
        out = self.path / "out.svg"
        self.assertEqual(run("plot", self.folder, "-o", out).returncode, 0)
        text = out.read_text(encoding="utf-8")
        self.assertRegex(text, r"113 points \(\d+ outside\)")
        bar = re.search(r'text-anchor="middle"[^>]*>([\d.e+]+)<', text)
        self.assertLess(float(bar.group(1)), 100)

    def test_reprojection_errors_are_drawn_by_image(self):
        out = self.path / "errors.svg"
        done = run("plot", self.folder, self.folder, "-o", out, "--reprojection-errors")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        text = out.read_text(encoding="utf-8")
        xml.fromstring(text)
        self.assertIn("3 images, 36 observations", text)
        self.assertRegex(text, r"median \d")
        graph = self.written("graph.g2o", "VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 1 0 0\nEDGE_SE2 0 1 1 0 0 1 0 0 1 0 1\n")
        self.assert_refused(run("plot", graph, "-o", out, "--reprojection-errors"), "expected a graph of bundle adjustment")
        self.assert_refused(run("plot", self.folder, "-o", out, "--reprojection-errors", "--truth", self.folder), "--truth")

    def test_bad_input_is_refused(self):
        (self.folder / "cameras.txt").write_text("4 FISH 640 480 480 320 240 0\n", encoding="utf-8")
        out = self.path / "out"
        for words in (["optimize", self.folder, "-o", out], ["info", self.folder], ["convert", self.folder, out],
                      ["plot", self.folder, "-o", self.path / "out.svg"]):
            self.assert_refused(run(*words), "cameras.txt:1:3: expected a camera model (SIMPLE_PINHOLE, PINHOLE")
        self.assertFalse(out.exists())
        (self.folder / "images.txt").unlink()
        self.assert_refused(run("info", self.folder), "images.txt: cannot be opened")
        self.assert_refused(run("info", self.path), "got a folder without the files of a graph")

    def test_a_folder_cannot_be_standard_output_or_hold_another_graph(self):
        self.assert_refused(run("optimize", self.folder, "-o", "-"), "as one text")
        self.assert_refused(run("convert", self.folder, "-"), "as one text")
        graph = self.written("graph.g2o", "VERTEX_SE2 0 0 0 0\n")
        self.assert_refused(run("convert", graph, str(self.path / "out") + "/"), "got vertex 0 of type SE2")
        self.assertFalse((self.path / "out").exists())

    def written_models(self):
        """A folder with a binary model, and the contents of its files and of the files of an optimized model."""
        folder, optimized = self.path / "folder", self.path / "optimized"
        run("convert", self.folder, folder, "--format", "colmap")
        run("optimize", folder, "-o", optimized)
        return folder, self.contents(folder), self.contents(optimized)

    def contents(self, folder):
        return {file.name: file.read_bytes() for file in folder.iterdir()}

    def restore(self, folder, files):
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir()
        for name, content in files.items():
            (folder / name).write_bytes(content)

    def test_a_model_is_not_changed_if_the_disk_is_full(self):
        folder, old, new = self.written_models()
        def limit():
            resource.setrlimit(resource.RLIMIT_FSIZE, (most, most))
        self.assertLess(len(new["cameras.bin"]), len(new["points3D.bin"]))
        for name in ("cameras.bin", "points3D.bin"):
            most = len(new[name]) - 1
            done = subprocess.run([BOXPLUS, "optimize", folder, "-q", "-o", folder], capture_output=True, encoding="utf-8", check=False,
                                  preexec_fn=limit, restore_signals=False)
            self.assertEqual(done.returncode, 2)
            self.assertIn("cannot be written: File too large", done.stderr)
            self.assertEqual(self.contents(folder), old)

    def test_files_of_a_model_that_are_no_regular_files_are_refused_before_anything_is_written(self):
        model, _, _ = self.written_models()
        for name, kind in (("images.bin", "a folder"), ("points3D.bin", "a pipe"), ("points3D.bin", "a special file")):
            for command in (("optimize", "-o"), ("convert",)):
                out = self.path / "out"
                out.mkdir()
                (out / "cameras.bin").write_text("old", encoding="utf-8")
                if kind == "a folder":
                    (out / name).mkdir()
                elif kind == "a pipe":
                    os.mkfifo(out / name)
                else:
                    (out / name).symlink_to("/dev/null")
                self.assert_refused(run(command[0], model, *command[1:], out), f"{name}: cannot be written: expected a regular file or none, got {kind}")
                self.assertEqual((out / "cameras.bin").read_text(encoding="utf-8"), "old")
                shutil.rmtree(out)

    @unittest.skipIf(len(sys.argv) < 5, "needs the path of faulty_rename")
    def test_a_model_is_as_before_if_a_file_cannot_be_renamed(self):
        folder, old, _ = self.written_models()
        for files in (old, {}, {"images.bin": old["images.bin"]}):
            for number in (1, 2, 3):
                self.restore(folder, files)
                done = run("convert", self.folder, folder, "--format", "colmap", environment={"LD_PRELOAD": sys.argv[4], "FAIL_AT_RENAME": str(number)})
                self.assertEqual(done.returncode, 2)
                self.assertIn("cannot be written: Input/output error", done.stderr)
                self.assertEqual(self.contents(folder), files)

    @unittest.skipIf(len(sys.argv) < 5, "needs the path of faulty_rename")
    def test_a_mixture_of_two_models_is_refused_and_either_one_can_be_restored(self):
        folder, old, new = self.written_models()
        for number in (1, 2, 3):
            for wanted in (new, old):
                self.restore(folder, old)
                done = run("optimize", folder, "-q", "-o", folder, environment={"LD_PRELOAD": sys.argv[4], "DIE_AT_RENAME": str(number)})
                self.assertEqual(done.returncode, -signal.SIGKILL)
                for words in (["info", folder], ["optimize", folder]):
                    self.assert_refused(run(*words), "folder: expected files that were written together, but writing them was interrupted",
                                        "boxplus_unfinished.txt")
                parts = (folder / "boxplus_unfinished.txt").read_text(encoding="utf-8").split("To get the old files")
                for line in parts[0 if wanted is new else 1].splitlines():
                    if " -> " in line:
                        source, target = line.split(" -> ")
                        if pathlib.Path(source.strip()).exists():
                            os.replace(source.strip(), target)
                self.assertEqual({name: content for name, content in self.contents(folder).items() if name in new}, wanted)
                # Writing it again also completes it.
                self.assertEqual(run("convert", self.folder, folder, "--format", "colmap").returncode, 0)
                self.assertEqual(run("info", folder).returncode, 0)

if __name__ == "__main__":
    main()
