# Finds the AMD and CAMD orderings of SuiteSparse, and defines the targets AMD::AMD and AMD::CAMD. This file
# is installed in the same folder as boxplusConfig.cmake.
find_path(AMD_INCLUDE_DIR NAMES amd.h PATH_SUFFIXES suitesparse)
find_path(CAMD_INCLUDE_DIR NAMES camd.h PATH_SUFFIXES suitesparse)
find_library(AMD_LIBRARY amd)
find_library(CAMD_LIBRARY camd)
mark_as_advanced(AMD_INCLUDE_DIR CAMD_INCLUDE_DIR AMD_LIBRARY CAMD_LIBRARY)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(AMD REQUIRED_VARS AMD_LIBRARY AMD_INCLUDE_DIR CAMD_LIBRARY CAMD_INCLUDE_DIR)

foreach(name AMD CAMD)
  if(AMD_FOUND AND NOT TARGET AMD::${name})
    add_library(AMD::${name} UNKNOWN IMPORTED)
    set_target_properties(AMD::${name} PROPERTIES IMPORTED_LOCATION ${${name}_LIBRARY}
                                                  INTERFACE_INCLUDE_DIRECTORIES ${${name}_INCLUDE_DIR})
  endif()
endforeach()
