// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_OWNERSHIP_H
#define G2O_OWNERSHIP_H

#include <iostream>

namespace g2o {

/// Deletes an object that a container owns through a raw pointer. Does nothing if
/// G2O_NO_IMPLICIT_OWNERSHIP_OF_OBJECTS is defined, because the client then owns such objects.
template <typename T>
void release(T* object) {
#ifdef G2O_NO_IMPLICIT_OWNERSHIP_OF_OBJECTS
  (void)object;
#else
  delete object;
#endif
}

}  // namespace g2o

#endif  // G2O_OWNERSHIP_H
