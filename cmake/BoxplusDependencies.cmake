# The dependencies of the library. If projects that link boxplus need a dependency, too,
# boxplusConfig.cmake.in also lists it.
find_package(Eigen3 3.4 REQUIRED)
find_package(Threads REQUIRED)
find_package(AMD REQUIRED)
find_package(fmt REQUIRED)
find_package(FastFloat REQUIRED)
find_package(ZLIB REQUIRED)
