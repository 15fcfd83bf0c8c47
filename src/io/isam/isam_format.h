// SPDX-License-Identifier: BSD-3-Clause
// The text files of iSAM (Kaess, Ranganathan and Dellaert, "iSAM: Incremental smoothing and mapping", 2008).
// A line is a measurement: a tag, the ids of a pose and of another pose or a landmark, the measured values,
// and the upper triangle of R by rows, where Ω = RᵀR (the square root of the information matrix):
//
//     ODOMETRY i j  x y θ  R (6)                         also EDGE2      an edge Between<SE2>
//     LANDMARK i l  x y  R (3)                                           PointObservation2
//     ODOMETRY3 i j  x y z roll pitch yaw  R (21)        also EDGE3      Between<SE3>
//     POINT3 i l  x y z  R (6)                                           OffsetPointObservation3, with the
//     identity
//
// The rotation is Rz(yaw) Ry(pitch) Rx(roll). The format is read-only.
#pragma once

#include "boxplus/io/file_format.h"

namespace boxplus {

/// Files have no vertices, so GraphFile::vertices_created is set. Poses and landmarks have separate ids in a
/// file. If an id is that of a pose and of a landmark, the id of each landmark is increased by the smallest
/// power of ten that is larger than all ids of poses, and a note says so.
FileFormat isam_format();

}  // namespace boxplus
