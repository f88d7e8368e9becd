// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/history/query/history_part.h"

#include "core/base/guarded.h"
#include "core/history/query/window.h"
#include "core/history/site_positions.h"
#include "core/history/walk.h"
#include "core/mesh/topology.h"

#include <algorithm>
#include <utility>

namespace tetra {

namespace {

constexpr MarkedText extractingRange = Message::marked("Extracting a range of meshes");

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

    bool includesAll() const { return ranges_.empty() && !sides_; }

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

/// Goes through the part of the file that the finer mesh needs.
class HistoryScan {
public:
    HistoryScan(const Model& model, const Choice& choice, HistoryPart& part)
        : model_(model), choice_(choice), part_(part)
    {
    }

    Status run(const Progress& progress);

private:
    Status makeRoom(const Progress& progress);
    Status keep(std::uint32_t creator, std::uint64_t tetrahedron, std::uint32_t destroyer);

    const Model& model_;
    const Choice& choice_;
    HistoryPart& part_;
    std::uint64_t inCoarse_ = 0;
    std::uint64_t inFine_ = 0;
};

Status HistoryScan::run(const Progress& progress)
{
    if (choice_.includesAll())
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
            model_,
            Message::say("the meshes of %1 and %2 sites do not have the %3 and %4 tetrahedra that they should have",
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
    const Tetrahedron found = {creator, a, b, c};
    if (!choice_.includes(found))
        return {};
    part_.mesh.tetrahedra.push_back(found);
    part_.births.push_back(creator + 1);
    part_.deaths.push_back(destroyer == Model::never ? Model::never : destroyer + 1);
    return {};
}

Status extractInto(const Model& model, std::span<const ValueRange> values, const std::optional<Window>& window,
                   const Progress& progress, HistoryPart& part)
{
    if (part.coarse.sites == 0)
        return inconsistentModel(model, Message::say("its first sites have an error"));
    if (const Status placed = placeSites(model, part.fine.sites, part.mesh.positions); !placed)
        return placed;
    if (const Status copied = copyValues(model, part.fine.sites, part.mesh.values); !copied)
        return copied;
    const Choice choice(values, window, part.mesh);
    if (const Status scanned = HistoryScan(model, choice, part).run(progress); !scanned)
        return scanned;
    turnToPhysicalSpace(model, part.mesh.tetrahedra);
    return model.checkIntact();
}

} // namespace

Result<HistoryPart> extractHistory(const Model& model, const Accuracy& one, const Accuracy& other,
                                   std::span<const ValueRange> values, const std::optional<Window>& window,
                                   const Progress& progress)
{
    if (window && window->border == WindowBorder::Clipped)
        return Error{ErrorKind::WrongUsage,
                     Message::say("Meshes of several accuracies cannot be cut at a window: what is cut has no life of "
                                  "its own. Ask for the tetrahedra that intersect the window, or that it contains.")};
    HistoryPart part;
    part.coarse = meshSizeAt(model, one);
    part.fine = meshSizeAt(model, other);
    if (part.coarse.sites > part.fine.sites)
        std::swap(part.coarse, part.fine);
    const Status extracted = guarded(
        Message::marked("Not enough memory for all meshes of up to %1 sites. Choose a larger error, or a window."),
        [&] { return extractInto(model, values, window, progress, part); }, part.fine.sites);
    if (!extracted)
        return extracted.error();
    return part;
}

} // namespace tetra
