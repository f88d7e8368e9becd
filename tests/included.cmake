# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -D OUTPUT=FILE -D SOURCES=FILE;... -P included.cmake: writes a header that includes what these tests include, each once, but for what
# moc makes of them. It is touched only when that changes.
set(included "")
foreach(source IN LISTS SOURCES)
    file(STRINGS ${source} lines REGEX "^#include [<\"]")
    list(APPEND included ${lines})
endforeach()
list(FILTER included EXCLUDE REGEX "\\.moc\"$")
list(REMOVE_DUPLICATES included)
list(JOIN included "\n" text)
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT "#pragma once\n@text@\n" @ONLY)
