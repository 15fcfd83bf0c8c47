#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tests `boxplus optimize --petsc`, with the plug-in if it was built, and without it."""

import json
import pathlib
import shutil
import subprocess
import unittest

from command_case import BOXPLUS, TOWN, CommandCase, main, run

PLUGIN = pathlib.Path(BOXPLUS).resolve().parent.parent / "lib/boxplus/boxplus_petsc.so"

class PetscTest(CommandCase):
    def report_of(self, *arguments):
        done = run("optimize", TOWN, *arguments, "--quiet", "--json", "-")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return json.loads(done.stdout)

    def test_says_how_to_get_the_plug_in_if_it_is_missing(self):
        alone = self.path / "bin" / "boxplus"
        alone.parent.mkdir()
        shutil.copy(BOXPLUS, alone)
        done = subprocess.run([alone, "optimize", TOWN, "--petsc", ""], capture_output=True, encoding="utf-8", check=False)
        self.assert_refused(done, "--petsc", "scripts/debian-packages-mpi.txt")

    @unittest.skipUnless(PLUGIN.exists(), "the plug-in of PETSc is not built")
    def test_reaches_the_optimum_of_the_own_solver(self):
        chi2 = self.report_of()["chi2_final"]
        for options in ("", "-ksp_type cg -pc_type pbjacobi", "-ksp_type preonly -pc_type cholesky"):
            report = self.report_of("--petsc", options)
            self.assertEqual(report["linear_solver"], "petsc")
            self.assertAlmostEqual(report["chi2_final"] / chi2, 1, places=9)

    @unittest.skipUnless(PLUGIN.exists(), "the plug-in of PETSc is not built")
    def test_refuses_options_that_petsc_does_not_know(self):
        for options, name in (("-ksp_type cq", "cq"), ("-kps_type cg", "-kps_type"), ("cg", "'cg'")):
            self.assert_refused(run("optimize", TOWN, "--petsc", options, "-q"), name)

if __name__ == "__main__":
    main()
