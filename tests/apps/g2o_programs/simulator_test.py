#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""simulator_test.py FOLDER: tests g2o_simulator2d, g2o_simulator3d and create_sphere."""

import collections
import json
import math

from program_case import ProgramCase, final_chi2, main, run

COMMON = ["simSteps", "worldSize", "hasOdom", "hasPointSensor", "hasPoseSensor", "hasCompass", "hasGPS", "seed", "truth"]
# The sensors of each program, and the tags of what they add.
SENSORS = {
    "g2o_simulator2d": {
        "hasPointSensor": {"VERTEX_XY", "EDGE_SE2_XY"},
        "hasPointBearingSensor": {"VERTEX_XY", "EDGE_BEARING_SE2_XY"},
        "hasPoseSensor": set(),
        "hasCompass": {"EDGE_PRIOR_SE2"},
        "hasGPS": {"EDGE_PRIOR_SE2_XY"},
        "hasSegmentSensor": {"VERTEX_SEGMENT2D", "EDGE_SE2_SEGMENT2D", "EDGE_SE2_SEGMENT2D_LINE", "EDGE_SE2_SEGMENT2D_POINTLINE"},
    },
    "g2o_simulator3d": {
        "hasPointSensor": {"VERTEX_TRACKXYZ", "EDGE_SE3_TRACKXYZ", "PARAMS_SE3OFFSET"},
        "hasPointDepthSensor": {"VERTEX_TRACKXYZ", "EDGE_PROJECT_DEPTH", "PARAMS_CAMERACALIB"},
        "hasPointDisparitySensor": {"VERTEX_TRACKXYZ", "EDGE_PROJECT_DISPARITY", "PARAMS_CAMERACALIB"},
        "hasPoseSensor": set(),
        "hasCompass": {"EDGE_SE3_PRIOR", "PARAMS_SE3OFFSET"},
        "hasGPS": {"EDGE_SE3_XYZ_PRIOR", "PARAMS_SE3OFFSET"},
    },
}
ODOMETRY = {"g2o_simulator2d": {"VERTEX_SE2", "FIX", "EDGE_SE2"}, "g2o_simulator3d": {"VERTEX_SE3:QUAT", "FIX", "EDGE_SE3:QUAT"}}

def tags_of(path):
    return collections.Counter(line.split(" ", 1)[0] for line in path.read_text(encoding="utf-8").splitlines())

class SimulatorTest(ProgramCase):
    def simulated(self, program, *arguments, name="graph.g2o"):
        path = self.path / name
        done = run(program, *arguments, path)
        self.assertEqual((done.returncode, done.stdout), (0, ""), done.stderr)
        return path

    def test_the_help_lists_all_switches(self):
        self.assert_switches("g2o_simulator2d", [*COMMON, "nlandmarks", "nSegments", "segmentGridSize", "minSegmentLength",
                                                 "maxSegmentLength", "hasPointBearingSensor", "hasSegmentSensor"])
        self.assert_switches("g2o_simulator3d", [*COMMON, "nLandmarks", "hasPointDepthSensor", "hasPointDisparitySensor"])

    def test_each_sensor_adds_its_tags_and_both_tools_optimize_its_graph(self):
        for program, sensors in SENSORS.items():
            for sensor, tags in sensors.items():
                with self.subTest(program=program, sensor=sensor):
                    graph = self.simulated(program, "-hasOdom", f"-{sensor}", "-simSteps", 200, "-worldSize", 15)
                    found = tags_of(graph)
                    self.assertEqual(set(found), ODOMETRY[program] | tags)
                    pose, edge = [tag for tag in ODOMETRY[program] if tag != "FIX" and tag.startswith("VERTEX")][0], \
                        [tag for tag in ODOMETRY[program] if tag.startswith("EDGE")][0]
                    self.assertEqual((found[pose], found["FIX"]), (200, 1))
                    self.assertEqual(found[edge] > 199, sensor == "hasPoseSensor")
                    report = self.path / "report.json"
                    done = run("boxplus", "optimize", graph, "--json", report, "-q")
                    self.assertEqual(done.returncode, 0, done.stderr)
                    chi2 = json.loads(report.read_text(encoding="utf-8"))["chi2_final"]
                    ratio = final_chi2(run("g2o_hierarchical", graph)) / chi2
                    if sensor == "hasSegmentSensor":  # g2o's rule also fixes a vertex of the largest size: a segment
                        self.assertTrue(1 < ratio < 1.05, ratio)
                    else:
                        self.assertAlmostEqual(ratio, 1, delta=1e-4)

    def test_the_switches_change_the_world(self):
        few = self.simulated("g2o_simulator2d", "-hasOdom", "-hasPointSensor", "-hasSegmentSensor", "-nlandmarks", 5,
                             "-nSegments", 30, "-segmentGridSize", 5, "-minSegmentLength", 1, "-maxSegmentLength", 1,
                             "-simSteps", 300, "-worldSize", 12)
        found = tags_of(few)
        self.assertLessEqual(found["VERTEX_XY"], 5)
        self.assertLessEqual(found["VERTEX_SEGMENT2D"], 30)
        truth = self.path / "truth.g2o"
        self.simulated("g2o_simulator2d", "-hasSegmentSensor", "-minSegmentLength", 1, "-maxSegmentLength", 2, "-truth", truth)
        lengths = []
        for line in truth.read_text(encoding="utf-8").splitlines():
            if line.startswith("VERTEX_SEGMENT2D"):
                x1, y1, x2, y2 = map(float, line.split()[2:])
                lengths.append(math.hypot(x2 - x1, y2 - y1))
        self.assertGreater(len(lengths), 20)
        self.assertTrue(1 <= min(lengths) < 1.3 and 1.7 < max(lengths) <= 2, lengths)

    def test_poses_stay_in_the_world(self):
        for program, pose in (("g2o_simulator2d", "VERTEX_SE2"), ("g2o_simulator3d", "VERTEX_SE3:QUAT")):
            truth = self.path / "truth.g2o"
            self.simulated(program, "-hasOdom", "-simSteps", 500, "-worldSize", 8, "-truth", truth)
            places = [list(map(float, line.split()[2:4])) for line in truth.read_text(encoding="utf-8").splitlines()
                      if line.startswith(pose)]
            self.assertEqual(len(places), 500)
            self.assertEqual(max(abs(x) for place in places for x in place), 4)

    def test_the_same_seed_gives_the_same_file(self):
        for program in SENSORS:
            a, b, c = (self.simulated(program, "-hasOdom", "-hasPointSensor", "-seed", seed, name=name).read_bytes()
                       for seed, name in ((3, "a"), (3, "b"), (4, "c")))
            self.assertEqual(a, b)
            self.assertNotEqual(a, c)

    def test_wrong_arguments_are_refused(self):
        for program in SENSORS:
            self.assert_refused(run(program, self.path / "x.g2o"), 1, f"{program}: expected at least one sensor (-hasOdom")
            self.assertFalse((self.path / "x.g2o").exists())
            self.assert_refused(run(program, "-hasOdom", "-simSteps", 1), 1, "parameter -simSteps: expected an integer from 2")
            self.assert_refused(run(program, "-hasOdom", "-worldSize", "nan"), 1, "parameter -worldSize")
            self.assert_refused(run(program, "-hasOdom", self.path / "none" / "x.g2o"), 1, "none")
            self.assert_refused(run(program, "-hasOdom", "-truth", "-", "-"), 1, "expected two different files")
        self.assert_refused(run("g2o_simulator2d", "-hasSegmentSensor", "-maxSegmentLength", 0.1, "-"), 1, "maximal length")

class SphereTest(ProgramCase):
    def test_the_help_lists_all_switches(self):
        self.assert_switches("create_sphere", ["o", "nodesPerLevel", "laps", "radius", "noiseTranslation", "noiseRotation",
                                               "randomSeed", "seed", "truth"])

    def test_the_sphere_goes_to_standard_output_and_its_optimum_explains_the_noise(self):
        done = run("create_sphere", "-laps", 20, "-nodesPerLevel", 20)
        self.assertEqual(done.returncode, 0, done.stderr)
        graph = self.written("sphere.g2o", done.stdout)
        edges = 399 + 3 * 380
        self.assertEqual(tags_of(graph), {"VERTEX_SE3:QUAT": 400, "FIX": 1, "EDGE_SE3:QUAT": edges})
        freedom = 6 * edges - 6 * 399
        self.assertAlmostEqual(final_chi2(run("g2o_hierarchical", graph)), freedom, delta=5 * math.sqrt(2 * freedom))

    def test_radius_noise_and_seeds(self):
        def text(*arguments):
            done = run("create_sphere", "-laps", 3, "-nodesPerLevel", 5, *arguments)
            self.assertEqual(done.returncode, 0, done.stderr)
            return done.stdout
        first = text("-radius", 7, "-noiseTranslation", "0.1;0.2;0.5", "-noiseRotation", "0.01,0.02,0.04", "-truth", self.path / "t")
        self.assertAlmostEqual(math.hypot(*map(float, first.split()[2:5])), 7)
        omega = [line for line in first.splitlines() if line.startswith("EDGE")][0].split()[10:]
        for k, value in {0: 100, 6: 25, 11: 4, 15: 1e4, 18: 2500, 20: 625}.items():
            self.assertAlmostEqual(float(omega[k]) / value, 1)
        self.assertEqual(text("-seed", 5), text("-seed", 5))
        self.assertNotEqual(text("-seed", 5), text("-seed", 6))
        self.assertNotEqual(text("-randomSeed"), text("-randomSeed"))

    def test_wrong_arguments_are_refused(self):
        self.assert_refused(run("create_sphere", "-noiseRotation", "1;2"), 1, "parameter -noiseRotation: expected 3 numbers")
        self.assert_refused(run("create_sphere", "-noiseTranslation", "0;1;1"), 1, "parameter -noiseTranslation: expected 3 numbers")
        self.assert_refused(run("create_sphere", "-laps", 0), 1, "parameter -laps: expected an integer from 1")

if __name__ == "__main__":
    main()
