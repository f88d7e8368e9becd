// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>

namespace tetra {

/// Bytes in a file of no name, mapped for reading and writing: like memory, but the system may put it on the disk when
/// memory is short. Zero at first; gone with the last copy. The room on the disk is taken at once.
class ScratchFile {
public:
    /// In `folder`. Errors: no room on the disk or in the address space.
    static Result<ScratchFile> create(const std::filesystem::path& folder, std::size_t bytes);

    template <class T> std::span<T> as() const noexcept
    {
        return {reinterpret_cast<T*>(bytes_.get()), size_ / sizeof(T)};
    }

private:
    ScratchFile() = default;

    std::shared_ptr<std::byte> bytes_;
    std::size_t size_ = 0;
};

} // namespace tetra
