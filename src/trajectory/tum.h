// SPDX-License-Identifier: BSD-3-Clause
// Reads trajectories in the format of the TUM RGB-D benchmark: each line is a pose, "time x y z qx qy qz qw"
// (Sturm et al., A benchmark for the evaluation of RGB-D SLAM systems, IROS 2012).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "boxplus/io/graph_file.h"
#include "trajectory/trajectory.h"

namespace boxplus {

/// True if the first line that is neither blank nor a comment begins with a number, and no file format other
/// than .g2o recognizes the text.
bool is_tum(std::string_view text);

/// Throws FileError, with `name` as the name of the file, if the text is a TUM file.
void refuse_tum(std::string_view text, const std::string& name);

/// Throws InputError, with `name` as the name of the file, if the text is a trajectory in a form that boxplus
/// does not read: values with commas, as in EuRoC's files, or the 12 numbers of KITTI's lines.
void refuse_other_trajectory(std::string_view text, const std::string& name);

/// Parses a TUM file. Messages call the file `name`. Throws InputError, with the position of the error, if a
/// line is malformed or if two poses have equal times, and FileError as trajectory_of() does. If `skipped` is
/// not nullptr, malformed lines are skipped instead, and each gets a note.
Trajectory parse_tum(std::string_view text, const std::string& name,
                     std::vector<GraphFile::Note>* skipped = nullptr);

}  // namespace boxplus
