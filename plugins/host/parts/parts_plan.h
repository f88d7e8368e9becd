// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/host/import_options.h"
#include "plugins/host/plugin_host.h"

#include <tan/base.h>
#include <tan/data.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tetra {

/// Where the samples of a dataset lie, for those who read only some of them.
struct SamplesInFile {
    std::filesystem::path file; ///< absolute
    std::uint64_t offset = 0;   ///< in bytes
    // By which a file that has changed is known:
    std::uint64_t fileBytes = 0;
    std::int64_t modified = 0;  ///< when, in nanoseconds
    std::uint64_t checksum = 0; ///< of some pieces
};

/// What all processes that share a build go by (D15): kept as "plan.json" in their folder, and what prepareParts() has
/// found by going through the whole dataset, so that nobody else does.
struct PartsPlan {
    using Texts = std::vector<std::pair<std::string, std::string>>;

    std::filesystem::path input; ///< absolute
    Texts imported{};            ///< importTexts()
    std::string builder{};       ///< id
    Texts parameters{};          ///< the builder's, with their defaults: usedTexts()
    // Of the dataset:
    std::string name{};
    std::uint64_t hash = 0;
    DomainClass domain = DomainClass::RegularLattice;
    SampleType type = SampleType::UInt8;
    Lattice lattice{};
    ValueRange range{};
    std::optional<SamplesInFile> samples{}; ///< nothing where they are not in a file as they are used
    std::uint32_t blocks = 0;               ///< how many there are to be shared

    /// Whether a part reads no more of the samples than its blocks need: weights are those of all points.
    bool readsOnlyItsBlocks() const;
};

/// JSON, for people to look at, too.
std::string planText(const PartsPlan& plan);

/// Whether there is a plan in a folder.
bool hasPlan(const std::filesystem::path& folder);

/// The plan in a folder. Errors: there is none (WrongUsage), it is damaged or of another version of TAn (BadInput).
Result<PartsPlan> readPlan(const std::filesystem::path& folder);

/// Makes the folder if it is not there and writes the plan into it. The same plan may be there already. Errors: another
/// one is, or other files, or the names of files are no text (WrongUsage); CannotWrite.
Status writePlan(const std::filesystem::path& folder, const PartsPlan& plan);

/// Removes the plan, the parts and the folder, unless there is something else in it.
void removeParts(const std::filesystem::path& folder);

/// Where the samples of a mapped dataset lie; nothing if they are not in a file as they are used.
std::optional<SamplesInFile> samplesInFile(const Dataset& dataset);

/// The dataset as far as refining its blocks goes, of which no sample is read: of samples that lie in a file. Errors:
/// the file is missing, or another one than when the build was prepared (BadInput).
Result<Dataset> mappedDataset(const PartsPlan& plan);

} // namespace tetra
