// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/queries/set_mesh.h"

#include "core/model/queries/stars.h"
#include "core/model/site_places.h"

#include <algorithm>
#include <numeric>

namespace tetra {

namespace {

constexpr std::uint32_t starsAtOnce = 1 << 14;
/// Sites between asking memory for a star and reading it.
constexpr std::size_t starsAhead = 6;

/// Copies the tetrahedra of the stars that none of the sites destroys.
class SetScan {
public:
    SetScan(const Model& model, const ClosedSet& set, ExtractedMesh& out) : model_(model), set_(set), out_(out) {}

    void numberVertices();
    Status run(const Progress& progress);

private:
    void scanStar(std::uint32_t site);
    std::uint32_t vertexOf(std::uint32_t site) const { return site < set_.prefix ? site : later_[site - set_.prefix]; }

    const Model& model_;
    const ClosedSet& set_;
    ExtractedMesh& out_;
    Buffer<std::uint32_t> later_; ///< the vertices of the sites behind the prefix
    Buffer<std::uint64_t> alive_;
    std::uint64_t found_ = 0;
    bool right_ = true;
};

void SetScan::numberVertices()
{
    out_.points.clear();
    out_.sites.resize(set_.sites.count());
    std::iota(out_.sites.begin(), out_.sites.begin() + set_.prefix, 0);
    std::uint32_t vertex = set_.prefix;
    set_.sites.visitFrom(set_.prefix, [this, &vertex](std::uint32_t site) { out_.sites[vertex++] = site; });
    const std::uint32_t end = vertex > set_.prefix ? out_.sites.back() + 1 : set_.prefix;
    later_.assign(end - set_.prefix, ExtractedMesh::noSite);
    for (std::uint32_t later = set_.prefix; later < vertex; ++later)
        later_[out_.sites[later] - set_.prefix] = later;
}

Status SetScan::run(const Progress& progress)
{
    Buffer<std::array<std::uint32_t, 4>>& tetrahedra = out_.mesh.tetrahedra;
    tetrahedra.resize(set_.tetrahedra);
    for (std::size_t vertex = 0; vertex < out_.sites.size(); ++vertex) {
        if (vertex % starsAtOnce == 0) {
            if (progress.cancelled())
                return cancelledError("Extracting the mesh");
            progress.report(static_cast<double>(vertex) / static_cast<double>(out_.sites.size()),
                            "Extracting the mesh");
        }
        if (vertex + 2 * starsAhead < out_.sites.size()) {
            fetchStarOffsets(model_, out_.sites[vertex + 2 * starsAhead]);
            fetchStar(model_, out_.sites[vertex + starsAhead], false);
        }
        scanStar(out_.sites[vertex]);
    }
    if (!right_ || found_ != tetrahedra.size())
        return inconsistentModel(model_, "its tetrahedra do not fit its mesh sizes");
    return {};
}

/// First which ones, without a branch on what no processor could predict; then their vertices.
void SetScan::scanStar(std::uint32_t site)
{
    const auto star = starOf(model_, site);
    if (alive_.size() <= star.size())
        alive_.resize(2 * star.size() + 1);
    std::size_t count = 0;
    for (const std::uint64_t t : star) {
        alive_[count] = t;
        count += set_.sites.contains(std::min(model_.destroyers()[t], model_.siteCount())) ? 0 : 1;
    }
    Buffer<std::array<std::uint32_t, 4>>& tetrahedra = out_.mesh.tetrahedra;
    right_ &= count <= tetrahedra.size() - found_;
    if (!right_)
        return;
    const std::uint32_t creator = vertexOf(site);
    for (const std::uint64_t t : std::span(alive_).first(count)) {
        const std::array<std::uint32_t, 3> others = model_.otherSites()[t];
        right_ &= others[0] < site && others[1] < site && others[2] < site;
        tetrahedra[found_++] = {creator, vertexOf(std::min(others[0], site)), vertexOf(std::min(others[1], site)),
                                vertexOf(std::min(others[2], site))};
    }
}

} // namespace

Status extractSet(const Model& model, const ClosedSet& set, const SitePlaces& places, const Progress& progress,
                  ExtractedMesh& out)
{
    if (set.tetrahedra > model.tetrahedronCount())
        return inconsistentModel(model, "its mesh sizes make no sense");
    SetScan scan(model, set, out);
    scan.numberVertices();
    if (const Status scanned = scan.run(progress); !scanned)
        return scanned;
    const auto noVertex = [](const std::array<std::uint32_t, 4>& t) {
        return std::ranges::find(t, ExtractedMesh::noSite) != t.end();
    };
    if (std::ranges::any_of(out.mesh.tetrahedra, noVertex))
        return inconsistentModel(model, "a tetrahedron has a site that its creator does not need");
    if (model.description().leftHanded)
        for (std::array<std::uint32_t, 4>& tetrahedron : out.mesh.tetrahedra)
            std::swap(tetrahedron[2], tetrahedron[3]);
    out.mesh.positions.resize(out.sites.size());
    out.mesh.values.resize(out.sites.size());
    std::ranges::transform(out.sites, out.mesh.positions.begin(),
                           [&places](std::uint32_t site) { return places.positions[site]; });
    std::ranges::transform(out.sites, out.mesh.values.begin(),
                           [&places](std::uint32_t site) { return places.values[site]; });
    out.wholeSites = set.sites.count();
    out.wholeTetrahedra = out.mesh.tetrahedra.size();
    out.scale = set.scale;
    out.method = VariableMethod::ClosedSet;
    return {};
}

} // namespace tetra
