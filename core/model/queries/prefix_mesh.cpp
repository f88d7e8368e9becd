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
constexpr double largestRefill = 0.4;
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
    if (sites > 0 && !model.check(model.meshSizes()[sites - 1]))
        return model.checkIntact();
    if (before == 0 || change > largestRefill * std::min(sites, before)) {
        if (const Status extracted = extract(model, sites, progress, out); !extracted)
            return extracted;
    } else if (sites != before) {
        if (const Status right = model.checkPrefix(std::max(sites, before), Model::Stars, progress); !right)
            return right;
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
    out.points.clear();
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
    if (!startReplacing(model, sites, out))
        return;
    for (std::uint32_t site = sites_; site < sites; ++site)
        for (const std::uint64_t t : starOf(model, site))
            add(model, t, site, model.destroyers()[t] >= sites, out);
    closeGaps(out);
}

void PrefixMesh::coarsen(const Model& model, std::uint32_t sites, ExtractedMesh& out)
{
    select(births_, sites, Model::never, going_);
    if (!startReplacing(model, sites, out))
        return;
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
            add(model, t, creator, true, out);
        }
    }
    closeGaps(out);
}

/// Finds places for what arrives, as many as the file says: those that become free, then new ones at the end, then one
/// that nobody will read. False if the file cannot be right.
bool PrefixMesh::startReplacing(const Model& model, std::uint32_t sites, ExtractedMesh& out)
{
    const std::size_t before = out.mesh.tetrahedra.size();
    arriving_ = std::uint64_t(model.meshSizes()[sites - 1]) + going_.size() - before;
    consistent_ = arriving_ <= model.tetrahedronCount();
    if (!consistent_)
        return false;
    const std::size_t more = arriving_ > going_.size() ? arriving_ - going_.size() : 0;
    places_ = going_;
    places_.resize(going_.size() + more + 1);
    std::iota(places_.begin() + static_cast<std::ptrdiff_t>(going_.size()), places_.end(),
              static_cast<std::uint32_t>(before));
    filled_ = 0;
    out.mesh.tetrahedra.resize(before + more + 1);
    births_.resize(before + more + 1);
    deaths_.resize(before + more + 1);
    return true;
}

/// Puts a tetrahedron of the history into the next place; the next one goes over it if it is not alive, which follows
/// no pattern that a processor could predict.
void PrefixMesh::add(const Model& model, std::uint64_t tetrahedron, std::uint32_t creator, bool alive,
                     ExtractedMesh& out)
{
    const std::array<std::uint32_t, 3> others = model.otherSites()[tetrahedron];
    const std::uint32_t place = places_[std::min<std::uint64_t>(filled_, arriving_)];
    const int turned = model.description().leftHanded ? 1 : 0;
    out.mesh.tetrahedra[place] = {creator, others[0], others[1 + turned], others[2 - turned]};
    births_[place] = creator;
    deaths_[place] = model.destroyers()[tetrahedron];
    consistent_ &= (others[0] < creator) & (others[1] < creator) & (others[2] < creator);
    filled_ += alive ? 1 : 0;
}

/// Places that are free still are taken by the last tetrahedra of the mesh.
void PrefixMesh::closeGaps(ExtractedMesh& out)
{
    consistent_ &= filled_ == arriving_;
    if (!consistent_)
        return;
    Buffer<std::array<std::uint32_t, 4>>& tetrahedra = out.mesh.tetrahedra;
    std::size_t end = tetrahedra.size() - 1;
    std::size_t last = going_.size();
    while (filled_ < last) {
        --end;
        if (going_[last - 1] == end) {
            --last;
            continue;
        }
        const std::size_t place = going_[filled_++];
        tetrahedra[place] = tetrahedra[end];
        births_[place] = births_[end];
        deaths_[place] = deaths_[end];
    }
    tetrahedra.resize(end);
    births_.resize(end);
    deaths_.resize(end);
}

} // namespace tetra
