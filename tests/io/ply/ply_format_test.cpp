// SPDX-License-Identifier: BSD-3-Clause
#include "io/ply/ply_format.h"

#include <gmock/gmock.h>

#include <cstring>

#include "boxplus/base/error.h"
#include "boxplus/types/slam3d.h"
#include "io/colmap/model_folder.h"

namespace boxplus {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

double double_at(std::string_view bytes, std::size_t at) {
  double value = 0;
  std::memcpy(&value, bytes.data() + at, sizeof value);  // tests run on little-endian machines
  return value;
}

TEST(PlyFormat, HasThePointsWithTheirColorsAndTheCamerasAsPyramids) {
  const std::string text = format_graph(read_model_texts({}), {.format = "ply"});
  constexpr const char* kHeader =
      "ply\nformat binary_little_endian 1.0\nelement vertex 18\n"
      "property double x\nproperty double y\nproperty double z\n"
      "property uchar red\nproperty uchar green\nproperty uchar blue\n"
      "element edge 24\nproperty int vertex1\nproperty int vertex2\nend_header\n";
  ASSERT_THAT(text, StartsWith(kHeader));
  const std::string_view bytes = std::string_view(text).substr(std::strlen(kHeader));
  ASSERT_EQ(bytes.size(), 18u * 27 + 24 * 8);
  // The points are sorted by id: 4, 17, 30.
  EXPECT_EQ(double_at(bytes, 0), -0.1);
  EXPECT_EQ(double_at(bytes, 2 * 27 + 16), 5);
  EXPECT_EQ(bytes.substr(2 * 27 + 24, 3), std::string_view("\xff\x80\0", 3));
  // Image 5 is the first camera. It looks along z from (0, -0.125, 0.25).
  EXPECT_EQ(double_at(bytes, 3 * 27 + 8), -0.125);
  EXPECT_EQ(double_at(bytes, 3 * 27 + 16), 0.25);
  for (std::size_t corner = 4; corner < 8; ++corner) EXPECT_GT(double_at(bytes, corner * 27 + 16), 0.25);
}

TEST(PlyFormat, LooksAlongTheNegativeAxisForBal) {
  const std::string text =
      format_graph(parse_graph("1 1 1\n0 0 1 2\n0 0 0 0 0 0 500 0 0\n1 2 -10\n", "g"), {.format = "ply"});
  const std::string_view bytes = std::string_view(text).substr(text.find("end_header\n") + 11);
  EXPECT_EQ(double_at(bytes, 27 + 16), 0) << "the center";
  EXPECT_LT(double_at(bytes, 2 * 27 + 16), 0);
}

TEST(PlyFormat, HasNoEdgesForAGraphWithoutCameras) {
  const std::string text = format_graph(
      parse_graph("VERTEX_SE3:QUAT 0 1 2 3 0 0 0 1\nVERTEX_TRACKXYZ 1 4 5 6\n", "g"), {.format = "ply"});
  EXPECT_THAT(text, HasSubstr("element vertex 2\n"));
  EXPECT_THAT(text, testing::Not(HasSubstr("element edge")));
}

TEST(PlyFormat, CannotBeReadNorShowAGraphWithoutPositions) {
  EXPECT_THAT(complaint_of([] { parse_graph("ply\nformat ascii 1.0\n", "g"); }),
              testing::EndsWith("got .ply, which boxplus can only write"));
  EXPECT_THAT(complaint_of([] { format_graph(Graph{}, {.format = "ply"}); }),
              HasSubstr("expected poses or points"));
}

}  // namespace
}  // namespace boxplus
