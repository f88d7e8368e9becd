// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/history/query/history_part.h"

#include "core/base/guarded.h"
#include "core/history/query/window.h"
#include "core/history/site_positions.h"
#include "core/history/walk.h"
#include "core/mesh/topology.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

namespace tetra {

namespace {

constexpr MarkedText extractingRange = Message::marked("Extracting a range of meshes");

/// Goes through the part of the file that the finer mesh needs.
class HistoryScan {
public:
    HistoryScan(const Model& model, HistoryPart& part) : model_(model), part_(part) {}

    Status run(const Progress& progress);

private:
    Status makeRoom(const Progress& progress);
    Status keep(std::uint32_t creator, std::uint64_t tetrahedron, std::uint32_t destroyer);

    const Model& model_;
    HistoryPart& part_;
    std::uint64_t inCoarse_ = 0;
    std::uint64_t inFine_ = 0;
};

Status HistoryScan::run(const Progress& progress)
{
    if (const Status made = makeRoom(progress.part(0, 0.2)); !made)
        return made;
    const auto visit = [this](const Stars& stars) {
        Status right;
        // Of later batches than the creator: so a life that ends behind the coarse mesh has meshes from there on.
        forEachAlive(stars, part_.coarse.sites, [&](std::uint32_t creator, std::uint64_t t, std::uint32_t destroyer) {
            inCoarse_ += creator < part_.coarse.sites ? 1 : 0;
            inFine_ += destroyer >= part_.fine.sites ? 1 : 0;
            if (right)
                right = keep(creator, t, destroyer);
        });
        return right;
    };
    if (const Status walked = walkHistory(model_, 0, part_.fine.sites, progress.part(0.2, 1), extractingRange, visit);
        !walked)
        return walked;
    if (inCoarse_ != part_.coarse.tetrahedra || inFine_ != part_.fine.tetrahedra)
        return inconsistentModel(
            model_, Message::say("the meshes of %1 and %2 sites do not have the expected %3 and %4 tetrahedra",
                                 part_.coarse.sites, part_.fine.sites, part_.coarse.tetrahedra, part_.fine.tetrahedra));
    return {};
}

/// Growing would copy gigabytes.
Status HistoryScan::makeRoom(const Progress& progress)
{
    std::size_t found = 0;
    const auto count = [&](const Stars& stars) -> Status {
        forEachAlive(stars, part_.coarse.sites, [&](std::uint32_t, std::uint64_t, std::uint32_t) { ++found; });
        return {};
    };
    const Status walked = walkHistory(model_, 0, part_.fine.sites, progress, extractingRange, count);
    part_.mesh.tetrahedra.reserve(found);
    part_.births.reserve(found);
    part_.deaths.reserve(found);
    return walked;
}

Status HistoryScan::keep(std::uint32_t creator, std::uint64_t tetrahedron, std::uint32_t destroyer)
{
    const auto [a, b, c] = model_.otherSites()[tetrahedron];
    if (a >= creator || b >= creator || c >= creator)
        return inconsistentModel(
            model_, Message::say("a tetrahedron of site %1 has a site that comes after its creator", creator));
    if (destroyer <= creator || (destroyer >= model_.siteCount() && destroyer != Model::never))
        return inconsistentModel(
            model_,
            Message::say("a tetrahedron of site %1 is destroyed by a site that does not come after it", creator));
    part_.mesh.tetrahedra.push_back({creator, a, b, c});
    part_.births.push_back(creator + 1);
    part_.deaths.push_back(destroyer == Model::never ? Model::never : destroyer + 1);
    return {};
}

/// What a mesh of so many sites had before the last of them entered, in % of the value range.
float errorBefore(const Model& model, std::uint32_t sites)
{
    if (sites == Model::never)
        return 0;
    const double extent = model.description().range.extent();
    const float key = model.runningKeys()[sites - 1];
    return std::isinf(key) ? key : static_cast<float>(extent > 0 ? 100 * static_cast<double>(key) / extent : 0);
}

Status extractInto(const Model& model, const Progress& progress, HistoryPart& part)
{
    if (part.coarse.sites == 0)
        return inconsistentModel(model, Message::say("its first sites have an error"));
    if (const Status placed = placeSites(model, part.fine.sites, part.mesh.positions); !placed)
        return placed;
    if (const Status copied = copyValues(model, part.fine.sites, part.mesh.values); !copied)
        return copied;
    if (const Status scanned = HistoryScan(model, part).run(progress); !scanned)
        return scanned;
    turnToPhysicalSpace(model, part.mesh.tetrahedra);
    model.check(model.runningKeys()); // what it finds is known to checkIntact()
    const auto errors = [&model](const Buffer<std::uint32_t>& sites, Buffer<float>& result) {
        result.resize(sites.size());
        std::ranges::transform(sites, result.begin(), [&](std::uint32_t site) { return errorBefore(model, site); });
    };
    errors(part.births, part.birthErrors);
    errors(part.deaths, part.deathErrors);
    return model.checkIntact();
}

} // namespace

Result<HistoryPart> extractHistory(const Model& model, const Accuracy& one, const Accuracy& other,
                                   const Progress& progress)
{
    HistoryPart part;
    part.coarse = meshSizeAt(model, one);
    part.fine = meshSizeAt(model, other);
    if (part.coarse.sites > part.fine.sites)
        std::swap(part.coarse, part.fine);
    const Status extracted = guarded(
        Message::marked("Not enough memory for all meshes of up to %1 sites. Choose a larger error."),
        [&] { return extractInto(model, progress, part); }, part.fine.sites);
    if (!extracted)
        return extracted.error();
    return part;
}

namespace {

/// What is asked of tetrahedra besides their life.
class Choice {
public:
    Choice(std::span<const ValueRange> values, const std::optional<Window>& window, const TetrahedralMesh& mesh)
        : ranges_(values), values_(mesh.values)
    {
        if (window) {
            border_ = window->border;
            sides_.emplace(window->box, mesh.positions);
        }
    }

    bool includes(const Tetrahedron& t) const
    {
        if (!ranges_.empty() && !canContain({values_[t[0]], values_[t[1]], values_[t[2]], values_[t[3]]}, ranges_))
            return false;
        if (!sides_)
            return true;
        return border_ == WindowBorder::Contained ? sides_->placeOf(t) == BoxSides::Place::Inside : sides_->meets(t);
    }

private:
    std::span<const ValueRange> ranges_;
    std::span<const float> values_;
    WindowBorder border_ = WindowBorder::Intersecting;
    std::optional<BoxSides> sides_;
};

} // namespace

Result<ExtractedMesh> chooseLives(const HistoryPart& part, const MeshQuery& query, const Progress& progress)
{
    constexpr MarkedText choosingLives = Message::marked("Selecting tetrahedra by when they appear and disappear");
    constexpr std::size_t chosenAtOnce = 1 << 16;
    const LifeRange range = query.range.value_or(LifeRange());
    const Choice choice(query.values, query.window, part.mesh);
    ExtractedMesh chosen;
    chosen.mesh.positions = part.mesh.positions;
    chosen.mesh.values = part.mesh.values;
    chosen.sites.resize(part.mesh.positions.size());
    std::iota(chosen.sites.begin(), chosen.sites.end(), 0);
    float firstBirth = std::numeric_limits<float>::infinity(), lastDeath = 0;
    for (std::size_t t = 0; t < part.mesh.tetrahedra.size(); ++t) {
        if (t % chosenAtOnce == 0 && progress.cancelled())
            return cancelledError(choosingLives);
        const float birth = part.birthErrors[t], death = part.deathErrors[t];
        const bool lives = range.births.minimum < birth && birth <= range.births.maximum &&
                           range.deaths.minimum <= death && death <= range.deaths.maximum;
        if (!lives || !choice.includes(part.mesh.tetrahedra[t]))
            continue;
        chosen.mesh.tetrahedra.push_back(part.mesh.tetrahedra[t]);
        chosen.birthErrors.push_back(birth);
        chosen.deathErrors.push_back(death);
        firstBirth = std::min(firstBirth, birth);
        lastDeath = std::max(lastDeath, death);
    }
    chosen.overlaps = !chosen.mesh.tetrahedra.empty() && !(lastDeath < firstBirth);
    chosen.wholeSites = part.fine.sites;
    chosen.wholeTetrahedra = part.mesh.tetrahedra.size();
    chosen.keptTetrahedra = chosen.mesh.tetrahedra.size();
    dropUnusedVertices(chosen);
    return chosen;
}

} // namespace tetra
