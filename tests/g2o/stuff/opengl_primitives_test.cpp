// SPDX-License-Identifier: BSD-3-Clause
// The code of a client that draws with OpenGL. This program is not linked to OpenGL.
#define G2O_NO_OPENGL
#include "g2o/stuff/opengl_primitives.h"

#include <gtest/gtest.h>

namespace {

/// Draws one of each primitive. Returns the depth of the matrix stack, which a client keeps balanced.
int draw_everything() {
  int depth = 0;
  glPushAttrib(GL_ENABLE_BIT | GL_POINT_BIT);
  glDisable(GL_LIGHTING);
  glPushMatrix();
  ++depth;
  glTranslatef(1, 2, 3);
  glRotatef(90, 0, 0, 1);
  glColor4f(0.5F, 0.5F, 0.8F, 0.2F);
  g2o::opengl::drawPoint(3);
  g2o::opengl::drawDisk(1);
  g2o::opengl::drawCircle(1);
  g2o::opengl::drawPlane(1, 2);
  g2o::opengl::drawBox(1, 2, 3);
  g2o::opengl::drawEllipsoid(1, 2, 3);
  g2o::opengl::drawSphere(1);
  g2o::opengl::drawCone(1, 2);
  g2o::opengl::drawCylinder(1, 2);
  g2o::opengl::drawArrow2D(1, 0.2F, 0.2F);
  g2o::opengl::drawPoseBox();
  g2o::opengl::drawRangeRing(5, 90);
  glPopMatrix();
  --depth;
  glPopAttrib();
  return depth;
}

TEST(OpenGlPrimitives, CompileLinkAndRunWithoutOpenGl) {
  EXPECT_EQ(draw_everything(), 0);
  EXPECT_EQ(glGenLists(1), 0U);  // as OpenGL does if it cannot make a list
}

}  // namespace
