#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tests `boxplus compare` with trajectories whose errors are known."""

import json
import math
import shutil

from command_case import CommandCase, main, run

PLACES = [(0, 0), (1, 0), (2, 0.5), (2, 2), (0, 3)]

def graph(places, turn=0.0, shift=(0, 0), scale=1.0):
    """A graph with poses at these positions in the plane, after the whole world is scaled, rotated and shifted."""
    lines = []
    for i, (x, y) in enumerate(places):
        moved = (scale * (math.cos(turn) * x - math.sin(turn) * y) + shift[0], scale * (math.sin(turn) * x + math.cos(turn) * y) + shift[1])
        lines.append(f"VERTEX_SE2 {i} {moved[0]!r} {moved[1]!r} {0.3 * i + turn!r}\n")
    return "".join(lines)

def tum(places, times, angle=0.0):
    """A TUM file with poses at these positions. Pose i is rotated about z by i times `angle`."""
    return "# time x y z qx qy qz qw\n" + "".join(
        f"{time!r} {x} {y} 0.5 0 0 {math.sin(angle * i / 2)!r} {math.cos(angle * i / 2)!r}\n"
        for i, (time, (x, y)) in enumerate(zip(times, places)))

class CompareTest(CommandCase):
    def compared(self, result, truth, *options):
        result, truth = self.written("result", result), self.written("truth", truth)
        done = run("compare", result, truth, "--json", "-", *options)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return json.loads(done.stdout)

    def assert_errors(self, errors, rmse, mean, median, most):
        for key, value in (("rmse", rmse), ("mean", mean), ("median", median), ("max", most)):
            self.assertAlmostEqual(errors[key], value, 12, key)

    def test_a_trajectory_has_no_error_compared_with_itself(self):
        facts = self.compared(graph(PLACES), graph(PLACES))
        self.assertEqual((facts["result_poses"], facts["truth_poses"], facts["matched"]), (5, 5, 5))
        for errors in (facts["ate_m"], facts["rpe"]["translation_m"], facts["rpe"]["rotation_rad"]):
            self.assertLess(errors["max"], 1e-14)

    def test_without_alignment_each_position_is_compared_as_it_is(self):
        moved = [(x + 0.1 * i, y) for i, (x, y) in enumerate(PLACES)]
        facts = self.compared(graph(moved), graph(PLACES), "--align", "none")
        self.assert_errors(facts["ate_m"], 0.1 * math.sqrt(30 / 5), 0.2, 0.2, 0.4)

    def test_a_rigid_motion_of_the_world_is_not_an_error(self):
        facts = self.compared(graph(PLACES, turn=2.5, shift=(30, -7)), graph(PLACES))
        self.assertLess(facts["ate_m"]["max"], 1e-13)
        self.assertLess(facts["rpe"]["translation_m"]["max"], 1e-13)
        self.assertLess(facts["rpe"]["rotation_rad"]["max"], 1e-14)
        first = self.compared(graph(PLACES, turn=2.5, shift=(30, -7)), graph(PLACES), "--align", "first")
        self.assertLess(first["ate_m"]["max"], 1e-13)

    def test_a_wrong_scale_is_an_error_unless_the_scale_is_estimated(self):
        rigid = self.compared(graph(PLACES, scale=0.5), graph(PLACES))
        self.assertGreater(rigid["ate_m"]["rmse"], 0.5)
        scaled = self.compared(graph(PLACES, scale=0.5, turn=1), graph(PLACES), "--scale")
        self.assertAlmostEqual(scaled["alignment"]["scale"], 2, 12)
        self.assertLess(scaled["ate_m"]["max"], 1e-13)
        self.assertLess(scaled["rpe"]["translation_m"]["max"], 1e-13)

    def test_the_alignment_contains_no_reflection(self):
        facts = self.compared(graph([(x, -y) for x, y in PLACES]), graph(PLACES))
        self.assertGreater(facts["ate_m"]["rmse"], 0.3)

    def test_relative_errors_are_the_errors_of_the_motions_between_poses(self):
        # The third step is 0.2 m too long, so all later positions are wrong by 0.2 m.
        longer = [(x, y + (0.2 if i >= 3 else 0)) for i, (x, y) in enumerate(PLACES)]
        facts = self.compared(graph(longer), graph(PLACES), "--align", "none")
        self.assertEqual(facts["rpe"]["count"], 4)
        self.assert_errors(facts["rpe"]["translation_m"], 0.1, 0.05, 0, 0.2)
        over_two = self.compared(graph(longer), graph(PLACES), "--steps", 2)
        self.assertEqual(over_two["rpe"]["count"], 3)
        self.assert_errors(over_two["rpe"]["translation_m"], math.sqrt(0.08 / 3), 0.4 / 3, 0.2, 0.2)

    def test_relative_errors_over_a_distance_begin_at_every_pose_that_is_far_enough_from_the_end(self):
        line = [(float(i), 0.0) for i in range(10)]
        stretched = [(1.01 * x, y) for x, y in line]
        facts = self.compared(tum(stretched, range(10)), tum(line, range(10)), "--distance", 3)
        self.assertEqual((facts["rpe"]["count"], facts["rpe"]["distance_m"], facts["rpe"]["steps"]), (7, 3, None))
        self.assert_errors(facts["rpe"]["translation_m"], 0.03, 0.03, 0.03, 0.03)

    def test_relative_rotation_errors_are_angles(self):
        facts = self.compared(tum(PLACES, range(5), angle=0.25), tum(PLACES, range(5)))
        self.assert_errors(facts["rpe"]["rotation_rad"], 0.25, 0.25, 0.25, 0.25)

    def test_poses_with_times_are_matched_to_the_nearest_pose_in_time(self):
        truth = tum([(0.1 * i, 0) for i in range(100)], [0.1 * i for i in range(100)])
        result = tum([(1, 0), (2, 0), (3, 0), (7, 7)], [1.004, 1.997, 3.0, 4.05])
        facts = self.compared(result, truth, "--align", "none")
        self.assertEqual((facts["result_poses"], facts["truth_poses"], facts["matched"]), (4, 100, 3))
        self.assertLess(facts["ate_m"]["max"], 1e-12)
        self.assertEqual(self.compared(result, truth, "--max-difference", 0.06)["matched"], 4)

    def test_no_pose_is_matched_twice(self):
        facts = self.compared(tum(PLACES, [1, 1.001, 1.002, 1.003, 1.004]), tum([(0, 0)], [1.0021]))
        self.assertEqual(facts["matched"], 1)
        self.assertIsNone(facts["rpe"]["translation_m"])

    def test_poses_are_matched_by_id_in_any_order_and_landmarks_are_ignored(self):
        lines = graph(PLACES).splitlines(keepends=True)
        facts = self.compared("".join(lines[:0:-1]) + "VERTEX_XY 77 5 5\n", graph(PLACES) + "VERTEX_XY 78 1 1\n")
        self.assertEqual((facts["result_poses"], facts["matched"]), (4, 4))
        self.assertLess(facts["ate_m"]["max"], 1e-13)

    def test_optimization_decreases_the_errors(self):
        before, after, truth = (self.path / name for name in ("before.g2o", "after.g2o", "truth.g2o"))
        run("simulate", "sphere", "--poses", 400, "-o", before, "--truth", truth)
        run("optimize", before, "-q", "-o", after)
        errors = [json.loads(run("compare", path, truth, "--json", "-").stdout)["ate_m"]["rmse"] for path in (before, after)]
        self.assertLess(errors[1], 0.2 * errors[0])

    def test_with_false_loop_closures_a_robust_kernel_helps_only_if_it_is_used_from_the_first_iteration(self):
        # The example of docs/first_steps.md under "Outliers".
        graph, squares, robust, late, truth = (self.path / f"{name}.g2o" for name in ("graph", "squares", "robust", "late", "truth"))
        run("simulate", "streets", "--poses", 2000, "--outliers", 0.2, "-o", graph, "--truth", truth)
        kernel = ("--start", "current", "--kernel", "Cauchy", "--kernel-width", 3, "--kernel-on", "loop-closures", "-q", "-o")
        run("optimize", graph, *kernel, robust)
        run("optimize", graph, "-q", "-o", squares)
        run("optimize", squares, *kernel, late)
        errors = [json.loads(run("compare", path, truth, "--json", "-").stdout)["ate_m"]["rmse"] for path in (robust, late)]
        self.assertLess(errors[0], 0.3)
        self.assertGreater(errors[1], 20)

    def simulated_bundle(self):
        """A simulated BAL problem, and the COLMAP model that boxplus makes from it."""
        problem, model = self.path / "exact.bal", self.path / "model"
        noise = [word for kind in ("noise", "pose-noise", "point-noise", "intrinsics-noise") for word in (f"--{kind}", 0)]
        run("simulate", "ba", "--shape", "ring", "--cameras", 30, "--points", 300, *noise, "-o", problem)
        self.assertEqual(run("convert", problem, model, "--format", "colmap-text").returncode, 0)
        return problem, model

    def change_images(self, model, change):
        """Passes the images to change(), each as the words of its first line and its second line. Writes the list that change()
        returns, or else the changed list."""
        file = model / "images.txt"
        lines = [line for line in file.read_text(encoding="utf-8").splitlines() if not line.startswith("#")]
        images = [[lines[i].split(), lines[i + 1]] for i in range(0, len(lines), 2)]
        images = change(images) or images
        file.write_text("".join(" ".join(first) + "\n" + second + "\n" for first, second in images), encoding="utf-8")

    def assert_exact(self, result, truth, matched_by):
        done = run("compare", result, truth, "--json", "-")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        facts = json.loads(done.stdout)
        self.assertEqual((facts["matched"], facts["matched_by"]), (30, matched_by))
        for errors in (facts["ate_m"], facts["rpe"]["translation_m"], facts["rpe"]["rotation_rad"]):
            self.assertLess(errors["max"], 1e-12)

    def test_a_bal_problem_and_its_colmap_model_have_the_same_poses(self):
        problem, model = self.simulated_bundle()
        self.assert_exact(model, problem, "name")
        self.assert_exact(problem, model, "name")
        self.assert_exact(problem, problem, "position")
        self.change_images(model, lambda images: images[::-1])
        self.assert_exact(model, problem, "name")

        def rename(images):
            for i, (first, _) in enumerate(images):
                first[9] = f"photo{(7 * i) % 30}.jpg"
        self.change_images(model, lambda images: images[::-1])
        self.change_images(model, rename)
        self.assert_exact(model, problem, "position")
        self.assertIn("30 of 30 true poses by position", run("compare", problem, model).stdout)

    def test_a_bal_problem_whose_cameras_may_be_other_ones_is_refused(self):
        problem, model = self.simulated_bundle()

        def rename(images):
            for first, _ in images:
                first[9] += ".jpg"
            return images[1:] + images[:1]
        self.change_images(model, rename)
        self.assert_refused(run("compare", model, problem), "are matched by position: expected camera 0 and image 2 to show equally many points")
        fewer = self.path / "fewer.bal"
        run("simulate", "ba", "--shape", "ring", "--cameras", 29, "--points", 300, "-o", fewer)
        for other in (problem, model):
            self.assert_refused(run("compare", fewer, other), "no names, only positions: expected as many poses in the other file, got ")

    def test_the_images_of_colmap_models_are_matched_by_name(self):
        _, model = self.simulated_bundle()
        other = self.path / "other"
        shutil.copytree(model, other)

        def renumber(images):
            for i, (first, _) in enumerate(images):
                first[0] = str((7 * i) % 30 + 1)
        # Without tracks, which would name the old numbers.
        (other / "points3D.txt").write_text(
            "".join(" ".join(line.split()[:8]) + "\n" for line in (model / "points3D.txt").read_text(encoding="utf-8").splitlines()
                    if not line.startswith("#")), encoding="utf-8")
        self.change_images(other, renumber)
        facts = json.loads(run("compare", other, model, "--json", "-").stdout)
        self.assertEqual((facts["matched"], facts["matched_by"]), (30, "name"))
        self.assertLess(facts["ate_m"]["max"], 1e-12)

        def repeat(images):
            images[4][0][9] = images[2][0][9]
        self.change_images(model, repeat)
        self.assert_refused(run("compare", model, model), "expected different names in each COLMAP model, but images 3 and 5 are both named '2'")

    def test_cameras_at_one_position_have_no_scale(self):
        camera = "0 0 0\n0 0 0\n500 0 0\n"
        points = "3 1 3\n0 0 1 2\n1 0 1 2\n2 0 1 2\n"
        flat = self.written("flat.bal", points + 3 * camera + "0 0 -5\n")
        moved = self.written("moved.bal", points + camera + camera.replace("0 0 0\n500", "1 0 0\n500") +
                             camera.replace("0 0 0\n500", "0 2 0\n500") + "0 0 -5\n")
        for result, truth in ((flat, moved), (moved, flat)):
            done = run("compare", result, truth, "--json", "-")
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertNotIn("ate_rmse_m_with_scale", json.loads(done.stdout))

    def test_without_json_the_values_are_printed_in_a_table(self):
        done = run("compare", "-", self.written("truth", graph(PLACES)), stdin=graph(PLACES, scale=0.5))
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        for text in ("<stdin> against", "5 of 5 poses", "ATE [m]", "RPE [deg]", "best rigid alignment", "from pose to pose"):
            self.assertIn(text, done.stdout)

    def test_lenient_reading_skips_malformed_lines_of_tum_files(self):
        good = tum(PLACES, range(5))
        bad = good.replace("1 1 0 0.5", "1 nan nan nan")
        self.assert_refused(run("compare", self.written("result", bad), self.written("truth", good)), "result:3:3: expected x (a finite number), got 'nan'")
        for result, truth in ((bad, good), (good, bad)):
            done = run("compare", "--lenient", self.written("result", result), self.written("truth", truth))
            self.assertEqual(done.returncode, 0)
            self.assertIn(":3:3: skipped: expected x (a finite number), got 'nan'", done.stderr)
            self.assertIn("4 of ", done.stdout)

    def test_input_that_cannot_be_compared_is_refused_and_the_message_names_the_place(self):
        good, flat = tum(PLACES, range(5)), graph(PLACES)
        space = "VERTEX_SE3:QUAT 0 0 0 0 0 0 0 1\n"
        for result, truth, options, text in (
                ("1 0 0 0 0 0 0 one\n", good, (), "result:1:15: expected qw (a finite number), got 'one'"),
                ("# c\n\n1 0 0 0 0 0 0\n", good, (), "result:3:14: expected qw, got the end of the line"),
                ("1 0 0 0 0 0 0 1 9\n", good, (), "result:1:17: "),
                ("1 0 0 0 0 0 0 0\n", good, (), "result:1:9: expected a quaternion of length 1, got length 0"),
                ("2 0 0 0 0 0 0 1\n1 0 0 0 0 0 0 1\n2 1 0 0 0 0 0 1\n", good, (), "result:3:1: expected a time that differs from the time of line 1, got 2"),
                ("VERTEX_SE2 0 0 zero 0\n", flat, (), "result:1:16: expected y"),
                ("", good, (), "result:1:1: expected a vertex or an edge"),
                ("VERTEX_XY 0 0 0\n", flat, (), "expected poses, got a graph without poses"),
                ("VERTEX_SE2 0 1e200 0 0\n", flat, (), "the pose of vertex 0 is farther away"),
                (flat, good, (), "got one of each; poses with ids cannot be matched with poses with times"),
                (flat, space, (), "two graphs in the plane or two in space"),
                (flat, "VERTEX_SE2 99 0 0 0\n", (), " by id, found none"),
                (good, tum(PLACES, range(100, 105)), (), " by time, found none"),
                (graph(5 * [(1, 1)]), flat, ("--scale",), "expected poses at different positions"),
                (flat, flat, ("--scale", "--align", "first"), "--scale"),
                (flat, flat, ("--steps", "2", "--distance", "3"), "--distance")):
            with self.subTest(text):
                done = run("compare", self.written("result", result), self.written("truth", truth), *options)
                self.assert_refused(done, text)
        self.assert_refused(run("compare", "-", "-"), "'-' twice")
        euroc = "#timestamp, p_RS_R_x [m]\n1403636579758555392,4.6,-1.7,0.7,0.5,-0.1,-0.8,-0.1\n"
        kitti = "1 0 0 0 0 1 0 0 0 0 1 0\n"
        for result, place, text in ((euroc, "2:1", "values with commas"), ("t,x,y,z\n1,2,3,4\n", "1:1", "values with commas"),
                                    (kitti, "1:1", "12 numbers")):
            with self.subTest(result):
                done = run("compare", "--lenient", self.written("result", result), self.written("truth", good))
                self.assert_refused(done, f"result:{place}: expected a TUM file, with lines of the form 'time x y z qx qy qz qw', got {text}")
        truth = self.written("truth", flat)
        self.assert_refused(run("compare", truth, self.path / "none"), "none: cannot be opened")
        self.assert_refused(run("compare", truth, truth, "--json", truth), "expected a file other than the input")

if __name__ == "__main__":
    main()
