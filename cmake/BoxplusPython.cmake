# Finds what the Python module needs: an interpreter (3.9 or later) with NumPy and the headers of Python, and pybind11.
# Several interpreters may be installed, and the first one in the PATH may lack NumPy or the headers. Therefore, each
# is asked. Sets BOXPLUS_PYTHON_MISSING to the reason if the module cannot be built, and otherwise BOXPLUS_PYTHON_PROGRAM to
# the interpreter.
find_path(PYBIND11_INCLUDE_DIR pybind11/pybind11.h)

# boxplus_ask_python(INTERPRETER RESULT): sets RESULT to the folder of the headers, the suffix of modules and the folder of
# packages below the prefix of an installation, or to a text that begins with "no" and says what is missing. An interpreter
# that the user chose needs no NumPy, because only the tests run the module.
function(boxplus_ask_python interpreter result)
  execute_process(
    COMMAND ${interpreter} -c "
import os, sys, sysconfig
folder = sysconfig.get_paths()['include']
try:
    import numpy
except ImportError:
    numpy = None
missing = ('no Python 3.9' if sys.version_info < (3, 9) else
           'no NumPy' if not numpy and '${BOXPLUS_PYTHON}' != '${interpreter}' else
           'no headers' if not os.path.exists(os.path.join(folder, 'Python.h')) else None)
packages = 'dist' if 'deb_system' in sysconfig.get_scheme_names() else 'site'
print(missing or ';'.join((folder, sysconfig.get_config_var('EXT_SUFFIX'),
      'lib/python%d.%d/%s-packages' % (*sys.version_info[:2], packages))), end='')"
    OUTPUT_VARIABLE answer ERROR_QUIET RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    set(answer "no answer")
  endif()
  set(${result} "${answer}" PARENT_SCOPE)
endfunction()

set(BOXPLUS_PYTHON "" CACHE FILEPATH "The Python interpreter for which the module is built; empty: the first suitable one")
find_program(path_python python3 NO_CACHE)
find_program(system_python python3 PATHS /usr/bin NO_DEFAULT_PATH NO_CACHE)
set(candidates ${path_python} ${system_python})
if(BOXPLUS_PYTHON)
  set(candidates ${BOXPLUS_PYTHON})
endif()
list(FILTER candidates EXCLUDE REGEX "NOTFOUND$")
set(complaints "")
foreach(interpreter IN LISTS candidates)
  boxplus_ask_python(${interpreter} answer)
  if(NOT answer MATCHES "^no ")
    list(GET answer 0 BOXPLUS_PYTHON_INCLUDE_DIR)
    list(GET answer 1 BOXPLUS_PYTHON_SUFFIX)
    list(GET answer 2 BOXPLUS_PYTHON_INSTALL_DIR)
    set(BOXPLUS_PYTHON_PROGRAM ${interpreter})
    break()
  endif()
  string(APPEND complaints " ${interpreter} has ${answer}.")
endforeach()

if(BOXPLUS_SANITIZE)
  set(BOXPLUS_PYTHON_MISSING "a sanitizer would have to be loaded before Python")
elseif(NOT PYBIND11_INCLUDE_DIR)
  set(BOXPLUS_PYTHON_MISSING "it needs pybind11-dev")
elseif(NOT BOXPLUS_PYTHON_PROGRAM)
  set(BOXPLUS_PYTHON_MISSING "it needs python3-dev and python3-numpy.${complaints}")
else()
  set(BOXPLUS_PYTHON_MISSING "")
endif()
