// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/build/build_state.h"

#include "core/base/checksum.h"
#include "core/base/file_writer.h"
#include "core/base/folder.h"
#include "core/base/mapped_file.h"
#include "core/history/blocks/run_files.h"

#include <tan/version.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <system_error>

namespace tetra {

std::uint64_t buildFingerprint(std::string_view files, const Dataset& dataset, std::span<const double> numbers,
                               std::span<const float> weights)
{
    std::string text = "TAn " TAN_VERSION "\n";
    const auto add = [&text](std::string_view part) { text.append(part) += '\n'; };
    add(files);
    for (const double number : numbers)
        add(formatNumber(number));
    add(std::to_string(dataset.source.hash));
    add(domainClassName(dataset.domain));
    add(sampleTypeName(dataset.values.type()));
    add(std::to_string(dataset.pointCount()));
    for (int axis = 0; axis < 3; ++axis) {
        add(std::to_string(dataset.lattice.size[static_cast<std::size_t>(axis)]));
        add(formatNumber(dataset.lattice.spacing[axis]));
    }
    add(std::to_string(checksum(std::as_bytes(weights))));
    return checksum(std::as_bytes(std::span(text)));
}

namespace {

/// Whether there is anything that a build could go on with: the state of one, or runs of blocks.
bool holdsWork(const std::filesystem::path& folder)
{
    std::error_code unreadable; // whoever writes there says so
    return std::ranges::any_of(pathsIn(folder, unreadable), [](const std::filesystem::path& path) {
        return path.filename() == "state" || holdsRuns(path);
    });
}

} // namespace

Status claimWork(const std::filesystem::path& folder, std::uint64_t fingerprint)
{
    const std::filesystem::path path = folder / "fingerprint";
    const std::string ours = std::to_string(fingerprint);
    constexpr std::size_t mostBytes = 64;
    const Result<std::string> there = wholeText(path, mostBytes);
    if (there && *there == ours)
        return {};
    if (there && holdsWork(folder)) // without a note the folder was about to be removed
        return SavedState::ofOtherWork(folder);
    auto file = FileWriter::create(path, 1, folder);
    if (!file)
        return file.error();
    if (const Status written = file->write(std::as_bytes(std::span(ours))); !written)
        return written;
    return file->commit(FileWriter::Durability::Power);
}

Result<std::unique_ptr<SavedState>> buildState(const BuildTarget& target, const Dataset& dataset,
                                               std::string_view method, std::span<const double> numbers,
                                               std::span<const float> weights)
{
    if (target.workFolder.empty() || !target.resume)
        return std::unique_ptr<SavedState>();
    const std::uint64_t fingerprint = buildFingerprint(method, dataset, numbers, weights);
    if (const Status claimed = claimWork(target.workFolder, fingerprint); !claimed)
        return claimed.error();
    return SavedState::open(target.workFolder, fingerprint);
}

} // namespace tetra
