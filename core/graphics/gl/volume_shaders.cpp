// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/gl/volume_shaders.h"

#include <tan_shaders.h>

namespace tetra {

std::string cellVertexShader(const char* last)
{
    return std::string("#version 330 core\n") + shaders::imageGlsl + shaders::cellGlsl + shaders::facesGlsl + last;
}

std::array<const char*, 3> volumeFragmentShaders()
{
    return {shaders::volumeFrag, shaders::slabFrag, shaders::focusFrag};
}

} // namespace tetra
