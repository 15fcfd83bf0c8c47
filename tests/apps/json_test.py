#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tests that every sub-command that reads graphs works with graphs as JSON, and that other programs can read them."""

import gzip
import json

from bal_test import problem
from command_case import TOWN, CommandCase, main, run

class JsonTest(CommandCase):
    def converted(self, source, name):
        done = run("convert", source, self.path / name)
        self.assertEqual(done.returncode, 0, done.stderr)
        return self.path / name

    def test_a_graph_as_json_is_the_same_graph(self):
        direct, graph = self.converted(TOWN, "direct.g2o"), self.converted(TOWN, "town.json")
        self.assertEqual(self.converted(graph, "back.g2o").read_bytes(), direct.read_bytes())
        self.assertEqual(self.converted(graph, "again.json").read_bytes(), graph.read_bytes())

    def test_other_programs_read_the_json_and_may_write_it_in_their_way(self):
        graph = self.converted(TOWN, "town.json")
        content = json.loads(graph.read_text(encoding="utf-8"))
        self.assertEqual((content["format"], content["version"]), ("boxplus graph", 1))
        reordered = dict(sorted(content.items()))  # edges before vertices
        other = self.written("other.json", json.dumps(reordered, indent=3))
        self.assertEqual(self.converted(other, "again.json").read_bytes(), graph.read_bytes())

    def test_files_are_packed_by_name(self):
        graph = self.converted(TOWN, "town.json")
        packed = self.converted(TOWN, "town.json.gz")
        self.assertEqual(gzip.decompress(packed.read_bytes()), graph.read_bytes())
        self.assertEqual(self.converted(packed, "again.json").read_bytes(), graph.read_bytes())
        lines = self.converted(packed, "town.g2o.gz")
        self.assertEqual(run("info", lines).stdout.splitlines()[1:], run("info", packed).stdout.splitlines()[1:])

    def test_what_other_formats_cannot_keep_is_said(self):
        content = json.loads(self.converted(TOWN, "town.json").read_text(encoding="utf-8"))
        content["edges"][3]["enabled"] = False
        content["edges"][4]["kernel"] = {"name": "Huber", "width": 2}
        graph = self.written("changed.json", json.dumps(content))
        done = run("convert", graph, self.path / "out.g2o")
        self.assertIn("out.g2o: only JSON keeps that 1 edges are disabled, 1 edges have kernels", done.stderr)
        self.assertNotIn("only JSON", run("convert", graph, self.path / "out.json").stderr)
        self.assertNotIn("only JSON", run("convert", TOWN, self.path / "out.g2o").stderr)

    def test_every_command_reads_json(self):
        graph = self.converted(TOWN, "town.json")
        done = run("optimize", graph, "-o", self.path / "out.json", "--json", "-", "--quiet")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        chi2 = json.loads(done.stdout)["chi2_final"]
        again = run("optimize", self.path / "out.json", "--json", "-", "--quiet")
        self.assertAlmostEqual(json.loads(again.stdout)["chi2_initial"], chi2, places=6)
        self.assertEqual(run("info", graph).returncode, 0)
        self.assertEqual(run("plot", graph, "-o", self.path / "town.svg").returncode, 0)
        self.assertEqual(run("compare", graph, TOWN).returncode, 0)

    def test_bundle_adjustment_is_kept_bit_for_bit(self):
        problem_file = self.written("problem.bal", problem())
        direct = self.converted(problem_file, "direct.bal")
        graph = self.converted(problem_file, "problem.json")
        self.assertEqual(self.converted(graph, "back.bal").read_bytes(), direct.read_bytes())

    def test_bad_json_is_refused_with_its_place(self):
        graph = self.converted(TOWN, "town.json")
        text = graph.read_text(encoding="utf-8")
        self.assert_refused(run("info", self.written("cut.json", text[:-2])), "got the end of the text")
        bad = self.written("bad.json", text.replace('"id": ', '"identity": ', 1))
        self.assert_refused(run("info", bad), "bad.json:", "expected one of the members tag, id, ", "got 'identity'")
        packed = self.path / "cut.json.gz"
        packed.write_bytes(gzip.compress(text.encode())[:-4])
        self.assert_refused(run("info", packed), "cut.json.gz: cannot be unpacked: the file ends early")

if __name__ == "__main__":
    main()
