// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/extraction.h"

#include "core/model/lattice_points.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <string>

namespace tetra {

namespace {

using Tetrahedron = std::array<std::uint32_t, 4>;

/// What is scanned before its result is checked: little enough for the result to be in the cache still.
constexpr std::uint64_t tetrahedraAtOnce = 1 << 12;
/// Pieces between two looks at whether the work was cancelled.
constexpr std::uint64_t piecesAtOnce = 64;
/// Room behind the mesh for tetrahedra that are written before it is known that they are dead.
constexpr std::uint64_t slack = 1 << 10;

Error inconsistent(const Model& model, const std::string& what)
{
    if (const Status intact = model.checkIntact(); !intact)
        return intact.error();
    return {ErrorKind::BadInput, "'" + model.path().string() + "' is damaged: " + what +
                                     ". Copy it again from where it came from, or build it again."};
}

/// Writes the tetrahedra of one star that are alive in the mesh of `sites` sites to `out`, which has room for all of
/// them, and returns the end. Which ones are alive follows no pattern that a processor could predict: every one is
/// written, and the next one goes over it if it was dead.
Tetrahedron* copyAlive(const Model& model, std::uint32_t creator, std::uint64_t begin, std::uint64_t end,
                       std::uint32_t sites, Tetrahedron* out)
{
    const std::array<std::uint32_t, 3>* const others = model.otherSites().data();
    const std::uint32_t* const destroyers = model.destroyers().data();
    for (std::uint64_t t = begin; t < end; ++t) {
        *out = {creator, others[t][0], others[t][1], others[t][2]};
        out += destroyers[t] >= sites;
    }
    return out;
}

/// No site of a tetrahedron may come after its creator: then it lies in the mesh, too.
bool creatorsAreLatest(std::span<const Tetrahedron> tetrahedra)
{
    std::uint32_t wrong = 0;
    for (const Tetrahedron& t : tetrahedra)
        wrong |= std::uint32_t(t[1] >= t[0]) | std::uint32_t(t[2] >= t[0]) | std::uint32_t(t[3] >= t[0]);
    return wrong == 0;
}

/// Takes the mesh out of the file star by star.
class PrefixScan {
public:
    PrefixScan(const Model& model, std::uint32_t sites, Buffer<Tetrahedron>& out)
        : model_(model), sites_(sites), expected_(model.meshSizes()[sites - 1]), out_(out)
    {
    }

    Status run(const Progress& progress);

private:
    Status scanSites(std::uint32_t& site, std::uint64_t until);
    Status scanLongStar(std::uint32_t site, std::uint64_t begin, std::uint64_t end);

    const Model& model_;
    const std::uint32_t sites_;
    const std::uint64_t expected_; ///< tetrahedra in the mesh, as the file says
    Buffer<Tetrahedron>& out_;
    std::uint64_t found_ = 0;
};

Status PrefixScan::run(const Progress& progress)
{
    const std::uint64_t scanned = model_.starOffsets()[sites_];
    if (scanned > model_.tetrahedronCount() || expected_ > scanned || model_.starOffsets()[0] != 0)
        return inconsistent(model_, "its star offsets do not fit its mesh sizes");
    out_.resize(expected_ + slack);
    std::uint32_t site = 0;
    for (std::uint64_t piece = 0; site < sites_; ++piece) {
        const std::uint64_t begin = model_.starOffsets()[site];
        if (piece % piecesAtOnce == 0) {
            if (progress.cancelled())
                return cancelledError("Extracting the mesh");
            progress.report(static_cast<double>(begin) / static_cast<double>(std::max<std::uint64_t>(scanned, 1)),
                            "Extracting the mesh");
        }
        const std::uint64_t foundBefore = found_;
        if (const Status right = scanSites(site, begin + tetrahedraAtOnce); !right)
            return right;
        if (!creatorsAreLatest(std::span(out_).subspan(foundBefore, found_ - foundBefore)))
            return inconsistent(model_, "a tetrahedron before site " + std::to_string(site) +
                                            " has a site that comes after its creator");
    }
    if (found_ != expected_)
        return inconsistent(model_, "the mesh of " + std::to_string(sites_) + " sites has " + std::to_string(found_) +
                                        " tetrahedra instead of " + std::to_string(expected_));
    out_.resize(found_);
    return {};
}

/// Goes on from `site` to the first one whose star begins at `until` or later.
Status PrefixScan::scanSites(std::uint32_t& site, std::uint64_t until)
{
    const std::uint64_t* const offsets = model_.starOffsets().data();
    const std::uint64_t last = offsets[sites_];
    for (; site < sites_ && offsets[site] < until; ++site) {
        const std::uint64_t begin = offsets[site];
        const std::uint64_t end = offsets[site + 1];
        if (end < begin || end > last)
            return inconsistent(model_, "the star offsets of site " + std::to_string(site) + " make no sense");
        if (end - begin > out_.size() - found_) {
            if (const Status right = scanLongStar(site, begin, end); !right)
                return right;
            continue;
        }
        Tetrahedron* const first = out_.data() + found_;
        found_ += static_cast<std::uint64_t>(copyAlive(model_, site, begin, end, sites_, first) - first);
    }
    return {};
}

/// A star that may have more tetrahedra than there is room for: looks before it writes.
Status PrefixScan::scanLongStar(std::uint32_t site, std::uint64_t begin, std::uint64_t end)
{
    for (std::uint64_t t = begin; t < end; ++t) {
        if (model_.destroyers()[t] < sites_)
            continue;
        if (found_ == expected_)
            return inconsistent(model_, "the mesh of " + std::to_string(sites_) + " sites has more than the " +
                                            std::to_string(expected_) + " tetrahedra that it should have");
        const std::array<std::uint32_t, 3>& others = model_.otherSites()[t];
        out_[found_++] = {site, others[0], others[1], others[2]};
    }
    return {};
}

/// Fills in where the sites lie.
Status placeSites(const Model& model, std::uint32_t sites, Buffer<Eigen::Vector3f>& positions)
{
    const Lattice& lattice = model.description().lattice;
    const LatticePoints lookUp(lattice);
    const std::uint32_t* const points = model.points().data();
    const std::uint64_t pointCount = lattice.pointCount();
    positions.resize(sites);
    bool outside = false;
    for (std::uint32_t site = 0; site < sites; ++site) {
        outside |= points[site] >= pointCount;
        positions[site] = lookUp.position(points[site]);
    }
    if (outside)
        return inconsistent(model, "a site is no point of its lattice");
    return {};
}

void copyValues(const Model& model, std::uint32_t sites, Buffer<float>& values)
{
    values.resize(sites);
    visitSampleType(model.description().sampleType, [&]<class T>() {
        const T* const samples = reinterpret_cast<const T*>(model.values().data());
        std::transform(samples, samples + sites, values.begin(), [](T sample) { return static_cast<float>(sample); });
    });
}

Status extractInto(const Model& model, std::uint32_t sites, const Progress& progress, TetrahedralMesh& mesh)
{
    if (sites == 0) {
        mesh = {};
        return {};
    }
    if (const Status scanned = PrefixScan(model, sites, mesh.tetrahedra).run(progress); !scanned)
        return scanned;
    if (const Status placed = placeSites(model, sites, mesh.positions); !placed)
        return placed;
    copyValues(model, sites, mesh.values);
    return model.checkIntact();
}

} // namespace

MeshSize meshSizeAt(const Model& model, const Accuracy& accuracy)
{
    const double extent = model.description().range.extent();
    const double asked = accuracy.error / 100 * extent;
    const std::span<const float> errors = model.runningErrors();
    // The mesh of the first N sites has the error that was there before site N entered. Infinity is no mesh yet.
    const auto reached = std::ranges::partition_point(
        errors, [asked](float error) { return std::isinf(error) || !(static_cast<double>(error) <= asked); });
    const auto sites = static_cast<std::uint32_t>(reached - errors.begin());
    if (sites == 0) // only in a damaged file: the initial sites have no error
        return {};
    const float error = reached == errors.end() ? std::min(model.finalError(), errors.back()) : *reached;
    return {sites, model.meshSizes()[sites - 1], extent > 0 ? 100 * static_cast<double>(error) / extent : 0};
}

Result<TetrahedralMesh> extractPrefix(const Model& model, std::uint32_t sites, const Progress& progress,
                                      TetrahedralMesh reuse)
{
    if (sites > model.siteCount())
        return Error{ErrorKind::WrongUsage, "'" + model.path().string() + "' has " + std::to_string(model.siteCount()) +
                                                " sites, fewer than the " + std::to_string(sites) + " asked for."};
    try {
        if (const Status extracted = extractInto(model, sites, progress, reuse); !extracted)
            return extracted.error();
    } catch (const std::bad_alloc&) {
        return Error{ErrorKind::OutOfResource,
                     "Not enough memory for a mesh of " + std::to_string(sites) + " sites. Choose a larger error."};
    }
    return reuse;
}

} // namespace tetra
