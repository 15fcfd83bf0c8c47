# SPDX-License-Identifier: BSD-3-Clause
"""dataset_optimum.py FILE BEST: checks that boxplus.optimize() ends at a chi2 within 1e-6 of BEST, and that a graph
that is built from arrays ends at the same bits. FILE is in the folder $BOXPLUS_DATA. If there is no such file, the test
prints this and is skipped (exit code 77).
"""

import os
import pathlib
import sys

import boxplus
from g2o_arrays import graph_from_arrays, parse_g2o

TOLERANCE = 1e-6  # the largest relative difference from BEST


def main(name, best):
    path = pathlib.Path(os.environ.get("BOXPLUS_DATA", "")) / name
    if not path.is_file():
        print(f"SKIPPED: there is no {name} in BOXPLUS_DATA")
        return 77
    graph, same = boxplus.load(path), graph_from_arrays(parse_g2o(path.read_text(encoding="utf-8")))
    assert graph.chi2() == same.chi2(), f"chi2 {graph.chi2()!r} of the file, {same.chi2()!r} of the arrays"
    report, report_of_same = boxplus.optimize(graph), boxplus.optimize(same)
    print(report)
    assert report.chi2_final == report_of_same.chi2_final
    difference = (report.chi2_final - best) / best
    print(f"{name}: chi2 {report.chi2_final:.10g}, best known {best:.10g}, relative difference {difference:+.1e}")
    return 0 if report.converged() and abs(difference) <= TOLERANCE else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], float(sys.argv[2])))
