#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""dataset_optimum.py BOXPLUS FILE BEST [THREADS...]: checks that `boxplus optimize FILE` ends at a chi2 within 1e-6 of BEST.

No option of the optimization is set. With several numbers of threads, each must give the same bytes. FILE is in the folder $BOXPLUS_DATA. If there is no such file, the test prints
this and is skipped (exit code 77).
"""

import json
import os
import pathlib
import subprocess
import sys
import tempfile

TOLERANCE = 1e-6  # the largest relative difference from BEST

def optimize(boxplus, path, *options):
    """Returns the report and the optimized graph as bytes, or exits."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        files = ["--json", folder / "report.json", "-o", folder / f"out{path.suffix}"]
        run = subprocess.run([boxplus, "optimize", path, *files, *options], text=True, stdin=subprocess.DEVNULL,
                             capture_output=True, check=False)
        print(run.stdout + run.stderr)
        if run.returncode != 0:
            sys.exit(f"FAILED: exit code {run.returncode}")
        return json.loads((folder / "report.json").read_text()), files[-1].read_bytes()

def main(boxplus, name, best, *numbers_of_threads):
    path = pathlib.Path(os.environ.get("BOXPLUS_DATA", "")) / name
    if not path.is_file():
        print(f"SKIPPED: there is no {name} in BOXPLUS_DATA")
        return 77
    runs = [optimize(boxplus, path, *options) for options in [["--threads", t] for t in numbers_of_threads] or [[]]]
    if any(graph != runs[0][1] for _, graph in runs):
        print(f"FAILED: the bytes differ with {' and '.join(numbers_of_threads)} threads")
        return 1
    report = runs[0][0]
    for key in ("status", "chi2_initial", "chi2_final", "iterations", "start", "gauge", "threads"):
        assert key in report, f"the JSON report lacks {key}"
    for key in ("load", "plan", "optimize", "total"):
        assert key in report["time_s"], f"the JSON report lacks time_s.{key}"
    difference = (report["chi2_final"] - best) / best
    print(f"{name}: {report['status']}, chi2 {report['chi2_final']:.10g}, best known {best:.10g}, relative difference {difference:+.1e}")
    return 0 if report["status"] == "converged" and abs(difference) <= TOLERANCE else 1

if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2], float(sys.argv[3]), *sys.argv[4:]))
