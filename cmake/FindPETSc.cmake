# Finds PETSc with real numbers in double and MPI, and defines the target PETSc::PETSc. Only the plug-in plugins/petsc
# links it.
find_path(PETSC_INCLUDE_DIR petscksp.h PATHS /usr/lib/petsc /usr/lib/petscdir/petsc-real ENV PETSC_DIR PATH_SUFFIXES include)
find_library(PETSC_LIBRARY NAMES petsc_real petsc PATHS /usr/lib/petsc /usr/lib/petscdir/petsc-real ENV PETSC_DIR
             PATH_SUFFIXES lib)
mark_as_advanced(PETSC_INCLUDE_DIR PETSC_LIBRARY)
find_package(MPI QUIET COMPONENTS CXX)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(PETSc REQUIRED_VARS PETSC_LIBRARY PETSC_INCLUDE_DIR MPI_CXX_FOUND)

if(PETSc_FOUND AND NOT TARGET PETSc::PETSc)
  add_library(PETSc::PETSc UNKNOWN IMPORTED)
  set_target_properties(
    PETSc::PETSc
    PROPERTIES IMPORTED_LOCATION ${PETSC_LIBRARY}
               INTERFACE_INCLUDE_DIRECTORIES ${PETSC_INCLUDE_DIR}
               # The C++ bindings of MPI are deprecated, and their headers do not compile without warnings.
               INTERFACE_COMPILE_DEFINITIONS "OMPI_SKIP_MPICXX;MPICH_SKIP_MPICXX"
               INTERFACE_LINK_LIBRARIES MPI::MPI_CXX)
endif()
