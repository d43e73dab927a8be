# How Trellis compiles: one set of flags for every target, one function for every layer.
# SPDX-License-Identifier: MIT

# C++20 without extensions, every warning. Floating-point contraction is off for whoever links a
# layer too: a leaf compiled with fused multiply-add would leave the recorded traces.
function(trellis_compile target)
    target_compile_features(${target} PUBLIC cxx_std_20)
    set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
    target_compile_options(${target}
        PUBLIC -ffp-contract=off
        PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion
                $<$<BOOL:${TRELLIS_WARNINGS_AS_ERRORS}>:-Werror>)
endfunction()

# trellis_layer(core FOLDER core BASE . [PUBLIC target...] [PRIVATE target...])
#
# The static library trellis_core, alias trellis::core, of every source in FOLDER. Its headers are
# included by their path from BASE: "core/ids.h" here, <trellis/core/ids.h> once installed. The
# target all_verify_interface_header_sets compiles each header alone.
function(trellis_layer name)
    cmake_parse_arguments(PARSE_ARGV 1 layer "" "FOLDER;BASE" "PUBLIC;PRIVATE")
    set(target trellis_${name})
    file(GLOB sources CONFIGURE_DEPENDS ${layer_FOLDER}/*.cpp)
    file(GLOB headers CONFIGURE_DEPENDS ${layer_FOLDER}/*.h)
    file(GLOB tables CONFIGURE_DEPENDS ${layer_FOLDER}/*.def)
    add_library(${target} STATIC ${sources} CMakeLists.txt)
    add_library(trellis::${name} ALIAS ${target})
    trellis_compile(${target})
    target_sources(${target} PUBLIC
        FILE_SET HEADERS BASE_DIRS ${layer_BASE} FILES ${headers}
        FILE_SET tables TYPE HEADERS BASE_DIRS ${layer_BASE} FILES ${tables})
    set_target_properties(${target} PROPERTIES
        EXPORT_NAME ${name}
        LINKER_LANGUAGE CXX  # said here, because a layer may be headers only
        INTERFACE_HEADER_SETS_TO_VERIFY HEADERS)
    # installed headers include each other by the same paths
    target_include_directories(${target} INTERFACE
        $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
    target_link_libraries(${target} PUBLIC ${layer_PUBLIC} PRIVATE ${layer_PRIVATE})

    install(TARGETS ${target} EXPORT trellis
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
        FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/trellis
        FILE_SET tables DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/trellis)
endfunction()
