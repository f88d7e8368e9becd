// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/render/camera.h"
#include "core/render/picture.h"
#include "core/render/scene.h"

#include <memory>
#include <string>
#include <string_view>

namespace tetra {

struct PictureOptions {
    int width = 1024;
    int height = 768;
    Colour background{1, 1, 1};
    bool transparentBackground = false;
    int samplesPerAxis = 2; ///< a pixel is the mean of this many squared samples: 1 (fast, no antialiasing) to 4
    int threads = 0;        ///< of the CPU back end; 0 or too many means all of the machine
    bool depth = false;     ///< make Picture::depth, too
    /// In degrees: a volume may be drawn in the visibility order of an earlier picture whose camera differed by no more
    /// than this (orderDrift). 0 for exact pictures; a few degrees while the camera moves.
    double orderTolerance = 0;
};

/// What the last picture took, for the cost model of progressive rendering (R23) and for people.
struct RenderStatistics {
    std::size_t cells = 0;        ///< tetrahedra of the volume that were drawn, once for each tile of the CPU back end
    std::size_t fragments = 0;    ///< samples of the picture times the cells drawn there, as far as they are counted
    std::size_t brokenCycles = 0; ///< of the visibility order (S14)
    bool orderReused = false;
    double orderSeconds = 0;
    double setUpSeconds = 0; ///< projecting, binning
    double fillSeconds = 0;
    std::size_t sentBytes = 0; ///< of cells and their order, to the graphics card; without the mesh, sent once
};

/// Turns a scene into a picture (B4). The CPU back end is the reference; the OpenGL one draws the same within 2/255.
/// One object is used from one thread at a time; it keeps what the next picture of the same scene can use.
class RenderBackend {
public:
    virtual ~RenderBackend() = default;
    virtual std::string_view id() const noexcept = 0; ///< "cpu" or "gl"
    virtual Result<Picture> render(const Scene& scene, const Camera& camera, const PictureOptions& options,
                                   const Progress& progress = {}) = 0;
    /// Of the last picture that was finished.
    virtual RenderStatistics statistics() const = 0;
};

/// Needs nothing but memory.
std::unique_ptr<RenderBackend> makeCpuBackend();
/// OpenGL 3.3 or newer without a window, by EGL; the error says what is missing on this machine.
Result<std::unique_ptr<RenderBackend>> makeGlBackend();

/// An error if the mesh has not one normal a vertex, or as many values or colours if any, or a triangle has a corner
/// that does not exist. O(triangles).
Status checkMesh(const TriangleMesh& mesh);
/// An error if a segment has an end that does not exist. O(segments).
Status checkLines(const LineSet& lines);

/// The scene has a volume to be seen.
bool hasVolume(const Scene& scene);
/// That volume has a focus with a fine volume.
bool hasFocus(const Scene& scene);

/// In pixels. Numbers of samples, the one after the last included, have 16 bits where a volume is drawn.
inline constexpr int largestPictureSide = 32767;

/// An error if no back end can make such a picture.
Status checkOptions(const PictureOptions& options);

} // namespace tetra
