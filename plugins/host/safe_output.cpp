// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/host/safe_output.h"

#include <algorithm>
#include <iterator>

namespace tetra {

Result<std::unique_ptr<SafeOutput>> SafeOutput::create(const std::filesystem::path& target, MarkedText activity,
                                                       const Progress& progress)
{
    auto file = FileWriter::create(target);
    if (!file)
        return file.error();
    return std::unique_ptr<SafeOutput>(new SafeOutput(*std::move(file), target, activity, progress));
}

Status SafeOutput::bytes(std::span<const std::byte> bytes)
{
    constexpr std::size_t pieceBytes = 1 << 18;
    while (!bytes.empty()) {
        if (progress_.cancelled())
            return cancelledError(activity_);
        const std::size_t size = std::min(bytes.size(), pieceBytes);
        if (const Status written = file_.write(bytes.first(size)); !written)
            return written;
        bytes = bytes.subspan(size);
        const std::uint64_t expected = first_->expected_;
        if (expected > 0)
            progress_.report(std::min(1.0, static_cast<double>(first_->written()) / static_cast<double>(expected)),
                             activity_);
    }
    return {};
}

Result<OutputFile*> SafeOutput::another(const std::filesystem::path& target)
{
    auto file = create(target, activity_, progress_);
    if (!file)
        return file.error();
    (*file)->first_ = first_;
    others_.push_back(*std::move(file));
    return others_.back().get();
}

std::uint64_t SafeOutput::written() const
{
    std::uint64_t bytes = file_.size();
    for (const auto& other : others_)
        bytes += other->written();
    return bytes;
}

std::vector<Message> SafeOutput::remarks() const
{
    std::vector<Message> all = remarks_;
    for (const auto& other : others_)
        std::ranges::move(other->remarks(), std::back_inserter(all));
    return all;
}

Status SafeOutput::commit()
{
    for (const auto& other : others_)
        if (const Status committed = other->commit(); !committed)
            return committed;
    return file_.commit();
}

} // namespace tetra
