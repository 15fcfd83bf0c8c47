# The files that `cmake --install` installs, and the package that find_package(boxplus) finds.
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/boxplus)
# The components are packages (BoxplusPackages.cmake). `cmake --install` installs all of them.
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME development)

install(TARGETS boxplus EXPORT boxplus LIBRARY COMPONENT library NAMELINK_COMPONENT development)
if(TARGET boxplus_viewer)
  install(TARGETS boxplus_viewer EXPORT boxplusViewer)
  install(EXPORT boxplusViewer FILE boxplusViewerTargets.cmake NAMESPACE boxplus:: DESTINATION ${package_dir})
endif()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/boxplus DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT boxplus FILE boxplusTargets.cmake NAMESPACE boxplus:: DESTINATION ${package_dir})

# If the library is static, programs also link its private dependencies, so boxplusConfig.cmake must find
# them.
get_target_property(type boxplus TYPE)
string(COMPARE EQUAL ${type} STATIC_LIBRARY BOXPLUS_IS_STATIC)
configure_package_config_file(cmake/boxplusConfig.cmake.in boxplusConfig.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(boxplusConfigVersion.cmake COMPATIBILITY SameMajorVersion)
install(FILES ${PROJECT_BINARY_DIR}/boxplusConfig.cmake ${PROJECT_BINARY_DIR}/boxplusConfigVersion.cmake
              cmake/FindAMD.cmake DESTINATION ${package_dir})

# With these files, the tools of ROS 2 know the package (docs/ros.md). The second is empty; its name is what counts.
file(CONFIGURE OUTPUT ament_index/boxplus CONTENT "")
install(FILES package.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/boxplus)
install(FILES ${PROJECT_BINARY_DIR}/ament_index/boxplus DESTINATION ${CMAKE_INSTALL_DATADIR}/ament_index/resource_index/packages)

install(FILES LICENSE README.md ARCHITECTURE.md CHANGELOG.md CONTRIBUTING.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY docs examples DESTINATION ${CMAKE_INSTALL_DOCDIR})
include(BoxplusPackages)
