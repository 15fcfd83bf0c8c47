// SPDX-License-Identifier: BSD-3-Clause
// Includes the OpenGL headers, for programs that draw. Only opengl_primitives.h includes this header.
#pragma once
#ifndef G2O_OPENGL_WRAPPER_H
#define G2O_OPENGL_WRAPPER_H

#include "g2o/config.h"

#if defined(__APPLE__)
#include <OpenGL/gl.h>
#include <OpenGL/glu.h>
#else
#include <GL/gl.h>
#include <GL/glu.h>
#endif

#endif  // G2O_OPENGL_WRAPPER_H
