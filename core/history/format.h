// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/data.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>

namespace tetra::format {

/// The `.tan` file as bytes; FORMAT.md explains every field. Little-endian throughout.
static_assert(std::endian::native == std::endian::little, "the file is mapped, not converted");
static_assert(std::numeric_limits<float>::is_iec559 && std::numeric_limits<double>::is_iec559);

constexpr std::array<char, 8> magic = {'\x89', 'T', 'A', 'N', '\r', '\n', '\x1a', '\n'};
constexpr std::uint16_t majorVersion = 1;
constexpr std::uint16_t minorVersion = 3;
/// Of files that have a section of this version (FORMAT.md, "Older files").
constexpr std::uint16_t minorVersionWithFrame = 4;
constexpr std::uint32_t byteOrderMark = 0x01020304;
constexpr std::uint32_t byteOrderMarkReversed = 0x04030201;

/// Sections begin at multiples of this; the bytes between them are zero.
constexpr std::uint64_t alignment = 64;
/// Limits that keep opening independent of the model's size.
constexpr std::uint32_t mostSections = 1024;
constexpr std::uint64_t longestText = 1 << 20;
/// Every section is summed up in chunks of so many bytes; readers take any power of two between the limits.
constexpr std::uint64_t chunkBytes = 256 << 10;
constexpr std::uint64_t leastChunkBytes = 64;
constexpr std::uint64_t mostChunkBytes = 1 << 30;

/// How a section's bytes are stored.
enum class Codec : std::uint32_t { None = 0 };

enum class SectionId : std::uint32_t {
    Text = 1,
    HistoryKind = 2,
    ChunkSums = 3,
    LevelIndex = 4,
    PackedFacts = 5, ///< this and the next three: of packed models alone
    PackedLevels = 6,
    PackedSums = 7,
    PackedChunks = 8,
    Frame = 9, ///< this and the next: of lattices alone
    Metric = 10,
    SitePoints = 16,
    SiteValues = 17,
    SiteRunningKeys = 18,
    StarOffsets = 19,
    MeshSizes = 20,
    SiteGroups = 21,
    SitePositions = 22,
    Samples = 23,
    SamplePositions = 24,
    OtherSites = 32,
    Destroyers = 33,
    OwnErrors = 34,
    OwnWarpings = 35,
    BatchEnds = 48,
    BatchErrors = 49,
    BatchWarpings = 50,
    Blocks = 51,
    Faults = 52,
    FaultyCells = 53,
};

/// What the section HistoryKind says; a file without it holds a history of Delaunay meshes.
enum class HistoryKind : std::uint32_t {
    ClosedSetsOnly = 1 ///< only closed sets of sites have a mesh: nothing can be inserted into one
};

/// The name that messages give a section.
std::string_view sectionName(std::uint32_t id) noexcept;

/// Flag of a section that a reader must understand to read the file rightly.
constexpr std::uint32_t required = 1;

struct Section {
    std::uint32_t id = 0;
    std::uint32_t flags = 0;
    std::uint32_t elementBytes = 0;
    std::uint32_t codec = 0;
    std::uint64_t offset = 0;
    std::uint64_t bytes = 0;
    std::uint64_t checksum = 0;
    std::array<std::uint64_t, 3> reserved{};
};
static_assert(sizeof(Section) == 64);

struct Header {
    std::array<char, 8> magic = format::magic;
    std::uint16_t majorVersion = format::majorVersion;
    std::uint16_t minorVersion = format::minorVersion;
    std::uint32_t byteOrderMark = format::byteOrderMark;
    std::uint32_t headerBytes = 256;
    std::uint32_t sectionCount = 0;
    std::uint64_t fileBytes = 0;
    std::uint32_t domainClass = 0;
    std::uint32_t sampleType = 0;
    std::array<std::uint32_t, 3> latticeSize{};
    std::uint32_t siteCount = 0;
    std::uint64_t tetrahedronCount = 0;
    std::array<double, 3> spacing{};
    std::array<double, 3> origin{};
    std::array<double, 2> valueRange{};
    std::array<double, 6> boundingBox{}; ///< minimum x y z, maximum x y z
    std::uint64_t sourceHash = 0;
    float finalKey = 0;
    std::uint32_t leftHanded = 0;
    double warpingWeight = 0;
    std::array<std::uint32_t, 12> reserved{};
    std::uint64_t checksum = 0; ///< XXH3 of the header up to here, followed by the section table
};
static_assert(sizeof(Header) == 256 && offsetof(Header, checksum) == 248);
static_assert(offsetof(Header, latticeSize) == 40 && offsetof(Header, spacing) == 64);
static_assert(offsetof(Header, sourceHash) == 176 && offsetof(Header, warpingWeight) == 192);

/// An entry of the level index: the mesh of the first `sites` sites, which end a batch.
struct LevelEntry {
    float key = 0;
    float error = 0;   ///< bounds, in units of the values and of length
    float warping = 0; ///< 0 without a warping weight
    std::uint32_t sites = 0;
    std::uint32_t tetrahedra = 0; ///< in the mesh
    std::uint32_t reserved = 0;
    std::uint64_t created = 0; ///< tetrahedra that the sites created
};
static_assert(sizeof(LevelEntry) == 32);

/// The index has room for so many.
constexpr std::uint64_t mostLevels = 256;

enum class FaultKind : std::uint32_t {
    FoldedCell = 1,         ///< of the grid
    CellWithoutVolume = 2,  ///< likewise
    InvertedTetrahedron = 3 ///< of the mesh of all sites
};

struct Fault {
    std::uint32_t kind = 0;
    std::uint32_t reserved = 0;
    std::uint64_t number = 0;
};
static_assert(sizeof(Fault) == 16);

/// A cell of the file that is no part of an irregular mesh.
struct FaultyCell {
    std::uint64_t number = 0;
    std::uint32_t fault = 0;   ///< CellFault
    std::uint32_t corners = 0; ///< 4 to 8: a tetrahedron, pyramid, prism or hexahedron, numbered as in VTK
    std::array<std::array<double, 3>, 8> places{}; ///< of the corners; 0 behind them
};
static_assert(sizeof(FaultyCell) == 208);

/// What a packed model says of itself and of the one that was packed.
struct PackedFacts {
    std::uint32_t method = 0;     ///< PackMethod
    std::uint32_t blockCells = 0; ///< along an edge of the blocks of a replayed model, 0 for none
    std::uint64_t fileBytes = 0;  ///< of the model that was packed, and its Header::checksum
    std::uint64_t headerChecksum = 0;
    std::array<std::uint64_t, 5> reserved{};
};
static_assert(sizeof(PackedFacts) == 64);

/// A mesh that the chunks up to here make.
struct PackedLevelEntry {
    float error = 0; ///< bounds, in units of the values and of length
    float warping = 0;
    std::uint32_t sites = 0;
    std::uint32_t replayLevel = 0; ///< of a replayed model: which one it is of those that it was packed in
    std::uint64_t chunkBytes = 0;  ///< of the chunks that it takes, from the first one on
};
static_assert(sizeof(PackedLevelEntry) == 24);

/// So many at most.
constexpr std::uint64_t mostPackedLevels = 512;

/// A section of the model that was packed.
struct PackedSum {
    std::uint32_t id = 0;
    std::uint32_t reserved = 0;
    std::uint64_t checksum = 0;
};
static_assert(sizeof(PackedSum) == 16);

/// Stands before a chunk's bytes.
struct PackedChunkHead {
    std::uint64_t checksum = 0; ///< XXH3 of all that follows: the rest of this, and the bytes
    std::uint32_t kind = 0;     ///< what the method makes of them
    std::uint32_t bytes = 0;
};
static_assert(sizeof(PackedChunkHead) == 16);

/// No chunk has more bytes.
constexpr std::uint32_t mostPackedChunkBytes = 1 << 20;

/// The number of chunks of a section of so many bytes.
constexpr std::uint64_t chunkCount(std::uint64_t sectionBytes, std::uint64_t chunk = chunkBytes) noexcept
{
    return (sectionBytes + chunk - 1) / chunk;
}

/// The next multiple of the alignment.
constexpr std::uint64_t aligned(std::uint64_t offset) noexcept
{
    return (offset + alignment - 1) / alignment * alignment;
}

} // namespace tetra::format
