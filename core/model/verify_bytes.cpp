// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/checksum.h"
#include "core/model/file_layout.h"
#include "core/model/shared_progress.h"
#include "core/model/verify_parts.h"

#include <algorithm>

namespace tetra {

namespace {

using format::Section;

/// Bytes summed up between two looks at whether the work was cancelled.
constexpr std::size_t bytesAtOnce = 64 << 20;

bool allZero(std::span<const std::byte> bytes)
{
    return std::ranges::all_of(bytes, [](std::byte byte) { return byte == std::byte{}; });
}

/// The checksums of the chunks of all sections but their own, in order, as the file gives them: none if it gives none.
struct StoredSums {
    std::uint64_t chunkBytes = 0;
    std::span<const std::uint64_t> left; ///< those of the sections that were not looked at yet
};

StoredSums storedSums(std::span<const std::byte> file, const FileLayout& layout)
{
    if (!layout.has(format::SectionId::ChunkSums))
        return {};
    const Section& section = layout.section(format::SectionId::ChunkSums);
    const std::span elements(reinterpret_cast<const std::uint64_t*>(file.data() + section.offset),
                             section.bytes / sizeof(std::uint64_t));
    return elements.empty() ? StoredSums() : StoredSums{elements.front(), elements.subspan(1)};
}

Status verifySection(const Section& section, std::span<const std::byte> bytes, StoredSums& stored,
                     std::vector<std::string>& failures, SharedProgress& progress)
{
    const bool hasChunks = stored.chunkBytes > 0 && section.id != std::uint32_t(format::SectionId::ChunkSums);
    const std::uint64_t atOnce = hasChunks ? stored.chunkBytes : bytesAtOnce;
    Checksum sum;
    std::uint64_t wrongChunks = 0;
    for (std::size_t at = 0; at < bytes.size(); at += atOnce) {
        if (progress.cancelled())
            return cancelledError("Verifying the model");
        const auto piece = bytes.subspan(at, std::min<std::size_t>(atOnce, bytes.size() - at));
        sum.add(piece);
        if (hasChunks) {
            wrongChunks += stored.left.empty() || checksum(piece) != stored.left.front() ? 1 : 0;
            stored.left = stored.left.subspan(stored.left.empty() ? 0 : 1);
        }
        progress.done(piece.size());
    }
    const std::string name = "Section '" + std::string(format::sectionName(section.id)) + "' (" +
                             std::to_string(bytes.size()) + " bytes at " + std::to_string(section.offset) + ")";
    if (sum.value() != section.checksum)
        failures.push_back(name + " is damaged: its checksum is wrong.");
    if (wrongChunks > 0)
        failures.push_back(name + " has " + std::to_string(wrongChunks) + " of " +
                           std::to_string(format::chunkCount(bytes.size(), atOnce)) +
                           " chunks that do not fit their checksums.");
    if (!allZero(std::as_bytes(std::span(section.reserved))) || (section.flags & ~format::required) != 0)
        failures.push_back(name + " has reserved fields that are not zero.");
    return {};
}

} // namespace

Status verifyBytes(const Model& model, std::vector<std::string>& failures, const Progress& progress)
{
    const std::span<const std::byte> file = model.fileBytes();
    const Result<FileLayout> layout = readLayout(file, model.path());
    if (!layout) {
        failures.push_back(layout.error().text);
        return {};
    }
    StoredSums stored = storedSums(file, *layout);
    SharedProgress shared(progress, file.size(), "Verifying checksums");
    std::uint64_t end = sizeof(format::Header) + layout->sections.size() * sizeof(Section);
    for (const Section& section : layout->sections) {
        if (!allZero(file.subspan(end, section.offset - end)))
            failures.push_back("The bytes from " + std::to_string(end) + " to " + std::to_string(section.offset) +
                               ", between two sections, are not zero.");
        end = section.offset + section.bytes;
        const auto bytes = file.subspan(section.offset, section.bytes);
        if (const Status done = verifySection(section, bytes, stored, failures, shared); !done)
            return done;
    }
    if (!allZero(std::as_bytes(std::span(layout->header.reserved))))
        failures.emplace_back("Reserved fields of the header are not zero.");
    return {};
}

} // namespace tetra
