// SPDX-License-Identifier: BSD-3-Clause
// For the tests of programs that link MPI, which does not free all of its memory. Include it in one source.
#pragma once

#ifdef BOXPLUS_SANITIZED
// NOLINTBEGIN(bugprone-reserved-identifier,misc-definitions-in-headers,readability-identifier-naming)
/// Options of AddressSanitizer.
extern "C" const char* __asan_default_options() {
  return "detect_leaks=0";
}
// NOLINTEND(bugprone-reserved-identifier,misc-definitions-in-headers,readability-identifier-naming)
#endif
