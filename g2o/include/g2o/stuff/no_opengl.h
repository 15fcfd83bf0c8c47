// SPDX-License-Identifier: BSD-3-Clause
// The functions of OpenGL 1 with which actions draw shapes. Here, they do nothing, so that the code of
// actions compiles and links without OpenGL. Include opengl_wrapper.h instead of this header.
#pragma once
#ifndef G2O_NO_OPENGL_H
#define G2O_NO_OPENGL_H

#include "g2o/config.h"

#if !defined(GL_VERSION_1_1)  // defined if a header with the real functions is already included

using GLenum = unsigned int;
using GLboolean = unsigned char;
using GLbitfield = unsigned int;
using GLint = int;
using GLuint = unsigned int;
using GLsizei = int;
using GLfloat = float;
using GLdouble = double;
using GLubyte = unsigned char;

constexpr GLenum GL_POINTS = 0x0000, GL_LINES = 0x0001, GL_LINE_LOOP = 0x0002, GL_LINE_STRIP = 0x0003;
constexpr GLenum GL_TRIANGLES = 0x0004, GL_TRIANGLE_STRIP = 0x0005, GL_TRIANGLE_FAN = 0x0006;
constexpr GLenum GL_QUADS = 0x0007, GL_QUAD_STRIP = 0x0008, GL_POLYGON = 0x0009;
constexpr GLenum GL_FRONT = 0x0404, GL_BACK = 0x0405, GL_FRONT_AND_BACK = 0x0408;
constexpr GLenum GL_LINE = 0x1B01, GL_FILL = 0x1B02, GL_COMPILE = 0x1300;
constexpr GLenum GL_CULL_FACE = 0x0B44, GL_LIGHTING = 0x0B50, GL_BLEND = 0x0BE2, GL_DEPTH_TEST = 0x0B71;
constexpr GLenum GL_MODELVIEW = 0x1700, GL_PROJECTION = 0x1701;
constexpr GLbitfield GL_CURRENT_BIT = 0x00000001, GL_POINT_BIT = 0x00000002, GL_LINE_BIT = 0x00000004;
constexpr GLbitfield GL_POLYGON_BIT = 0x00000008, GL_ENABLE_BIT = 0x00002000, GL_LIGHTING_BIT = 0x00000040;

inline void glBegin(GLenum) {}
inline void glEnd() {}
inline void glVertex2f(GLfloat, GLfloat) {}
inline void glVertex2d(GLdouble, GLdouble) {}
inline void glVertex3f(GLfloat, GLfloat, GLfloat) {}
inline void glVertex3d(GLdouble, GLdouble, GLdouble) {}
inline void glVertex3fv(const GLfloat*) {}
inline void glVertex3dv(const GLdouble*) {}
inline void glNormal3f(GLfloat, GLfloat, GLfloat) {}
inline void glNormal3d(GLdouble, GLdouble, GLdouble) {}
inline void glColor3f(GLfloat, GLfloat, GLfloat) {}
inline void glColor4f(GLfloat, GLfloat, GLfloat, GLfloat) {}
inline void glColor3fv(const GLfloat*) {}
inline void glColor4fv(const GLfloat*) {}
inline void glPointSize(GLfloat) {}
inline void glLineWidth(GLfloat) {}
inline void glPolygonMode(GLenum, GLenum) {}
inline void glEnable(GLenum) {}
inline void glDisable(GLenum) {}
inline void glMatrixMode(GLenum) {}
inline void glLoadIdentity() {}
inline void glPushMatrix() {}
inline void glPopMatrix() {}
inline void glMultMatrixf(const GLfloat*) {}
inline void glMultMatrixd(const GLdouble*) {}
inline void glTranslatef(GLfloat, GLfloat, GLfloat) {}
inline void glTranslated(GLdouble, GLdouble, GLdouble) {}
inline void glRotatef(GLfloat, GLfloat, GLfloat, GLfloat) {}
inline void glRotated(GLdouble, GLdouble, GLdouble, GLdouble) {}
inline void glScalef(GLfloat, GLfloat, GLfloat) {}
inline void glScaled(GLdouble, GLdouble, GLdouble) {}
inline void glPushAttrib(GLbitfield) {}
inline void glPopAttrib() {}
inline GLuint glGenLists(GLsizei) {
  return 0;
}
inline void glNewList(GLuint, GLenum) {}
inline void glEndList() {}
inline void glCallList(GLuint) {}
inline void glDeleteLists(GLuint, GLsizei) {}

#endif

#endif  // G2O_NO_OPENGL_H
