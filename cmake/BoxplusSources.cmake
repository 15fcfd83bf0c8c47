# boxplus_sources(RESULT PATTERN... [EXCEPT REGEX]): finds sources below the current folder, as paths relative to it. New
# sources are found when the project is built again. EXCEPT leaves out the paths that match.
function(boxplus_sources result)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "EXCEPT" "")
  file(GLOB_RECURSE found CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} ${arg_UNPARSED_ARGUMENTS})
  if(arg_EXCEPT)
    list(FILTER found EXCLUDE REGEX "${arg_EXCEPT}")
  endif()
  set(${result} ${found} PARENT_SCOPE)
endfunction()
