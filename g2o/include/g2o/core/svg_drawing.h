// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_SVG_DRAWING_H
#define G2O_SVG_DRAWING_H

#include <iosfwd>
#include <string>
#include <vector>

#include "g2o/core/drawing.h"

namespace g2o {

/// Collects shapes and writes them as an SVG picture: first lines, then poses and points, then text.
///
/// If all shapes have z = 0, the picture is a view from above, with x to the right and y up. Otherwise, it is
/// a parallel projection, seen from the south-east and from above. setView() chooses another direction.
class G2O_CORE_API SvgDrawing : public Drawing {
 public:
  /// `size` is the longer side of the picture in pixels. It is at least 16.
  explicit SvgDrawing(int size = 800);
  ~SvgDrawing() override;

  void polyline(const std::vector<Vector3>& corners, bool isClosed, const Color& color,
                double width) override;
  void point(const Vector3& at, const Color& color, double diameter) override;
  void pose(const Isometry3& pose, const Color& color, double length, double width) override;
  void text(const Vector3& at, const std::string& words, const Color& color, double height) override;

  /// Sets the rotation from the world to the viewer. The viewer's x-axis points right, the y-axis points up,
  /// and the z-axis points towards the viewer.
  void setView(const Matrix3& view);
  bool empty() const { return _shapes.empty(); }
  void clear();

  /// Returns false if the stream or the file cannot be written. Leaves out shapes with coordinates that are
  /// not finite.
  bool write(std::ostream& os) const;
  bool save(const std::string& path) const;

 private:
  enum class Kind { kLine, kFilled, kPoint, kText };
  struct Shape {
    Kind kind = Kind::kLine;
    std::vector<Vector3> corners;
    bool isClosed = false;
    Color color;
    double size = 1;  ///< the width of a line, the diameter of a point, or the height of text
    std::string words;
  };
  class Page;

  void add(Kind kind, std::vector<Vector3> corners, bool isClosed, const Color& color, double size,
           const std::string& words);

  int _size;
  bool _hasView = false, _isFlat = true;
  Matrix3 _view;
  std::vector<Shape> _shapes;
};

}  // namespace g2o

#endif  // G2O_SVG_DRAWING_H
