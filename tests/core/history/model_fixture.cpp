// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/history/model_fixture.h"

#include "core/base/checksum.h"
#include "core/history/file_layout.h"
#include "core/history/model_writer.h"
#include "tests/core/history/reference_refinement.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>

namespace tetra {

Dataset bumps(SampleType type, std::array<std::uint32_t, 3> size)
{
    const Lattice lattice{size, {0.5, 2, 1.25}, {-3, 10, 0.1}};
    const bool isUnsigned = type == SampleType::UInt8 || type == SampleType::UInt16 || type == SampleType::UInt32;
    const double offset = isUnsigned ? 100 : 0;
    return visitSampleType(type, [&]<class T>() {
        const std::shared_ptr<T[]> samples(new T[lattice.pointCount()]);
        for (std::uint64_t point = 0; point < lattice.pointCount(); ++point) {
            const auto c = lattice.coordinates(point);
            const double value =
                std::sin(1.3 * c[0]) * std::cos(0.9 * c[1]) + 0.5 * std::sin(0.7 * c[2] + 0.2 * c[0] * c[1]);
            samples[point] =
                static_cast<T>(isInteger(type) ? std::round(value * 60 + offset) * (sizeof(T) == 4 ? 1e7 : 1) : value);
        }
        ScalarField field(type, lattice.pointCount(),
                          std::shared_ptr<const std::byte>(samples, reinterpret_cast<const std::byte*>(samples.get())));
        const std::uint64_t hash = checksum(field.bytes());
        return Dataset{.lattice = lattice,
                       .values = std::move(field),
                       .source = {"bumps \\ a=b\nof " + std::string(sampleTypeName(type)), {}, hash}};
    });
}

Dataset bentBumps(SampleType type, std::array<std::uint32_t, 3> size, bool precise, bool mirrored)
{
    Dataset dataset = bumps(type, size);
    auto positions = std::make_shared<std::vector<Eigen::Vector3d>>();
    for (std::uint64_t point = 0; point < dataset.pointCount(); ++point) {
        const auto c = dataset.lattice.coordinates(point);
        const double angle = 0.07 * c[0];
        const double radius = 9 + 0.8 * c[1] + 0.1 * std::sin(1.7 * c[2]);
        Eigen::Vector3d place(-radius * std::cos(angle), radius * std::sin(angle), 1.5 * c[2] + 0.02 * c[0] * c[1]);
        if (mirrored)
            place[0] = -place[0];
        positions->push_back(precise ? place : place.cast<float>().cast<double>());
    }
    dataset.domain = DomainClass::Curvilinear;
    dataset.lattice = {dataset.lattice.size, {1, 1, 1}, {0, 0, 0}};
    dataset.positions = positions;
    dataset.source.name = "bent " + dataset.source.name;
    dataset.source.hash = contentHash(dataset.values, dataset.positions);
    return dataset;
}

Dataset faultyGrid()
{
    Dataset dataset = bentBumps(SampleType::Float32, {5, 4, 5});
    auto positions = std::make_shared<std::vector<Eigen::Vector3d>>(*dataset.positions);
    const auto at = [&](std::uint32_t i, std::uint32_t j, std::uint32_t k) -> Eigen::Vector3d& {
        return (*positions)[dataset.lattice.index(i, j, k)];
    };
    at(2, 1, 2) += Eigen::Vector3d(0, 0, -4);
    for (const std::uint32_t i : {0u, 1u})
        for (const std::uint32_t k : {3u, 4u})
            at(i, 3, k) = at(i, 2, k); // the cell (0, 2, 3) is flat
    dataset.positions = positions;
    dataset.source.hash = contentHash(dataset.values, dataset.positions);
    return dataset;
}

Status RecordedSteps::begin(const HistoryTraits& given)
{
    traits = given;
    return {};
}

Status RecordedSteps::add(const HistoryStep& step)
{
    steps.push_back({step.point,
                     step.keyBefore,
                     {step.star.begin(), step.star.end()},
                     {step.destroyed.begin(), step.destroyed.end()}});
    return {};
}

Status RecordedSteps::finish(float error)
{
    finalKey = error;
    return {};
}

std::vector<std::array<std::uint32_t, 4>> RecordedSteps::meshOf(std::size_t sites) const
{
    std::map<std::uint32_t, std::array<std::uint32_t, 4>> alive;
    std::uint32_t next = 0;
    for (std::uint32_t site = 0; site < sites; ++site) {
        for (const std::uint32_t destroyed : steps[site].destroyed)
            alive.erase(destroyed);
        for (const HistoryTetrahedron& t : steps[site].star)
            alive[next++] = {site, t.sites[0], t.sites[1], t.sites[2]};
    }
    std::vector<std::array<std::uint32_t, 4>> mesh;
    for (const auto& [number, tetrahedron] : alive)
        mesh.push_back(tetrahedron);
    return mesh;
}

std::vector<std::uint32_t> RecordedSteps::points() const
{
    std::vector<std::uint32_t> points;
    for (const Step& step : steps)
        points.push_back(static_cast<std::uint32_t>(step.point));
    return points;
}

TetrahedraByPoints byPoints(std::span<const std::array<std::uint32_t, 4>> tetrahedra,
                            std::span<const std::uint32_t> points)
{
    TetrahedraByPoints result;
    for (const auto& t : tetrahedra) {
        result.push_back({points[t[0]], points[t[1]], points[t[2]], points[t[3]]});
        std::ranges::sort(result.back());
    }
    std::ranges::sort(result);
    return result;
}

bool endsBatch(const Model& model, std::uint32_t sites)
{
    return sites == 0 || sites == model.siteCount() || model.runningKeys()[sites] < model.runningKeys()[sites - 1];
}

const RecordedSteps& historyOf(const Dataset& dataset)
{
    static std::map<std::uint64_t, RecordedSteps> known;
    const auto [place, isNew] = known.try_emplace(dataset.source.hash);
    if (isNew && !refineSlowly(dataset, place->second))
        std::abort();
    return place->second;
}

Status replay(const RecordedSteps& history, HistorySink& sink)
{
    if (const Status begun = sink.begin(history.traits); !begun)
        return begun;
    for (const RecordedSteps::Step& step : history.steps)
        if (const Status added = sink.add({step.point, step.keyBefore, step.star, step.destroyed}); !added)
            return added;
    return sink.finish(history.finalKey);
}

void writeModel(const std::filesystem::path& path, const Dataset& dataset)
{
    ModelDescription description;
    description.builder = "slow";
    description.parameters = {{"stop=error", "0"}, {"note", "two\nlines \\n"}};
    auto writer = ModelWriter::create(path, dataset, description);
    if (!writer || !replay(historyOf(dataset), **writer))
        std::abort();
}

std::vector<std::byte> readBytes(const std::filesystem::path& path)
{
    std::ifstream stream(path, std::ios::binary);
    const std::vector<char> chars{std::istreambuf_iterator<char>(stream), {}};
    const auto bytes = std::as_bytes(std::span(chars));
    return {bytes.begin(), bytes.end()};
}

void writeBytes(const std::filesystem::path& path, std::span<const std::byte> bytes)
{
    std::ofstream stream(path, std::ios::binary | std::ios::trunc);
    stream.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

std::span<format::Section> FileParts::sections()
{
    return {reinterpret_cast<format::Section*>(content.data() + sizeof(format::Header)), header().sectionCount};
}

format::Section& FileParts::section(format::SectionId id)
{
    return *std::ranges::find(sections(), static_cast<std::uint32_t>(id), &format::Section::id);
}

std::span<const std::byte> FileParts::bytesOf(const format::Section& section) const
{
    const bool lies = section.offset <= content.size() && section.bytes <= content.size() - section.offset;
    return lies ? std::span(content).subspan(section.offset, section.bytes) : std::span<const std::byte>();
}

std::vector<std::uint64_t> FileParts::chunkSums(std::uint64_t chunkBytes)
{
    std::vector<std::uint64_t> sums{chunkBytes};
    for (const format::Section& section : sections()) {
        if (section.id == std::uint32_t(format::SectionId::ChunkSums))
            continue;
        const std::span<const std::byte> bytes = bytesOf(section);
        for (std::size_t at = 0; at < bytes.size(); at += chunkBytes)
            sums.push_back(checksum(bytes.subspan(at, std::min<std::size_t>(chunkBytes, bytes.size() - at))));
    }
    return sums;
}

void FileParts::repairChecksums()
{
    const std::uint64_t front = sizeof(format::Header) + sections().size_bytes();
    for (const format::Section& section : sections()) {
        const bool lies = section.offset >= front && bytesOf(section).size() >= sizeof(std::uint64_t);
        if (section.id != std::uint32_t(format::SectionId::ChunkSums) || !lies)
            continue;
        std::uint64_t chunkBytes = 0;
        std::memcpy(&chunkBytes, content.data() + section.offset, sizeof chunkBytes);
        const std::vector<std::uint64_t> sums = chunkSums(std::clamp<std::uint64_t>(chunkBytes, 64, 1 << 30));
        std::memcpy(content.data() + section.offset + 8, sums.data() + 1,
                    std::min<std::size_t>(sums.size() * 8, section.bytes) - 8); // its first number stays as it is
    }
    for (format::Section& section : sections())
        if (section.bytes == 0 || !bytesOf(section).empty())
            section.checksum = checksum(bytesOf(section));
    repairHeader();
}

void FileParts::repairHeader()
{
    Checksum sum;
    sum.add(std::span(content).first(offsetof(format::Header, checksum)));
    sum.add(std::as_bytes(sections()));
    header().checksum = sum.value();
}

void FileParts::setChunkBytes(std::uint64_t bytes)
{
    const std::vector<std::uint64_t> sums = chunkSums(bytes);
    format::Section& last = section(format::SectionId::ChunkSums);
    last.bytes = sums.size() * sizeof sums[0];
    const std::uint64_t begin = last.offset, end = begin + last.bytes;
    content.resize(end); // the table of sections is part of it, too
    std::memcpy(content.data() + begin, sums.data(), end - begin);
    header().fileBytes = content.size();
    repairChecksums();
}

void FileParts::removeChunkSums()
{
    const format::Section& last = sections().back(); // its entry in the table becomes a gap
    if (last.id != std::uint32_t(format::SectionId::ChunkSums))
        std::abort();
    const format::Section& before = sections()[sections().size() - 2];
    content.resize(before.offset + before.bytes);
    std::memset(content.data() + sizeof(format::Header) + (sections().size() - 1) * sizeof last, 0, sizeof last);
    --header().sectionCount;
    header().minorVersion = 2;
    header().fileBytes = content.size();
    repairChecksums();
}

void FileParts::addSection(std::uint32_t id, std::uint32_t flags)
{
    const std::size_t end = sizeof(format::Header) + sections().size() * sizeof(format::Section);
    format::Section added;
    added.id = id;
    added.flags = flags;
    for (format::Section& section : sections())
        section.offset += sizeof added;
    content.insert(content.begin() + static_cast<std::ptrdiff_t>(end), sizeof added, std::byte{});
    content.resize(format::aligned(content.size()));
    added.offset = content.size();
    std::memcpy(content.data() + end, &added, sizeof added);
    ++header().sectionCount;
    header().fileBytes = content.size();
}

} // namespace tetra
