# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -DOUTPUT=header "-DSHADERS=file;file;..." -P embed.cmake: a header with each shader's text as a constant, named
# after the file: surface.vert becomes surfaceVert.
set(text "// Made from resources/shaders by embed.cmake.\n#pragma once\n\nnamespace tetra::shaders {\n\n")
foreach(shader ${SHADERS})
    get_filename_component(name ${shader} NAME_WE)
    get_filename_component(stage ${shader} EXT)
    string(SUBSTRING ${stage} 1 1 initial)
    string(TOUPPER ${initial} initial)
    string(SUBSTRING ${stage} 2 -1 rest)
    file(READ ${shader} source)
    string(APPEND text "inline constexpr const char* ${name}${initial}${rest} = R\"GLSL(${source})GLSL\";\n\n")
endforeach()
string(APPEND text "} // namespace tetra::shaders\n")
file(WRITE ${OUTPUT} "${text}")
