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

# tan_plugin_module(NAME CLASS SOURCES...): a plugin; CLASS is the one that Q_PLUGIN_METADATA stands in.
function(tan_plugin_module name class)
    tan_build_tag(tag)
    qt_add_plugin(${name} CLASS_NAME ${class})
    target_sources(${name} PRIVATE ${ARGN})
    target_link_libraries(${name} PRIVATE TAn::plugin Qt6::Core)
    # Where no build type is chosen, compilers would not optimise, and pictures take several times as long.
    target_compile_options(${name} PRIVATE $<$<CONFIG:>:-O2>)
    set_target_properties(${name} PROPERTIES AUTOMOC ON AUTOMOC_MOC_OPTIONS "-Mbuild=${tag}")
endfunction()
