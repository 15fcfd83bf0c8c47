// SPDX-License-Identifier: BSD-3-Clause
// Functions that draw shapes around the origin with OpenGL, including normals. Lengths are in the units of
// the current matrix.
#pragma once
#ifndef G2O_OPENGL_PRIMITIVES_H
#define G2O_OPENGL_PRIMITIVES_H

#include <algorithm>
#include <cmath>

#include "g2o/stuff/misc.h"
#include "g2o/stuff/opengl_wrapper.h"

namespace g2o {
namespace opengl {
namespace internal {

constexpr int kSegments = 32;  // number of segments in a full circle

inline GLfloat angle_of(int i, int segments) {
  return static_cast<GLfloat>(2 * const_pi() * i / segments);
}

/// Draws the side of a cone or cylinder along z, from 0 to the height.
inline void draw_side(GLfloat bottom, GLfloat top, GLfloat height) {
  glBegin(GL_TRIANGLE_STRIP);
  for (int i = 0; i <= kSegments; ++i) {
    const GLfloat c = std::cos(angle_of(i, kSegments)), s = std::sin(angle_of(i, kSegments));
    const GLfloat slope = bottom - top, length = std::sqrt(slope * slope + height * height);
    if (length > 0) glNormal3f(c * height / length, s * height / length, slope / length);
    glVertex3f(c * bottom, s * bottom, 0);
    glVertex3f(c * top, s * top, height);
  }
  glEnd();
}

/// Draws a segment of a ring in the xy-plane. The x-axis bisects the segment. `angle` is in radians.
inline void draw_ring(GLfloat inner, GLfloat outer, GLfloat angle, GLfloat z, GLfloat normal) {
  const int segments = std::max(1, static_cast<int>(std::ceil(kSegments * angle / (2 * const_pi()))));
  glNormal3f(0, 0, normal);
  glBegin(GL_TRIANGLE_STRIP);
  for (int i = 0; i <= segments; ++i) {
    const GLfloat at = angle * (static_cast<GLfloat>(i) / static_cast<GLfloat>(segments) - 0.5F);
    glVertex3f(inner * std::cos(at), inner * std::sin(at), z);
    glVertex3f(outer * std::cos(at), outer * std::sin(at), z);
  }
  glEnd();
}

inline void draw_rectangle(const GLfloat (&normal)[3], const GLfloat (&corners)[4][3]) {
  glBegin(GL_TRIANGLE_FAN);
  glNormal3f(normal[0], normal[1], normal[2]);
  for (const auto& corner : corners) glVertex3f(corner[0], corner[1], corner[2]);
  glEnd();
}

}  // namespace internal

inline void drawPoint(float pointSize) {
  glPointSize(pointSize);
  glBegin(GL_POINTS);
  glVertex3f(0, 0, 0);
  glEnd();
}

/// Draws a disk in the xy-plane that is visible from z > 0.
inline void drawDisk(GLfloat radius) {
  internal::draw_ring(0, radius, static_cast<GLfloat>(2 * const_pi()), 0, 1);
}

/// Draws a circle of lines in the xy-plane.
inline void drawCircle(GLfloat radius, int segments = internal::kSegments) {
  glBegin(GL_LINE_LOOP);
  for (int i = 0; i < segments; ++i) {
    const GLfloat at = internal::angle_of(i, segments);
    glVertex3f(radius * std::cos(at), radius * std::sin(at), 0);
  }
  glEnd();
}

/// Draws a rectangle in the xy-plane, with length l along x and width w along y.
inline void drawPlane(GLfloat l, GLfloat w) {
  const GLfloat x = l / 2, y = w / 2;
  internal::draw_rectangle({0, 0, 1}, {{-x, -y, 0}, {x, -y, 0}, {x, y, 0}, {-x, y, 0}});
}

/// Draws a box with length l along x, width w along y and height h along z.
inline void drawBox(GLfloat l, GLfloat w, GLfloat h) {
  const GLfloat x = l / 2, y = w / 2, z = h / 2;
  internal::draw_rectangle({0, 0, 1}, {{-x, -y, z}, {x, -y, z}, {x, y, z}, {-x, y, z}});
  internal::draw_rectangle({0, 0, -1}, {{-x, y, -z}, {x, y, -z}, {x, -y, -z}, {-x, -y, -z}});
  internal::draw_rectangle({1, 0, 0}, {{x, -y, -z}, {x, y, -z}, {x, y, z}, {x, -y, z}});
  internal::draw_rectangle({-1, 0, 0}, {{-x, -y, z}, {-x, y, z}, {-x, y, -z}, {-x, -y, -z}});
  internal::draw_rectangle({0, 1, 0}, {{-x, y, z}, {x, y, z}, {x, y, -z}, {-x, y, -z}});
  internal::draw_rectangle({0, -1, 0}, {{-x, -y, -z}, {x, -y, -z}, {x, -y, z}, {-x, -y, z}});
}

inline void drawEllipsoid(GLfloat r1, GLfloat r2, GLfloat r3) {
  constexpr int kRings = internal::kSegments / 2;
  const auto vertex = [&](int ring, int i) {
    const auto up = static_cast<GLfloat>(const_pi() * ring / kRings - const_pi() / 2);
    const GLfloat at = internal::angle_of(i, internal::kSegments);
    const GLfloat x = std::cos(up) * std::cos(at), y = std::cos(up) * std::sin(at), z = std::sin(up);
    glNormal3f(x / r1, y / r2, z / r3);
    glVertex3f(r1 * x, r2 * y, r3 * z);
  };
  for (int ring = 0; ring < kRings; ++ring) {
    glBegin(GL_TRIANGLE_STRIP);
    for (int i = 0; i <= internal::kSegments; ++i) {
      vertex(ring + 1, i);
      vertex(ring, i);
    }
    glEnd();
  }
}
inline void drawSphere(GLfloat radius) {
  drawEllipsoid(radius, radius, radius);
}

/// Draw a cone or a cylinder with its base in the xy-plane.
inline void drawCone(GLfloat radius, GLfloat height) {
  internal::draw_side(radius, 0, height);
  internal::draw_ring(0, radius, static_cast<GLfloat>(2 * const_pi()), 0, -1);
}
inline void drawCylinder(GLfloat radius, GLfloat height) {
  internal::draw_side(radius, radius, height);
  internal::draw_ring(0, radius, static_cast<GLfloat>(2 * const_pi()), 0, -1);
  internal::draw_ring(0, radius, static_cast<GLfloat>(2 * const_pi()), height, 1);
}

/// Draws an arrow along x.
inline void drawArrow2D(float len, float head_width, float head_len) {
  glBegin(GL_LINES);
  glVertex2f(0, 0);
  glVertex2f(len, 0);
  glEnd();
  glNormal3f(0, 0, 1);
  glBegin(GL_TRIANGLES);
  glVertex2f(len, 0);
  glVertex2f(len - head_len, head_width / 2);
  glVertex2f(len - head_len, -head_width / 2);
  glEnd();
}

/// Draws a box that represents a pose. The box is 0.5 long and has an arrow along x.
inline void drawPoseBox() {
  drawBox(0.5F, 0.25F, 0.1F);
  drawArrow2D(0.5F, 0.2F, 0.2F);
}

/// Draws a ring segment at distance `range` that shows the field of view (degrees) of a sensor along x.
inline void drawRangeRing(GLfloat range, GLfloat fov, GLfloat range_width = 0.05F) {
  internal::draw_ring(range - range_width / 2, range + range_width / 2, static_cast<GLfloat>(deg2rad(fov)), 0,
                      1);
}

}  // namespace opengl
}  // namespace g2o

#endif  // G2O_OPENGL_PRIMITIVES_H
