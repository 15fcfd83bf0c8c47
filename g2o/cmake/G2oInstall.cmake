# The files that `cmake --install` installs, and the package that find_package(g2o) finds.
include(CMakePackageConfigHelpers)
set(g2o_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/g2o)
get_property(G2O_LIBRARY_NAMES GLOBAL PROPERTY G2O_LIBRARY_NAMES)
get_property(G2O_SUITESPARSE_NAMES GLOBAL PROPERTY G2O_SUITESPARSE_NAMES)
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME g2o_development) # see BoxplusPackages.cmake
set(G2O_IS_SHARED_BUILD ${BUILD_SHARED_LIBS})

# g2oTargets.cmake has the shared libraries. A static build also installs the static libraries, with
# g2oStaticTargets.cmake.
install(TARGETS g2o_headers EXPORT g2o)
install(TARGETS g2o_headers EXPORT g2o_static)
foreach(name IN LISTS G2O_LIBRARY_NAMES)
  if(TARGET g2o_${name}_shared)
    install(TARGETS g2o_${name}_shared EXPORT g2o LIBRARY COMPONENT g2o NAMELINK_COMPONENT g2o_development)
    install(TARGETS g2o_${name} EXPORT g2o_static)
  else()
    install(TARGETS g2o_${name} EXPORT g2o LIBRARY COMPONENT g2o NAMELINK_COMPONENT g2o_development)
  endif()
endforeach()
install(DIRECTORY include/g2o DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT g2o FILE g2oTargets.cmake NAMESPACE g2o:: DESTINATION ${g2o_package_dir})
if(NOT BUILD_SHARED_LIBS)
  install(EXPORT g2o_static FILE g2oStaticTargets.cmake NAMESPACE g2o:: DESTINATION ${g2o_package_dir})
endif()
configure_package_config_file(cmake/g2oConfig.cmake.in g2oConfig.cmake INSTALL_DESTINATION ${g2o_package_dir}
                              PATH_VARS CMAKE_INSTALL_INCLUDEDIR)
# The version of the package is the version of the g2o API, because clients request that version.
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/g2oConfigVersion.cmake VERSION 1.0.0
                                 COMPATIBILITY AnyNewerVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/g2oConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/g2oConfigVersion.cmake
        DESTINATION ${g2o_package_dir})
if(G2O_SUITESPARSE_NAMES)
  install(FILES ${PROJECT_SOURCE_DIR}/cmake/FindCHOLMOD.cmake ${PROJECT_SOURCE_DIR}/cmake/FindCXSparse.cmake
          DESTINATION ${g2o_package_dir})
endif()
