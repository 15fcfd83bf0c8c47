// SPDX-License-Identifier: BSD-3-Clause
// Includes the OpenGL headers, for programs that draw. If they are not installed, or if G2O_NO_OPENGL is
// defined, includes functions of the same names that do nothing. Only opengl_primitives.h includes this
// header.
#pragma once
#ifndef G2O_OPENGL_WRAPPER_H
#define G2O_OPENGL_WRAPPER_H

#include "g2o/config.h"

#if defined(G2O_NO_OPENGL)
#include "g2o/stuff/no_opengl.h"
#elif defined(__APPLE__)
#include <OpenGL/gl.h>
#include <OpenGL/glu.h>
#elif defined(__has_include)
#if __has_include(<GL/gl.h>) && __has_include(<GL/glu.h>)
#include <GL/gl.h>
#include <GL/glu.h>
#else
#include "g2o/stuff/no_opengl.h"
#endif
#else
#include <GL/gl.h>
#include <GL/glu.h>
#endif

#endif  // G2O_OPENGL_WRAPPER_H
