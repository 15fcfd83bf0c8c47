#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""same_bits.py BOXPLUS: checks that the output has the same bytes with 1, 2 and 3 threads and in each process.

Each process has a different address-space layout (ASLR), so the test fails if results depend on the order of addresses.
The test also checks that every thread did some of the work.
"""

import json
import pathlib
import subprocess
import sys
import tempfile

def run(*arguments):
    subprocess.run([str(a) for a in arguments], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, check=True)

def main(boxplus):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for world in ("torus", "city"):
            graph = folder / f"{world}.g2o"
            run(boxplus, "simulate", world, "--poses", 5000, "--seed", 7, "-o", graph)
            outputs = {}
            for threads in (1, 2, 3):
                for repetition in (1, 2, 3):
                    out, report = folder / "out.g2o", folder / "report.json"
                    run(boxplus, "optimize", graph, "-o", out, "--threads", threads, "--json", report, "--quiet")
                    workers = json.loads(report.read_text())["workers"]
                    assert workers == threads, f"{world}: {workers} workers did work, expected {threads}"
                    outputs[threads, repetition] = out.read_bytes()
            different = [key for key, value in outputs.items() if value != outputs[1, 1]]
            if different:
                print(f"FAILED: {world}: the bytes differ for (threads, repetition) = {different}")
                return 1
            print(f"{world}: the same {len(outputs[1, 1])} bytes in {len(outputs)} runs")
    return 0

if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
