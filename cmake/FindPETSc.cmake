# PETSc with the MPI it was built with, as target PETSc::PETSc. Its pkg-config file lacks MPI's include path.
find_package(PkgConfig QUIET)
find_package(MPI QUIET COMPONENTS CXX)
if(PKG_CONFIG_FOUND AND MPI_CXX_FOUND)
  pkg_check_modules(PETSC QUIET IMPORTED_TARGET PETSc)
endif()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(PETSc REQUIRED_VARS PETSC_LINK_LIBRARIES VERSION_VAR PETSC_VERSION
                                  REASON_FAILURE_MESSAGE "on Debian: apt install petsc-dev")
if(PETSc_FOUND AND NOT TARGET PETSc::PETSc)
  add_library(PETSc::PETSc INTERFACE IMPORTED)
  target_link_libraries(PETSc::PETSc INTERFACE PkgConfig::PETSC MPI::MPI_CXX)
endif()
