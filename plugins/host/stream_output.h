// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/output_file.h"

#include <tan/base.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace tetra {

/// What writers write into where a file goes to nowhere but an open descriptor: a pipe, or standard output in a file.
/// It goes in pieces of a quarter of a megabyte, after each of which it is told how far the writing is and looked
/// whether it should stop. What has gone cannot be taken back, so whoever reads hears of an error only from the program
/// itself.
class StreamOutput : public OutputFile {
public:
    /// The descriptor stays open. `name` is what messages call it; it ends as a file of the format does.
    StreamOutput(int descriptor, std::filesystem::path name, MarkedText activity, const Progress& progress)
        : descriptor_(descriptor), name_(std::move(name)), activity_(activity), progress_(progress)
    {
    }

    const std::filesystem::path& target() const override { return name_; }
    void expect(std::uint64_t bytes) override { expected_ = bytes; }
    Status bytes(std::span<const std::byte> bytes) override;
    /// An error: what comes out is one file.
    Result<OutputFile*> another(const std::filesystem::path& target) override;

    void remark(Message sentence) override { remarks_.push_back(std::move(sentence)); }

    const std::vector<Message>& remarks() const noexcept { return remarks_; }
    /// Lets the last piece go.
    Status finish() { return flush(); }

private:
    Status flush();
    Status put(std::span<const std::byte> bytes);

    int descriptor_;
    std::filesystem::path name_;
    MarkedText activity_;
    Progress progress_;
    std::uint64_t expected_ = 0;
    std::uint64_t written_ = 0;
    std::vector<std::byte> piece_;
    std::vector<Message> remarks_;
};

} // namespace tetra
