// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

namespace tetra {

/// The places in a file polyMesh/points of OpenFOAM, three numbers each, in text or in binary, packed by gzip or not:
/// what VTK takes in single precision. Nothing if there are more than `most`, or the file is none such or cut: whoever
/// asks has VTK's. Memory is bounded by `most`. Any thread.
std::optional<std::vector<double>> readFoamPoints(const std::filesystem::path& path, std::uint64_t most);

} // namespace tetra
