# libbondstatic_petsc.so: PETSc and MPI, loaded by the program when they are asked for (src/solver/petsc_module.hpp).
# It carries its own position-independent copies of the functions it shares with the library, hidden, so that it
# serves programs of any build of the library and clashes with none.
file(GLOB petsc_sources CONFIGURE_DEPENDS src/petsc/*.cpp)
add_library(bondstatic_petsc MODULE ${petsc_sources} src/bond/bond.cpp src/solver/machine.cpp
                                    src/system/block_row.cpp src/system/body_positions.cpp src/system/incidence.cpp)
target_include_directories(bondstatic_petsc PRIVATE include)
target_link_libraries(bondstatic_petsc PRIVATE bondstatic_flags Eigen3::Eigen fmt::fmt OpenMP::OpenMP_CXX PETSc::PETSc
                                               ${CMAKE_DL_LIBS})
set_target_properties(bondstatic_petsc PROPERTIES CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON
                      LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})
install(TARGETS bondstatic_petsc LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/bondstatic)
