// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/site_sections.h"

#include "core/data/grid_handedness.h"

#include <span>
#include <vector>

namespace tetra {

namespace {

/// Writes elementOf(point) for every site's point, a chunk at a time.
template <class Element, class Function> Status writeForEach(SectionWriter& sections, format::SectionId id,
                                                             const SpooledArray<std::uint32_t>& points,
                                                             Function&& elementOf)
{
    if (const Status begun = sections.begin(id, sizeof(Element)); !begun)
        return begun;
    std::vector<Element> elements;
    const Status written = points.forEachChunk([&](std::span<const std::uint32_t> chunk) {
        elements.clear();
        for (const std::uint32_t point : chunk)
            elements.push_back(elementOf(point));
        return sections.add(std::as_bytes(std::span(elements)));
    });
    sections.end();
    return written;
}

} // namespace

Status writeSiteValues(SectionWriter& sections, const Dataset& dataset, const SpooledArray<std::uint32_t>& points)
{
    return visitSampleType(dataset.values.type(), [&]<class T>() {
        const std::span<const T> samples = dataset.values.as<T>();
        return writeForEach<T>(sections, format::SectionId::SiteValues, points,
                               [samples](std::uint32_t point) { return samples[point]; });
    });
}

Status writeSitePositions(SectionWriter& sections, const Dataset& dataset, const SpooledArray<std::uint32_t>& points)
{
    const std::vector<Eigen::Vector3d>& positions = *dataset.positions;
    constexpr auto id = format::SectionId::SitePositions;
    if (fitFloats(positions))
        return writeForEach<Eigen::Vector3f>(sections, id, points, [&](std::uint32_t point) -> Eigen::Vector3f {
            return positions[point].cast<float>();
        });
    return writeForEach<Eigen::Vector3d>(sections, id, points, [&](std::uint32_t point) { return positions[point]; });
}

} // namespace tetra
