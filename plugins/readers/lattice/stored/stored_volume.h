// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/reader.h"

#include <tan/base.h>
#include <tan/data.h>

#include <Eigen/Core>

#include <array>
#include <bit>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
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

/// "uint8", "int64" ..., as sampleTypeName() has them.
constexpr std::string_view storedTypeName(StoredType type) noexcept
{
    constexpr std::string_view names[] = {"uint8", "int8",   "uint16", "int16",  "uint32", "int32",
                                          "float", "double", "int64",  "uint64", "float16"};
    return names[static_cast<std::size_t>(type)];
}

/// The type of samples in which the numbers stand as they are; none of the wider integers and halves.
constexpr std::optional<SampleType> plainSampleType(StoredType type) noexcept
{
    return type <= StoredType::Float64 ? std::optional(static_cast<SampleType>(type)) : std::nullopt;
}

enum class StoredPacking : std::uint8_t {
    None,
    Zlib, ///< or gzip
    Text  ///< with blanks, line ends or commas between the numbers; exponents also as Fortran writes them
};

struct StoredFile {
    std::filesystem::path path;
    StoredPacking packing = StoredPacking::None;
};

/// What there may be behind the numbers of a file that is not packed.
enum class StoredRest : std::uint8_t {
    Told,    ///< of one file in StoredVolume::leftOut
    Ignored, ///< something else
    Refused, ///< nothing, since then the description is wrong
};

/// What the header of a volume says, or the user of a raw file, and what was chosen of it: the one description that
/// every format becomes, by which its samples are read (stored_reading.h). The files together hold `numbers` numbers,
/// equally many each; that of component c of point (i, j, k) is number
/// first + i * strides[0] + j * strides[1] + k * strides[2] + c * componentStride. Headers are believed only where the
/// files have the bytes.
struct StoredVolume {
    // What it is: as in Dataset, Source and FileContents.
    Lattice lattice; ///< its size is checked, its place is not
    std::string space{};
    std::string lengthUnit{};
    std::string valueName{};
    std::vector<FileArray> arrays{}; ///< among which there is a choice; empty: one without a name
    std::vector<std::string> untold{};
    /// How many steps of the spacing lie between what the file says and the origin: 1/2 where it says where the first
    /// cell begins.
    Eigen::Vector3d stepsToOrigin = Eigen::Vector3d::Zero();
    std::vector<Message> remarks{};
    std::vector<Taken> taken{};
    std::vector<Message> leftOut{};
    std::vector<double> timeSteps{};

    // How its numbers stand in the files.
    StoredType type = StoredType::UInt8; ///< of text: what its numbers become
    std::endian order = std::endian::native;
    std::vector<StoredFile> files{};
    std::uint64_t headerBytes = 0;          ///< of each file, before anything else
    std::uint64_t skippedLines = 0;         ///< behind that
    std::uint64_t offset = 0;               ///< bytes before the numbers, or what they are packed in, behind the lines
    std::uint64_t unpackedOffset = 0;       ///< of packed ones: bytes before the numbers when they are unpacked
    bool atEndOfFile = false;               ///< of files that are not packed: the numbers are the last bytes
    std::optional<std::uint64_t> endByte{}; ///< of each file, where the numbers end at the latest
    std::uint64_t packedBytes = 0;          ///< of each file; 0: to its end
    std::uint64_t numbers = 0;
    StoredRest rest = StoredRest::Told;
    bool mayBeWider = false; ///< there are programs that write this type with twice the bytes
    /// Text as the library of MetaImages takes it: fractions of whole numbers are cut off, and the last number, too,
    /// has a blank or an end of line behind it, or a part of it may be missing.
    bool isTextOfMetaIo = false;

    // Which of them are the samples.
    std::uint64_t first = 0;
    std::array<std::uint64_t, 3> strides{};
    std::uint64_t componentStride = 1;
    std::uint32_t components = 1;
    std::optional<std::uint32_t> component{}; ///< one of them; none: the magnitude, if there are several
    double slope = 1, intercept = 0;          ///< a sample is a number * slope + intercept

    bool isScaled() const noexcept { return slope != 1 || intercept != 0; }
    bool isMagnitude() const noexcept { return components > 1 && !component; }
    std::uint64_t numbersOfFile() const noexcept { return numbers / files.size(); }
};

/// A file in the hands of the reader of its format.
struct VolumeRequest {
    std::filesystem::path path;
    std::shared_ptr<const MappedFile> file;
    const ParameterValues& values;

    std::string_view text() const;
};

/// What the user may choose of what a file with a header holds: "array", "component" and "time".
std::vector<Parameter> volumeChoices();

/// A product that stays the largest number where it would be larger than any file: what headers ask for may overflow.
constexpr std::uint64_t cappedProduct(std::uint64_t a, std::uint64_t b)
{
    constexpr std::uint64_t most = std::uint64_t(1) << 62;
    return b != 0 && a > most / b ? ~std::uint64_t(0) : a * b;
}

/// Sets the lattice's size; if the volume has so many time steps and components, `numbers`; and the strides of
/// components side by side, the first index running fastest. Errors: sizes that no volume has (checkLatticeSize()),
/// more than any file holds.
Status setStoredSize(StoredVolume& volume, const std::array<std::uint64_t, 3>& size, std::uint64_t steps);

/// The strides of points that stand one after the other with so many numbers each.
void setStrides(StoredVolume& volume, std::uint64_t ofPoint, bool lastFastest);

/// The number of the array that the user asks for, by its name or its number from 1; the first if he does not, which is
/// a guess. It is told in `volume`, whose arrays are there, if there are several. Errors (WrongUsage) name them.
Result<std::size_t> takeArray(StoredVolume& volume, const ParameterValues& values);

/// Takes the component that is asked for, else the magnitude of all of them, which is a guess, and says so. Errors
/// (WrongUsage): there is none of that number.
Status takeComponent(StoredVolume& volume, const ParameterValues& values);

/// More time steps than that have no list of times.
inline constexpr std::uint64_t mostTimes = 1'000'000;

/// Takes the time step that is asked for, else the first, which is a guess, and says so; `numbersOfStep` lie between
/// one and the next. Without times in `timeSteps` their numbers stand there. Errors (WrongUsage): there are not so
/// many.
Status takeTimeStep(StoredVolume& volume, const ParameterValues& values, std::uint64_t steps,
                    std::uint64_t numbersOfStep);

/// Puts it where the user says, as far as its files do not tell. Errors (WrongUsage): what they tell is given;
/// (BadInput) a place that no lattice has.
Status placeStored(StoredVolume& volume, const ParameterValues& values);

/// Dataset's type of values as far as it does not depend on them: none of integers of 64 bits, which become int32 if
/// all are as small, uint32 if that holds them, else double.
std::optional<SampleType> storedSampleType(const StoredVolume& volume);

} // namespace tetra
