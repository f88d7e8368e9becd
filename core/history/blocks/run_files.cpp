// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/history/blocks/run_files.h"

#include "core/base/checksum.h"
#include "core/base/file_writer.h"
#include "core/base/finished_file.h"
#include "core/base/folder.h"
#include "core/base/positioned_io.h"
#include "core/base/text.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <random>
#include <set>
#include <string_view>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

namespace tetra {

namespace {

constexpr std::string_view ownFile = "blocks.runs";
constexpr std::string_view partStart = "part-";
constexpr std::string_view partMiddle = "-of-";
constexpr std::string_view finishedEnd = ".runs";
constexpr std::string_view unfinishedEnd = ".unfinished";

/// What each file of runs begins with.
struct RunFileHeader {
    std::array<char, 8> magic{'T', 'A', 'N', 'R', 'U', 'N', 'S', '1'};
    std::uint64_t fingerprint = 0; ///< of the build
};
static_assert(sizeof(RunFileHeader) == 16);

/// "part-3-of-8"
std::string nameOf(const PartNumber& part)
{
    return std::string(partStart) + std::to_string(part.number) + std::string(partMiddle) + std::to_string(part.count);
}

/// Of a finished part's file name; nothing of other names.
std::optional<PartNumber> partOf(const std::string& name)
{
    const std::size_t middle = name.find(partMiddle);
    if (!name.starts_with(partStart) || !name.ends_with(finishedEnd) || middle == std::string::npos)
        return std::nullopt;
    const std::size_t second = middle + partMiddle.size(), end = name.size() - finishedEnd.size();
    const auto number = parseNumber<std::uint32_t>(name.substr(partStart.size(), middle - partStart.size()));
    const auto count = parseNumber<std::uint32_t>(name.substr(second, std::max(second, end) - second));
    if (!number || !count)
        return std::nullopt;
    const PartNumber part{*number, *count};
    return partFileName(part) == name ? std::optional(part) : std::nullopt;
}

/// Of an attempt at a part: no other process has the same name.
std::string unfinishedName(const PartNumber& part)
{
    constexpr std::string_view digits = "0123456789abcdef";
    std::random_device random;
    std::string name = nameOf(part) + "-";
    for (int digit = 0; digit < 16; ++digit)
        name += digits[random() % digits.size()];
    return name.append(unfinishedEnd);
}

bool isUnfinished(std::string_view name, const PartNumber& part)
{
    return name.starts_with(nameOf(part) + "-") && name.ends_with(unfinishedEnd);
}

/// Whether so many files may stay open, or are opened for each look into them: of those that a process may have open,
/// 1024 as a rule, half are left to others.
bool canStayOpen(std::size_t files)
{
    struct rlimit limit {};
    return ::getrlimit(RLIMIT_NOFILE, &limit) == 0 && files <= limit.rlim_cur / 2;
}

std::uint64_t fileSize(int descriptor)
{
    struct stat status {};
    return ::fstat(descriptor, &status) == 0 ? static_cast<std::uint64_t>(status.st_size) : 0;
}

/// Whether it may be the header of a run that so many bytes hold.
bool isPlausible(const BlockRunHeader& header, std::uint32_t blockCount, std::uint64_t bytes)
{
    constexpr std::uint64_t most = 1u << 31;
    return header.magic == BlockRunHeader().magic && header.block < blockCount &&
           (header.recordBytes == sizeof(NarrowTetrahedron) || header.recordBytes == sizeof(WarpedTetrahedron) ||
            header.recordBytes == sizeof(WideTetrahedron)) &&
           header.wordCount < most && header.tetrahedronCount < 2 * most && header.cureCount < most &&
           runBytes(header) <= bytes;
}

/// Closes a file at the end of a block of code.
class OpenFile {
public:
    explicit OpenFile(const std::filesystem::path& path)
        : descriptor_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK))
    {
    }
    ~OpenFile()
    {
        if (descriptor_ >= 0)
            ::close(descriptor_);
    }
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;

    int descriptor() const noexcept { return descriptor_; }

private:
    int descriptor_;
};

/// Adds bytes of a file to a sum. 0, or the system's error; ECANCELED when cancelled.
int addBytes(int descriptor, std::uint64_t offset, std::uint64_t size, const Progress& progress, Checksum& checksum)
{
    constexpr std::size_t pieceBytes = std::size_t(1) << 20;
    std::vector<std::byte> bytes(std::min<std::uint64_t>(size, pieceBytes));
    for (std::uint64_t done = 0; done < size; done += bytes.size()) {
        if (progress.cancelled())
            return ECANCELED;
        bytes.resize(std::min<std::uint64_t>(size - done, pieceBytes));
        if (const int problem = readFully(descriptor, offset + done, bytes); problem != 0)
            return problem;
        checksum.add(bytes);
    }
    return 0;
}

Error ofOtherBuild(const std::filesystem::path& path)
{
    return {ErrorKind::WrongUsage,
            Message::say("'%1' belongs to another build: of other data, with other options, or by another version of "
                         "TAn. Remove it, or choose another folder.",
                         path.string()),
            path};
}

} // namespace

BlockShare shareOf(const PartNumber& part, std::uint32_t blockCount) noexcept
{
    const auto begin = [&](std::uint64_t number) {
        return static_cast<std::uint32_t>(number * blockCount / part.count);
    };
    return {begin(part.number - 1), begin(part.number)};
}

std::string partFileName(const PartNumber& part)
{
    return nameOf(part).append(finishedEnd);
}

bool holdsRuns(const std::filesystem::path& path)
{
    std::error_code problem;
    const auto size = std::filesystem::file_size(path, problem);
    return !problem && path.filename() == ownFile && size > sizeof(RunFileHeader);
}

std::string roundFileName(const PartNumber& part, std::uint64_t rounds)
{
    return nameOf(part) + ".round-" + std::to_string(rounds);
}

RunFiles::RunFiles(std::filesystem::path folder, std::uint64_t fingerprint, std::uint32_t blockCount)
    : folder_(std::move(folder)), fingerprint_(fingerprint), places_(blockCount)
{
}

RunFiles::~RunFiles()
{
    for (const RunFile& file : files_)
        if (file.descriptor >= 0)
            ::close(file.descriptor);
}

// Which runs a file has.

/// Enters the whole runs of a file among the places. Where its last plausible run ends; nothing if it is of another
/// build. `damagedRuns` counts those whose sum is wrong.
Result<std::optional<std::uint64_t>> RunFiles::findRuns(std::uint32_t file, const Progress& progress,
                                                        std::uint32_t& damagedRuns)
{
    const std::filesystem::path& path = files_[file].path;
    const OpenFile opened(path);
    if (opened.descriptor() < 0)
        return unreadable(path, systemErrorText(errno));
    const std::uint64_t size = fileSize(opened.descriptor());
    RunFileHeader begin;
    if (size < sizeof begin) // killed before its first run
        return std::optional<std::uint64_t>(0);
    if (const int problem = readFully(opened.descriptor(), 0, std::as_writable_bytes(std::span(&begin, 1))))
        return unreadable(path, systemErrorText(problem));
    if (begin.magic != RunFileHeader().magic || begin.fingerprint != fingerprint_)
        return std::optional<std::uint64_t>();
    std::uint64_t offset = sizeof begin;
    BlockRunHeader header;
    while (offset + sizeof header <= size) {
        if (const int problem = readFully(opened.descriptor(), offset, std::as_writable_bytes(std::span(&header, 1))))
            return unreadable(path, systemErrorText(problem));
        if (!isPlausible(header, blockCount(), size - offset))
            break;
        Checksum checksum;
        checksum.add(std::as_bytes(std::span(&header, 1)).first(offsetof(BlockRunHeader, checksum)));
        const int problem =
            addBytes(opened.descriptor(), offset + sizeof header, runBytes(header) - sizeof header, progress, checksum);
        if (problem == ECANCELED)
            return cancelledError(Message::marked("The build"));
        if (problem != 0)
            return unreadable(path, systemErrorText(problem));
        if (checksum.value() == header.checksum)
            places_[header.block] = {header, offset, file};
        else
            ++damagedRuns;
        offset += runBytes(header);
        progress.report(static_cast<double>(offset) / static_cast<double>(size),
                        Message::marked("Checking what is done already"));
    }
    return std::optional(offset);
}

// Opening.

/// Makes or opens the file that is appended to, its last one.
Status RunFiles::openToAppend(const std::filesystem::path& path, int flags)
{
    constexpr int readableByAll = 0666;
    const int descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW | flags, readableByAll);
    if (descriptor < 0)
        return cannotWriteFile(path, errno);
    appended_ = static_cast<std::uint32_t>(files_.size());
    files_.push_back({path, descriptor});
    return {};
}

/// Cuts off what follows the last run; of an empty file makes one without runs.
Status RunFiles::beginToAppend(std::uint64_t end)
{
    const RunFile& file = files_[appended_];
    if (::ftruncate(file.descriptor, static_cast<off_t>(end)) != 0)
        return cannotWriteFile(file.path, errno);
    end_ = end;
    if (end > 0)
        return {};
    const RunFileHeader header{.fingerprint = fingerprint_};
    if (const int problem = writeFully(file.descriptor, 0, std::as_bytes(std::span(&header, 1))))
        return cannotWriteFile(file.path, problem);
    end_ = sizeof header;
    return {};
}

Status RunFiles::openOwn(bool reuse, const Progress& progress)
{
    if (const Status opened = openToAppend(folder_ / ownFile, 0); !opened)
        return opened;
    std::uint64_t end = 0;
    std::uint32_t damagedRuns = 0; // are made again
    if (reuse) {
        const auto found = findRuns(appended_, progress, damagedRuns);
        if (!found)
            return found.error();
        end = found->value_or(0);
    }
    return beginToAppend(end);
}

Status RunFiles::openPart(const PartNumber& part, const Progress& progress)
{
    part_ = part;
    const BlockShare share = shareOf(part, blockCount());
    std::error_code problem;
    for (const std::filesystem::path& path : pathsIn(folder_, problem)) {
        const std::string name = path.filename().string();
        const bool isFinished = name == partFileName(part);
        if (!isFinished && !isUnfinished(name, part))
            continue;
        files_.push_back({path, -1});
        std::uint32_t damagedRuns = 0;
        const auto found = findRuns(static_cast<std::uint32_t>(files_.size() - 1), progress, damagedRuns);
        if (!found && found.error().kind == ErrorKind::Cancelled)
            return found.error();
        if (found && !*found)
            return ofOtherBuild(path);
        const bool isWhole = found && damagedRuns == 0 && **found == fileSize(OpenFile(path).descriptor());
        partIsFinished_ = partIsFinished_ || (isFinished && isWhole && has(share));
    }
    if (problem)
        return cannotWriteFile(folder_ / partFileName(part), problem.value());
    if (partIsFinished_)
        return {};
    for (bool made = false; !made;) { // a name may be lost to who clears up before it is locked
        if (const Status opened = openToAppend(folder_ / unfinishedName(part), O_EXCL); !opened)
            return opened;
        made = lockFile(files_.back().descriptor, files_.back().path) != FileLock::Gone;
    }
    if (const Status begun = beginToAppend(0); !begun)
        return begun;
    for (std::uint32_t block = share.first; block < share.end; ++block)
        if (places_[block].file != none)
            if (const Status copied = takeOver(block, progress); !copied)
                return copied;
    removeLeftFiles(folder_, [&](std::string_view name) { return isUnfinished(name, part); });
    return {};
}

/// Copies a run of an earlier attempt.
Status RunFiles::takeOver(std::uint32_t block, const Progress& progress)
{
    if (progress.cancelled())
        return cancelledError(Message::marked("The build"));
    const Place from = places_[block];
    std::vector<std::byte> bytes(runBytes(from.header) - sizeof from.header);
    if (!read(from, sizeof from.header, bytes)) { // gone meanwhile: it is made again
        places_[block] = {};
        return {};
    }
    const std::array<std::span<const std::byte>, 1> content{bytes};
    return put(from.header, content);
}

Status RunFiles::finishPart()
{
    const std::filesystem::path finished = folder_ / partFileName(*part_);
    const std::filesystem::path own = files_[appended_].path;
    if (const Status named = replaceFile(own, finished); !named) {
        std::error_code problem; // where files cannot be locked, somebody may have cleared up after finishing the part
        return !std::filesystem::exists(own, problem) && std::filesystem::exists(finished, problem) ? Status() : named;
    }
    removeLeftFiles(folder_, [&](std::string_view name) { return isUnfinished(name, *part_); });
    return {};
}

Status RunFiles::openParts(const Progress& progress)
{
    std::error_code problem;
    std::vector<std::filesystem::path> paths = pathsIn(folder_, problem);
    if (problem)
        return unreadable(folder_, Message::say("%1.", systemErrorText(problem.value())));
    std::erase_if(paths, [](const std::filesystem::path& path) { return !partOf(path.filename().string()); });
    std::ranges::sort(paths);
    const bool staysOpen = canStayOpen(paths.size());
    for (std::size_t number = 0; number < paths.size(); ++number) {
        files_.push_back({paths[number], -1});
        std::uint32_t damagedRuns = 0;
        const auto count = static_cast<double>(paths.size()), done = static_cast<double>(number);
        const auto found =
            findRuns(static_cast<std::uint32_t>(number), progress.part(done / count, (done + 1) / count), damagedRuns);
        if (!found)
            return found.error();
        if (!*found)
            return ofOtherBuild(paths[number]);
        std::error_code unknown;
        if (damagedRuns > 0 || **found != std::filesystem::file_size(paths[number], unknown))
            return Error{ErrorKind::BadInput,
                         Message::say("'%1' is damaged. Build that part again, which replaces what is damaged.",
                                      paths[number].string()),
                         paths[number]};
        if (staysOpen)
            files_.back().descriptor = ::open(paths[number].c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    }
    takesAnyCures_ = true;
    return has({0, blockCount()}) ? Status() : missing();
}

/// Which parts are, as far as the names of the others tell how many there are to be.
Status RunFiles::missing() const
{
    std::set<std::uint32_t> counts, numbers;
    for (const RunFile& file : files_)
        if (const auto part = partOf(file.path.filename().string())) {
            counts.insert(part->count);
            numbers.insert(part->number);
        }
    if (counts.empty())
        return Error{ErrorKind::NotYet,
                     Message::say("No part of the build in '%1' is finished yet.", folder_.string())};
    if (counts.size() > 1)
        return Error{ErrorKind::NotYet,
                     Message::say("Parts of the build in '%1' are missing, and those that are there are of different "
                                  "divisions. Build all parts of one of them.",
                                  folder_.string())};
    constexpr std::size_t mostNamed = 20;
    std::string names;
    std::size_t missingParts = 0;
    for (std::uint32_t number = 1; number <= *counts.begin(); ++number)
        if (!numbers.contains(number) && ++missingParts <= mostNamed)
            names += (names.empty() ? "" : ", ") + std::to_string(number);
    if (missingParts > mostNamed)
        names += ", ...";
    return Error{ErrorKind::NotYet, Message::say("Of the %1 parts of the build in '%2', %3 are not finished yet: %4.",
                                                 *counts.begin(), folder_.string(), missingParts, names)};
}

// Appending.

void RunFiles::setCures(std::uint32_t block, std::span<const FaceCure> cures)
{
    if (cures_.empty())
        cures_.resize(blockCount());
    cures_[block] = cures.empty() ? 0 : checksum(std::as_bytes(cures));
}

std::uint64_t RunFiles::fingerprintOf(std::uint32_t block) const noexcept
{
    return cures_.empty() ? fingerprint_ : fingerprint_ ^ cures_[block];
}

bool RunFiles::intact(std::uint32_t block) const noexcept
{
    const Place& place = places_[block];
    return place.file != none && (takesAnyCures_ || place.header.fingerprint == fingerprintOf(block));
}

/// Whether there are runs of these blocks, with whatever cures.
bool RunFiles::has(const BlockShare& share) const noexcept
{
    for (std::uint32_t block = share.first; block < share.end; ++block)
        if (places_[block].file == none)
            return false;
    return true;
}

Status RunFiles::append(BlockRunRecorder& recorder, std::uint32_t block)
{
    const FinishedRun run = recorder.finished(fingerprintOf(block), block);
    return put(run.header, run.content);
}

Status RunFiles::put(const BlockRunHeader& header, std::span<const std::span<const std::byte>> content)
{
    const std::lock_guard lock(mutex_);
    const RunFile& file = files_[appended_];
    std::uint64_t end = end_;
    const auto write = [&](std::span<const std::byte> bytes) {
        const int problem = writeFully(file.descriptor, end, bytes);
        end += bytes.size();
        return problem;
    };
    int problem = write(std::as_bytes(std::span(&header, 1)));
    for (const std::span<const std::byte> part : content)
        problem = problem != 0 ? problem : write(part);
    if (problem != 0) {
        // The room that it took is free again; if even that fails, the sum tells that it is not whole.
        [[maybe_unused]] const int cut = ::ftruncate(file.descriptor, static_cast<off_t>(end_));
        return cannotWriteFile(file.path, problem);
    }
    places_[header.block] = {header, end_, appended_};
    end_ = end;
    return {};
}

// Reading.

Result<std::vector<FaceCure>> RunFiles::readCures(std::uint32_t block) const
{
    const Place& place = places_[block];
    std::vector<FaceCure> cures(place.header.cureCount);
    const std::span<std::byte> bytes = std::as_writable_bytes(std::span(cures));
    if (const Status done = read(place, runBytes(place.header) - bytes.size(), bytes); !done)
        return done.error();
    return cures;
}

Status RunFiles::checkComplete() const
{
    for (std::uint32_t block = 0; block < blockCount(); ++block)
        if (!intact(block))
            return damaged(places_[block]);
    return {};
}

Status RunFiles::readWords(std::uint32_t block, std::uint64_t first, std::span<std::uint32_t> words) const
{
    const Place& place = places_[block];
    if (first + words.size() > place.header.wordCount)
        return damaged(place);
    return read(place, sizeof(BlockRunHeader) + first * sizeof(std::uint32_t), std::as_writable_bytes(words));
}

Status RunFiles::readTetrahedra(std::uint32_t block, std::uint64_t first, std::uint64_t count,
                                std::span<std::byte> to) const
{
    const Place& place = places_[block];
    const BlockRunHeader& header = place.header;
    if (first + count > header.tetrahedronCount)
        return damaged(place);
    return read(place, sizeof header + header.wordCount * sizeof(std::uint32_t) + first * header.recordBytes, to);
}

Status RunFiles::read(const Place& place, std::uint64_t offset, std::span<std::byte> to) const
{
    const RunFile& file = files_[place.file];
    int problem = 0;
    if (file.descriptor >= 0) {
        problem = readFully(file.descriptor, place.offset + offset, to);
    } else {
        const OpenFile opened(file.path);
        problem = opened.descriptor() < 0 ? errno : readFully(opened.descriptor(), place.offset + offset, to);
    }
    if (problem == 0)
        return {};
    const Message reason = systemErrorText(problem);
    return unreadable(file.path, isLackOfResources(problem) ? Message::say("%1. %2", reason, resourceRemedy)
                                                            : Message::say("%1. Start the build again.", reason));
}

Error RunFiles::damaged(const Place& place) const
{
    return unreadable(place.file == none ? folder_ : files_[place.file].path,
                      Message::say("it is not what was written. Start the build again."));
}

Error RunFiles::unreadable(const std::filesystem::path& path, const Message& why) const
{
    return {ErrorKind::OutOfResource, Message::say("Cannot read '%1', which this build wrote: %2", path.string(), why),
            path};
}

} // namespace tetra
