// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/planned_model_writer.h"

#include "core/model/description_text.h"
#include "core/model/file_layout.h"
#include "core/model/sample_section.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <new>

namespace tetra {

using format::SectionId;

Result<std::unique_ptr<PlannedModelWriter>>
PlannedModelWriter::create(const std::filesystem::path& path, const Dataset& dataset, ModelDescription description,
                           const PlannedCounts& counts, const std::filesystem::path& workFolder)
{
    describeSource(description, dataset);
    Result<FileWriter> file = FileWriter::create(path, 1, workFolder);
    if (!file)
        return file.error();
    try {
        std::unique_ptr<PlannedModelWriter> writer(
            new PlannedModelWriter(std::move(*file), dataset, std::move(description), counts));
        if (const Status begun = writer->begin(); !begun)
            return begun.error();
        return writer;
    } catch (const std::bad_alloc&) {
        return Error{ErrorKind::OutOfResource,
                     "Not enough memory to write '" + path.string() + "'. Close other programs."};
    }
}

PlannedModelWriter::PlannedModelWriter(FileWriter file, const Dataset& dataset, ModelDescription description,
                                       const PlannedCounts& counts)
    : target_(file.target()), sections_(std::move(file)), dataset_(dataset), description_(std::move(description)),
      planned_(counts)
{
}

Status PlannedModelWriter::begin()
{
    const Result<std::string> text = textOf(description_, target_);
    if (!text)
        return text.error();
    const auto sampleBytes = static_cast<std::uint32_t>(sampleSize(dataset_.values.type()));
    std::vector<PlannedSection> sections = {{SectionId::Text, 1, text->size()},
                                            {SectionId::SitePoints, 4, planned_.sites},
                                            {SectionId::SiteValues, sampleBytes, planned_.sites},
                                            {SectionId::SiteRunningErrors, 4, planned_.sites},
                                            {SectionId::StarOffsets, 8, planned_.sites + 1ull},
                                            {SectionId::MeshSizes, 4, planned_.sites},
                                            {SectionId::SiteGroups, 1, planned_.sites},
                                            {SectionId::OtherSites, 12, planned_.tetrahedra},
                                            {SectionId::Destroyers, 4, planned_.tetrahedra},
                                            {SectionId::OwnErrors, 2, planned_.tetrahedra}};
    if (samplesKept())
        sections.push_back({SectionId::Samples, sampleBytes, dataset_.pointCount(), 0});
    if (const Status planned = sections_.plan(sections); !planned)
        return planned;
    return sections_.add(SectionId::Text, std::as_bytes(std::span(*text)));
}

Status PlannedModelWriter::add(const PlannedStars& stars)
{
    if (stars.points.size() > planned_.sites - added_.sites ||
        stars.otherSites.size() > planned_.tetrahedra - added_.tetrahedra)
        return notAsPlanned();
    for (const Status& written : {sections_.add(SectionId::SitePoints, std::as_bytes(stars.points)),
                                  sections_.add(SectionId::SiteRunningErrors, std::as_bytes(stars.runningKeys)),
                                  sections_.add(SectionId::MeshSizes, std::as_bytes(stars.meshSizes)),
                                  sections_.add(SectionId::SiteGroups, std::as_bytes(stars.groupGoesOn)),
                                  sections_.add(SectionId::OtherSites, std::as_bytes(stars.otherSites)),
                                  sections_.add(SectionId::Destroyers, std::as_bytes(stars.destroyers)),
                                  sections_.add(SectionId::OwnErrors, std::as_bytes(stars.ownErrors)),
                                  addOffsets(stars.starSizes), addValues(stars.points)})
        if (!written)
            return written;
    return {};
}

Status PlannedModelWriter::addOffsets(std::span<const std::uint32_t> starSizes)
{
    offsets_.clear();
    for (const std::uint32_t size : starSizes) {
        offsets_.push_back(added_.tetrahedra);
        added_.tetrahedra += size;
    }
    added_.sites += static_cast<std::uint32_t>(starSizes.size());
    return sections_.add(SectionId::StarOffsets, std::as_bytes(std::span(offsets_)));
}

Status PlannedModelWriter::addValues(std::span<const std::uint32_t> points)
{
    return visitSampleType(dataset_.values.type(), [&]<class T>() {
        const std::span<const T> samples = dataset_.values.as<T>();
        values_.resize(points.size() * sizeof(T));
        for (std::size_t i = 0; i < points.size(); ++i)
            std::memcpy(values_.data() + i * sizeof(T), &samples[points[i]], sizeof(T));
        return sections_.add(SectionId::SiteValues, values_);
    });
}

Status PlannedModelWriter::finish(float finalKey)
{
    if (added_.sites != planned_.sites || added_.tetrahedra != planned_.tetrahedra || !(finalKey >= 0) ||
        !std::isfinite(finalKey))
        return notAsPlanned();
    const std::uint64_t end = added_.tetrahedra;
    if (const Status written = sections_.add(SectionId::StarOffsets, std::as_bytes(std::span(&end, 1))); !written)
        return written;
    if (samplesKept()) {
        const Status written = writeSamples(dataset_.values, [this](std::span<const std::byte> piece) {
            return sections_.add(SectionId::Samples, piece);
        });
        if (!written)
            return written;
    }
    format::Header header = headerOf(description_);
    header.siteCount = planned_.sites;
    header.tetrahedronCount = planned_.tetrahedra;
    header.finalError = finalKey;
    if (const Status intact = dataset_.checkIntact(); !intact)
        return intact;
    return sections_.finish(header);
}

bool PlannedModelWriter::samplesKept() const noexcept
{
    return keepsSamples(dataset_.domain, dataset_.values.type(), 0, dataset_.pointCount(),
                        {planned_.sites, planned_.tetrahedra});
}

std::uint64_t PlannedModelWriter::expectedBytes(const PlannedCounts& counts, SampleType type,
                                                std::uint64_t points) noexcept
{
    constexpr std::uint64_t frontAndText = 4096;
    const ModelCounts whole{counts.sites, counts.tetrahedra};
    const bool samples = keepsSamples(DomainClass::RegularLattice, type, 0, points, whole);
    const std::uint64_t content = arrayBytes(whole, type) + (samples ? points * sampleSize(type) : 0);
    return content + format::chunkCount(content) * sizeof(std::uint64_t) + frontAndText;
}

Error PlannedModelWriter::notAsPlanned() const
{
    return {ErrorKind::BadInput, "The builder '" + description_.builder +
                                     "' made another history than it had announced. Nothing was written; report this "
                                     "to its author."};
}

} // namespace tetra
