// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/model.h>
#include <tan/query.h>

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace tetra {

/// What there is to know of a model without having it.
struct WholeSizes {
    std::uint32_t sites = 0;
    std::uint64_t tetrahedra = 0; ///< of its history
    std::uint64_t bytes = 0;      ///< of its file
    /// Of some of its uniform meshes, the first and the most accurate one among them, in this order: at least one.
    std::vector<MeshSize> meshes;
};

/// Who keeps a model of which only the beginning is at hand (Model::elsewhere()): says how large its meshes are, and
/// finds them. Immutable; safe from any number of threads.
class WholeElsewhere {
public:
    explicit WholeElsewhere(WholeSizes sizes) : sizes_(std::move(sizes)) {}
    virtual ~WholeElsewhere() = default;
    WholeElsewhere(const WholeElsewhere&) = delete;
    WholeElsewhere& operator=(const WholeElsewhere&) = delete;

    const WholeSizes& sizes() const noexcept { return sizes_; }
    /// As MeshExtractor::extract() of the whole; which site a vertex is it does not tell (ExtractedMesh::noSite). Waits
    /// for as long as it takes. Errors besides: whoever keeps the model cannot be reached, refuses, or says what is no
    /// mesh.
    virtual Result<std::shared_ptr<const ExtractedMesh>> extract(const MeshQuery& query,
                                                                 const Progress& progress) const = 0;

private:
    WholeSizes sizes_;
};

/// Of the whole model, wherever it is.
inline std::uint32_t wholeSites(const Model& model)
{
    return model.elsewhere() != nullptr ? model.elsewhere()->sizes().sites : model.siteCount();
}
inline std::uint64_t wholeTetrahedra(const Model& model)
{
    return model.elsewhere() != nullptr ? model.elsewhere()->sizes().tetrahedra : model.tetrahedronCount();
}
inline std::uint64_t wholeBytes(const Model& model)
{
    return model.elsewhere() != nullptr ? model.elsewhere()->sizes().bytes : model.fileSize();
}

} // namespace tetra
