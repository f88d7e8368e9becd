# SPDX-License-Identifier: GPL-3.0-or-later
# Run by the installation of the component "bundle", after the programs and the VTK readers: puts Qt, VTK and all that they need
# beside them, with their licences. TAN_INSTALL_LIBDIR is the folder of the libraries below the prefix. Left to the machine is what must fit its kernel, its driver or its fonts, and what those use.
cmake_policy(VERSION 3.25)
set(prefix "$ENV{DESTDIR}${CMAKE_INSTALL_PREFIX}")
cmake_path(GET TAN_INSTALL_LIBDIR PARENT_PATH library_folder)
set(libraries "${prefix}/${TAN_INSTALL_LIBDIR}")
set(of_the_machine
    "^ld-linux" "^lib(c|m|dl|rt|pthread|resolv|util|anl)\\.so" "^libstdc\\+\\+" "^libgcc_s"
    "^lib(GL|EGL|GLX|OpenGL|GLdispatch|drm|gbm)\\.so" "^libwayland-" "^libX(11|11-xcb|ext|au|dmcp)\\.so" "^libxcb\\.so"
    "^lib(bsd|md)\\.so" "^lib(fontconfig|freetype|expat|png16|z|bz2|brotlidec|brotlicommon)\\.so")

execute_process(COMMAND qtpaths6 --query QT_INSTALL_PLUGINS OUTPUT_VARIABLE qt_plugins OUTPUT_STRIP_TRAILING_WHITESPACE
    COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND qtpaths6 --query QT_INSTALL_TRANSLATIONS OUTPUT_VARIABLE qt_translations
    OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
set(wanted platforms/libqxcb.so platforms/libqoffscreen.so platforms/libqminimal.so platforms/libqwayland-*.so
    wayland-shell-integration/*.so wayland-graphics-integration-client/*.so wayland-decoration-client/*.so
    xcbglintegrations/*.so platforminputcontexts/*.so)
set(plugins "")
foreach(pattern IN LISTS wanted)
    file(GLOB found RELATIVE "${qt_plugins}" "${qt_plugins}/${pattern}")
    list(APPEND plugins ${found})
endforeach()
set(plugin_files "")
foreach(plugin IN LISTS plugins)
    get_filename_component(folder "${plugin}" DIRECTORY)
    file(INSTALL "${qt_plugins}/${plugin}" DESTINATION "${libraries}/qt/${folder}" FOLLOW_SYMLINK_CHAIN)
    list(APPEND plugin_files "${qt_plugins}/${plugin}")
endforeach()
file(GLOB translations "${qt_translations}/qtbase_*.qm")
file(INSTALL ${translations} DESTINATION "${prefix}/share/tan/qt-translations")
file(WRITE "${prefix}/bin/qt.conf"
    "[Paths]\nPrefix = ..\nPlugins = ${TAN_INSTALL_LIBDIR}/qt\nTranslations = share/tan/qt-translations\n")

file(GLOB ours "${prefix}/${library_folder}/libtan-*.so.*" "${libraries}/libtan-*.so.*" "${libraries}/plugins/*.so")
file(GET_RUNTIME_DEPENDENCIES RESOLVED_DEPENDENCIES_VAR found UNRESOLVED_DEPENDENCIES_VAR missing
    EXECUTABLES "${prefix}/bin/tan" "${prefix}/bin/tan-desktop" "${libraries}/plugins/tan-read-vtk"
        "${libraries}/plugins/tan-read-images"
        "${libraries}/plugins/tan-read-netcdf"
        "${libraries}/plugins/tan-read-hdf5"
        "${libraries}/plugins/tan-read-zarr"
    LIBRARIES ${ours} ${plugin_files} PRE_EXCLUDE_REGEXES ${of_the_machine})
if(missing)
    message(FATAL_ERROR "The bundle lacks ${missing}")
endif()
set(licences "${prefix}/share/doc/tan/bundled")
foreach(library IN LISTS found plugin_files)
    cmake_path(IS_PREFIX prefix "${library}" NORMALIZE ours)
    if(ours)
        continue()
    endif()
    if(NOT library IN_LIST plugin_files)
        file(INSTALL "${library}" DESTINATION "${libraries}" FOLLOW_SYMLINK_CHAIN)
        # A run path of its own (of Open MPI, for one) would hide that of the program.
        get_filename_component(name "${library}" NAME)
        file(REAL_PATH "${libraries}/${name}" copy)
        file(CHMOD "${copy}" PERMISSIONS OWNER_READ OWNER_WRITE GROUP_READ WORLD_READ)
        file(RPATH_REMOVE FILE "${copy}")
    endif()
    file(REAL_PATH "${library}" real)
    execute_process(COMMAND dpkg -S "${real}" OUTPUT_VARIABLE owner ERROR_QUIET)
    if(NOT owner)
        string(REGEX REPLACE "^/usr" "" short "${real}")
        execute_process(COMMAND dpkg -S "${short}" OUTPUT_VARIABLE owner ERROR_QUIET)
    endif()
    if(NOT owner MATCHES "^([a-z0-9.+-]+)(:[a-z0-9]+)?: ")
        message(FATAL_ERROR "The licence of ${library} is not known: no package owns it")
    endif()
    configure_file("/usr/share/doc/${CMAKE_MATCH_1}/copyright" "${licences}/${CMAKE_MATCH_1}.copyright" COPYONLY)
endforeach()
