// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_MACROS_H
#define G2O_MACROS_H

#include <cmath>
#include <iomanip>
#include <iostream>

/// Use PVAR and PVARA after `stream <<`. They write the source text of an expression, followed by its value.
/// PVARA converts the value from radians to degrees.
#ifndef PVAR
#define PVAR(s) #s << " = " << (s) << std::flush
#endif
#ifndef PVARA
#define PVARA(s) #s << " = " << ((s)*57.29577951308232087721) << "deg" << std::flush
#endif
// Other libraries, such as PCL, have macros with the following names. If their headers come first, their
// macros stay.
/// Use FIXED after `stream <<`. It writes a value in fixed notation, and then resets the stream to its
/// default notation.
#ifndef FIXED
#define FIXED(s) std::fixed << (s) << std::resetiosflags(std::ios_base::fixed)
#endif

#ifndef DEG2RAD
#define DEG2RAD(x) ((x)*0.01745329251994329575)
#endif
#ifndef RAD2DEG
#define RAD2DEG(x) ((x)*57.29577951308232087721)
#endif

#if defined(__GNUC__) || defined(__clang__)
#define G2O_ATTRIBUTE_CONSTRUCTOR(func)                \
  static void func(void) __attribute__((constructor)); \
  static void func(void)
#define G2O_ATTRIBUTE_UNUSED __attribute__((unused))
#define G2O_ATTRIBUTE_FORMAT12 __attribute__((format(printf, 1, 2)))
#define G2O_ATTRIBUTE_FORMAT23 __attribute__((format(printf, 2, 3)))
#define G2O_ATTRIBUTE_WARNING(func) func __attribute__((warning))
#define G2O_ATTRIBUTE_DEPRECATED(func) func __attribute__((deprecated))
#else
#define G2O_ATTRIBUTE_CONSTRUCTOR(func) static void func(void)
#define G2O_ATTRIBUTE_UNUSED
#define G2O_ATTRIBUTE_FORMAT12
#define G2O_ATTRIBUTE_FORMAT23
#define G2O_ATTRIBUTE_WARNING(func) func
#define G2O_ATTRIBUTE_DEPRECATED(func) func
#endif

#define g2o_isnan(x) std::isnan(x)
#define g2o_isinf(x) std::isinf(x)
#define g2o_isfinite(x) std::isfinite(x)

#ifndef __PRETTY_FUNCTION__
#if !defined(__GNUC__) && !defined(__clang__)
#define __PRETTY_FUNCTION__ __FUNCTION__
#endif
#endif

#endif  // G2O_MACROS_H
