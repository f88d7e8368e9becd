// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/history/format.h"

#include <tan/base.h>
#include <tan/data.h>
#include <tan/model.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tetra {

/// The header and the section table of a `.tan` file, after all that can be checked without looking at a section:
/// version, checksum, sizes, bounds, overlaps, and that the counts of the header fit the sections.
struct FileLayout {
    format::Header header;
    std::vector<format::Section> sections; ///< known and unknown ones, in order of their offsets

    /// One of the sections that the domain requires; readLayout() made sure that it is there.
    const format::Section& section(format::SectionId id) const;
    bool has(format::SectionId id) const;
};

/// Reads nothing but the header and the table. Errors say what is wrong with the file at `path` and what to do.
Result<FileLayout> readLayout(std::span<const std::byte> file, const std::filesystem::path& path);
/// The same of a file of so many bytes of which `front` is the beginning: as many as frontBytes() says, or all.
Result<FileLayout> readLayout(std::span<const std::byte> front, std::uint64_t fileBytes,
                              const std::filesystem::path& path);
/// The bytes of header and table; those of the header alone if these are no more, or no header.
std::uint64_t frontBytes(std::span<const std::byte> front) noexcept;

/// Likewise of a packed model (FORMAT.md, "Packed form") of `fileBytes` bytes, of which `front` are the first: header
/// and table at least.
Result<FileLayout> readPackedLayout(std::span<const std::byte> front, std::uint64_t fileBytes,
                                    const std::filesystem::path& path);
/// Whether the table of a file that begins like this, as far as it is there, is that of a packed model.
bool isFrontOfPacked(std::span<const std::byte> front) noexcept;

/// The sites of the smallest mesh of such a domain: the corners of a lattice, or a tetrahedron.
constexpr std::uint32_t fewestSites(DomainClass domain) noexcept
{
    return isOnLattice(domain) ? 8 : 4;
}

/// The checksum that Header::checksum should have. `table` is the section table as it stands in the file.
std::uint64_t headerChecksum(const format::Header& header, std::span<const std::byte> table);

/// What the header says of the model; names and parameters are in the text section.
ModelDescription descriptionOf(const format::Header& header);
format::Header headerOf(const ModelDescription& description);

/// Takes over what a dataset says of itself.
void describeSource(ModelDescription& description, const Dataset& dataset);

/// The text section of a `.tan` file (FORMAT.md): a description's names and parameters. The Error is one of writing
/// `target`: they are too long.
Result<std::string> textOf(const ModelDescription& description, const std::filesystem::path& target);

/// Fills in names and parameters. Keys that it does not know and lines without a key are skipped.
void readText(std::string_view text, ModelDescription& description);

} // namespace tetra
