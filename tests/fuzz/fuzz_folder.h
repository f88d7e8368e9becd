// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <string_view>

#include <unistd.h>

namespace tetra {

/// A folder in memory for the fuzzers of readers that open files: one for each process, gone at its end.
class FuzzFolder {
public:
    FuzzFolder() : path_("/dev/shm/tan-fuzz-" + std::to_string(getpid())) { std::filesystem::create_directory(path_); }
    ~FuzzFolder()
    {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    FuzzFolder(const FuzzFolder&) = delete;
    FuzzFolder& operator=(const FuzzFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    /// Makes or replaces a file.
    std::filesystem::path write(std::string_view name, std::span<const std::byte> bytes) const
    {
        std::ofstream(path_ / name, std::ios::binary)
            .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
        return path_ / name;
    }

private:
    std::filesystem::path path_;
};

} // namespace tetra
