# SPDX-License-Identifier: GPL-3.0-or-later
# The packages, by CPack; `./dev package` builds them. What differs between them is in packages_of_a_kind.cmake.
set(CPACK_PACKAGE_NAME tan)
set(CPACK_PACKAGE_VENDOR "TAn")
set(CPACK_PACKAGE_CONTACT "${TAN_CONTACT}")
set(CPACK_PACKAGE_HOMEPAGE_URL "${TAN_HOMEPAGE}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "look at volume data at any accuracy")
set(CPACK_PACKAGE_DESCRIPTION "TAn shows scalar volume data at any accuracy that is asked for, and
tells what that accuracy is. It turns a dataset once into a multiresolution
model and takes meshes from it whose error is bounded at the samples.")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_STRIP_FILES ON)
set(CPACK_THREADS 0)
set(CPACK_PROJECT_CONFIG_FILE ${CMAKE_CURRENT_LIST_DIR}/packages_of_a_kind.cmake)
set(CPACK_COMPONENTS_ALL core program window vtk development)
if(TARGET tan-python)
    list(APPEND CPACK_COMPONENTS_ALL python)
endif()

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SOURCE tan)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${CMAKE_LIBRARY_OUTPUT_DIRECTORY})
set(same_version "tan (= ${PROJECT_VERSION})")
# The library alone, for programs on machines without Qt.
set(core_of_same_version "tan-core (= ${PROJECT_VERSION})")
set(CPACK_DEBIAN_CORE_PACKAGE_NAME tan-core)
set(CPACK_DEBIAN_CORE_PACKAGE_SECTION libs)
# The version is not seen from its symbols.
if(TAN_NETWORK)
    set(CPACK_DEBIAN_CORE_PACKAGE_DEPENDS "libcurl4 (>= 7.87)")
endif()
# Loaded at run time, so that no link says so; the library does without, but for pictures by OpenGL.
set(CPACK_DEBIAN_CORE_PACKAGE_RECOMMENDS "ca-certificates, libegl1, libgl1-mesa-dri, libopengl0")
# libtan-core lies where the system looks: installing it tells the loader, and packages of programs that use it which one has it.
file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/shlibs "libtan-core ${TAN_SOVERSION} libtan-core${TAN_SOVERSION}\n")
set(CPACK_DEBIAN_CORE_PACKAGE_PROVIDES "libtan-core${TAN_SOVERSION} (= ${PROJECT_VERSION})")
set(CPACK_DEBIAN_CORE_PACKAGE_CONTROL_EXTRA ${CMAKE_CURRENT_LIST_DIR}/debian/triggers ${CMAKE_CURRENT_BINARY_DIR}/shlibs)
set(CPACK_COMPONENT_CORE_DESCRIPTION "the library of TAn, without its programs
Builds multiresolution models of volume data, takes meshes of a known error
from them, and draws these. Needs no Qt.")
# The command line, for machines without a screen, too; and libtan-picture, which lies where the system looks and draws with its plugins.
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME tan)
file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/program/shlibs "libtan-picture ${TAN_SOVERSION} tan (= ${PROJECT_VERSION})\n")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_CONTROL_EXTRA ${CMAKE_CURRENT_LIST_DIR}/debian/triggers ${CMAKE_CURRENT_BINARY_DIR}/program/shlibs)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS "${core_of_same_version}, python3") # tan-read-meshio.py
# Until 0.1 the window was in this package: who has it keeps the window. meshio reads Gmsh, MED, XDMF ... by a script.
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "tan-desktop, python3-meshio")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "tan-vtk-readers")
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION "${CPACK_PACKAGE_DESCRIPTION}
This is the command line, which needs no screen and no Qt, and the library that
draws pictures as it does.")
set(CPACK_DEBIAN_WINDOW_PACKAGE_NAME tan-desktop)
# Qt's own words, as in the dialogs for files and colours, are in a package of their own.
set(CPACK_DEBIAN_WINDOW_PACKAGE_DEPENDS "${same_version}, libegl1, libgl1-mesa-dri, libopengl0, qt6-translations-l10n")
set(CPACK_DEBIAN_WINDOW_PACKAGE_BREAKS "tan (<< 0.2)")
set(CPACK_DEBIAN_WINDOW_PACKAGE_REPLACES "tan (<< 0.2)")
# xdg-utils opens the manual in the web browser.
set(CPACK_DEBIAN_WINDOW_PACKAGE_RECOMMENDS "xdg-utils")
# ffmpeg makes videos of films.
set(CPACK_DEBIAN_WINDOW_PACKAGE_SUGGESTS "ffmpeg, tan-vtk-readers")
set(CPACK_COMPONENT_WINDOW_DESCRIPTION "the window of TAn
Shows multiresolution models as isosurfaces and volumes, at any accuracy, and
builds them.")
set(CPACK_DEBIAN_VTK_PACKAGE_NAME tan-vtk-readers)
set(CPACK_DEBIAN_VTK_PACKAGE_DEPENDS "${same_version}")
set(CPACK_COMPONENT_VTK_DESCRIPTION "reads VTK, NetCDF, HDF5, Zarr, DICOM, TIFF and more into TAn
Programs in which VTK, the libraries of NetCDF and HDF5, Blosc, GDCM and libtiff
read files for TAn, each in a process of its own.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME tan-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "${core_of_same_version}, libeigen3-dev")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_RECOMMENDS "${same_version}")
# Plugins that are editors.
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SUGGESTS "qt6-base-dev")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "headers for programs with the library of TAn, and for plugins
The headers of TAn's library and of its plugin interfaces, of which those of
editors alone need Qt, a CMake package, and examples.")
# Compiled for this version of Python alone. Files are read, and models served, by the program `tan`.
if(TARGET tan-python)
    execute_process(COMMAND ${TAN_PYTHON_PROGRAM} -c
        "import sys; minor = sys.version_info[1]; print(f'python3 (>= 3.{minor}), python3 (<< 3.{minor + 1})')"
        OUTPUT_VARIABLE this_python OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
    set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-tan)
    set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
    set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "${same_version}, ${this_python}, python3-numpy")
    set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-meshio, python3-vtk9, python3-tqdm, tan-vtk-readers")
    set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA ${CMAKE_CURRENT_LIST_DIR}/debian/python/postinst
        ${CMAKE_CURRENT_LIST_DIR}/debian/python/prerm)
    set(CPACK_COMPONENT_PYTHON_DESCRIPTION "TAn from Python
The module tan: models of arrays and files, their meshes as arrays of NumPy,
and pictures. Needs no screen and no Qt.")
endif()

set(CPACK_RPM_COMPONENT_INSTALL ON)
set(CPACK_RPM_FILE_NAME RPM-DEFAULT)
set(CPACK_RPM_MAIN_COMPONENT program)
set(CPACK_RPM_PACKAGE_LICENSE "GPL-3.0-or-later")
set(CPACK_RPM_PACKAGE_GROUP "Applications/Engineering")
# The files of the .deb as they are: rpmbuild would strip them once more, and link to them for packages of debugging symbols, which
# there are none of.
set(CPACK_RPM_SPEC_MORE_DEFINE "%define _build_id_links none\n%define __os_install_post %{nil}")
set(CPACK_RPM_CORE_PACKAGE_NAME tan-core)
set(CPACK_RPM_PROGRAM_PACKAGE_REQUIRES "tan-core = ${PROJECT_VERSION}")
set(CPACK_RPM_WINDOW_PACKAGE_NAME tan-desktop)
set(CPACK_RPM_WINDOW_PACKAGE_REQUIRES "tan = ${PROJECT_VERSION}")
set(CPACK_RPM_WINDOW_PACKAGE_OBSOLETES "tan < 0.2") # whoever has it keeps the window
set(CPACK_RPM_VTK_PACKAGE_NAME tan-vtk-readers)
set(CPACK_RPM_VTK_PACKAGE_REQUIRES "tan = ${PROJECT_VERSION}")
set(CPACK_RPM_DEVELOPMENT_PACKAGE_NAME tan-devel)
set(CPACK_RPM_DEVELOPMENT_PACKAGE_REQUIRES "tan-core = ${PROJECT_VERSION}")
# Folders that belong to the system.
set(CPACK_RPM_EXCLUDE_FROM_AUTO_FILELIST_ADDITION /usr/share/applications /usr/share/icons /usr/share/icons/hicolor
    /usr/share/icons/hicolor/scalable /usr/share/icons/hicolor/scalable/apps /usr/share/man /usr/share/man/man1
    /usr/share/mime /usr/share/mime/packages /usr/share/metainfo /usr/share/bash-completion
    /usr/share/bash-completion/completions /usr/share/zsh /usr/share/fish /usr/share/fish/vendor_completions.d
    /usr/share/doc /usr/lib/cmake)
set(CPACK_CMAKE_BUILD_FOLDER ${PROJECT_BINARY_DIR})
set(CPACK_MACHINE ${CMAKE_SYSTEM_PROCESSOR})
include(CPack)
