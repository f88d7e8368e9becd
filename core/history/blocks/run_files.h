// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/history/blocks/block_run.h"

#include <tan/base.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tetra {

/// A part of a build that several processes share: `number` of `count`, from 1.
struct PartNumber {
    std::uint32_t number = 1;
    std::uint32_t count = 1;
    bool operator==(const PartNumber&) const = default;
};

/// The blocks of a part, [first, end): consecutive ones, as many as of any other part or one more.
struct BlockShare {
    std::uint32_t first = 0;
    std::uint32_t end = 0;
};
BlockShare shareOf(const PartNumber& part, std::uint32_t blockCount) noexcept;

inline bool contains(const BlockShare& share, std::uint32_t block) noexcept
{
    return share.first <= block && block < share.end;
}

/// "part-3-of-8.runs", the file of a finished part.
TAN_INTERNAL std::string partFileName(const PartNumber& part);

/// "part-3-of-8.round-2", what a part tells the others after so many rounds.
std::string roundFileName(const PartNumber& part, std::uint64_t rounds);

/// The parts of a shared build that are finished in a folder, by the names of their files; those of one division (of
/// one count) follow each other.
TAN_INTERNAL std::vector<PartNumber> finishedParts(const std::filesystem::path& folder);

/// That all parts of one division are among them. Error: NotYet.
TAN_INTERNAL Status checkNoneMissing(const std::filesystem::path& folder);

/// Whether a file is one of a build that nobody shares and has runs, whole or not.
bool holdsRuns(const std::filesystem::path& path);

/// The runs of all blocks of a build, in files of one folder, where they stand one after the other in the order in
/// which they were finished: in one file of the build, or in one of each part of a build that several processes share.
/// Files begin with what tells the build. They are not synced run by run: after a power failure the sums tell which are
/// whole.
///
/// First one of openOwn(), openPart() and openParts(). Then append() and what reads are safe from any number of
/// threads, as long as a block's run is not read while it is appended.
class RunFiles {
public:
    /// Runs of `blockCount` blocks that depend on what `fingerprint` stands for.
    RunFiles(std::filesystem::path folder, std::uint64_t fingerprint, std::uint32_t blockCount);
    ~RunFiles();
    RunFiles(const RunFiles&) = delete;
    RunFiles& operator=(const RunFiles&) = delete;

    std::uint32_t blockCount() const noexcept { return static_cast<std::uint32_t>(places_.size()); }
    const std::filesystem::path& folder() const noexcept { return folder_; }
    std::uint64_t fingerprint() const noexcept { return fingerprint_; }

    /// The file of a build that nobody shares, which is locked by its folder: with `reuse` the one that is there, but
    /// for what a killed process did not finish in it. O(bytes of the file) then, as all sums are checked. Errors: it
    /// cannot be read or written; cancelled.
    Status openOwn(bool reuse, const Progress& progress = {});
    /// The file of a part, under a name of this process alone until finishPart(): whoever else works on the part does
    /// no harm. It is that of an earlier attempt that has ended, or begins with what others have finished so far.
    /// Errors: as openOwn(); what is there is of another build (WrongUsage).
    Status openPart(const PartNumber& part, const Progress& progress);
    /// Of an open part: its blocks have their runs, so that nothing is left to do.
    bool partIsFinished() const noexcept { return partIsFinished_; }
    /// Gives the part's file its name, for good, when it has the runs of all its blocks, unless somebody else has
    /// finished the part meanwhile. Removes what earlier attempts left. Error: CannotWrite.
    Status finishPart();
    /// For reading: the files of finished parts, however many there were, with whatever cures. Errors: the folder or a
    /// file cannot be read, or a file is damaged (BadInput); one is of another build (WrongUsage); parts are missing
    /// (NotYet); cancelled.
    Status openParts(const Progress& progress);

    /// The run of a block depends on the cures on its faces, too.
    void setCures(std::uint32_t block, std::span<const FaceCure> cures);
    /// Whether the run of the block is there, and of this build and these cures.
    bool intact(std::uint32_t block) const noexcept;
    /// Adds the recorder's run of a block, in place of one that is there. Error: the file cannot be written.
    Status append(BlockRunRecorder& recorder, std::uint32_t block);

    /// Of a run that is intact().
    const BlockRunHeader& header(std::uint32_t block) const noexcept { return places_[block].header; }
    /// The cures that the block needs; none if its run is complete.
    Result<std::vector<FaceCure>> readCures(std::uint32_t block) const;
    /// That all runs are intact(): comes before the members below.
    Status checkComplete() const;
    Status readWords(std::uint32_t block, std::uint64_t first, std::span<std::uint32_t> words) const;
    Status readTetrahedra(std::uint32_t block, std::uint64_t first, std::uint64_t count, std::span<std::byte> to) const;

private:
    struct RunFile {
        std::filesystem::path path;
        int descriptor = -1;     ///< opened for each read if there are too many to keep them open ...
        std::uint64_t inode = 0; ///< ... and by this known again
    };
    static constexpr std::uint32_t none = 0xffffffff;
    struct Place {
        BlockRunHeader header;
        std::uint64_t offset = 0;
        std::uint32_t file = none;
    };

    /// What a file of runs was found to be.
    struct Found {
        bool ofThisBuild = true;
        bool whole = true;     ///< it has nothing but runs whose sums are right
        std::uint64_t end = 0; ///< of the last run, in bytes
    };

    Result<Found> findRuns(std::uint32_t file, const Progress& progress);
    Status openFile(const std::filesystem::path& path, int flags);
    Status beginToAppend(std::uint64_t end);
    Status makeUnfinished();
    Status adoptOrCopy(std::span<const std::filesystem::path> attempts, const Progress& progress);
    Status takeOver(std::uint32_t block);
    Status put(const BlockRunHeader& header, std::span<const std::span<const std::byte>> content);
    Status read(const Place& place, std::uint64_t offset, std::span<std::byte> to) const;
    std::uint64_t fingerprintOf(std::uint32_t block) const noexcept;
    bool has(const BlockShare& share) const noexcept;
    Error damaged(const Place& place) const;

    std::filesystem::path folder_;
    std::uint64_t fingerprint_;
    std::vector<std::uint64_t> cures_; ///< their sum for each block, 0 without; empty where no block has any
    std::vector<Place> places_;
    std::vector<RunFile> files_;
    std::mutex mutex_;              ///< of what is appended
    std::uint32_t appended_ = none; ///< the file that runs are appended to ...
    std::uint64_t end_ = 0;         ///< ... and where the next one begins
    std::optional<PartNumber> part_;
    bool partIsFinished_ = false;
    bool replacesDamaged_ = false; ///< a file of the finished part that is there
    std::uint64_t unsynced_ = 0;   ///< bytes of a part's file
    bool takesAnyCures_ = false;   ///< which those who made the runs knew
};

} // namespace tetra
