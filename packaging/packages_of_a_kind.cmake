# SPDX-License-Identifier: GPL-3.0-or-later
# Read by CPack for each kind of package.
if(CPACK_GENERATOR MATCHES "DEB|RPM")
    set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
    if(CPACK_GENERATOR MATCHES "RPM")
        list(REMOVE_ITEM CPACK_COMPONENTS_ALL python) # other systems have their modules in other folders
    endif()
else()
    # One archive that runs from any folder: the programs with all that they load.
    set(CPACK_MONOLITHIC_INSTALL ON)
    set(CPACK_INSTALL_CMAKE_PROJECTS "")
    foreach(component core program window vtk bundle)
        list(APPEND CPACK_INSTALL_CMAKE_PROJECTS "${CPACK_CMAKE_BUILD_FOLDER}" TAn ${component} /)
    endforeach()
    string(TOLOWER "${CPACK_SYSTEM_NAME}" system)
    set(CPACK_PACKAGE_FILE_NAME "tan-${CPACK_PACKAGE_VERSION}-${system}-${CPACK_MACHINE}")
endif()
