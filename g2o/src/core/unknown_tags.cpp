// SPDX-License-Identifier: BSD-3-Clause
#include "core/unknown_tags.h"

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include "g2o/stuff/logger.h"
#include "io/characters.h"

namespace g2o {
namespace internal {
namespace {

/// The tags of a type group (G2O_USE_TYPE_GROUP) and its library, separated by blanks.
struct TypeGroup {
  std::string_view library, name, tags;
};

constexpr TypeGroup kTypeGroups[] = {
    {"types_slam2d", "slam2d",
     "VERTEX_SE2 VERTEX_XY PARAMS_SE2OFFSET CACHE_SE2_OFFSET EDGE_SE2 EDGE_SE2_XY "
     "EDGE_BEARING_SE2_XY EDGE_PRIOR_SE2 EDGE_PRIOR_SE2_XY EDGE_PRIOR_XY EDGE_POINTXY "
     "EDGE_SE2_XY_CALIB EDGE_SE2_OFFSET EDGE_SE2_POINTXY_OFFSET EDGE_SE2_TWOPOINTSXY "
     "EDGE_SE2_LOTSOFXY"},
    {"types_slam2d_addons", "slam2d_segment",
     "VERTEX_SEGMENT2D VERTEX_LINE2D EDGE_SE2_SEGMENT2D EDGE_SE2_SEGMENT2D_LINE "
     "EDGE_SE2_SEGMENT2D_POINTLINE EDGE_SE2_LINE2D EDGE_LINE2D EDGE_LINE2D_POINTXY"},
    {"types_sclam2d", "sclam", "VERTEX_ODOM_DIFFERENTIAL EDGE_SE2_CALIB EDGE_SE2_ODOM_DIFFERENTIAL_CALIB"},
    {"types_slam3d", "slam3d",
     "VERTEX_SE3:QUAT VERTEX_TRACKXYZ PARAMS_SE3OFFSET CACHE_SE3_OFFSET EDGE_SE3:QUAT "
     "EDGE_SE3_TRACKXYZ EDGE_SE3_PRIOR EDGE_SE3_XYZ_PRIOR EDGE_SE3_OFFSET EDGE_POINTXYZ "
     "EDGE_POINTXYZ_PRIOR EDGE_SE3_LOTSOF_XYZ PARAMS_CAMERACALIB PARAMS_STEREOCAMERACALIB "
     "CACHE_CAMERA EDGE_PROJECT_DEPTH EDGE_PROJECT_DISPARITY"},
    {"types_slam3d_addons", "slam3d_addons",
     "VERTEX3 EDGE3 VERTEX_PLANE EDGE_PLANE EDGE_SE3_CALIB EDGE_SE3_PLANE_CALIB VERTEX_LINE3D "
     "EDGE_SE3_LINE3D"},
    {"types_sba", "sba",
     "VERTEX_CAM VERTEX_XYZ VERTEX_INTRINSICS EDGE_PROJECT_P2MC EDGE_PROJECT_P2SC EDGE_CAM "
     "EDGE_SCALE"},
    {"types_sba", "expmap",
     "PARAMS_CAMERAPARAMETERS VERTEX_SE3:EXPMAP EDGE_SE3:EXPMAP EDGE_PROJECT_XYZ2UV:EXPMAP "
     "EDGE_PROJECT_XYZ2UVU:EXPMAP EDGE_PROJECT_PSI2UV:EXPMAP EDGE_SE3_PROJECT_XYZ:EXPMAP "
     "EDGE_SE3_PROJECT_XYZONLYPOSE:EXPMAP EDGE_STEREO_SE3_PROJECT_XYZ:EXPMAP "
     "EDGE_STEREO_SE3_PROJECT_XYZONLYPOSE:EXPMAP"},
    {"types_sim3", "sim3",
     "VERTEX_SIM3:EXPMAP EDGE_SIM3:EXPMAP EDGE_PROJECT_SIM3_XYZ:EXPMAP "
     "EDGE_PROJECT_INVERSE_SIM3_XYZ:EXPMAP"},
    {"types_icp", "icp", "EDGE_V_V_GICP"},
    {"types_data", "data", "ROBOTLASER1 RAWLASER1 VERTEX_TAG VERTEX_ELLIPSE"},
};

const TypeGroup* group_of(const std::string& tag) {
  const std::string wanted = ' ' + tag + ' ';
  for (const TypeGroup& group : kTypeGroups) {
    if ((' ' + std::string(group.tags) + ' ').find(wanted) != std::string::npos) return &group;
  }
  return nullptr;
}

std::string skipped(int lines) {
  return lines == 1 ? "1 line is skipped" : std::to_string(lines) + " lines are skipped";
}

}  // namespace

void UnknownTags::add(const std::string& tag, int line) {
  Lines& lines = tags_[tag];
  if (lines.count++ == 0 || line < lines.first) lines.first = line;
}

void UnknownTags::report() const {
  constexpr int kShown = 5;
  std::vector<std::pair<std::string, Lines>> tags(tags_.begin(), tags_.end());
  std::sort(tags.begin(), tags.end(),
            [](const auto& a, const auto& b) { return a.second.first < b.second.first; });
  int without_library = 0, other_lines = 0;
  for (const auto& [tag, lines] : tags) {
    const std::string what = "unknown tag " + boxplus::in_quotes(tag) + ", " + skipped(lines.count);
    if (const TypeGroup* group = group_of(tag)) {
      G2O_ERROR("line {}: {}; link libg2o_{} and use G2O_USE_TYPE_GROUP({})", lines.first, what,
                group->library, group->name);
    } else if (++without_library <= kShown) {
      G2O_ERROR("line {}: {}", lines.first, what);
    } else {
      other_lines += lines.count;
    }
  }
  if (other_lines > 0) G2O_ERROR("{} other unknown tags, {}", without_library - kShown, skipped(other_lines));
}

}  // namespace internal
}  // namespace g2o
