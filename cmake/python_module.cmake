# The Python package: PYTHONPATH=BUILD/python imports it from the build folder, cmake --install puts it beside the
# library. Debian's interpreter before others on the PATH: it has numpy and scipy.
if(NOT DEFINED Python_EXECUTABLE AND EXISTS /usr/bin/python3)
  set(Python_EXECUTABLE /usr/bin/python3)
endif()
set(PYBIND11_FINDPYTHON ON)
if(BONDSTATIC_PYTHON STREQUAL "AUTO" AND CMAKE_CXX_FLAGS MATCHES "-fsanitize=")
  message(STATUS "Building without the Python module: a sanitizer's runtime would have to be there before Python")
  return()
elseif(BONDSTATIC_PYTHON STREQUAL "AUTO")
  find_package(Python 3.9 COMPONENTS Interpreter Development.Module)
  find_package(pybind11 2.10)
else()
  find_package(Python 3.9 REQUIRED COMPONENTS Interpreter Development.Module)
  find_package(pybind11 2.10 REQUIRED)
endif()
if(NOT Python_FOUND OR NOT pybind11_FOUND)
  message(STATUS "Building without the Python module: Debian's pybind11-dev and python3-dev are not there")
  return()
endif()

# Nobody replaces functions of the library at run time, so that it is as fast as without.
set_target_properties(bondstatic PROPERTIES POSITION_INDEPENDENT_CODE ON)
target_compile_options(bondstatic PRIVATE -fno-semantic-interposition)

file(GLOB python_sources CONFIGURE_DEPENDS src/python/*.cpp)
pybind11_add_module(bondstatic_python MODULE NO_EXTRAS ${python_sources})
target_precompile_headers(bondstatic_python PRIVATE ${precompiled} <pybind11/pybind11.h> <pybind11/numpy.h>)
target_link_libraries(bondstatic_python PRIVATE bondstatic bondstatic_flags fmt::fmt OpenMP::OpenMP_CXX)
set(python_package ${PROJECT_BINARY_DIR}/python/bondstatic)
set_target_properties(bondstatic_python PROPERTIES OUTPUT_NAME _core LIBRARY_OUTPUT_DIRECTORY ${python_package})

# Links, so that a changed file needs no build.
file(GLOB python_files CONFIGURE_DEPENDS src/python/bondstatic/*.py src/python/bondstatic/*.pyi
     src/python/bondstatic/py.typed)
file(MAKE_DIRECTORY ${python_package})
foreach(file IN LISTS python_files)
  cmake_path(GET file FILENAME name)
  file(CREATE_LINK ${file} ${python_package}/${name} SYMBOLIC)
endforeach()

# Debian's interpreters look for what is not Debian's in dist-packages.
execute_process(COMMAND ${Python_EXECUTABLE} -c "import sysconfig
print('dist' if 'deb_system' in sysconfig.get_scheme_names() else 'site', end='')"
                OUTPUT_VARIABLE python_packages_kind COMMAND_ERROR_IS_FATAL ANY)
set(BONDSTATIC_PYTHON_DIR lib/python${Python_VERSION_MAJOR}.${Python_VERSION_MINOR}/${python_packages_kind}-packages
    CACHE STRING "Where the Python package is installed, below the prefix")
cmake_path(SET python_folder NORMALIZE "/${BONDSTATIC_PYTHON_DIR}/bondstatic")
file(RELATIVE_PATH python_to_lib ${python_folder} /${CMAKE_INSTALL_LIBDIR})
set_target_properties(bondstatic_python PROPERTIES INSTALL_RPATH "$ORIGIN/${python_to_lib}")
# Modules that are loaded on demand lie in the package, too: so it works wherever it is put.
add_custom_target(python_package)
foreach(module IN ITEMS bondstatic_python bondstatic_ceres bondstatic_petsc)
  if(TARGET ${module})
    add_dependencies(python_package ${module})
    install(TARGETS ${module} LIBRARY DESTINATION ${BONDSTATIC_PYTHON_DIR}/bondstatic COMPONENT python)
  endif()
endforeach()
install(FILES ${python_files} DESTINATION ${BONDSTATIC_PYTHON_DIR}/bondstatic COMPONENT python)
