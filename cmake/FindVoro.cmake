# voro++ (BSD licence) ships no package file: makes the target voro::voro.
find_path(VORO_INCLUDE_DIR voro++/voro++.hh)
find_library(VORO_LIBRARY voro++)
mark_as_advanced(VORO_INCLUDE_DIR VORO_LIBRARY)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Voro
  REQUIRED_VARS VORO_LIBRARY VORO_INCLUDE_DIR
  REASON_FAILURE_MESSAGE "On Debian: apt install voro++-dev")

if(Voro_FOUND AND NOT TARGET voro::voro)
  add_library(voro::voro UNKNOWN IMPORTED)
  set_target_properties(voro::voro PROPERTIES
    IMPORTED_LOCATION ${VORO_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES ${VORO_INCLUDE_DIR})
endif()
