// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/queries/prefix_mesh.h"

#include "core/model/extraction.h"
#include "core/model/queries/number_selection.h"
#include "core/model/queries/stars.h"
#include "core/model/site_places.h"

#include <algorithm>
#include <numeric>

namespace tetra {

namespace {

/// Beyond this share of the sites that come or go, a mesh is quicker made afresh.
constexpr double largestChange = 0.4;
/// Tetrahedra of the history that are searched for dead ones at a time: their numbers fit 32 bits.
constexpr std::uint64_t searchedAtOnce = 1 << 16;

void select(std::span<const std::uint32_t> numbers, std::uint32_t least, std::uint32_t largest,
            Buffer<std::uint32_t>& out)
{
    out.resize(numbers.size() + selectionOverrun);
    const std::uint32_t* const end = numberSelections().front().select(numbers, least, largest, out.data());
    out.resize(static_cast<std::size_t>(end - out.data()));
}

} // namespace

Status PrefixMesh::moveTo(const Model& model, std::uint32_t sites, const SitePlaces& places, const Progress& progress,
                          ExtractedMesh& out)
{
    const std::uint32_t before = std::exchange(sites_, 0);
    const double change = std::abs(static_cast<double>(sites) - before);
    consistent_ = true;
    if (before == 0 || change > largestChange * std::min(sites, before)) {
        if (const Status extracted = extract(model, sites, progress, out); !extracted)
            return extracted;
    } else if (sites != before) {
        if (!livesKnown_)
            noteLives(model, out);
        sites_ = before;
        if (sites > before)
            refine(model, sites, out);
        else
            coarsen(model, sites, out);
        sites_ = 0;
        if (!consistent_ || out.mesh.tetrahedra.size() != model.meshSizes()[sites - 1])
            return inconsistentModel(model, "its tetrahedra do not fit its mesh sizes");
    }
    const auto kept = static_cast<std::uint32_t>(std::min<std::size_t>(out.sites.size(), sites));
    out.sites.resize(sites);
    std::iota(out.sites.begin() + kept, out.sites.end(), kept);
    out.mesh.positions.resize(sites);
    out.mesh.values.resize(sites);
    std::copy(places.positions.begin() + kept, places.positions.begin() + sites, out.mesh.positions.begin() + kept);
    std::copy(places.values.begin() + kept, places.values.begin() + sites, out.mesh.values.begin() + kept);
    out.wholeSites = sites;
    out.wholeTetrahedra = out.mesh.tetrahedra.size();
    out.method = VariableMethod::ClosedSet;
    sites_ = sites;
    return {};
}

Status PrefixMesh::extract(const Model& model, std::uint32_t sites, const Progress& progress, ExtractedMesh& out)
{
    auto extracted = extractPrefix(model, sites, progress, std::move(out.mesh));
    if (!extracted)
        return extracted.error();
    out.mesh = std::move(*extracted);
    sites_ = sites;
    livesKnown_ = false;
    out.sites.clear();
    return {};
}

/// The mesh is fresh: its tetrahedra are in the order of the history.
void PrefixMesh::noteLives(const Model& model, const ExtractedMesh& out)
{
    const std::size_t count = out.mesh.tetrahedra.size();
    births_.resize(count);
    deaths_.resize(count);
    std::ranges::transform(out.mesh.tetrahedra, births_.begin(), [](const auto& sites) { return sites[0]; });
    std::size_t found = 0;
    for (std::uint32_t site = 0; site < out.wholeSites; ++site)
        for (const std::uint64_t t : starOf(model, site)) {
            const std::uint32_t destroyer = model.destroyers()[t];
            if (destroyer >= out.wholeSites && found < count)
                deaths_[found++] = destroyer;
        }
    consistent_ &= found == count;
    livesKnown_ = true;
}

void PrefixMesh::refine(const Model& model, std::uint32_t sites, ExtractedMesh& out)
{
    select(deaths_, 0, sites - 1, going_);
    startReplacing(out, model.meshSizes()[sites - 1] + going_.size() - out.mesh.tetrahedra.size(),
                   model.tetrahedronCount());
    for (std::uint32_t site = sites_; site < sites; ++site)
        for (const std::uint64_t t : starOf(model, site))
            if (model.destroyers()[t] >= sites)
                add(model, t, site, out);
    closeGaps(out);
}

void PrefixMesh::coarsen(const Model& model, std::uint32_t sites, ExtractedMesh& out)
{
    select(births_, sites, Model::never, going_);
    startReplacing(out, model.meshSizes()[sites - 1] + going_.size() - out.mesh.tetrahedra.size(),
                   model.tetrahedronCount());
    const std::span<const std::uint64_t> offsets = model.starOffsets();
    const std::uint64_t end = std::min(offsets[sites], model.tetrahedronCount());
    std::uint32_t creator = 0;
    for (std::uint64_t first = 0; first < end; first += searchedAtOnce) {
        const std::uint64_t count = std::min(searchedAtOnce, end - first);
        select(model.destroyers().subspan(first, count), sites, sites_ - 1, revived_);
        for (const std::uint32_t place : revived_) {
            const std::uint64_t t = first + place;
            while (creator + 1 < sites && offsets[creator + std::size_t(1)] <= t)
                ++creator;
            add(model, t, creator, out);
        }
    }
    closeGaps(out);
}

/// Makes room for what arrives, as many as the file says; there cannot be more than `all`.
void PrefixMesh::startReplacing(ExtractedMesh& out, std::uint64_t arriving, std::uint64_t all)
{
    filled_ = 0;
    end_ = out.mesh.tetrahedra.size();
    consistent_ &= arriving <= all;
    if (!consistent_)
        return;
    const std::uint64_t most = end_ + (arriving > going_.size() ? arriving - going_.size() : 0);
    out.mesh.tetrahedra.resize(most);
    births_.resize(most);
    deaths_.resize(most);
}

/// Puts a tetrahedron of the history into the next free place.
void PrefixMesh::add(const Model& model, std::uint64_t tetrahedron, std::uint32_t creator, ExtractedMesh& out)
{
    const std::size_t place = filled_ < going_.size() ? going_[filled_++] : end_++;
    const std::array<std::uint32_t, 3> others = model.otherSites()[tetrahedron];
    consistent_ &= others[0] < creator && others[1] < creator && others[2] < creator && place < deaths_.size();
    if (place >= deaths_.size())
        return;
    const bool turned = model.description().leftHanded;
    out.mesh.tetrahedra[place] = {creator, others[0], others[turned ? 2 : 1], others[turned ? 1 : 2]};
    births_[place] = creator;
    deaths_[place] = model.destroyers()[tetrahedron];
}

/// Places that are free still are taken by the last tetrahedra of the mesh.
void PrefixMesh::closeGaps(ExtractedMesh& out)
{
    Buffer<std::array<std::uint32_t, 4>>& tetrahedra = out.mesh.tetrahedra;
    std::size_t last = going_.size();
    while (filled_ < last) {
        --end_;
        if (going_[last - 1] == end_) {
            --last;
            continue;
        }
        const std::size_t place = going_[filled_++];
        tetrahedra[place] = tetrahedra[end_];
        births_[place] = births_[end_];
        deaths_[place] = deaths_[end_];
    }
    tetrahedra.resize(end_);
    births_.resize(end_);
    deaths_.resize(end_);
}

} // namespace tetra
