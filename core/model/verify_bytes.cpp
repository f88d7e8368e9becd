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

Status verifySection(const Section& section, std::span<const std::byte> bytes, std::vector<std::string>& failures,
                     SharedProgress& progress)
{
    Checksum sum;
    for (std::size_t at = 0; at < bytes.size(); at += bytesAtOnce) {
        if (progress.cancelled())
            return cancelledError("Verifying the model");
        const auto piece = bytes.subspan(at, std::min(bytesAtOnce, bytes.size() - at));
        sum.add(piece);
        progress.done(piece.size());
    }
    const std::string name = "Section '" + std::string(format::sectionName(section.id)) + "' (" +
                             std::to_string(bytes.size()) + " bytes at " + std::to_string(section.offset) + ")";
    if (sum.value() != section.checksum)
        failures.push_back(name + " is damaged: its checksum is wrong.");
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
    SharedProgress shared(progress, file.size(), "Verifying checksums");
    std::uint64_t end = sizeof(format::Header) + layout->sections.size() * sizeof(Section);
    for (const Section& section : layout->sections) {
        if (!allZero(file.subspan(end, section.offset - end)))
            failures.push_back("The bytes from " + std::to_string(end) + " to " + std::to_string(section.offset) +
                               ", between two sections, are not zero.");
        end = section.offset + section.bytes;
        if (const Status done = verifySection(section, file.subspan(section.offset, section.bytes), failures, shared);
            !done)
            return done;
    }
    if (!allZero(std::as_bytes(std::span(layout->header.reserved))))
        failures.emplace_back("Reserved fields of the header are not zero.");
    return {};
}

} // namespace tetra
