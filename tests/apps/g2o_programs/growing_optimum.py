#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""growing_optimum.py FOLDER MODE FILE BEST: checks that a public graph that is fed incrementally ends at BEST.

FOLDER is that of the programs. MODE `file` runs g2o_incremental -i FILE; `protocol` sends the graph, which has only
poses, to g2o_online as commands, in the order of the poses. FILE is in the folder $BOXPLUS_DATA. If there is no such
file, the test prints this and is skipped (exit code 77).
"""

import math
import os
import pathlib
import re
import subprocess
import sys

# The largest relative difference from BEST. The chi2 of a file with quaternions depends on their norms, which are not 1
# because of rounding; the protocol has angles.
TOLERANCE = {"file": 1e-6, "protocol": 1e-5}

def angles(qx, qy, qz, qw):
    """Roll, pitch and yaw of a quaternion."""
    n = math.sqrt(qx * qx + qy * qy + qz * qz + qw * qw)
    x, y, z, w = qx / n, qy / n, qz / n, qw / n
    sine = 2 * (w * y - x * z)
    cosine = math.hypot(1 - 2 * (y * y + z * z), 2 * (x * y + w * z))
    return (math.atan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y)), math.atan2(sine, cosine),
            math.atan2(2 * (x * y + w * z), 1 - 2 * (y * y + z * z)))

def edge_in_space(values):
    """The fields of EDGE_XYZRPY for those of EDGE_SE3:QUAT, whose error is half an angle."""
    measured = [*values[:3], *angles(*values[3:7])]
    omega, k = [], 7
    for i in range(6):
        for j in range(i, 6):
            omega.append(values[k] / ((1 if i < 3 else 2) * (1 if j < 3 else 2)))
            k += 1
    return measured + omega

def commands_of(path):
    """The commands that send the graph of a file, with SOLVE_STATE after each pose."""
    steps, fixed = {}, "FIX 0;\n"
    for line in path.read_text(encoding="utf-8").splitlines():
        tag, *fields = line.split() or [""]
        if tag not in ("EDGE_SE2", "EDGE_SE3:QUAT"):
            continue
        a, b, values = int(fields[0]), int(fields[1]), list(map(float, fields[2:]))
        name, values = ("EDGE_XYT", values) if tag == "EDGE_SE2" else ("EDGE_XYZRPY", edge_in_space(values))
        steps.setdefault(max(a, b), []).append(f"ADD {name} {a} {b} {' '.join(map(repr, values))};\n")
    kind = "VERTEX_XYT" if name == "EDGE_XYT" else "VERTEX_XYZRPY"
    return f"ADD {kind} 0;\n" + fixed + "".join("".join(steps[k]) + "SOLVE_STATE;\n" for k in sorted(steps))

def main(folder, mode, name, best):
    path = pathlib.Path(os.environ.get("BOXPLUS_DATA", "")) / name
    if not path.is_file():
        print(f"SKIPPED: there is no {name} in BOXPLUS_DATA")
        return 77
    if mode == "file":
        command, text = [f"{folder}/g2o_incremental", "-i", str(path)], ""
    else:
        command, text = [f"{folder}/g2o_online"], commands_of(path)
    run = subprocess.run(command, text=True, input=text, capture_output=True, check=False)
    print(run.stdout + run.stderr)
    if run.returncode != 0:
        print(f"FAILED: exit code {run.returncode}")
        return 1
    chi2 = float(re.search(r"^# final chi2 = (\S+)$", run.stderr, re.MULTILINE).group(1))
    difference = (chi2 - best) / best
    print(f"{name}: chi2 {chi2:.10g}, best known {best:.10g}, relative difference {difference:+.1e}")
    return 0 if abs(difference) <= TOLERANCE[mode] else 1

if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2], sys.argv[3], float(sys.argv[4])))
