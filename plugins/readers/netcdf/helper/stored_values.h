// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/netcdf/helper/netcdf_file.h"

#include <tan/data.h>

#include <functional>
#include <limits>

namespace tetra {

/// How a variable's stored numbers become values, as its attributes say. The rules:
/// https://docs.unidata.ucar.edu/nug/current/attribute_conventions.html and chapters 2.5.1 and 8.1 of the conventions
/// CF.
struct StoredNumbers {
    int type = 0;          ///< nc_type, unsigned where `_Unsigned` says so
    bool isPacked = false; ///< values are numbers * scale + offset
    double scale = 1;
    double offset = 0;
    bool unpacksToFloat = false;              ///< else to double
    std::vector<long double> noValue{};       ///< stored numbers that stand for no value
    std::optional<long double> defaultFill{}; ///< one more, if the file does not say: what the library fills with
    long double least = -std::numeric_limits<long double>::infinity(); ///< of stored numbers that are values
    long double most = std::numeric_limits<long double>::infinity();
    std::vector<double> noUnpackedValue{}; ///< as noValue, of values
    double leastUnpacked = -std::numeric_limits<double>::infinity();
    double mostUnpacked = std::numeric_limits<double>::infinity();
    Message saysNoValue{}; ///< what the file says of all this, for TakenPart::Fill; empty if nothing
};

StoredNumbers storedNumbers(const NetCdfFile& file, const NetCdfVariable& variable);

/// The number with which the library fills what nobody writes of the variable; nothing if the file names a _FillValue
/// or says that nothing is filled, and of bytes, of which every number is a value.
std::optional<long double> libraryFillOf(const NetCdfFile& file, const NetCdfVariable& variable);

/// A stored number as files and people write it: "-32767", "1e+20" of the number of single precision next to that.
std::string numberText(long double number);

/// That this number stands where nobody wrote one, for TakenPart::Fill.
Message filledByLibrary(long double number);

/// The type of samples without holes; of 64-bit integers the smaller of the two they may become.
SampleType sampleTypeOf(const StoredNumbers& stored);

struct NetCdfSamples {
    SampleType type = SampleType::Float32;
    Buffer<std::byte> samples{}; ///< NaN where there is no value
    std::uint64_t holes = 0;     ///< by what the file says, or by the library's fill
    bool isDefaultFill = false;  ///< some are the library's fill, of which the file says nothing
    bool isConstant = false;     ///< all values are one
    std::vector<Message> remarks{};
};

/// Reads a part of the variable. Numbers are held against fill values as they are stored, before they are scaled.
/// `progress`: fractions. Integers keep their type where there are no holes; those of 64 bits become int32 if all fit,
/// else double. Errors: the library's.
Result<NetCdfSamples> readSamples(const NetCdfFile& file, const NetCdfVariable& variable, const NetCdfPart& part,
                                  const std::function<void(double)>& progress);

/// The same as doubles, for coordinates.
Result<std::vector<double>> readValues(const NetCdfFile& file, const NetCdfVariable& variable, const NetCdfPart& part);

} // namespace tetra
