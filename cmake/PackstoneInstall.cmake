# find_package(packstone) for other projects: targets packstone::core, ::engine, ::analysis, ::viz.
include(CMakePackageConfigHelpers)

get_property(libraries GLOBAL PROPERTY PACKSTONE_LIBRARIES)
install(TARGETS ${libraries} EXPORT packstone-targets)
install(TARGETS packstone)
if(TARGET packstone-pictures)
  install(TARGETS packstone-pictures)
endif()
foreach(library IN LISTS libraries)
  string(REPLACE "packstone_" "" folder ${library})
  install(DIRECTORY ${folder}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/packstone/${folder} FILES_MATCHING PATTERN "*.hpp")
endforeach()
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/packstone)
install(EXPORT packstone-targets NAMESPACE packstone:: DESTINATION ${package_dir})
configure_package_config_file(cmake/packstone-config.cmake.in packstone-config.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(packstone-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/packstone-config.cmake ${CMAKE_BINARY_DIR}/packstone-config-version.cmake
              ${PROJECT_SOURCE_DIR}/cmake/FindVoro.cmake
        DESTINATION ${package_dir})
