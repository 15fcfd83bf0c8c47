// SPDX-License-Identifier: BSD-3-Clause
// A sparse matrix of CHOLMOD that deletes its arrays. Only this header needs CHOLMOD (LGPL and GPL), and no
// other header includes this header.
#pragma once
#ifndef G2O_CHOLMOD_EXT_H
#define G2O_CHOLMOD_EXT_H

#if defined(__has_include) && __has_include(<suitesparse/cholmod.h>)
#include <suitesparse/cholmod.h>
#else
#include <cholmod.h>
#endif

#include <cstddef>

#include "g2o/config.h"

namespace g2o {

/// A symmetric matrix of doubles that stores its upper triangle. Initially, it is empty. The client allocates
/// the arrays p (int), i (int) and x (double) by new[], and the destructor deletes them.
struct CholmodExt : public cholmod_sparse {
  CholmodExt() : cholmod_sparse() {
    stype = 1;
    itype = CHOLMOD_INT;
    xtype = CHOLMOD_REAL;
    dtype = CHOLMOD_DOUBLE;
    sorted = 1;
    packed = 1;
  }
  CholmodExt(const CholmodExt&) = delete;
  CholmodExt& operator=(const CholmodExt&) = delete;
  ~CholmodExt() {
    delete[] static_cast<int*>(p);
    delete[] static_cast<int*>(i);
    delete[] static_cast<double*>(x);
  }
  std::size_t columnsAllocated = 0;  ///< the size of p minus one
};

}  // namespace g2o

#endif  // G2O_CHOLMOD_EXT_H
