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
        selected_.clear();
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
    out.mesh.positions.assign(places.positions.begin(), places.positions.begin() + sites);
    out.mesh.values.assign(places.values.begin(), places.values.begin() + sites);
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
    select(deaths_, 0, sites - 1, selected_);
    arriving_.clear();
    arrivingBirths_.clear();
    arrivingDeaths_.clear();
    for (std::uint32_t site = sites_; site < sites; ++site)
        for (const std::uint64_t t : starOf(model, site))
            if (model.destroyers()[t] >= sites)
                add(model, t, site);
    replace(out);
}

void PrefixMesh::coarsen(const Model& model, std::uint32_t sites, ExtractedMesh& out)
{
    select(births_, sites, Model::never, selected_);
    arriving_.clear();
    arrivingBirths_.clear();
    arrivingDeaths_.clear();
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
            add(model, t, creator);
        }
    }
    replace(out);
}

void PrefixMesh::add(const Model& model, std::uint64_t tetrahedron, std::uint32_t creator)
{
    const std::array<std::uint32_t, 3> others = model.otherSites()[tetrahedron];
    consistent_ &= others[0] < creator && others[1] < creator && others[2] < creator;
    std::array<std::uint32_t, 4> sites = {creator, others[0], others[1], others[2]};
    if (model.description().leftHanded)
        std::swap(sites[2], sites[3]);
    arriving_.push_back(sites);
    arrivingBirths_.push_back(creator);
    arrivingDeaths_.push_back(model.destroyers()[tetrahedron]);
}

/// Puts what arrives in the place of what goes; places that are left are filled from the end.
void PrefixMesh::replace(ExtractedMesh& out)
{
    Buffer<std::array<std::uint32_t, 4>>& tetrahedra = out.mesh.tetrahedra;
    const std::size_t both = std::min(selected_.size(), arriving_.size());
    const auto put = [this, &tetrahedra](std::size_t place, std::size_t arrival) {
        tetrahedra[place] = arriving_[arrival];
        births_[place] = arrivingBirths_[arrival];
        deaths_[place] = arrivingDeaths_[arrival];
    };
    for (std::size_t i = 0; i < both; ++i)
        put(selected_[i], i);
    const std::size_t before = tetrahedra.size();
    const std::size_t after = before + arriving_.size() - selected_.size();
    if (after > before) {
        for (auto* const array : {&births_, &deaths_})
            array->resize(after);
        tetrahedra.resize(after);
        for (std::size_t i = both; i < arriving_.size(); ++i)
            put(before + i - both, i);
        return;
    }
    std::size_t last = before;
    std::size_t lastGoing = selected_.size();
    for (std::size_t i = both; i < lastGoing; ++i) {
        while (lastGoing > i && selected_[lastGoing - 1] == last - 1) {
            --last;
            --lastGoing;
        }
        if (lastGoing == i)
            break;
        --last;
        tetrahedra[selected_[i]] = tetrahedra[last];
        births_[selected_[i]] = births_[last];
        deaths_[selected_[i]] = deaths_[last];
    }
    tetrahedra.resize(after);
    births_.resize(after);
    deaths_.resize(after);
}

} // namespace tetra
