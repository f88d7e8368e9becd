# SPDX-License-Identifier: GPL-3.0-or-later
# Used by the build of TAn and, installed, by plugins outside of it. TAn_VERSION is that of the headers.
include(CheckCXXSourceCompiles)

# tan_build_tag(VARIABLE): what a plugin and the program must share to be loadable, since objects of the C++ library and of TAn pass
# between them: the system, the size of pointers, the compiler, the C++ library, and before 1.0 TAn's version.
function(tan_build_tag variable)
    string(REGEX MATCH "^[0-9]+" compiler "${CMAKE_CXX_COMPILER_VERSION}")
    math(EXPR bits "8 * ${CMAKE_SIZEOF_VOID_P}")
    check_cxx_source_compiles("#include <string>\n#ifndef _LIBCPP_VERSION\n#error\n#endif\nint main() {}" TAN_HAS_LIBCXX)
    check_cxx_source_compiles("#include <string>\n#if !_GLIBCXX_USE_CXX11_ABI\n#error\n#endif\nint main() {}" TAN_HAS_LIBSTDCXX)
    if(TAN_HAS_LIBCXX)
        set(library libc++)
    elseif(TAN_HAS_LIBSTDCXX)
        set(library libstdc++)
    else()
        set(library other-c++-library)
    endif()
    set(tag "${CMAKE_SYSTEM_NAME}-${CMAKE_SYSTEM_PROCESSOR}-${bits}/${CMAKE_CXX_COMPILER_ID}-${compiler}/${library}")
    if(TAn_VERSION VERSION_LESS 1.0)
        string(APPEND tag "/tan-${TAn_VERSION}")
    endif()
    if(TAN_SANITIZE)
        string(REPLACE "," "+" sanitizers "${TAN_SANITIZE}")
        string(APPEND tag "/${sanitizers}")
    endif()
    string(TOLOWER "${tag}" tag)
    set(${variable} ${tag} PARENT_SCOPE)
endfunction()

# tan_plugin_module(NAME METADATA SOURCES...): a plugin. METADATA is the JSON file of what it says of itself (plugins/api/metadata.h); one
# of the sources has the line TAN_PLUGIN(CLASS, INTERFACE) (plugins/api/plugin.h). An editor is linked with Qt by its author.
function(tan_plugin_module name metadata)
    cmake_path(ABSOLUTE_PATH metadata OUTPUT_VARIABLE file)
    if(NOT metadata MATCHES "\\.json$" OR NOT EXISTS "${file}")
        message(FATAL_ERROR "tan_plugin_module(${name}): '${metadata}' is not the plugin's JSON file, which stands before its sources.")
    endif()
    file(READ "${file}" text)
    string(JSON members ERROR_VARIABLE mistake LENGTH "${text}")
    if(mistake)
        message(FATAL_ERROR "${file}: ${mistake}")
    endif()
    tan_build_tag(tag)
    # Kept as it is where nothing has changed, so that nothing is compiled again.
    set(folder ${CMAKE_CURRENT_BINARY_DIR}/${name}_metadata)
    file(CONFIGURE OUTPUT "${folder}/tan_plugin_metadata.h" @ONLY CONTENT [[
// Made of @file@ by tan_plugin_module().
#pragma once

#include <string_view>

namespace tetra {
constexpr std::string_view pluginBuild = "@tag@";
constexpr std::string_view pluginMetadata = R"metadata(@text@)metadata";
} // namespace tetra
]])
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${file}")
    add_library(${name} MODULE ${ARGN})
    target_include_directories(${name} PRIVATE ${folder})
    target_link_libraries(${name} PRIVATE TAn::plugin)
    # Where no build type is chosen, compilers would not optimise, and pictures take several times as long.
    target_compile_options(${name} PRIVATE $<$<CONFIG:>:-O2>)
endfunction()
