# The Debian packages that `make packages` makes with CPack. Each package has the files of one component of the install rules.
set(CPACK_GENERATOR DEB)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_PACKAGE_CONTACT "The authors of boxplus")
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
if(CMAKE_CROSSCOMPILING AND CMAKE_SYSTEM_PROCESSOR STREQUAL "aarch64")
  set(CPACK_DEBIAN_PACKAGE_ARCHITECTURE arm64) # by default, that of this machine
endif()
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR}/g2o/shared ${PROJECT_BINARY_DIR}/src)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_COMPONENTS_ALL)

# boxplus_package(COMPONENT NAME SECTION [DEPENDS PACKAGE...] SUMMARY [LINE...])
function(boxplus_package component name section)
  cmake_parse_arguments(PARSE_ARGV 3 arg "" "" "DEPENDS;SUMMARY")
  string(TOUPPER ${component} key)
  list(POP_FRONT arg_SUMMARY summary)
  list(JOIN arg_SUMMARY " " text)
  list(JOIN arg_DEPENDS ", " depends)
  set(CPACK_DEBIAN_${key}_PACKAGE_NAME ${name} PARENT_SCOPE)
  set(CPACK_DEBIAN_${key}_PACKAGE_SECTION ${section} PARENT_SCOPE)
  set(CPACK_DEBIAN_${key}_PACKAGE_DEPENDS "${depends}" PARENT_SCOPE)
  set(CPACK_DEBIAN_${key}_DESCRIPTION "${summary}\n${text}" PARENT_SCOPE)
  set(CPACK_COMPONENTS_ALL ${CPACK_COMPONENTS_ALL} ${component} PARENT_SCOPE)
  # Only in packages: the license, where Debian's users look for it.
  install(FILES ${PROJECT_SOURCE_DIR}/LICENSE RENAME copyright DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${name}
          COMPONENT ${component} EXCLUDE_FROM_ALL)
endfunction()

if(BUILD_SHARED_LIBS)
  set(library_package libboxplus${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  boxplus_package(library ${library_package} libs SUMMARY "nonlinear least squares on graphs (library)"
                  "The shared library of programs that use boxplus.")
  set(library_needs "${library_package} (= ${PROJECT_VERSION})")
endif()
boxplus_package(
  development libboxplus-dev libdevel DEPENDS libeigen3-dev libfmt-dev libsuitesparse-dev libcpp-httplib-dev ${library_needs}
  SUMMARY "nonlinear least squares on graphs (library and headers)"
  "A C++20 framework for SLAM, bundle adjustment and calibration: the library boxplus with its headers, the library"
  "of the viewer, the CMake package, documents and examples.")
if(TARGET boxplus_command)
  boxplus_package(command boxplus science DEPENDS fonts-liberation2 SUMMARY "optimizes graphs of SLAM and bundle adjustment (command)"
                  "Reads .g2o, TORO, BAL and COLMAP, optimizes, compares, simulates, plots and shows graphs in a browser.")
endif()
if(TARGET boxplus_python AND BOXPLUS_PYTHON_PROGRAM STREQUAL "/usr/bin/python3")
  boxplus_package(python python3-boxplus python DEPENDS "python3 (>= 3.11)" "python3 (<< 3.12)" python3-numpy
                  SUMMARY "nonlinear least squares on graphs (Python)" "The Python module boxplus.")
  boxplus_package(python_g2o python3-g2o-boxplus python DEPENDS "python3-boxplus (= ${PROJECT_VERSION})"
                  SUMMARY "the names of g2o's Python bindings on boxplus"
                  "The Python package g2o. It replaces other Python packages of this name.")
  foreach(field PROVIDES CONFLICTS REPLACES)
    set(CPACK_DEBIAN_PYTHON_G2O_PACKAGE_${field} python3-g2o)
  endforeach()
endif()
if(BOXPLUS_BUILD_G2O)
  boxplus_package(g2o libg2o-boxplus libs SUMMARY "the API of g2o on boxplus (libraries and programs)"
                  "Libraries with the names and classes of g2o, and its programs: g2o, g2o_viewer,"
                  "g2o_hierarchical, g2o_incremental, g2o_online, g2o_simulator2d, g2o_simulator3d and create_sphere."
                  "They replace g2o.")
  boxplus_package(g2o_development libg2o-boxplus-dev libdevel
                  DEPENDS "libg2o-boxplus (= ${PROJECT_VERSION})" libeigen3-dev libfmt-dev libsuitesparse-dev
                  SUMMARY "the API of g2o on boxplus (headers)"
                  "Headers, static libraries and the CMake package g2o. They replace the development files of g2o.")
  # The names of the packages of g2o that are replaced; a program finds the same files in ours.
  foreach(component G2O G2O_DEVELOPMENT)
    set(names libg2o)
    if(component STREQUAL "G2O_DEVELOPMENT")
      set(names libg2o-dev)
    endif()
    foreach(field PROVIDES CONFLICTS REPLACES)
      set(CPACK_DEBIAN_${component}_PACKAGE_${field} ${names})
    endforeach()
  endforeach()
endif()
include(CPack)
