# RapidCheck is missing: Debian has no sources of it, and its library is compiled with libstdc++. Test sources that include
# it are left out. (The preset `libcxx` has this folder as rapidcheck_DIR.)
if(NOT TARGET rapidcheck)
  add_library(rapidcheck INTERFACE IMPORTED)
endif()
set(BOXPLUS_RAPIDCHECK_MISSING ON)
