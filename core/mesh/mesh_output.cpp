// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/mesh_output.h"

namespace tetra {

Result<MeshOutput> MeshOutput::create(const std::filesystem::path& path, std::uint64_t bytes, const Message& activity,
                                      const Progress& progress)
{
    auto file = FileWriter::create(path);
    if (!file)
        return file.error();
    return MeshOutput(*std::move(file), bytes, activity, progress);
}

Status MeshOutput::bytes(std::span<const std::byte> bytes)
{
    while (!bytes.empty()) {
        const std::size_t size = std::min(bytes.size(), pieceBytes);
        if (const Status written = piece(bytes.first(size)); !written)
            return written;
        bytes = bytes.subspan(size);
    }
    return {};
}

Status MeshOutput::piece(std::span<const std::byte> bytes)
{
    if (progress_->cancelled())
        return cancelledError(activity_);
    if (const Status written = file_.write(bytes); !written)
        return written;
    progress_->report(std::min(1.0, static_cast<double>(file_.size()) / static_cast<double>(total_)), activity_);
    return {};
}

} // namespace tetra
