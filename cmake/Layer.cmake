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

# trellis_layer(core FOLDER core HEADERS core [PUBLIC target...] [PRIVATE target...])
#
# The static library trellis_core, alias trellis::core, of every source in FOLDER. HEADERS is the
# path by which its headers are included: "core/ids.h" here, <trellis/core/ids.h> once installed.
function(trellis_layer name)
    cmake_parse_arguments(PARSE_ARGV 1 layer "" "FOLDER;HEADERS" "PUBLIC;PRIVATE")
    set(target trellis_${name})
    file(GLOB sources CONFIGURE_DEPENDS ${layer_FOLDER}/*.cpp)
    file(GLOB headers CONFIGURE_DEPENDS ${layer_FOLDER}/*.h ${layer_FOLDER}/*.def)
    add_library(${target} STATIC ${sources} ${headers} CMakeLists.txt)
    add_library(trellis::${name} ALIAS ${target})
    set_target_properties(${target} PROPERTIES EXPORT_NAME ${name} LINKER_LANGUAGE CXX)
    trellis_compile(${target})
    target_include_directories(${target} PUBLIC
        $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/runtime>
        $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
        $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
        $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/trellis>)
    target_link_libraries(${target} PUBLIC ${layer_PUBLIC} PRIVATE ${layer_PRIVATE})

    install(TARGETS ${target} EXPORT trellis ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
    install(FILES ${headers} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/trellis/${layer_HEADERS})
endfunction()
