include(CheckCXXCompilerFlag)

# GCC copies structs of 512-bit registers by halves, and the loads of whole ones that follow wait for both. For the loops
# over particles; everywhere it would bring false warnings of GCC's about strings.
set(PACKSTONE_WHOLE_COPIES "")
if(PACKSTONE_NATIVE)
  check_cxx_compiler_flag(-mmove-max=512 PACKSTONE_CAN_COPY_WHOLE_REGISTERS)
  if(PACKSTONE_CAN_COPY_WHOLE_REGISTERS)
    set(PACKSTONE_WHOLE_COPIES -mmove-max=512 -mstore-max=512)
  endif()
endif()

# Read once a target rather than by each file: half the time of a build goes into them.
set(PACKSTONE_COMMON_HEADERS <Eigen/Core> <Eigen/Geometry> <algorithm> <functional> <map> <optional> <string> <vector>
    <fmt/format.h>)

# packstone_library(NAME SOURCES... ) makes the target packstone_NAME with the alias packstone::NAME and the settings
# that all parts share. Headers are included as "NAME/header.hpp", from the source tree and from an installation alike.
function(packstone_compile_settings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow)
  # GCC 12 reports -Wrestrict on correct std::string code (GCC bug 105651).
  target_compile_options(${target} PRIVATE -Wno-restrict)
  if(PACKSTONE_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
  if(PACKSTONE_NATIVE)
    target_compile_options(${target} PRIVATE -march=native)
  endif()
  # Same bits from every inlined copy of a formula: a multiply and an add are fused nowhere.
  target_compile_options(${target} PRIVATE -ffp-contract=off)
  # sqrt and the like as instructions: nobody asks for errno or floating-point traps. No result changes.
  target_compile_options(${target} PRIVATE -fno-math-errno -fno-trapping-math)
endfunction()

function(packstone_library name)
  add_library(packstone_${name} STATIC ${ARGN})
  add_library(packstone::${name} ALIAS packstone_${name})
  set_target_properties(packstone_${name} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON)
  target_compile_features(packstone_${name} PUBLIC cxx_std_20)
  target_include_directories(packstone_${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/packstone>)
  packstone_compile_settings(packstone_${name})
  target_precompile_headers(packstone_${name} PRIVATE ${PACKSTONE_COMMON_HEADERS})
  set_property(GLOBAL APPEND PROPERTY PACKSTONE_LIBRARIES packstone_${name})
endfunction()
