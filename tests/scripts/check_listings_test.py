#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""scripts/check_listings.py checks that the outputs shown in documents equal the current outputs of the programs."""

import importlib.util
import pathlib
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).parents[2] / "scripts" / "check_listings.py"
spec = importlib.util.spec_from_file_location("check_listings", SCRIPT)
check_listings = importlib.util.module_from_spec(spec)
spec.loader.exec_module(check_listings)

class CheckListings(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.programs = pathlib.Path(folder.name) / "examples/bin"
        self.program(self.programs / "hello", "echo 'chi2 2.5 in 0.1234 s'")
        self.program(pathlib.Path(folder.name) / "bin/boxplus", "echo \"x of $1\" >&2; exit ${2:-0}")

    @staticmethod
    def program(path, text):
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(f"#!/bin/sh\n{text}\n", encoding="utf-8")
        path.chmod(0o755)

    def complaints(self, block):
        """Checks one block. Returns the messages of the script and the corrected block."""
        found = []
        match = check_listings.BLOCK.search(block)
        corrected = check_listings.check_block(match, self.programs, lambda what, _: found.append(what))
        return found, corrected

    def test_an_output_that_the_program_prints_is_accepted(self):
        block = "<!-- output of hello -->\n```text\nchi2 2.5 in 0.9999 s\n```"
        self.assertEqual(self.complaints(block), ([], block))

    def test_an_outdated_output_is_reported_and_corrected(self):
        found, corrected = self.complaints("<!-- output of hello -->\n```text\nchi2 2.4 in 0.1 s\n```")
        self.assertEqual(found, ["differs from: output of hello"])
        self.assertIn("chi2 2.5 in 0.1234 s", corrected)

    def test_the_error_output_and_the_exit_code_of_a_command_are_checked(self):
        self.assertEqual(self.complaints("<!-- complaint of boxplus a 2 -->\n```text\nx of a\n```")[0], [])
        found, _ = self.complaints("<!-- output of boxplus a 2 -->\n```text\nx of a\n```")
        self.assertIn("exit code 2, expected 0", found[0])

    def test_a_text_block_without_a_command_is_refused_unless_it_is_a_drawing(self):
        self.assertEqual(self.complaints("```text\nchi2 3\n```")[0], ["text that does not say which command prints it"])
        self.assertEqual(self.complaints("<!-- drawing -->\n```text\na -- b\n```")[0], [])

    def test_numbers_may_differ_by_rounding_errors_but_times_and_thread_counts_by_any_amount(self):
        self.assertTrue(check_listings.alike("1.25e-09 of 2.0", "1.31e-09 of 2.0000001"))
        self.assertTrue(check_listings.alike("1 of 2 threads, 0.0007 s", "3 of 16 threads, 12.3456 s"))
        self.assertFalse(check_listings.alike("4 iterations", "5 iterations"))
        self.assertFalse(check_listings.alike("start chordal 1", "start current 1"))

    def test_a_registered_tag_that_formats_md_does_not_explain_is_reported(self):
        root = self.programs.parent
        for file, text in (("docs/formats.md", "`VERTEX_A` is a number."),
                           ("src/io/format/register_domain.cpp", 'r.vertex<A>("VERTEX_A");\nr.edge<E, A>("EDGE_B");')):
            (root / file).parent.mkdir(parents=True, exist_ok=True)
            (root / file).write_text(text, encoding="utf-8")
        self.assertEqual(list(check_listings.missing_words(root)),
                         ["docs/formats.md: does not explain EDGE_B of src/io/format/register_domain.cpp"])

    def test_it_is_an_error_if_no_file_registers_tags(self):
        root = self.programs.parent
        (root / "docs").mkdir(parents=True)
        (root / "docs/formats.md").touch()
        self.assertEqual(list(check_listings.missing_words(root)),
                         ["src/io: no register_*.cpp, so no tag of docs/formats.md was checked"])

if __name__ == "__main__":
    unittest.main()
