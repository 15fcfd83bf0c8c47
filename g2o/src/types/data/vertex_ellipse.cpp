// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/types/data/vertex_ellipse.h"

#include <Eigen/Eigenvalues>

#include "types/data/adapters_data.h"

namespace g2o {

VertexEllipse::VertexEllipse() = default;
VertexEllipse::~VertexEllipse() = default;

bool VertexEllipse::read(std::istream& is) {
  return adapters::read_data<boxplus::VertexEllipse>(is, [&](const boxplus::VertexEllipse& ellipse) {
    std::vector<double> numbers;
    Matrix3F covariance;
    std::vector<Vector2F> vertices;
    for (int row = 0; row < 3; ++row) {
      for (int column = row; column < 3; ++column) {
        numbers.push_back(ellipse.covariance(row, column));
        covariance(row, column) = covariance(column, row) = adapters::to_float(numbers.back());
      }
    }
    for (const auto& point : ellipse.matching_vertices) {
      numbers.insert(numbers.end(), {point[0], point[1]});
      vertices.emplace_back(adapters::to_float(point[0]), adapters::to_float(point[1]));
    }
    setCovariance(covariance);
    _matchingVertices = std::move(vertices);
    _matchingVerticesIDs.clear();
    _numbersOfFile = std::move(numbers);
  });
}

bool VertexEllipse::write(std::ostream& os) const {
  std::size_t k = 0;
  const auto number = [&](float value) {
    const std::size_t at = k++;
    return at < _numbersOfFile.size() ? adapters::number_of(value, _numbersOfFile[at])
                                      : adapters::number_of(value);
  };
  boxplus::VertexEllipse ellipse;
  for (int row = 0; row < 3; ++row) {
    for (int column = row; column < 3; ++column)
      ellipse.covariance(row, column) = ellipse.covariance(column, row) = number(_covariance(row, column));
  }
  for (const Vector2F& vertex : _matchingVertices) {
    const double x = number(vertex[0]), y = number(vertex[1]);
    ellipse.matching_vertices.emplace_back(x, y);
  }
  return adapters::write_data(os, ellipse);
}

void VertexEllipse::setCovariance(const Matrix3F& c) {
  _covariance = c;
  _updateSVD();
}

void VertexEllipse::_updateSVD() const {
  Eigen::SelfAdjointEigenSolver<Matrix2F> solver;
  solver.computeDirect(_covariance.topLeftCorner<2, 2>());
  _UMatrix = solver.eigenvectors().rowwise().reverse();
  _singularValues = solver.eigenvalues().reverse();
}

}  // namespace g2o
