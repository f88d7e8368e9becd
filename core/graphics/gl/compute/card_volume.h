// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/graphics/cpu/kept_order.h"
#include "core/graphics/gl/compute/card_cells.h"
#include "core/graphics/render_backend.h"
#include "core/graphics/scene.h"

#include <map>
#include <memory>

namespace tetra {

/// A volume whose cells the graphics card orders, classifies, projects and sorts, by compute shaders. The processor
/// orders those that the card cannot: domains with gaps, whose order depends on the samples of the picture, and meshes
/// whose keys do not come to an end (CardKeys); of these the ranks are sent, 4 bytes a cell. As StorageBuffer.
class CardVolume {
public:
    struct Request {
        const Volume& volume;
        KeptOrder::Request order;
        int threads = 0; ///< where the processor orders
        CardCells::SetView setView;
    };

    /// Makes ready to draw a picture, and adds to `statistics`. Errors: those of fillMesh() and checkDriver(), which
    /// every later call gives, too; cancelled. Always of the same mesh.
    Status prepare(const ComputeContext& context, const ComputePrograms& programs, const Request& request,
                   const Progress& progress, RenderStatistics& statistics);

    CardCells& cells() noexcept { return cells_; }
    const CardMesh& mesh() const noexcept { return mesh_; }

private:
    Status tryPreparing(const ComputeContext& context, const ComputePrograms& programs, const Request& request,
                        const Progress& progress, RenderStatistics& statistics);
    Status order(const ComputeContext& context, const ComputePrograms& programs, const Request& request,
                 const Progress& progress, RenderStatistics& statistics);
    Result<bool> orderOnCard(const ComputeContext& context, const ComputePrograms& programs,
                             const KeptOrder::Request& request, const Progress& progress, RenderStatistics& statistics);

    Status refused_;
    bool filled_ = false; ///< the mesh is on the card
    CardMesh mesh_;
    CardKeys keys_;
    CardCells cells_;
    Camera camera_;           ///< that the card's keys are for
    bool keysFit_ = false;    ///< the card has keys of its own
    bool cardOrders_ = false; ///< it can, as far as is known
    KeptOrder order_;         ///< the processor's
};

/// Keeps the volumes of every mesh that still lives. As StorageBuffer.
class CardVolumeCache {
public:
    /// That of `mesh`, valid until dropDead().
    CardVolume& volumeOf(const std::shared_ptr<const VolumeMesh>& mesh);
    /// Frees the volumes of meshes that nobody holds any more.
    void dropDead();

private:
    struct Entry {
        std::weak_ptr<const VolumeMesh> mesh; ///< tells a new mesh at an old address
        std::unique_ptr<CardVolume> volume;
    };
    std::map<const VolumeMesh*, Entry> entries_;
};

} // namespace tetra
