# SPDX-License-Identifier: GPL-3.0-or-later
# tan_plugin_module(NAME CLASS SOURCES...): a plugin; CLASS is the one that Q_PLUGIN_METADATA stands in. TAN_BUILD_TAG is the
# tag of the program that is to load it. Used by the build of TAn and, installed, by plugins outside of it.
function(tan_plugin_module name class)
    qt_add_plugin(${name} CLASS_NAME ${class})
    target_sources(${name} PRIVATE ${ARGN})
    target_link_libraries(${name} PRIVATE TAn::plugin Qt6::Core)
    set_target_properties(${name} PROPERTIES AUTOMOC ON AUTOMOC_MOC_OPTIONS "-Mbuild=${TAN_BUILD_TAG}")
endfunction()
