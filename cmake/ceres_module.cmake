# libbondstatic_ceres.so: least squares by Ceres, loaded when something is calibrated (src/calibration/ceres_module.hpp).
# It carries its own position-independent copies of the functions it shares with the library, hidden, so that it
# serves programs of any build of the library and clashes with none.
file(GLOB ceres_sources CONFIGURE_DEPENDS src/calibration/ceres/*.cpp)
add_library(bondstatic_ceres MODULE ${ceres_sources} src/calibration/loss.cpp)
target_include_directories(bondstatic_ceres PRIVATE include)
target_link_libraries(bondstatic_ceres PRIVATE bondstatic_flags Eigen3::Eigen Ceres::ceres Boost::headers)
set_target_properties(bondstatic_ceres PROPERTIES CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON
                      LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})
install(TARGETS bondstatic_ceres LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/bondstatic)
