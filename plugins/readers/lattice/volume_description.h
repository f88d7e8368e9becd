// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/reader.h"
#include "plugins/readers/lattice/stored_numbers.h"

#include <tan/base.h>
#include <tan/data.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tetra {

/// What the header of a volume says, with what the user asks for: where its samples stand, and all that is told of
/// them. Made without a look at the samples.
struct VolumeDescription {
    Lattice lattice; ///< checked; its size is that of the numbers
    StoredNumbers numbers;
    std::shared_ptr<const MappedFile> file; ///< that has the numbers
    std::uint64_t firstByte = 0;            ///< of them in that file, once it is unpacked
    std::optional<std::uint64_t> endByte{}; ///< where they end at the latest; none: with the file
    bool isPacked = false;                  ///< by gzip
    std::string valueName{};                ///< as Source has it
    std::string lengthUnit{};
    std::vector<FileArray> arrays{}; ///< among which there is a choice; one without a name if there is none
    std::vector<std::string> untold{};
    std::vector<Taken> taken{};
    std::vector<Message> leftOut{};
    std::vector<Message> remarks{};
};

/// A volume in the hands of a reader of its format.
struct VolumeRequest {
    std::filesystem::path path;
    std::shared_ptr<const MappedFile> file;
    const ParameterValues& values;

    std::string_view text() const
    {
        const auto bytes = file->bytes();
        return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
    }
};

/// "array" and "component": the choices among what a file of these formats holds.
std::vector<Parameter> choiceParameters();

/// The number of the array that the user asks for, by its name or its number from 1; the first if he does not. Errors
/// (WrongUsage) name those there are. What was taken is told in `volume`, if there are several.
Result<std::size_t> chooseArray(const ParameterValues& values, VolumeDescription& volume);

/// Sets which of `components` numbers of each point is taken, as the user says, else their magnitude, and tells it.
/// Errors: WrongUsage.
Status chooseComponent(const ParameterValues& values, std::uint64_t components, VolumeDescription& volume);

/// Sets the size of the lattice and of its numbers. Errors: checkLatticeSize().
Status setVolumeSize(const std::array<std::uint64_t, 3>& size, VolumeDescription& volume);

/// Another file that a header names, in its folder. The error names both.
Result<std::shared_ptr<const MappedFile>> openNumbersFile(const VolumeRequest& request, const std::string& name);

/// What a probe tells of it. Errors: too few numbers.
Result<FileContents> contentsOf(const VolumeDescription& volume);

/// Reads the samples. Errors as those of readStored(), in the words of the file that has them.
Result<Dataset> readVolume(const VolumeRequest& request, VolumeDescription volume, const Progress& progress);

} // namespace tetra
