// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/parameter.h"

#include <tan/base.h>
#include <tan/data.h>

#include <Eigen/Core>

#include <array>
#include <bit>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tetra {

/// How a number stands in a file: in one of the types of TAn's samples (with the same numbers), or in one that becomes
/// one of them.
enum class StoredType : std::uint8_t {
    UInt8,
    Int8,
    UInt16,
    Int16,
    UInt32,
    Int32,
    Float32,
    Float64,
    Int64,
    UInt64,
    Float16
};

constexpr std::size_t storedSize(StoredType type) noexcept
{
    constexpr std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 4, 8, 8, 8, 2};
    return sizes[static_cast<std::size_t>(type)];
}

/// The type of samples in which the numbers stand as they are; none of the wider integers and halves.
constexpr std::optional<SampleType> plainSampleType(StoredType type) noexcept
{
    return type <= StoredType::Float64 ? std::optional(static_cast<SampleType>(type)) : std::nullopt;
}

enum class StoredPacking : std::uint8_t {
    None,
    Zlib, ///< or gzip
    Text  ///< each number with a blank or an end of line behind it
};

struct StoredFile {
    std::filesystem::path path;
    StoredPacking packing = StoredPacking::None;
};

/// What the header of a volume says and what was chosen of it (MetaImage, NIfTI, MRC). The files together hold
/// `numbers` numbers, equally many each; that of component c of point p is number
/// first + p * pointStride + c * componentStride. Headers are believed only where the files have the bytes
/// (stored_reading.h).
struct StoredVolume {
    // What it is: as in Dataset, Source and FileContents.
    Lattice lattice; ///< its size is checked, its place is not
    std::string space{};
    std::string lengthUnit{};
    std::vector<std::string> untold{};
    /// How many steps of the spacing lie between what the file says and the origin; of files that do not tell the
    /// spacing, else zeros.
    Eigen::Vector3d stepsToOrigin = Eigen::Vector3d::Zero();
    std::vector<Message> remarks{};
    std::vector<Taken> taken{};
    std::vector<Message> leftOut{};
    std::vector<double> timeSteps{};

    // How its numbers stand in the files.
    StoredType type = StoredType::UInt8;
    std::endian order = std::endian::native;
    std::vector<StoredFile> files{};
    std::uint64_t offset = 0;      ///< bytes before the numbers, or what they are packed in, of each file
    bool atEndOfFile = false;      ///< of files that are not packed: the numbers are the last bytes
    std::uint64_t packedBytes = 0; ///< of each file; 0: to its end
    std::uint64_t numbers = 0;
    bool mayBeWider = false; ///< there are programs that write this type with twice the bytes

    // Which of them are the samples.
    std::uint64_t first = 0;
    std::uint64_t pointStride = 1;
    std::uint64_t componentStride = 1;
    std::uint32_t components = 1;
    std::optional<std::uint32_t> component{}; ///< one of them; none: the magnitude, if there are several
    double slope = 1, intercept = 0;          ///< a sample is a number * slope + intercept

    bool isScaled() const noexcept { return slope != 1 || intercept != 0; }
    bool isMagnitude() const noexcept { return components > 1 && !component; }
    std::uint64_t numbersOfFile() const noexcept { return numbers / files.size(); }
};

/// What the user may choose of such a volume.
struct VolumeChoice {
    std::int64_t time = 1;   ///< from 1
    std::string component{}; ///< a number from 0, or "magnitude", which is the default
};

/// "component" and "time".
std::vector<Parameter> volumeParameters();
VolumeChoice volumeChoice(const ParameterValues& values);

/// A product that stays the largest number where it would be larger than any file: what headers ask for may overflow.
constexpr std::uint64_t cappedProduct(std::uint64_t a, std::uint64_t b)
{
    constexpr std::uint64_t most = std::uint64_t(1) << 62;
    return b != 0 && a > most / b ? ~std::uint64_t(0) : a * b;
}

/// Sets the lattice's size and, if the volume has so many time steps and components, `numbers`. Errors: sizes that no
/// volume has (checkLatticeSize()), more than any file holds.
Status setStoredSize(StoredVolume& volume, const std::array<std::uint64_t, 3>& size, std::uint64_t steps);

/// More time steps than that have no list of times.
inline constexpr std::uint64_t mostTimes = 1'000'000;

/// Takes the time step that is asked for, which begins behind `numbersOfStep` numbers for each before it, and says so.
/// Without times in `timeSteps` their numbers stand there. Errors (WrongUsage): there are not so many.
Status takeTimeStep(StoredVolume& volume, const VolumeChoice& choice, std::uint64_t steps, std::uint64_t numbersOfStep);

/// Takes the component that is asked for, or the magnitude of all of them, and says so. Errors (WrongUsage): there is
/// none of that number.
Status takeComponent(StoredVolume& volume, const VolumeChoice& choice);

/// Puts it where the user says, as far as its files do not tell. Errors (WrongUsage): what they tell is given;
/// (BadInput) a place that no lattice has.
Status placeStored(const ParameterValues& values, StoredVolume& volume);

/// Dataset's type of values as far as it does not depend on them: none of integers of 64 bits, which become int32 if
/// all are as small, uint32 if that holds them, else double.
std::optional<SampleType> storedSampleType(const StoredVolume& volume);

} // namespace tetra
