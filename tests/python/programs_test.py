# SPDX-License-Identifier: BSD-3-Clause
"""Ten programs for boxplus, GTSAM and g2o (examples/python/programs), and their numbers of lines."""

import pathlib
import re
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAMS = ROOT / "examples/python/programs"
NAMES = ("pose_graph", "landmark_slam", "hand_eye", "bundle_adjustment", "curve_fitting", "custom_factor", "planner", "calibration",
         "robust", "online")
PEERS = ("gtsam", "g2o")


def program(path):
    text = path.read_text(encoding="utf-8")
    return re.search(r"^# \[program\]\n(.*?)^# \[/program\]$", text, re.DOTALL | re.MULTILINE)[1]


def lines(path):
    """The lines of a program without empty lines and comments, or None if there is no such program."""
    if not path.exists():
        return None
    return sum(1 for line in program(path).splitlines() if line.strip() and not line.strip().startswith("#"))


class Programs(unittest.TestCase):
    def counts(self, name):
        return lines(PROGRAMS / f"{name}.py"), *(lines(PROGRAMS / f"{name}_{peer}.py") for peer in PEERS)

    def test_each_has_at_most_half_the_lines_of_a_peer(self):
        for name in NAMES:
            own, *peers = self.counts(name)
            peers = [count for count in peers if count is not None]
            with self.subTest(name):
                self.assertLessEqual(own, max(peers) / 2)
                self.assertLessEqual(own, 0.75 * min(peers))  # of the shorter one, if there are two

    def test_the_document_has_their_numbers_of_lines(self):
        page = (ROOT / "docs/from_python.md").read_text(encoding="utf-8")
        rows = {row[0]: row[1:] for row in re.findall(
            r"^\| [^|]+ \| \[(\d+)\]\(\.\./examples/python/programs/(\w+)\.py\) \| (?:\[(\d+)\]\S+|–) \| (?:\[(\d+)\]\S+|–) \|$", page,
            re.MULTILINE) for row in [(row[1], row[0], *row[2:])]}
        self.assertEqual(list(rows), list(NAMES))
        for name in NAMES:
            self.assertEqual(rows[name], tuple("" if count is None else str(count) for count in self.counts(name)))

    def test_every_line_has_one_statement_and_the_data_of_its_row(self):
        for path in PROGRAMS.glob("*.py"):
            if path.stem == "worlds":
                continue
            text = path.read_text(encoding="utf-8")
            compile(text, path, "exec")  # those for GTSAM are not run
            self.assertEqual([line for line in program(path).splitlines() if ";" in line or len(line) > 132], [], path.name)
            name = re.sub("_(gtsam|g2o)$", "", path.stem)
            self.assertIn(name, NAMES)
            self.assertEqual(re.findall(r"^world = .*$", text, re.MULTILINE),
                             re.findall(r"^world = .*$", (PROGRAMS / f"{name}.py").read_text(encoding="utf-8"), re.MULTILINE))

    def test_every_name_that_a_program_uses_is_imported_in_it(self):
        for path in PROGRAMS.glob("*.py"):
            if path.stem == "worlds":
                continue
            text = program(path)
            if re.search(r"\bnp\.", text):
                self.assertIn("import numpy as np", text, path.name)


if __name__ == "__main__":
    unittest.main()
