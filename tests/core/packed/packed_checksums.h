// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/checksum.h"
#include "core/history/file_layout.h"
#include "core/history/format.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <span>

namespace tetra {

/// Makes all checksums of a packed file right, as somebody may who means harm; does nothing where its table makes no
/// sense.
inline void repairPackedChecksums(std::span<std::byte> file)
{
    format::Header header;
    if (file.size() < sizeof header)
        return;
    std::memcpy(static_cast<void*>(&header), file.data(), sizeof header);
    if (header.sectionCount > std::min<std::size_t>(16, (file.size() - sizeof header) / sizeof(format::Section)))
        return;
    const auto table = file.subspan(sizeof header, header.sectionCount * sizeof(format::Section));
    for (std::size_t number = 0; number < header.sectionCount; ++number) {
        format::Section section;
        std::memcpy(static_cast<void*>(&section), table.data() + number * sizeof section, sizeof section);
        if (section.offset > file.size() || section.bytes > file.size() - section.offset)
            continue;
        auto content = file.subspan(section.offset, section.bytes);
        if (section.id == static_cast<std::uint32_t>(format::SectionId::PackedChunks))
            for (auto rest = content; rest.size() >= sizeof(format::PackedChunkHead);) {
                format::PackedChunkHead head;
                std::memcpy(static_cast<void*>(&head), rest.data(), sizeof head);
                const std::size_t size = std::min<std::size_t>(head.bytes, rest.size() - sizeof head) + sizeof head;
                head.checksum = checksum(rest.subspan(sizeof head.checksum, size - sizeof head.checksum));
                std::memcpy(rest.data(), &head, sizeof head);
                rest = rest.subspan(size);
            }
        section.checksum = checksum(content);
        std::memcpy(table.data() + number * sizeof section, &section, sizeof section);
    }
    header.checksum = headerChecksum(header, table);
    std::memcpy(file.data(), &header, sizeof header);
}

} // namespace tetra
