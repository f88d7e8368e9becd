// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/saved_state.h"

#include "core/base/guarded.h"
#include "core/base/positioned_io.h"
#include "core/base/system_error.h"
#include "core/base/work_folder.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace tetra {

namespace {

constexpr std::array<char, 8> stateMagic{'T', 'A', 'n', 'S', 't', 'a', 't', 'e'};
constexpr std::size_t readBytes = std::size_t(1) << 20;

int openToRead(const std::filesystem::path& path)
{
    return ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK); // a pipe in its place is waited for by nobody
}

std::uint64_t sizeOf(int descriptor)
{
    struct stat found {};
    return ::fstat(descriptor, &found) == 0 ? static_cast<std::uint64_t>(found.st_size) : 0;
}

/// Adds bytes of a file to a checksum; false if they cannot be read.
bool addTo(Checksum& sum, int descriptor, std::uint64_t begin, std::uint64_t end)
{
    Buffer<std::byte> some(readBytes);
    while (begin < end) {
        const std::span<std::byte> next = std::span(some).first(std::min<std::uint64_t>(readBytes, end - begin));
        if (readFully(descriptor, begin, next) != 0)
            return false;
        sum.add(next);
        begin += next.size();
    }
    return true;
}

template <class T> std::span<std::byte> bytesOf(T& plain)
{
    return std::as_writable_bytes(std::span(&plain, 1));
}

} // namespace

void StateArchive::bytes(std::span<std::byte> some)
{
    bytes_ += some.size();
    if (mode_ == Mode::Measure || some.empty())
        return;
    if (mode_ == Mode::Save) {
        state_.sum_.add(some);
        (void)state_.writer_->write(some); // commit() tells
        return;
    }
    const std::uint64_t offset = bytes_ - some.size();
    if (state_.readFailed_ || offset + some.size() > state_.end_) {
        state_.readFailed_ = true;
        std::ranges::fill(some, std::byte{});
        return;
    }
    if (some.size() >= readBytes) {
        state_.readFailed_ = readFully(state_.file_, offset, some) != 0;
        return;
    }
    Buffer<std::byte>& read = state_.read_;
    if (offset < state_.readAt_ || offset + some.size() > state_.readAt_ + read.size()) {
        read.resize(std::min<std::uint64_t>(readBytes, state_.end_ - offset));
        state_.readAt_ = offset;
        state_.readFailed_ = readFully(state_.file_, offset, read) != 0;
    }
    std::memcpy(some.data(), read.data() + (offset - state_.readAt_), some.size());
}

bool StateArchive::isThere(std::uint64_t size)
{
    if (isLoading())
        state_.readFailed_ = state_.readFailed_ || size > state_.end_ - std::min(bytes_, state_.end_);
    return !isLoading() || !state_.readFailed_;
}

std::uint64_t StateArchive::count(std::uint64_t size, std::size_t bytesEach)
{
    bytes(bytesOf(size));
    if (isLoading() && (size > state_.end_ / bytesEach || !isThere(size * bytesEach))) {
        state_.readFailed_ = true;
        return 0;
    }
    return size;
}

std::uint64_t StateArchive::grownBytes(std::uint64_t size) const
{
    if (!isLoading())
        return size;
    std::uint64_t found = 0;
    for (const SavedState::Extent& extent : state_.extents_)
        found += extent.stream == stream_ ? extent.size : 0;
    return found;
}

void StateArchive::grownPart(std::span<std::byte> all)
{
    std::uint64_t known = 0;
    for (const SavedState::Extent& extent : state_.extents_) {
        if (extent.stream != stream_)
            continue;
        if (isLoading() && !state_.readFailed_)
            state_.readFailed_ =
                known + extent.size > all.size() || !state_.readJournal(extent.offset, all.subspan(known, extent.size));
        known += extent.size;
    }
    if (mode_ == Mode::Save)
        state_.append(stream_, all.subspan(known));
    else if (mode_ == Mode::Measure)
        bytes_ += all.size() - known;
    ++stream_;
}

Result<std::unique_ptr<SavedState>> SavedState::open(const std::filesystem::path& folder, std::uint64_t fingerprint)
{
    std::unique_ptr<SavedState> state(new SavedState(folder, fingerprint));
    if (const Status found = state->find(); !found)
        return found.error();
    return state;
}

SavedState::SavedState(const std::filesystem::path& folder, std::uint64_t fingerprint)
    : folder_(folder), path_(folder / "state"), journalPath_(folder / "journal"), fingerprint_(fingerprint),
      next_(start_ + shortest)
{
}

SavedState::~SavedState()
{
    for (const int descriptor : {file_, journal_})
        if (descriptor >= 0)
            ::close(descriptor);
}

Error SavedState::ofOtherWork(const std::filesystem::path& folder)
{
    return {ErrorKind::WrongUsage,
            Message::say("What an interrupted build left in '%1' belongs to other data, other options, or another "
                         "version of TAn. Give the same ones, or build from the beginning.",
                         folder.string())};
}

Error SavedState::damaged() const
{
    return {
        ErrorKind::BadInput,
        Message::say("What an interrupted build left in '%1' is damaged. Build from the beginning.", folder_.string())};
}

Status SavedState::find()
{
    file_ = openToRead(path_);
    if (file_ < 0 && errno == ENOENT)
        return {};
    if (file_ < 0)
        return Error{isLackOfResources(errno) ? ErrorKind::OutOfResource : ErrorKind::BadInput,
                     Message::say("'%1' cannot be read: %2.", path_.string(), systemErrorText(errno))};
    Foot foot;
    std::uint64_t checksum = 0;
    const std::uint64_t size = sizeOf(file_), least = sizeof foot + sizeof checksum;
    if (size < least || readFully(file_, size - least, bytesOf(foot)) != 0 || foot.magic != stateMagic ||
        readFully(file_, size - sizeof checksum, bytesOf(checksum)) != 0 ||
        !addTo(sum_, file_, 0, size - sizeof checksum) || sum_.value() != checksum)
        return damaged();
    if (foot.fingerprint != fingerprint_)
        return ofOtherWork(folder_);
    end_ = foot.objectSize;
    extents_.resize(foot.extentCount);
    if (readFully(file_, end_, std::as_writable_bytes(std::span(extents_))) != 0)
        return damaged();
    return checkJournal(foot);
}

Status SavedState::checkJournal(const Foot& foot)
{
    journal_ = ::open(journalPath_.c_str(), O_RDWR | O_CLOEXEC | O_NONBLOCK);
    journalSize_ = foot.journalSize;
    if (journalSize_ > 0 &&
        (journal_ < 0 || sizeOf(journal_) < journalSize_ || !addTo(journalSum_, journal_, 0, journalSize_)))
        return damaged();
    if (journalSum_.value() != foot.journalChecksum)
        return damaged();
    found_ = true;
    return {};
}

Status SavedState::endOfLoading(const StateArchive& archive)
{
    const bool fits = !readFailed_ && archive.bytes_ == end_;
    ::close(std::exchange(file_, -1)); // the next one takes its place, and its room
    Buffer<std::byte>().swap(read_);
    return fits ? Status() : damaged();
}

Status SavedState::readJournal(std::uint64_t offset, std::span<std::byte> bytes) const
{
    if (offset > journalSize_ || bytes.size() > journalSize_ - offset || readFully(journal_, offset, bytes) != 0)
        return damaged();
    return {};
}

Status SavedState::readNotes(const std::function<Status(std::span<const std::byte>)>& visit)
{
    Buffer<std::byte> some;
    for (const Extent& extent : extents_) {
        if (extent.stream != notes)
            continue;
        for (std::uint64_t done = 0; done < extent.size; done += some.size()) {
            some.resize(std::min<std::uint64_t>(readBytes, extent.size - done));
            if (const Status read = readJournal(extent.offset + done, some); !read)
                return read;
            if (const Status visited = visit(some); !visited)
                return visited;
        }
    }
    return {};
}

void SavedState::note(std::span<const std::byte> bytes)
{
    if (bytes.empty())
        return;
    const std::size_t before = noted_.size();
    noted_.resize(before + bytes.size());
    std::memcpy(noted_.data() + before, bytes.data(), bytes.size());
    if (noted_.size() >= readBytes)
        appendNoted();
}

void SavedState::appendNoted()
{
    append(notes, noted_);
    noted_.clear();
}

/// The last state is still there, and the model will want about as much as the journal.
bool SavedState::hasRoom(std::uint64_t bytes) const
{
    const std::uint64_t free = freeDiskBytes(folder_);
    return free == 0 || free >= 2 * bytes + journalSize_; // 0: not known
}

void SavedState::append(std::uint64_t stream, std::span<const std::byte> bytes)
{
    if (givenUp_ || bytes.empty())
        return;
    if (journal_ < 0)
        journal_ = ::open(journalPath_.c_str(), O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (journal_ < 0 || !hasRoom(bytes.size()) || writeFully(journal_, journalSize_, bytes) != 0)
        return giveUp();
    if (extents_.empty() || extents_.back().stream != stream)
        extents_.push_back({stream, journalSize_, 0});
    extents_.back().size += bytes.size();
    journalSum_.add(bytes);
    journalSize_ += bytes.size();
}

/// Before anything was saved it is not known how long that takes; a large state had better be saved once, and late,
/// than as soon as the build has begun.
bool SavedState::comesTooEarly(std::uint64_t bytes)
{
    constexpr double bytesAMillisecond = 1e6;
    if (std::exchange(putOff_, true))
        return false;
    const auto wait = static_cast<std::int64_t>(share * static_cast<double>(bytes) / bytesAMillisecond);
    next_ = std::max(next_, start_ + std::chrono::milliseconds(wait));
    return Clock::now() < next_;
}

void SavedState::save(const std::function<void(StateArchive& archive)>& archiveObject, bool atOnce)
{
    const auto begin = Clock::now();
    try {
        if (!write(archiveObject, atOnce))
            giveUp();
    } catch (const std::bad_alloc&) {
        giveUp(); // the build needs it more
    }
    writer_ = nullptr;
    const auto end = Clock::now();
    next_ = std::max(next_, end + std::max<Clock::duration>(shortest, share * (end - begin)));
}

bool SavedState::write(const std::function<void(StateArchive& archive)>& archiveObject, bool atOnce)
{
    StateArchive measuring(*this, StateArchive::Mode::Measure);
    archiveObject(measuring);
    if (!hasRoom(measuring.bytes_) || (!atOnce && comesTooEarly(measuring.bytes_)))
        return true; // perhaps the next time
    appendNoted();
    auto writer = FileWriter::create(path_, readBytes); // which clears away those that were never done
    if (!writer)
        return false;
    writer_ = &*writer;
    sum_.reset();
    StateArchive saving(*this, StateArchive::Mode::Save);
    archiveObject(saving);
    Foot foot{stateMagic, fingerprint_, saving.bytes_, extents_.size(), journalSize_, journalSum_.value()};
    saving.elements(std::span(extents_));
    saving(foot);
    std::uint64_t checksum = sum_.value();
    saving(checksum);
    const bool journalIsSafe = !givenUp_ && (journal_ < 0 || ::fdatasync(journal_) == 0);
    return journalIsSafe && writer->commit().ok();
}

void SavedState::giveUp() noexcept
{
    givenUp_ = true;
    std::error_code problem;
    std::filesystem::remove(path_, problem);
    std::filesystem::remove(journalPath_, problem);
}

} // namespace tetra
