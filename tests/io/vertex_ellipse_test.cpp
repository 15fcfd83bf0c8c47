// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/io/vertex_ellipse.h"

#include <gtest/gtest.h>

#include "boxplus/base/error.h"

namespace boxplus {
namespace {

std::string complaint(std::string_view fields) {
  FieldReader in("g", 2, fields);
  try {
    VertexEllipse::read(in);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no complaint";
}

TEST(VertexEllipse, HasTheFieldsOfTheLineInTheirOrder) {
  constexpr const char* kFields = "4 0.5 0.25 9 -0.125 0.01 2 1 2 3 4.5";
  FieldReader in("g", 1, kFields);
  const VertexEllipse ellipse = VertexEllipse::read(in);
  Matrix<double, 3, 3> expected;
  expected << 4, 0.5, 0.25, 0.5, 9, -0.125, 0.25, -0.125, 0.01;
  EXPECT_EQ(ellipse.covariance, expected);
  ASSERT_EQ(ellipse.matching_vertices.size(), 2);
  EXPECT_EQ(ellipse.matching_vertices[0], (Vector<double, 2>(1, 2)));
  EXPECT_EQ(ellipse.matching_vertices[1], (Vector<double, 2>(3, 4.5)));
  std::string text;
  FieldWriter out(text);
  ellipse.write(out);
  EXPECT_EQ(text, kFields);
}

TEST(VertexEllipse, ReportsTheFieldThatIsWrong) {
  EXPECT_EQ(complaint("4 0 0 -9"), "g:2:7: expected a variance ≥ 0, got -9");
  EXPECT_EQ(complaint("4 0 0 9 0 1 -2"), "g:2:13: expected the number of points (a number ≥ 0), got -2");
  EXPECT_EQ(complaint("4 0 0 9 0 1 9000000000000000000 1"),
            "g:2:34: expected the position of a point, got the end of the line");
  EXPECT_EQ(complaint("4 0 0 9 0 1 0 1"), "g:2:15: expected the end of the line, got '1'");
}

}  // namespace
}  // namespace boxplus
