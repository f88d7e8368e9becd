// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <Eigen/Core>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace tetra {

enum class NiftiVersion : std::uint8_t { Analyze, One, Two };

/// The header of a NIfTI-1 or NIfTI-2 file, or of Analyze 7.5, as it stands there; with the names of nifti1.h, where
/// the formats are explained: https://nifti.nimh.nih.gov/pub/dist/src/niftilib/nifti1.h, nifti2.h.
struct NiftiHeader {
    NiftiVersion version = NiftiVersion::One;
    std::endian order = std::endian::little;
    bool isPair = false; ///< the samples are in a file .img beside it
    std::array<std::int64_t, 8> dim{};
    std::int32_t datatype = 0;
    std::array<double, 8> pixdim{};
    double dataOffset = 0;           ///< vox_offset
    double slope = 0, intercept = 0; ///< scl_slope, scl_inter; of Analyze the factor that SPM writes
    std::int32_t qformCode = 0, sformCode = 0;
    Eigen::Vector3d quaternion = Eigen::Vector3d::Zero();
    Eigen::Vector3d qOffset = Eigen::Vector3d::Zero();
    Eigen::Matrix<double, 3, 4> sRows = Eigen::Matrix<double, 3, 4>::Zero();
    std::int32_t units = 0; ///< xyzt_units
    std::int32_t intent = 0;
    double timeOffset = 0;                    ///< toffset
    std::string unitName{};                   ///< of Analyze: vox_units
    std::array<std::int16_t, 3> originator{}; ///< of Analyze: the sample at the origin, from 1, as SPM writes it
    int orientation = 0;                      ///< of Analyze: orient
};

/// Whether a file begins with such a header; one of Analyze has little to know it by.
bool looksLikeNifti(std::span<const std::byte> firstBytes);
bool looksLikeAnalyze(std::span<const std::byte> firstBytes);

/// The header at the beginning of a file. Errors: it is none, or cut short.
Result<NiftiHeader> parseNiftiHeader(std::span<const std::byte> file);

/// The names that the other file of a pair may have: that of the samples of "head.hdr", or the header of "head.img".
std::vector<std::filesystem::path> niftiPartners(const std::filesystem::path& path);

} // namespace tetra
