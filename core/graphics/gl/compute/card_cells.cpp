// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/gl/compute/card_cells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace tetra {
namespace {

/// As in setup.comp.
constexpr std::size_t texelsPerCell = 8;
constexpr std::size_t bytesPerCell = texelsPerCell * 16;
/// So few that drawing can stop soon where nothing more is seen; 4 MiB.
constexpr std::size_t mostCellsPerChunk = std::size_t(1) << 15;

/// The least float from a number on, and the largest up to it: a float is compared with these as with the number.
std::array<float, 2> floatsAround(double number)
{
    const auto nearest = static_cast<float>(number);
    constexpr float infinity = std::numeric_limits<float>::infinity();
    return {double(nearest) >= number ? nearest : std::nextafter(nearest, infinity),
            double(nearest) <= number ? nearest : std::nextafter(nearest, -infinity)};
}

std::size_t chunkSize(const GlFunctions& gl)
{
    int texels = 0;
    gl.getIntegerv(gl::maximumTextureBufferSize, &texels);
    return std::clamp<std::size_t>(static_cast<std::size_t>(std::max(texels, 0)) / texelsPerCell, 1, mostCellsPerChunk);
}

} // namespace

void CardCells::sendTransfer(const ComputeContext& context, const VolumeTransfer& transfer)
{
    std::vector<std::array<float, 2>> knots;
    std::vector<std::uint32_t> visibleBefore{0};
    for (const TransferSegment& segment : transfer.segments) {
        if (&segment != &transfer.segments.front())
            knots.push_back(floatsAround(segment.begin));
        visibleBefore.push_back(visibleBefore.back() + (segment.transparent() ? 0 : 1));
    }
    knots_.fill(context, std::as_bytes(std::span(knots)));
    visibleBefore_.fill(context, std::as_bytes(std::span(visibleBefore)));
    sentBytes_ = std::as_bytes(std::span(knots)).size() + std::as_bytes(std::span(visibleBefore)).size();
}

Status CardCells::choose(const ComputeContext& context, const ComputePrograms& programs, const CardMesh& mesh,
                         const CardKeys& keys, const VolumeTransfer& transfer, const SetView& setView)
{
    const std::size_t cells = mesh.cellCount;
    sendTransfer(context, transfer);
    projected_.reserve(context, mesh.vertexCount * 4 * sizeof(float));
    vertexSegments_.reserve(context, mesh.vertexCount * sizeof(std::uint32_t));
    segmentsOfCell_.reserve(context, cells * sizeof(std::uint32_t));
    shown_.reserve(context, (cells + 1) * sizeof(std::uint32_t));

    const auto use = [&](const GlProgram& program, std::size_t count) {
        program.use();
        setView(program);
        program.set("count", static_cast<unsigned>(count));
    };
    use(*programs.project, mesh.vertexCount);
    programs.project->set("knotCount", static_cast<unsigned>(transfer.segments.size() - 1));
    bindStorage(context, {&mesh.vertices, &projected_, &vertexSegments_, &knots_});
    runFor(context, mesh.vertexCount);

    use(*programs.classify, cells);
    bindStorage(context, {&mesh.corners, &projected_, &vertexSegments_, &visibleBefore_, &segmentsOfCell_, &shown_});
    runFor(context, cells + 1);
    sums_.run(context, *programs.sums, shown_, cells + 1);
    std::uint32_t count = 0;
    shown_.read(context, cells * sizeof count, std::as_writable_bytes(std::span(&count, 1)));
    if (Status status = checkDriver(context); !status)
        return status;

    count_ = std::min<std::size_t>(count, cells);
    sort_.reserve(context, count_);
    use(*programs.gather, cells);
    bindStorage(context, {&segmentsOfCell_, &shown_, &keys.keys(), &sort_.pairs()});
    runFor(context, cells);
    sort_.run(context, programs, count_, keys.bits());
    cellsPerChunk_ = chunkSize(context.gl);
    chunk_.reserve(context, std::min(cellsPerChunk_, count_) * bytesPerCell);
    chunk_.makeTexture(context, gl::rgba32ui);
    projected_.makeTexture(context, gl::rgba32f);
    return checkDriver(context);
}

std::size_t CardCells::chunkCount() const noexcept
{
    return (count_ + cellsPerChunk_ - 1) / cellsPerChunk_;
}

int CardCells::setUpChunk(const ComputeContext& context, const ComputePrograms& programs, const CardMesh& mesh,
                          std::size_t chunk)
{
    const std::size_t first = chunk * cellsPerChunk_;
    const std::size_t count = std::min(cellsPerChunk_, count_ - first);
    programs.setUp->use();
    programs.setUp->set("first", static_cast<unsigned>(first));
    programs.setUp->set("count", static_cast<unsigned>(count));
    bindStorage(context, {&sort_.pairs(), &mesh.corners, &projected_, &segmentsOfCell_, &chunk_});
    runFor(context, count);
    return static_cast<int>(count);
}

void CardCells::bindChunk(const GlProgram& program) const
{
    program.setTexture("projected", 3, projected_.texture(), gl::textureBuffer);
    program.setTexture("cells", 5, chunk_.texture(), gl::textureBuffer);
}

} // namespace tetra
