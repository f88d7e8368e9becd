// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/history/section_checks.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <system_error>

#include <sys/resource.h>
#include <unistd.h>

namespace tetra {

void SectionSums::add(std::span<const std::byte> bytes)
{
    whole_.add(bytes);
    while (!bytes.empty()) {
        const auto piece = bytes.first(std::min<std::size_t>(bytes.size(), format::chunkBytes - inChunk_));
        if (piece.size() == format::chunkBytes) {
            full_.push_back(checksum(piece));
        } else {
            chunk_.add(piece);
            inChunk_ += piece.size();
        }
        if (inChunk_ == format::chunkBytes) {
            full_.push_back(chunk_.value());
            chunk_.reset();
            inChunk_ = 0;
        }
        bytes = bytes.subspan(piece.size());
    }
}

std::vector<std::uint64_t> SectionSums::ofChunks() const
{
    std::vector<std::uint64_t> sums = full_;
    if (inChunk_ > 0)
        sums.push_back(chunk_.value());
    return sums;
}

void ChunkSums::append(const SectionSums& sums)
{
    const std::vector<std::uint64_t> chunks = sums.ofChunks();
    elements_.insert(elements_.end(), chunks.begin(), chunks.end());
}

namespace {

using format::Section;
using format::SectionId;

constexpr std::uint64_t bitsInWord = 64;
/// Fewer chunks are not worth waking other threads for.
constexpr std::uint64_t chunksForThreads = 16;
/// Read by the thread at once: so long it takes to stop it.
constexpr std::uint64_t bytesAtOnce = 1 << 20;
constexpr int lowPriority = 10; // as 'nice' counts

/// The bits [first, end) of the word of that number.
std::uint64_t bitsOf(std::uint64_t word, std::uint64_t first, std::uint64_t end)
{
    const std::uint64_t from = std::max(first, word * bitsInWord) - word * bitsInWord;
    const std::uint64_t to = std::min(end, (word + 1) * bitsInWord) - word * bitsInWord;
    return ~std::uint64_t(0) << from & ~std::uint64_t(0) >> (bitsInWord - to);
}

Error damaged(const MappedFile& file, const Message& what)
{
    return {ErrorKind::BadInput,
            Message::say("'%1' is damaged: %2. Copy the file again, or build it again.", file.path().string(), what),
            file.path()};
}

Message wrongChecksum(std::uint32_t section)
{
    return Message::say("the checksum of section '%1' is wrong", format::sectionName(section));
}

Message impossibleNumbers(std::uint32_t section)
{
    return Message::say("section '%1' holds impossible numbers", format::sectionName(section));
}

} // namespace

Result<std::unique_ptr<const SectionChecks>> SectionChecks::make(std::shared_ptr<const MappedFile> file,
                                                                 const FileLayout& layout)
{
    std::unique_ptr<SectionChecks> checks(new SectionChecks(std::move(file), layout));
    if (!layout.has(SectionId::ChunkSums))
        checks->startThread();
    else if (const Status read = checks->readChunkSums(layout); !read)
        return read.error();
    return std::unique_ptr<const SectionChecks>(std::move(checks));
}

SectionChecks::SectionChecks(std::shared_ptr<const MappedFile> file, const FileLayout& layout) : file_(std::move(file))
{
    for (const Section& section : layout.sections)
        sections_.push_back({section.id,
                             NumberLimits(section, layout.header),
                             file_->bytes().subspan(section.offset, section.bytes),
                             section.checksum,
                             {},
                             {},
                             {}});
}

SectionChecks::~SectionChecks() = default;

Status SectionChecks::readChunkSums(const FileLayout& layout)
{
    const Section& section = layout.section(SectionId::ChunkSums);
    const std::span<const std::byte> bytes = file_->bytes().subspan(section.offset, section.bytes);
    if (checksum(bytes) != section.checksum)
        return damaged(*file_, wrongChecksum(section.id));
    const std::span elements(reinterpret_cast<const std::uint64_t*>(bytes.data()),
                             bytes.size() / sizeof(std::uint64_t));
    const std::uint64_t chunk = elements.empty() ? 0 : elements.front();
    if (!std::has_single_bit(chunk) || chunk < format::leastChunkBytes || chunk > format::mostChunkBytes)
        return damaged(*file_, Message::say("chunks of %1 bytes are impossible", chunk));
    std::uint64_t next = 1;
    for (Watched& watched : sections_) {
        if (watched.id == section.id)
            continue;
        const std::uint64_t count = format::chunkCount(watched.bytes.size(), chunk);
        if (count > elements.size() - next)
            break;
        watched.chunks = elements.subspan(next, count);
        next += count;
        const std::uint64_t words = count / bitsInWord + 1;
        watched.begun = std::make_unique<std::atomic<std::uint64_t>[]>(words);
        watched.done = std::make_unique<std::atomic<std::uint64_t>[]>(words);
    }
    std::uint64_t expected = 1;
    for (const Watched& watched : sections_)
        expected += watched.id == section.id ? 0 : format::chunkCount(watched.bytes.size(), chunk);
    if (expected != elements.size() || section.elementBytes != sizeof(std::uint64_t))
        return damaged(*file_, Message::say("section '%1' has %2 bytes instead of %3 elements of 8",
                                            format::sectionName(section.id), bytes.size(), expected));
    chunkBits_ = std::countr_zero(chunk);
    return {};
}

/// Where no thread can be had finish() does it all.
void SectionChecks::startThread()
{
    try {
        thread_ = std::jthread([this](const std::stop_token& stop) {
            ::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), lowPriority); // of this thread alone
            while (!stop.stop_requested() && goOn())
                continue;
        });
    } catch (const std::system_error&) {
        thread_ = {};
    }
}

/// Reads the next piece; false at the end. Whoever calls it takes part.
bool SectionChecks::goOn() const noexcept
{
    const std::lock_guard lock(mutex_);
    if (section_ == sections_.size())
        return false;
    const Watched& section = sections_[section_];
    const auto piece = section.bytes.subspan(read_, std::min<std::uint64_t>(bytesAtOnce, section.bytes.size() - read_));
    sum_.add(piece);
    checkNumbers(section, read_, piece);
    read_ += piece.size();
    readInAll_ += piece.size();
    if (read_ < section.bytes.size())
        return true;
    if (sum_.value() != section.sum)
        damaged_ = section.id;
    sum_.reset();
    read_ = 0;
    return ++section_ < sections_.size();
}

Status SectionChecks::finish(const Progress& progress) const
{
    while (chunkBits_ == 0 && goOn()) {
        if (progress.cancelled())
            return cancelledError(Message::marked("Checking the model's file"));
        progress.report(static_cast<double>(readInAll_) / static_cast<double>(file_->bytes().size()),
                        Message::marked("Checking the model's file"));
    }
    return damage();
}

Status SectionChecks::damage() const
{
    const std::uint32_t section = damaged_;
    if (section == 0)
        return {};
    return damaged(*file_, isImpossible_ ? impossibleNumbers(section) : wrongChecksum(section));
}

const SectionChecks::Watched& SectionChecks::sectionOf(const std::byte* place) const noexcept
{
    const auto behind = std::ranges::upper_bound(sections_, place, std::less<>(),
                                                 [](const Watched& section) { return section.bytes.data(); });
    return *std::prev(behind);
}

bool SectionChecks::check(std::span<const std::byte> part) const noexcept
{
    if (chunkBits_ > 0 && !part.empty()) {
        const Watched& section = sectionOf(part.data());
        const auto offset = static_cast<std::uint64_t>(part.data() - section.bytes.data());
        const std::uint64_t first = offset >> chunkBits_;
        const std::uint64_t end = ((offset + part.size() - 1) >> chunkBits_) + 1;
        if (!isDone(section, first, end))
            checkChunks(section, first, end);
    }
    return damaged_.load(std::memory_order_relaxed) == 0;
}

bool SectionChecks::isDone(const Watched& section, std::uint64_t first, std::uint64_t end) const noexcept
{
    for (std::uint64_t word = first / bitsInWord; word * bitsInWord < end; ++word)
        if (const std::uint64_t bits = bitsOf(word, first, end);
            (section.done[word].load(std::memory_order_acquire) & bits) != bits)
            return false;
    return true;
}

void SectionChecks::checkChunks(const Watched& section, std::uint64_t first, std::uint64_t end) const noexcept
{
    if (end - first >= chunksForThreads)
        try {
            tbb::parallel_for(first, end, [&](std::uint64_t chunk) { checkChunk(section, chunk); });
            return;
        } catch (...) { // no memory for tasks: then without
        }
    for (std::uint64_t chunk = first; chunk < end; ++chunk)
        checkChunk(section, chunk);
}

/// Checks it, or waits until the thread that has set about it is done, which waits for nothing itself.
void SectionChecks::checkChunk(const Watched& section, std::uint64_t chunk) const noexcept
{
    const std::uint64_t word = chunk / bitsInWord;
    const std::uint64_t bit = std::uint64_t(1) << chunk % bitsInWord;
    std::uint64_t done = section.done[word].load(std::memory_order_acquire);
    if ((done & bit) != 0)
        return;
    if ((section.begun[word].fetch_or(bit, std::memory_order_relaxed) & bit) == 0) {
        const std::uint64_t begin = chunk << chunkBits_;
        const std::uint64_t bytes = std::min(std::uint64_t(1) << chunkBits_, section.bytes.size() - begin);
        const std::span<const std::byte> content = section.bytes.subspan(begin, bytes);
        if (checksum(content) != section.chunks[chunk])
            damaged_ = section.id;
        else
            checkNumbers(section, begin, content);
        section.done[word].fetch_or(bit, std::memory_order_release);
        section.done[word].notify_all();
        return;
    }
    for (; (done & bit) == 0; done = section.done[word].load(std::memory_order_acquire))
        section.done[word].wait(done, std::memory_order_acquire);
}

void SectionChecks::checkNumbers(const Watched& section, std::uint64_t offset,
                                 std::span<const std::byte> part) const noexcept
{
    if (damaged_ != 0 || section.limits.hold(offset, part))
        return;
    isImpossible_ = true;
    damaged_ = section.id;
}

} // namespace tetra
