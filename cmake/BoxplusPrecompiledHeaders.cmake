# The compiler spends most of its time on headers that many sources share. With precompiled headers, it parses
# them only once per target. Each source must still include all headers that it uses. The preset `tidy` checks
# this, because it builds without precompiled headers.
option(BOXPLUS_PRECOMPILE_HEADERS "Precompile common headers, so that each target parses them only once" ${PROJECT_IS_TOP_LEVEL})
if(NOT BOXPLUS_PRECOMPILE_HEADERS)
  set(CMAKE_DISABLE_PRECOMPILE_HEADERS ON)
elseif(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  add_compile_options($<$<COMPILE_LANGUAGE:CXX>:-fpch-preprocess>) # so that ccache sees which header was precompiled
else()
  add_compile_options("$<$<COMPILE_LANGUAGE:CXX>:SHELL:-Xclang -fno-pch-timestamp>") # so that ccache can reuse the precompiled header
endif()

set(BOXPLUS_STANDARD_HEADERS
    <algorithm> <array> <cmath> <cstdint> <functional> <limits> <map> <memory> <optional> <ranges> <span> <string>
    <string_view> <unordered_map> <utility> <vector>)
