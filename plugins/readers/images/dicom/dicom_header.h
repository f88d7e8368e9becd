// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tetra {

/// By what the pictures of one series may differ that lie on one place, the plainest first.
enum class DicomMark : std::uint8_t {
    TemporalPosition,
    Echo,
    DiffusionWeight,
    TriggerTime,
    ReferenceTime,
    ImageType,
    Acquisition,
    AcquisitionTime,
    ContentTime
};
inline constexpr std::size_t dicomMarks = 9;

/// In words for the user: "echo".
MarkedText dicomMarkText(DicomMark mark) noexcept;

/// One picture: a file has one, or, in functional groups or otherwise, many. Of places in millimetres, x to the left, y
/// to the back and z to the head of the patient.
struct DicomFrame {
    std::optional<Eigen::Vector3d> position{};               ///< of the middle of the first pixel
    std::optional<std::array<Eigen::Vector3d, 2>> axes{};    ///< where rows and columns lead, of length 1
    std::optional<Eigen::Vector2d> pixelSpacing{};           ///< along a row, along a column
    std::optional<double> thickness{}, distance{}, height{}; ///< of slices, between them, SliceLocation
    double slope = 1, intercept = 0;                         ///< value = slope * stored + intercept
    std::string unit{};                                      ///< of the values; empty if it is not said
    std::string stack{};                                     ///< to which one of the file's it belongs
    std::array<std::string, dicomMarks> marks{};
};

/// What a file says of itself before its pixels.
struct DicomHeader {
    std::filesystem::path path{};
    std::uint64_t bytes = 0; ///< of the file
    std::string series{};    ///< SeriesInstanceUID; empty if it has none
    std::string instance{};  ///< SOPInstanceUID
    std::string kind{};      ///< SOPClassUID
    std::string seriesNumber{}, description{}, modality{}, photometric{};
    std::optional<std::int64_t> number{}; ///< InstanceNumber
    std::uint64_t rows = 0, columns = 0, samples = 1;
    std::uint64_t allocatedBits = 0, storedBits = 0, highBit = 0;
    bool isSigned = false;
    bool hasPixels = false, isPacked = false;
    bool hasFloats = false;          ///< pixels that are no whole numbers
    bool lostInPacking = false;      ///< the pixels were packed with loss once
    bool isMosaic = false;           ///< its picture is many slices side by side
    bool isFilm = false;             ///< its pictures are moments
    bool isImagerSpacing = false;    ///< the spacing is that at the detector
    bool hasTable = false;           ///< a modality lookup table
    std::optional<double> padding{}; ///< the stored number of what lies outside of the picture
    bool areStacked = false;         ///< of several pictures none but the first says where it lies
    std::vector<DicomFrame> frames{};
    Message fault{}; ///< a sentence about "it": why it cannot be read; then what stands here is what was read before
};

/// Reads it by GDCM, up to the pixels, of which packed ones are only measured. Its fault is that it is no DICOM file,
/// ends too early, or has not all of its pixels. May throw std::bad_alloc.
DicomHeader dicomHeader(const std::filesystem::path& path);

/// Whether a file begins as DICOM files do, with or without the usual 128 bytes before. Reads the first bytes only.
bool looksLikeDicom(const std::filesystem::path& path);

/// The samples of all pictures of a file one after the other, as they are stored, in the machine's byte order:
/// allocatedBits each. Unpacked by GDCM where they are packed. The error is a sentence about "it".
Result<std::vector<char>> dicomSamples(const DicomHeader& header);

} // namespace tetra
