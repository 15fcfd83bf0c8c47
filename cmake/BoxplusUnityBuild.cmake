# A unity build compiles several sources as one, so that the compiler reads their headers and instantiates their templates
# only once. After a change in one source, the whole batch is compiled again. Therefore, the presets for development build
# each source alone. They also find sources that do not include what they use, and names that hide each other.
#
# The sources of a batch share their unnamed namespaces: two of them must not define the same name there.
option(BOXPLUS_UNITY_BUILD "Compile the sources of the library in batches" ${PROJECT_IS_TOP_LEVEL})

# boxplus_unity_build(TARGET BATCH): compiles BATCH sources as one. Sources with SKIP_UNITY_BUILD_INCLUSION are compiled alone,
# and so are sources with compiler flags of their own.
function(boxplus_unity_build target batch)
  if(NOT BOXPLUS_UNITY_BUILD)
    return()
  endif()
  # A local name may be the same as a name in an unnamed namespace of another source.
  set_target_properties(
    ${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${batch}
                         UNITY_BUILD_CODE_BEFORE_INCLUDE "#pragma GCC diagnostic ignored \"-Wshadow\"")
endfunction()
