// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/render/gl/gl_functions.h"

#include <tan/base.h>
#include <tan/render.h>

#include <memory>
#include <string>
#include <vector>

namespace tetra {

/// Draws scenes with OpenGL 3.3 into a framebuffer of a context that somebody else owns: a window's, or the picture
/// back end's. It is the OpenGL half of RenderBackend: the same pictures as the CPU's within 2/255, but where an edge
/// falls into another sample by rounding.
///
/// Translucency is exact to the sample, by depth peeling from the front: each layer draws the translucent surfaces once
/// more, until a layer is empty. Sorting triangles would be cheaper, but wrong where they cross, and OpenGL 3.3 has no
/// lists of fragments. Time is that of the scene's triangles times the largest number of layers at any sample. A volume
/// is drawn once more for each layer, too: between the one before and that one (R21). A focus (R24) is drawn in 13
/// parts, one without a border in three; of both only the cells that may be in a part.
///
/// Everything is called from one thread with the context current, the destructor, too.
class TAN_INTERNAL ScenePainter {
public:
    /// Looks up the functions and compiles the shaders. Errors: no OpenGL 3.3, what the driver refuses of it.
    static Result<std::unique_ptr<ScenePainter>> make(const GetProcAddress& getProcAddress);
    ~ScenePainter();
    ScenePainter(const ScenePainter&) = delete;
    ScenePainter& operator=(const ScenePainter&) = delete;

    /// Draws the part of the picture that options want, or all of it, into `framebuffer` (0 is the window's own), over
    /// as many of its lower left pixels, with straight alpha. Buffers of a mesh and the order of its cells are kept
    /// while somebody holds the mesh. Leaves `framebuffer` bound, and depth test, blending, face culling, scissor and
    /// stencil test off, no program, no vertex array. The threads in `options` are for the order of a volume's cells.
    /// Cancelled between layers and chunks of cells. Errors: a scene that does not hang together, more clip planes than
    /// 16, out of memory.
    Status draw(const Scene& scene, const Camera& camera, const PictureOptions& options, unsigned framebuffer,
                const Progress& progress = {});

    /// The samples a side that it can draw at once.
    int largestSide() const noexcept;

    /// Of the last picture.
    RenderStatistics statistics() const noexcept;
    /// Picture::depth of the last picture, if it was wanted. It takes MedianDepth::steps times as long as the picture.
    /// Of a volume with wholeCells, too, depths are those without.
    std::vector<float> takeDepth() noexcept;

    /// The driver's name of what draws: "NVIDIA ...", "llvmpipe (LLVM ...)".
    const std::string& rendererName() const noexcept;

private:
    class Implementation;
    explicit ScenePainter(std::unique_ptr<Implementation> implementation);
    std::unique_ptr<Implementation> implementation_;
};

} // namespace tetra
