# QD (double-double arithmetic), as target QD::QD; it brings neither a CMake package nor usable pkg-config flags.
find_path(QD_INCLUDE_DIR qd/dd_real.h)
find_library(QD_LIBRARY qd)
mark_as_advanced(QD_INCLUDE_DIR QD_LIBRARY)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(QD REQUIRED_VARS QD_LIBRARY QD_INCLUDE_DIR
                                  REASON_FAILURE_MESSAGE "on Debian: apt install libqd-dev")
if(QD_FOUND AND NOT TARGET QD::QD)
  add_library(QD::QD UNKNOWN IMPORTED)
  set_target_properties(QD::QD PROPERTIES IMPORTED_LOCATION "${QD_LIBRARY}"
                        INTERFACE_INCLUDE_DIRECTORIES "${QD_INCLUDE_DIR}")
endif()
