// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/render/gl/gl_buffers.h"
#include "core/render/gl/gl_program.h"
#include "core/render/gl/sample_targets.h"
#include "core/render/volume/volume_view.h"

#include <tan/base.h>
#include <tan/render.h>

#include <Eigen/Core>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tetra {

/// The regions of a focus as focus.frag wants them: lengths in units of w (VolumeView), places from a region's middle.
struct RegionsInView {
    std::vector<Eigen::Vector4f> shapes; ///< half of a box; of a ball the radius, in each coordinate; 1 if it is a ball
    std::vector<Eigen::Vector4f> places; ///< where the image (0, 0, 0) is, and the border
    Eigen::Matrix3f worldFromImage = Eigen::Matrix3f::Identity();
};

/// A part of each ray, of one of the two volumes. The numbers of places are those of focus.frag.
struct VolumePart {
    enum class Place { Whole, Before, FrontBorder, Within, BackBorder };
    Place place = Place::Whole;
    int interval = 0; ///< of FocusRays; before the one after the last is behind all
    bool fine = false;
    Eigen::Vector2f shares{0, 1}; ///< of the way through the border on one side, where the part begins and ends
};

/// The textures between whose surfaces a volume is drawn.
struct VolumeLayers {
    unsigned opaqueDepth = 0;
    unsigned before = 0; ///< the key of each sample's layer before (peel.frag); 0 without translucent surfaces
    unsigned behind = 0; ///< and of the next
};

/// Draws the volume of a scene cell by cell, front to back, under what is in the framebuffer already. Every cell is the
/// faces of its that look away from the eye; each fragment computes the ray's way through the cell and its light in
/// closed form, as the CPU back end does.
///
/// The order comes from the CPU and stays on the card while it fits; the vertex shader sets up each cell, for each of
/// its corners.
///
/// A focus is drawn by parts of rays: before a region, in its border layers of both volumes in turn by their weights,
/// in it, and so on, and behind the last. Each part is a drawing of the cells that may have something in it.
///
/// The context must be current for everything, also when it goes; `gl` must outlive it.
class VolumePainter {
public:
    explicit VolumePainter(const GlFunctions& gl) : gl_(gl), coarse_(gl), fine_(gl) {}

    /// How the pieces of a ray are combined in the scene that is ready.
    Combiner combiner() const noexcept { return combiner_; }

    /// Gives what the pieces of a ray make together its light (OpticalModel::lightOfRay); null if they are it.
    const GlProgram* rayProgram() const noexcept { return rayProgram_; }
    /// Sets what that reads besides what is gathered; it is in use.
    void setRayData() const;

    /// Makes ready to draw the scene's volume, which there must be. Errors: parts that do not belong together, more
    /// vertices than the driver allows, no memory, cancelled.
    Status prepare(const Scene& scene, const SampleView& view, const PictureOptions& options, const Progress& progress);

    /// Draws what lies between two layers into targets.accumulatedFramebuffer or gatheredFramebuffer, which is bound,
    /// with a vertex array without attributes and blending under what is there. From time to time the samples where
    /// nothing more can be seen are marked, and left out from then on. For a combiner() other than Over the caller sets
    /// the blending that combines, and no samples are marked. Leaves depth test and face culling off. Cancelled between
    /// chunks of cells.
    Status draw(const PainterPrograms& programs, const SampleTargets& targets, const VolumeLayers& layers,
                const Progress& progress) const;

    /// Frees the buffers of meshes that nobody holds any more.
    void dropDead()
    {
        coarse_.kept.dropDead();
        fine_.kept.dropDead();
    }

    /// Of what prepare() did.
    const RenderStatistics& statistics() const noexcept { return statistics_; }

private:
    /// The volume of a scene, or that in its focus. They keep buffers each, as both may be of one mesh.
    struct DrawnVolume {
        explicit DrawnVolume(const GlFunctions& gl) : kept(gl) {}
        VolumeBufferCache kept;
        TextureBuffer segmentBuffer;
        // Of the picture being drawn.
        VolumeBuffers* buffers = nullptr;
        ScaledSegments segments;
        bool shaded = false;
        float perFullGradient = 0; ///< of volume_mesh.h, of its gradients
    };

    Status prepareVolume(const Volume& volume, const SampleView& view, const PictureOptions& options,
                         const Progress& progress, DrawnVolume& drawn);
    Status prepareBuffers(const Volume& volume, const CachedOrder::Request& order, int threads,
                          const Progress& progress, DrawnVolume& drawn);
    void setUniforms(const GlProgram& program) const;
    void setVolume(const GlProgram& program, const DrawnVolume& volume) const;
    Status drawPart(const PainterPrograms& programs, const SampleTargets& targets, const VolumeLayers& layers,
                    const VolumePart& part, const Progress& progress) const;
    void setPartUniforms(const GlProgram& program, const DrawnVolume& volume, const VolumePart& part) const;
    Status prepareModel(const Volume& volume, const std::string& maker);
    Status prepareRays(const std::shared_ptr<const OpticalModel>& model, const std::string& maker);
    using Programs = std::map<std::string, std::unique_ptr<GlProgram>>; ///< by their text, the last few
    using MakeProgram = Result<std::unique_ptr<GlProgram>> (*)(const GlFunctions& gl, const std::string& shader,
                                                               const std::string& maker);
    Result<const GlProgram*> keptProgram(Programs& kept, MakeProgram make, const std::string& shader,
                                         const std::string& maker) const;
    void markSaturated(const GlProgram& program, const SampleTargets& targets) const;
    void setCellState() const;

    const GlFunctions& gl_;
    DrawnVolume coarse_;
    DrawnVolume fine_;
    RenderStatistics statistics_;
    // Of the picture being drawn.
    std::optional<RegionsInView> regions_;
    VolumeView whole_;                ///< of the whole picture
    VolumeView view_;                 ///< of the part that is drawn
    Eigen::Vector3d origin_{0, 0, 0}; ///< the eye, or in orthographic views what it looks at
    std::vector<Eigen::Vector4f> cuts_;
    Eigen::Vector2f boundOfDepth_{0, 0};
    bool wholeCells_ = false;
    Combiner combiner_ = Combiner::Over;
    const GlProgram* program_ = nullptr; ///< of the optical model; null: that of all volumes without one
    const GlProgram* rayProgram_ = nullptr;
    Programs models_;
    Programs rays_;
    TextureBuffer rayData_;
    std::weak_ptr<const OpticalModel> rayDataOf_; ///< whose data are sent
};

} // namespace tetra
