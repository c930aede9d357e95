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

# Read once rather than by each file: half the time of a build would go into them.
set(PACKSTONE_COMMON_HEADERS <Eigen/Core> <Eigen/Geometry> <algorithm> <functional> <map> <optional> <string> <vector>
    <fmt/format.h>)

# packstone_library(NAME SOURCES... ) makes the target packstone_NAME with the alias packstone::NAME and the settings
# that all parts share. Headers are included as "NAME/header.hpp", from the source tree and from an installation alike.
function(packstone_compile_settings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow)
  # GCC 12 reports these on every "text" + std::string (GCC bugs 105651 and 105329).
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    target_compile_options(${target} PRIVATE -Wno-restrict -Wno-stringop-overflow -Wno-stringop-overread
                                             -Wno-array-bounds)
  endif()
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

# packstone_headers(TARGET HEADERS...) makes a target that precompiles the headers, for others to take by
# packstone_take_headers. The compiler takes them only where its options are the same, so they are made so here.
function(packstone_headers target)
  add_library(${target} OBJECT ${PROJECT_SOURCE_DIR}/cmake/precompiled.cpp)
  packstone_headers_settings(${target})
  target_precompile_headers(${target} PRIVATE ${ARGN})
endfunction()

function(packstone_headers_settings target)
  packstone_compile_settings(${target})
  target_compile_options(${target} PRIVATE -fPIC)  # for programs, too, to which CMake would give -fPIE
  target_link_libraries(${target} PRIVATE Eigen3::Eigen OpenMP::OpenMP_CXX fmt::fmt)
endfunction()

function(packstone_take_headers target from)
  packstone_headers_settings(${target})
  target_precompile_headers(${target} REUSE_FROM ${from})
endfunction()

function(packstone_library name)
  add_library(packstone_${name} STATIC ${ARGN})
  add_library(packstone::${name} ALIAS packstone_${name})
  set_target_properties(packstone_${name} PROPERTIES EXPORT_NAME ${name})
  target_compile_features(packstone_${name} PUBLIC cxx_std_20)
  target_include_directories(packstone_${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/packstone>)
  packstone_take_headers(packstone_${name} packstone_headers)
  set_property(GLOBAL APPEND PROPERTY PACKSTONE_LIBRARIES packstone_${name})
endfunction()
