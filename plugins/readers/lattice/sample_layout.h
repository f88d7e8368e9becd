// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/lattice/nrrd_types.h"

#include <tan/base.h>
#include <tan/data.h>

#include <bit>
#include <cstdint>
#include <string>
#include <vector>

namespace tetra {

/// How the samples of a lattice lie in a file: what a NRRD header or the user says.
struct SampleLayout {
    Lattice lattice;   ///< checked
    std::string space; ///< as those of a dataset
    std::string lengthUnit{};
    std::vector<std::string> untold{}; ///< as FileContents::untold
    /// How many steps of the spacing lie between what the file says and the origin: 1/2 where it says where the first
    /// cell begins. Of files that do not tell the spacing; else zeros.
    Eigen::Vector3d stepsToOrigin = Eigen::Vector3d::Zero();
    std::vector<Message> remarks{}; ///< for Dataset::remarks
    std::vector<Taken> taken{};     ///< for Source::taken
    std::vector<Message> leftOut{}; ///< for Source::leftOut
    SampleType type = SampleType::UInt8;
    SampleEncoding encoding = SampleEncoding::Raw;
    std::endian order = std::endian::native; ///< of types of more than one byte; text has none
    std::uint64_t skippedLines = 0;          ///< before anything else
    std::uint64_t skippedBytes = 0;          ///< after the lines and after unpacking
    bool atEndOfFile = false;                ///< raw only: the samples are the last bytes, whatever stands before

    std::uint64_t sampleBytes() const { return lattice.pointCount() * sampleSize(type); }
};

} // namespace tetra
