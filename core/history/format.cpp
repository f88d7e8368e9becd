// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/history/format.h"

namespace tetra::format {

std::string_view sectionName(std::uint32_t id) noexcept
{
    switch (static_cast<SectionId>(id)) {
    case SectionId::Text: return "text";
    case SectionId::HistoryKind: return "history kind";
    case SectionId::ChunkSums: return "chunk checksums";
    case SectionId::LevelIndex: return "level index";
    case SectionId::PackedFacts: return "packed facts";
    case SectionId::PackedLevels: return "packed levels";
    case SectionId::PackedSums: return "packed sums";
    case SectionId::PackedChunks: return "packed chunks";
    case SectionId::Frame: return "frame";
    case SectionId::Metric: return "metric";
    case SectionId::SitePoints: return "site points";
    case SectionId::SiteValues: return "site values";
    case SectionId::SiteRunningKeys: return "site running keys";
    case SectionId::StarOffsets: return "star offsets";
    case SectionId::MeshSizes: return "mesh sizes";
    case SectionId::SiteGroups: return "site groups";
    case SectionId::SitePositions: return "site positions";
    case SectionId::Samples: return "samples";
    case SectionId::SamplePositions: return "sample positions";
    case SectionId::OtherSites: return "other sites";
    case SectionId::Destroyers: return "destroyers";
    case SectionId::OwnErrors: return "own errors";
    case SectionId::OwnWarpings: return "own warpings";
    case SectionId::BatchEnds: return "batch ends";
    case SectionId::BatchErrors: return "batch errors";
    case SectionId::BatchWarpings: return "batch warpings";
    case SectionId::Blocks: return "blocks";
    case SectionId::Faults: return "faults";
    case SectionId::FaultyCells: return "faulty cells";
    }
    return "unknown";
}

} // namespace tetra::format
