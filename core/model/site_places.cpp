// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/site_places.h"

#include "core/model/lattice_points.h"

#include <algorithm>
#include <utility>

namespace tetra {

namespace {

/// The sites 0, 1, 2 ... as a list.
struct FirstSites {
    std::size_t count;
    std::size_t size() const noexcept { return count; }
    std::size_t operator[](std::size_t i) const noexcept { return i; }
};

template <class Sites>
Status placeLatticeSites(const Model& model, const Sites& sites, Buffer<Eigen::Vector3f>& positions)
{
    const Lattice& lattice = model.description().lattice;
    const LatticePoints lookUp(lattice);
    const std::uint32_t* const points = model.points().data();
    const std::uint64_t pointCount = lattice.pointCount();
    Eigen::Vector3f* const out = positions.data();
    const std::size_t count = sites.size();
    bool outside = false;
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t point = points[sites[i]];
        outside |= point >= pointCount;
        out[i] = lookUp.position(point);
    }
    if (outside)
        return inconsistentModel(model, "a site is no point of its lattice");
    return {};
}

template <class Sites> Status place(const Model& model, const Sites& sites, Buffer<Eigen::Vector3f>& positions)
{
    positions.resize(sites.size());
    if (model.description().domain == DomainClass::RegularLattice)
        return placeLatticeSites(model, sites, positions);
    const Eigen::Vector3f* const floats = model.floatPositions().data();
    const Eigen::Vector3d* const doubles = model.doublePositions().data();
    Eigen::Vector3f* const out = positions.data();
    const std::size_t count = sites.size();
    if (!model.floatPositions().empty())
        for (std::size_t i = 0; i < count; ++i)
            out[i] = floats[sites[i]];
    else
        for (std::size_t i = 0; i < count; ++i)
            out[i] = doubles[sites[i]].template cast<float>();
    return {};
}

template <class Sites> void copy(const Model& model, const Sites& sites, Buffer<float>& values)
{
    values.resize(sites.size());
    visitSampleType(model.description().sampleType, [&]<class T>() {
        const T* const samples = reinterpret_cast<const T*>(model.values().data());
        float* const out = values.data();
        const std::size_t count = sites.size();
        for (std::size_t i = 0; i < count; ++i)
            out[i] = static_cast<float>(samples[sites[i]]);
    });
}

} // namespace

Status placeSites(const Model& model, std::uint32_t sites, Buffer<Eigen::Vector3f>& positions)
{
    return place(model, FirstSites{sites}, positions);
}

Status placeSites(const Model& model, std::span<const std::uint32_t> sites, Buffer<Eigen::Vector3f>& positions)
{
    const std::uint32_t count = model.siteCount();
    if (std::ranges::any_of(sites, [count](std::uint32_t site) { return site >= count; }))
        return inconsistentModel(model, "it has fewer sites than its numbers of sites say");
    return place(model, sites, positions);
}

void copyValues(const Model& model, std::uint32_t sites, Buffer<float>& values)
{
    copy(model, FirstSites{sites}, values);
}

void copyValues(const Model& model, std::span<const std::uint32_t> sites, Buffer<float>& values)
{
    copy(model, sites, values);
}

void turnToPhysicalSpace(const Model& model, std::span<std::array<std::uint32_t, 4>> tetrahedra)
{
    if (!model.description().leftHanded)
        return;
    for (std::array<std::uint32_t, 4>& tetrahedron : tetrahedra)
        std::swap(tetrahedron[2], tetrahedron[3]);
}

Error inconsistentModel(const Model& model, const std::string& what)
{
    if (const Status intact = model.checkIntact(); !intact)
        return intact.error();
    return {ErrorKind::BadInput, "'" + model.path().string() + "' is damaged: " + what +
                                     ". Copy it again from where it came from, or build it again."};
}

} // namespace tetra
