# Compiler settings for boxplus itself. A project that links boxplus gets compiler settings only from the
# target properties that src/CMakeLists.txt sets.
if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_CXX_EXTENSIONS OFF)

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # With CCACHE_BASEDIR, ccache uses paths relative to the project, so that another clone can use the same
  # cache. With CCACHE_INODECACHE, it computes the checksum of a precompiled header of 180 MB once, and not once per
  # source, which takes a second.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_BASEDIR=${CMAKE_CURRENT_SOURCE_DIR}
                                  CCACHE_NOHASHDIR=1 CCACHE_INODECACHE=1
                                  CCACHE_SLOPPINESS=pch_defines,time_macros ${CCACHE_PROGRAM})
endif()

set(BOXPLUS_WARNINGS -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor)
if(BOXPLUS_WARNINGS_ARE_ERRORS)
  list(APPEND BOXPLUS_WARNINGS -Werror)
endif()
add_library(boxplus_warnings INTERFACE)
target_compile_options(boxplus_warnings INTERFACE ${BOXPLUS_WARNINGS})
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # GCC 12 reports false positives of these warnings deep inside Eigen, <string> and <vector>.
  target_compile_options(boxplus_warnings INTERFACE -Wno-array-bounds -Wno-maybe-uninitialized -Wno-restrict -Wno-stringop-overflow)
endif()

set(BOXPLUS_SANITIZE "" CACHE STRING "address, undefined, thread, or 'address,undefined'")
if(BOXPLUS_SANITIZE)
  add_compile_options(-fsanitize=${BOXPLUS_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${BOXPLUS_SANITIZE})
endif()
