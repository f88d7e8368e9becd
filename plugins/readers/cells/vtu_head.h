// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tetra {

/// A DataArray element of a VTK XML file.
struct VtuArray {
    std::string name;
    std::string type; ///< "Float32" ...
    std::string format;
    int components = 1;
    std::string_view content;   ///< from its first byte; of an appended array to the end of the file
    std::uint64_t offset = 0;   ///< of an appended array, among what is appended
    std::string rangeMinimum{}; ///< as the file says; may be empty
    std::string rangeMaximum{};
};

struct VtuPiece {
    std::uint64_t points = 0;
    std::uint64_t cells = 0;
    std::vector<VtuArray> pointArrays;
    std::vector<VtuArray> cellArrays;
    VtuArray positions, connectivity, offsets, types;
    VtuArray faces, faceOffsets; ///< of polyhedra, as VTK before 9.4 writes them; may be missing
    /// The same as VTK writes them from 9.4 on; may be missing. The points of the faces, one face after the other, with
    /// where each ends; and the numbers of the faces of each cell, one cell after the other, with where each ends.
    VtuArray facePoints{}, faceEnds{}, cellFaces{}, cellFaceEnds{};
};

/// The structure of a .vtu file; views into its bytes.
struct VtuHead {
    bool bigEndian = false;
    bool wideHeaders = false; ///< block headers of 64 bits, not 32
    bool packed = false;      ///< with zlib
    bool appendedBase64 = false;
    bool exchangesLagrangeEdges = false; ///< before version 2.1: VTK numbers two edges of hexahedra the other way round
    std::string activePoints, activeCells; ///< the scalars of the first piece that the file calls active
    VtuArray time{};                       ///< in the field data; may be missing
    std::vector<VtuPiece> pieces;
};

/// Errors: no such file, or one of another kind; a compressor but zlib; several time steps; missing elements; no end.
Result<VtuHead> parseVtuHead(std::string_view bytes);

} // namespace tetra
