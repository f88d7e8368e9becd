// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/history/blocks/run_files.h"

#include "core/base/checksum.h"
#include "core/base/file_writer.h"
#include "core/base/finished_file.h"
#include "core/base/folder.h"
#include "core/base/mapped_file.h"
#include "core/base/positioned_io.h"
#include "core/base/text.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <random>
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
    const bool isOne = part.number >= 1 && part.number <= part.count && partFileName(part) == name;
    return isOne ? std::optional(part) : std::nullopt;
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

/// Of an open file; zeros if the system does not tell.
struct stat statusOf(int descriptor)
{
    struct stat status {};
    if (::fstat(descriptor, &status) != 0)
        status = {};
    return status;
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

/// Enters the whole runs of an open file among the places.
Result<RunFiles::Found> RunFiles::findRuns(std::uint32_t file, const Progress& progress)
{
    const auto& [path, descriptor, inode] = files_[file];
    const auto size = static_cast<std::uint64_t>(statusOf(descriptor).st_size);
    RunFileHeader begin;
    if (size < sizeof begin) // killed before its first run
        return Found{.whole = false};
    if (const int problem = readFully(descriptor, 0, std::as_writable_bytes(std::span(&begin, 1))))
        return cannotReadFile(path, problem);
    if (begin.magic != RunFileHeader().magic)
        return Found{.whole = false};
    if (begin.fingerprint != fingerprint_)
        return Found{.ofThisBuild = false};
    Found found{.end = sizeof begin};
    BlockRunHeader header;
    while (found.end + sizeof header <= size) {
        if (const int problem = readFully(descriptor, found.end, std::as_writable_bytes(std::span(&header, 1))))
            return cannotReadFile(path, problem);
        if (!isPlausible(header, blockCount(), size - found.end))
            break;
        Checksum checksum;
        checksum.add(std::as_bytes(std::span(&header, 1)).first(offsetof(BlockRunHeader, checksum)));
        const int problem =
            addBytes(descriptor, found.end + sizeof header, runBytes(header) - sizeof header, progress, checksum);
        if (problem == ECANCELED)
            return cancelledError(Message::marked("The build"));
        if (problem != 0)
            return cannotReadFile(path, problem);
        if (checksum.value() == header.checksum)
            places_[header.block] = {header, found.end, file};
        else
            found.whole = false;
        found.end += runBytes(header);
        progress.report(static_cast<double>(found.end) / static_cast<double>(size),
                        Message::marked("Checking what is done already"));
    }
    found.whole = found.whole && found.end == size;
    return found;
}

// Opening.

/// As the last of the files.
Status RunFiles::openFile(const std::filesystem::path& path, int flags)
{
    constexpr int readableByAll = 0666;
    const int descriptor = ::open(path.c_str(), flags | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, readableByAll);
    if (descriptor < 0)
        return (flags & O_CREAT) != 0 ? cannotWriteFile(path, errno) : cannotReadFile(path, errno);
    files_.push_back({path, descriptor, statusOf(descriptor).st_ino});
    return {};
}

/// To the last file: cuts off what follows its last run, and gives an empty one its header.
Status RunFiles::beginToAppend(std::uint64_t end)
{
    appended_ = static_cast<std::uint32_t>(files_.size() - 1);
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
    if (const Status opened = openFile(folder_ / ownFile, O_RDWR | O_CREAT); !opened)
        return opened;
    if (!reuse)
        return beginToAppend(0);
    const auto found = findRuns(0, progress);
    if (!found)
        return found.error();
    return beginToAppend(found->ofThisBuild ? found->end : 0);
}

Status RunFiles::openPart(const PartNumber& part, const Progress& progress)
{
    constexpr double finishedShare = 0.5;
    part_ = part;
    std::error_code problem;
    std::vector<std::filesystem::path> attempts = pathsIn(folder_, problem);
    if (problem)
        return cannotReadFile(folder_, problem.value());
    if (std::ranges::find(attempts, folder_ / partFileName(part)) != attempts.end()) {
        if (const Status opened = openFile(folder_ / partFileName(part), O_RDONLY); !opened)
            return opened;
        const auto found = findRuns(0, progress.part(0, finishedShare));
        if (!found)
            return found.error();
        if (!found->ofThisBuild)
            return ofOtherBuild(files_[0].path);
        partIsFinished_ = found->whole && has(shareOf(part, blockCount()));
        replacesDamaged_ = !partIsFinished_;
    }
    if (partIsFinished_)
        return {};
    std::erase_if(attempts, [&](const auto& path) { return !isUnfinished(path.filename().string(), part); });
    return adoptOrCopy(attempts, progress.part(finishedShare, 1));
}

/// An attempt that has ended is gone on with: nobody else has its file when this process has locked it. What an attempt
/// has done that may still go on is copied.
Status RunFiles::adoptOrCopy(std::span<const std::filesystem::path> attempts, const Progress& progress)
{
    std::optional<std::uint32_t> adopted;
    std::uint64_t end = 0;
    for (std::size_t number = 0; number < attempts.size(); ++number) {
        const auto file = static_cast<std::uint32_t>(files_.size());
        if (!openFile(attempts[number], O_RDWR)) // gone meanwhile, or of somebody else
            continue;
        const bool isOver = lockFile(files_[file].descriptor, attempts[number]) == FileLock::Taken;
        const auto count = static_cast<double>(attempts.size()), done = static_cast<double>(number);
        const auto found = findRuns(file, progress.part(done / count, (done + 1) / count));
        if (!found)
            return found.error();
        if (!found->ofThisBuild)
            return ofOtherBuild(attempts[number]);
        if (isOver && found->end > end) {
            adopted = file;
            end = found->end;
        }
    }
    if (adopted) { // as the last one, which is appended to
        std::swap(files_[*adopted], files_.back());
        const auto last = static_cast<std::uint32_t>(files_.size() - 1);
        for (Place& place : places_)
            if (place.file == *adopted || place.file == last)
                place.file = place.file == last ? *adopted : last;
    } else if (const Status made = makeUnfinished(); !made) {
        return made;
    }
    if (const Status begun = beginToAppend(end); !begun)
        return begun;
    const BlockShare share = shareOf(*part_, blockCount());
    for (std::uint32_t block = share.first; block < share.end; ++block)
        if (places_[block].file != none && places_[block].file != appended_) {
            if (progress.cancelled())
                return cancelledError(Message::marked("The build"));
            if (const Status copied = takeOver(block); !copied)
                return copied;
        }
    for (RunFile& file : files_)
        if (&file != &files_.back())
            ::close(std::exchange(file.descriptor, -1));
    removeLeftFiles(folder_, [&](std::string_view name) { return isUnfinished(name, *part_); });
    return {};
}

/// A file of this process alone, which it has locked, if the file system can: so that nobody takes it for left behind.
Status RunFiles::makeUnfinished()
{
    for (;;) {
        if (const Status made = openFile(folder_ / unfinishedName(*part_), O_RDWR | O_CREAT | O_EXCL); !made)
            return made;
        const FileLock lock = lockFile(files_.back().descriptor, files_.back().path);
        if (lock == FileLock::Taken || lock == FileLock::Impossible)
            return {};
        ::close(files_.back().descriptor); // another process found it before it was locked, and removes it
        files_.pop_back();
    }
}

/// Copies a run of another attempt; one that is not what it was any more is made again.
Status RunFiles::takeOver(std::uint32_t block)
{
    const Place from = std::exchange(places_[block], {});
    std::vector<std::byte> bytes(runBytes(from.header) - sizeof from.header);
    if (!read(from, sizeof from.header, bytes))
        return {};
    const std::array<std::span<const std::byte>, 1> content{bytes};
    return runChecksum(from.header, content) == from.header.checksum ? put(from.header, content) : Status();
}

Status RunFiles::finishPart()
{
    const std::filesystem::path finished = folder_ / partFileName(*part_);
    const std::filesystem::path& own = files_[appended_].path;
    std::error_code problem;
    if (!replacesDamaged_ && std::filesystem::exists(finished, problem))
        ::unlink(own.c_str()); // whoever merges may have begun to read the other one, whose runs are the same
    else if (const Status named = replaceFile(own, finished); !named)
        return named;
    removeLeftFiles(folder_, [&](std::string_view name) { return isUnfinished(name, *part_); });
    return {};
}

Status RunFiles::openParts(const Progress& progress)
{
    std::vector<PartNumber> parts = finishedParts(folder_);
    const bool staysOpen = canStayOpen(parts.size());
    for (std::uint32_t file = 0; file < parts.size(); ++file) {
        const std::filesystem::path path = folder_ / partFileName(parts[file]);
        if (const Status opened = openFile(path, O_RDONLY); !opened)
            return opened;
        const auto count = static_cast<double>(parts.size()), done = static_cast<double>(file);
        const auto found = findRuns(file, progress.part(done / count, (done + 1) / count));
        if (!found)
            return found.error();
        if (!found->ofThisBuild)
            return ofOtherBuild(path);
        if (!found->whole || !has(shareOf(parts[file], blockCount())))
            return Error{ErrorKind::BadInput,
                         Message::say("'%1' is damaged. Build that part again: it keeps what is whole.", path.string()),
                         path};
        if (!staysOpen)
            ::close(std::exchange(files_[file].descriptor, -1));
    }
    takesAnyCures_ = true;
    return has({0, blockCount()}) ? Status() : checkNoneMissing(folder_);
}

std::vector<PartNumber> finishedParts(const std::filesystem::path& folder)
{
    std::error_code unreadable; // then there are none
    std::vector<PartNumber> parts;
    for (const std::filesystem::path& path : pathsIn(folder, unreadable))
        if (const auto part = partOf(path.filename().string()))
            parts.push_back(*part);
    std::ranges::sort(parts, {}, [](const PartNumber& part) { return std::pair(part.count, part.number); });
    return parts;
}

Status checkNoneMissing(const std::filesystem::path& folder)
{
    const std::vector<PartNumber> parts = finishedParts(folder);
    const std::span<const PartNumber> finished(parts);
    if (finished.empty())
        return Error{ErrorKind::NotYet, Message::say("No part of the build in '%1' is finished yet.", folder.string())};
    const std::uint32_t count = finished.front().count;
    for (std::size_t first = 0; first < finished.size();) { // the parts of one division follow each other
        const auto isOfOther = [&](const PartNumber& part) { return part.count != finished[first].count; };
        const auto end = std::ranges::find_if(finished.subspan(first), isOfOther);
        const auto there = static_cast<std::size_t>(end - finished.subspan(first).begin());
        if (there == finished[first].count)
            return {};
        first += there;
    }
    if (finished.back().count != count)
        return Error{ErrorKind::NotYet,
                     Message::say("Parts of the build in '%1' are missing, and those that are there are of different "
                                  "divisions. Build all parts of one of them.",
                                  folder.string())};
    constexpr std::size_t mostNamed = 20;
    std::string names;
    std::size_t named = 0, next = 0; // the first of the finished that is not before the number
    for (std::uint32_t number = 1; number <= count && named < mostNamed; ++number) {
        if (next < finished.size() && finished[next].number == number) {
            ++next;
            continue;
        }
        names += (names.empty() ? "" : ", ") + std::to_string(number);
        ++named;
    }
    return Error{ErrorKind::NotYet,
                 Message::say("Of the %1 parts of the build in '%2' these are not finished yet: %3%4.", count,
                              folder.string(), names, count - finished.size() > named ? ", ..." : "")};
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
    unsynced_ += end - std::exchange(end_, end);
    // A part is synced when it is finished, which would take long then, and all at once.
    constexpr std::uint64_t mostUnsynced = 256 << 20;
    if (part_ && unsynced_ > mostUnsynced) {
        unsynced_ = 0;
        if (::fdatasync(file.descriptor) != 0)
            return cannotWriteFile(file.path, errno);
    }
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
        if (opened.descriptor() >= 0 && statusOf(opened.descriptor()).st_ino != file.inode)
            return damaged(place);
        problem = opened.descriptor() < 0 ? errno : readFully(opened.descriptor(), place.offset + offset, to);
    }
    return problem == 0 ? Status() : Status(cannotReadFile(file.path, problem));
}

Error RunFiles::damaged(const Place& place) const
{
    const std::filesystem::path& path = place.file == none ? folder_ : files_[place.file].path;
    return {ErrorKind::OutOfResource,
            Message::say("'%1', which this build wrote, is not what was written. Start the same command again.",
                         path.string()),
            path};
}

} // namespace tetra
