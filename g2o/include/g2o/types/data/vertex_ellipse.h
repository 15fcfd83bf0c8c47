// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_VERTEX_ELLIPSE_H
#define G2O_VERTEX_ELLIPSE_H

#include <vector>

#include "g2o/core/eigen_types.h"
#include "g2o/core/hyper_graph_action.h"
#include "g2o/types/data/robot_data.h"

namespace g2o {

/// The uncertainty of a pose in the plane, in the frame of the pose (meters and radians), and the vertices
/// that may match it. Tag: VERTEX_ELLIPSE. read() and write() use all fields of the rest of a line.
class G2O_TYPES_DATA_API VertexEllipse : public RobotData {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  VertexEllipse();
  ~VertexEllipse() override;

  bool read(std::istream& is) override;
  /// Values that have not changed since read() are written as they were read. The ids of matching vertices
  /// are not written.
  bool write(std::ostream& os) const override;

  /// The covariance of (x, y, θ). The function that sets it also updates the axes.
  const Matrix3F& covariance() const { return _covariance; }
  void setCovariance(const Matrix3F& c);

  /// The columns are the directions of the axes of the ellipse, the longest one first.
  const Matrix2F& U() const { return _UMatrix; }
  /// The variances along these axes.
  const Vector2F& singularValues() const { return _singularValues; }

  void addMatchingVertex(float x, float y) { _matchingVertices.emplace_back(x, y); }
  void addMatchingVertexID(int id) { _matchingVerticesIDs.push_back(id); }
  void clearMatchingVertices() { _matchingVertices.clear(); }
  const std::vector<Vector2F>& matchingVertices() const { return _matchingVertices; }
  const std::vector<int>& matchingVerticesIDs() const { return _matchingVerticesIDs; }

 protected:
  void _updateSVD() const;

  Matrix3F _covariance = Matrix3F::Identity();
  mutable Matrix2F _UMatrix = Matrix2F::Identity();
  mutable Vector2F _singularValues = Vector2F::Ones();
  std::vector<int> _matchingVerticesIDs;
  std::vector<Vector2F> _matchingVertices;

 private:
  std::vector<double> _numbersOfFile;  // in double precision: the covariance, and the matching vertices
};

/// The action "draw" of VertexEllipse: the ellipse of one standard deviation, the headings within one
/// standard deviation, and lines to the matching vertices, if the data belongs to a pose. Its property is
/// SCALING_FACTOR.
class G2O_TYPES_DATA_API VertexEllipseDrawAction : public internal::NamedAction<DrawAction> {
 public:
  VertexEllipseDrawAction();
};

}  // namespace g2o

#endif  // G2O_VERTEX_ELLIPSE_H
