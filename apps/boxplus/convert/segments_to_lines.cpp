// SPDX-License-Identifier: BSD-3-Clause
#include "convert/segments_to_lines.h"

#include <fmt/format.h>

#include <Eigen/QR>
#include <cmath>

#include "boxplus/types/slam2d.h"
#include "convert/replace_vertices.h"

namespace boxplus::app {
namespace {

/// The line through two points.
Line2 line_through(const Vector2& first, const Vector2& second) {
  if (first == second) {
    throw InvalidArgument(
        fmt::format("--to lines: expected segments with two different end points, got ({}, {}) twice",
                    first[0], first[1]));
  }
  Line2 line;
  line.angle = detail::normal_angle(first, second);
  const Vector2 n(std::cos(line.angle), std::sin(line.angle));
  line.distance = 0.5 * n.dot(first + second);
  return line;
}

/// ∂p/∂(θ, ρ, t) of the point p = ρ n + t d at z.
Eigen::Matrix<double, 2, 3> derivatives(const Line2& line, const Vector2& z) {
  const Eigen::Vector2d n(std::cos(line.angle), std::sin(line.angle)), d(-n[1], n[0]), p(z[0], z[1]);
  Eigen::Matrix<double, 2, 3> J;
  J << line.distance * d - d.dot(p) * n, n, d;
  return J;
}

/// AᵀΩA for coordinates (θ, ρ, t…), after the marginalization of all but the first two.
Eigen::Matrix2d information_of_line(const Eigen::MatrixXd& A, const Eigen::MatrixXd& omega) {
  const Eigen::MatrixXd full = A.transpose() * omega * A;
  const auto rest = full.rows() - 2;
  const Eigen::MatrixXd along = full.bottomRightCorner(rest, rest), coupling = full.topRightCorner(2, rest);
  const Eigen::MatrixXd inverse = along.completeOrthogonalDecomposition().pseudoInverse();
  const Eigen::Matrix2d result = full.topLeftCorner<2, 2>() - coupling * inverse * coupling.transpose();
  return 0.5 * (result + result.transpose());  // exactly symmetric
}

class SegmentsToLines {
 public:
  explicit SegmentsToLines(GraphFile& file) : graph_(file.graph), replacement_(file) {}

  void run() {
    if (!replacement_.is_needed())
      throw InvalidArgument("--to lines: expected segments (VERTEX_SEGMENT2D), got none");
    replacement_.add_vertices(
        [](const Segment2& segment) { return line_through(segment.first, segment.second); });
    replacement_.replace_edges("--to lines: expected edges of one pose and one VERTEX_SEGMENT2D",
                               [this](EdgeRef edge) { return replace(edge); });
  }

 private:
  std::optional<EdgeRef> replace(EdgeRef edge) {
    if (is_edge<SegmentLineObservation2, SE2, Segment2>(graph_, edge)) {
      const Vector2 z = graph_.measurement(EdgeHandle<SegmentLineObservation2>{edge}).measurement;
      return add(edge, z, omega(edge));
    }
    if (is_edge<SegmentObservation2, SE2, Segment2>(graph_, edge)) return replace_both_ends(edge);
    if (is_edge<SegmentEndObservation2, SE2, Segment2>(graph_, edge)) return replace_end(edge);
    return std::nullopt;
  }

  EdgeRef replace_both_ends(EdgeRef edge) {
    const Vector<double, 4> z = graph_.measurement(EdgeHandle<SegmentObservation2>{edge}).measurement;
    const Vector2 first(z[0], z[1]), second(z[2], z[3]);
    const Line2 line = line_through(first, second);
    Eigen::Matrix4d A = Eigen::Matrix4d::Zero();  // columns: θ, ρ, t of the first point, t of the second
    A.topLeftCorner<2, 3>() = derivatives(line, first);
    A.bottomLeftCorner<2, 2>() = derivatives(line, second).leftCols<2>();
    A.bottomRightCorner<2, 1>() = derivatives(line, second).col(2);
    return add(edge, Vector2(line.angle, line.distance), information_of_line(A, omega(edge)));
  }

  EdgeRef replace_end(EdgeRef edge) {
    const Vector3 z = graph_.measurement(EdgeHandle<SegmentEndObservation2>{edge}).measurement;
    Line2 line;
    line.angle = z[2];
    line.distance = std::cos(z[2]) * z[0] + std::sin(z[2]) * z[1];
    Eigen::Matrix3d A;
    A << derivatives(line, Vector2(z[0], z[1])), 1, 0, 0;
    return add(edge, Vector2(line.angle, line.distance), information_of_line(A, omega(edge)));
  }

  EdgeRef add(EdgeRef old, const Vector2& z, const Eigen::MatrixXd& information) {
    const std::vector<VertexRef> ends = graph_.vertices(old);  // the pose, the segment
    return graph_.add_edge(LineObservation2(z), information, graph_.typed<SE2>(ends[0]),
                           replacement_.new_vertex(ends[1]));
  }

  Eigen::MatrixXd omega(EdgeRef edge) const { return graph_.information(edge).matrix(); }

  Graph& graph_;
  VertexReplacement<Segment2, Line2> replacement_;
};

}  // namespace

void segments_to_lines(GraphFile& file) {
  SegmentsToLines(file).run();
}

}  // namespace boxplus::app
