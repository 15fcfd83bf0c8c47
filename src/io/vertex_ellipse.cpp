// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/io/vertex_ellipse.h"

#include <fmt/format.h>

#include <array>

#include "io/data_fields.h"

namespace boxplus {

VertexEllipse VertexEllipse::read(FieldReader& in) {
  VertexEllipse ellipse;
  for (int row = 0; row < 3; ++row) {
    for (int column = row; column < 3; ++column) {
      const FieldPlace place = in.place();
      const double value = in.number("a covariance");
      if (row == column && value < 0) in.fail(place, fmt::format("expected a variance ≥ 0, got {}", value));
      ellipse.covariance(row, column) = ellipse.covariance(column, row) = value;
    }
  }
  const std::int64_t count = read_count(in, "the number of points");
  for (std::int64_t i = 0; i < count; ++i) {
    Vector<double, 2> point;
    in.numbers(point.data(), 2, "the position of a point");
    ellipse.matching_vertices.push_back(point);
  }
  in.expect_end();
  return ellipse;
}

void VertexEllipse::write(FieldWriter& out) const {
  const auto& c = covariance;
  write_finite(out, std::array{c(0, 0), c(0, 1), c(0, 2), c(1, 1), c(1, 2), c(2, 2)});
  out.integer(static_cast<std::int64_t>(matching_vertices.size()));
  for (const Vector<double, 2>& point : matching_vertices) write_finite(out, std::array{point[0], point[1]});
}

}  // namespace boxplus
