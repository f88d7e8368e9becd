// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>

namespace tetra {

/// Whether a file that begins so is NetCDF in one of the classic formats: CDF-1, 64-bit offset, CDF-5.
bool isClassicNetCdf(std::span<const std::byte> firstBytes) noexcept;

/// Holds the header of a NetCDF file in one of the classic formats against the size of the file: its lists must lie in
/// it, and so must the end of every variable, over all records. The library of NetCDF gives zeros for what lies behind
/// the end, and memory for any number that a header names. Other files (NetCDF-4 is HDF5, whose library looks by
/// itself) pass. Gives the bytes of the file. Linear in the header; the data are not read. Any thread. Errors
/// (BadInput): sentences about "it".
Result<std::uint64_t> checkClassicNetCdf(const std::filesystem::path& path);

} // namespace tetra
