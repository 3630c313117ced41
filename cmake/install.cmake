# cmake --install: the program, the library, its headers, and what find_package(bondstatic) reads.
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/bondstatic)

install(TARGETS bondstatic EXPORT bondstaticTargets FILE_SET HEADERS)
install(TARGETS bondstatic_app)
install(EXPORT bondstaticTargets NAMESPACE bondstatic:: DESTINATION ${package_dir})

configure_package_config_file(cmake/bondstaticConfig.cmake.in ${PROJECT_BINARY_DIR}/bondstaticConfig.cmake
                              INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/bondstaticConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/bondstaticConfig.cmake ${PROJECT_BINARY_DIR}/bondstaticConfigVersion.cmake
        DESTINATION ${package_dir})
install(FILES cmake/FindCHOLMOD.cmake cmake/FindQD.cmake DESTINATION ${package_dir})
install(FILES LICENSE README.md CITATION.cff DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES src/formats/exporters/README.md src/formats/exporters/yade.py src/formats/exporters/pfc.py
              src/formats/exporters/pfc.fis src/formats/exporters/liggghts.in
        DESTINATION ${CMAKE_INSTALL_DATADIR}/bondstatic/exporters)
