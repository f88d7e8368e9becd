// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/site_sections.h"

#include "core/data/grid_handedness.h"

#include <algorithm>
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

std::size_t positionBytes(const Dataset& dataset)
{
    if (dataset.domain == DomainClass::RegularLattice)
        return 0;
    return fitFloats(*dataset.positions) ? sizeof(Eigen::Vector3f) : sizeof(Eigen::Vector3d);
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

Status writeSamplePositions(SectionWriter& sections, const Dataset& dataset)
{
    constexpr std::size_t atOnce = 1 << 15;
    const std::span<const Eigen::Vector3d> positions = *dataset.positions;
    const bool floats = positionBytes(dataset) == sizeof(Eigen::Vector3f);
    if (const Status begun = sections.begin(format::SectionId::SamplePositions, positionBytes(dataset), 0); !begun)
        return begun;
    std::vector<Eigen::Vector3f> rounded;
    for (std::size_t first = 0; first < positions.size(); first += atOnce) {
        const auto piece = positions.subspan(first, std::min(atOnce, positions.size() - first));
        rounded.clear();
        if (floats)
            for (const Eigen::Vector3d& position : piece)
                rounded.push_back(position.cast<float>());
        const Status written =
            sections.add(floats ? std::as_bytes(std::span<const Eigen::Vector3f>(rounded)) : std::as_bytes(piece));
        if (!written)
            return written;
    }
    sections.end();
    return {};
}

} // namespace tetra
