// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/history/site_positions.h"

#include <algorithm>
#include <utility>

namespace tetra {

namespace {

Status placeLatticeSites(const Model& model, std::uint32_t sites, Buffer<Eigen::Vector3d>& positions)
{
    if (!model.check(model.points().first(sites)))
        return model.checkIntact();
    const Lattice& lattice = model.description().lattice;
    const LatticePoints lookUp(lattice);
    const std::uint32_t* const points = model.points().data();
    const std::uint64_t pointCount = lattice.pointCount();
    Eigen::Vector3d* const out = positions.data();
    bool outside = false;
    const auto place = [&](const auto& positionOf) {
        for (std::size_t site = 0; site < sites; ++site) {
            const std::uint32_t point = points[site];
            outside |= point >= pointCount;
            out[site] = positionOf(point);
        }
    };
    if (lattice.isAlongAxes())
        place([&](std::uint32_t point) { return lookUp.positionAlongAxes(point); });
    else
        place([&](std::uint32_t point) { return lookUp.position(point); });
    if (outside)
        return inconsistentModel(model, Message::say("a site is not a point of its lattice"));
    return {};
}

/// The first elements of the array that is there.
template <class T> bool copyFirst(const Model& model, std::span<const T> from, std::span<Eigen::Vector3d> to)
{
    if (from.empty())
        return true;
    for (std::size_t site = 0; site < to.size(); ++site)
        to[site] = from[site].template cast<double>();
    return model.check(from.first(to.size()));
}

} // namespace

Status placeSites(const Model& model, std::uint32_t sites, Buffer<Eigen::Vector3d>& positions)
{
    positions.resize(sites);
    if (model.description().domain == DomainClass::RegularLattice)
        return placeLatticeSites(model, sites, positions);
    if (!copyFirst(model, model.floatPositions(), positions) || !copyFirst(model, model.doublePositions(), positions))
        return model.checkIntact();
    return {};
}

Status copyValues(const Model& model, std::uint32_t sites, Buffer<float>& values)
{
    values.resize(sites);
    visitSampleType(model.description().sampleType, [&]<class T>() {
        const T* const samples = reinterpret_cast<const T*>(model.values().data());
        std::transform(samples, samples + sites, values.begin(), [](T sample) { return static_cast<float>(sample); });
    });
    const std::size_t bytes = sites * sampleSize(model.description().sampleType);
    return model.check(model.values().first(bytes)) ? Status() : model.checkIntact();
}

void turnToPhysicalSpace(const Model& model, std::span<std::array<std::uint32_t, 4>> tetrahedra)
{
    if (!model.description().leftHanded)
        return;
    for (std::array<std::uint32_t, 4>& tetrahedron : tetrahedra)
        std::swap(tetrahedron[2], tetrahedron[3]);
}

Error inconsistentModel(const Model& model, const Message& what)
{
    if (const Status intact = model.checkIntact(); !intact)
        return intact.error();
    return {ErrorKind::BadInput,
            Message::say("'%1' is damaged: %2. Copy the file again, or build it again.", model.path().string(), what),
            model.path()};
}

} // namespace tetra
