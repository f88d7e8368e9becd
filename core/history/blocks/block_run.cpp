// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/history/blocks/block_run.h"

#include "core/base/checksum.h"
#include "core/base/file_writer.h"
#include "core/base/positioned_io.h"
#include "core/base/rounding.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <limits>
#include <utility>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

namespace tetra {

void BlockRunRecorder::start()
{
    builder_ = std::make_unique<BatchBuilder>(pointCount_, static_cast<BatchSink&>(*this));
    finalKey_ = 0;
    siteCount_ = 0;
    words_.clear();
    tetrahedra_.clear();
    setFindings({}, 0, 0);
}

Status BlockRunRecorder::add(const HistoryStep& step)
{
    return builder_->add(step);
}

Status BlockRunRecorder::finish(float finalKey)
{
    finalKey_ = finalKey;
    const Status done = builder_->finish();
    livingCount_ = builder_->aliveCount();
    builder_.reset();
    return done;
}

Status BlockRunRecorder::add(const Batch& batch)
{
    for (const Batch::Tetrahedron& made : batch.tetrahedra)
        tetrahedra_.push_back({made.sites, WideTetrahedron::never, halfBound(made.error, valueExtent_),
                               diagonal_ > 0 ? halfBound(made.warping, diagonal_) : std::uint16_t(0)});
    destroyed_.assign(batch.points.size(), 0);
    for (const Batch::Destruction& destruction : batch.destructions) {
        tetrahedra_[destruction.tetrahedron].destroyer = destruction.destroyer;
        ++destroyed_[destruction.destroyer - batch.firstSite];
    }
    words_.push_back(std::bit_cast<std::uint32_t>(batch.runningKey));
    words_.push_back(static_cast<std::uint32_t>(std::ranges::count(batch.groupGoesOn, 0)));
    std::size_t first = 0;
    for (std::size_t place = 0; place < batch.points.size(); ++place)
        if (batch.groupGoesOn[place] == 0) {
            addGroup(batch, first, place + 1);
            first = place + 1;
        }
    siteCount_ += static_cast<std::uint32_t>(batch.points.size());
    return {};
}

void BlockRunRecorder::addGroup(const Batch& batch, std::size_t first, std::size_t end)
{
    std::uint32_t destroyed = 0;
    for (std::size_t place = first; place < end; ++place)
        destroyed += destroyed_[place];
    words_.push_back(static_cast<std::uint32_t>(end - first));
    words_.push_back(batch.starEnds[end - 1] - (first == 0 ? 0 : batch.starEnds[first - 1]));
    words_.push_back(destroyed);
    for (std::size_t place = first; place < end; ++place)
        words_.push_back(static_cast<std::uint32_t>(batch.points[place]));
}

/// The tetrahedra with numbers of 16 bits.
std::span<const std::byte> BlockRunRecorder::narrowed()
{
    const auto narrow = []<class Record>(const WideTetrahedron& wide, Record& record) {
        std::ranges::transform(wide.sites, record.sites.begin(),
                               [](std::uint32_t site) { return static_cast<std::uint16_t>(site); });
        record.destroyer = static_cast<std::uint16_t>(wide.destroyer);
        record.ownError = wide.ownError;
    };
    if (diagonal_ > 0) {
        warped_.resize(tetrahedra_.size());
        for (std::size_t i = 0; i < warped_.size(); ++i) {
            narrow(tetrahedra_[i], warped_[i]);
            warped_[i].ownWarping = tetrahedra_[i].ownWarping;
        }
        return std::as_bytes(std::span(warped_));
    }
    narrow_.resize(tetrahedra_.size());
    for (std::size_t i = 0; i < narrow_.size(); ++i)
        narrow(tetrahedra_[i], narrow_[i]);
    return std::as_bytes(std::span(narrow_));
}

void BlockRunRecorder::setFindings(std::vector<FaceCure> cures, std::uint64_t inverted, std::uint64_t degenerate)
{
    cures_ = std::move(cures);
    inverted_ = static_cast<std::uint32_t>(inverted);
    degenerate_ = static_cast<std::uint32_t>(degenerate);
}

Status BlockRunRecorder::write(const std::filesystem::path& path, std::uint64_t fingerprint, std::uint32_t block)
{
    if (!cures_.empty()) { // nobody will read the rest
        siteCount_ = 0;
        livingCount_ = 0;
        words_.clear();
        tetrahedra_.clear();
    }
    BlockRunHeader header;
    header.fingerprint = fingerprint;
    header.block = block;
    header.cureCount = cures_.size();
    header.inverted = inverted_;
    header.degenerate = degenerate_;
    header.siteCount = siteCount_;
    header.wordCount = words_.size();
    header.tetrahedronCount = tetrahedra_.size();
    header.finalKey = finalKey_;
    header.livingCount = livingCount_;
    const bool isNarrow = siteCount_ <= NarrowTetrahedron::never;
    header.recordBytes = !isNarrow       ? sizeof(WideTetrahedron)
                         : diagonal_ > 0 ? sizeof(WarpedTetrahedron)
                                         : sizeof(NarrowTetrahedron);
    const auto records = isNarrow ? narrowed() : std::as_bytes(std::span(tetrahedra_));
    const auto words = std::as_bytes(std::span(words_));
    const auto cures = std::as_bytes(std::span(cures_));
    Checksum checksum;
    checksum.add(std::as_bytes(std::span(&header, 1)).first(offsetof(BlockRunHeader, checksum)));
    for (const std::span<const std::byte> part : {words, records, cures})
        checksum.add(part);
    header.checksum = checksum.value();

    Result<FileWriter> file = FileWriter::create(path, 1, path.parent_path());
    if (!file)
        return file.error();
    for (const std::span<const std::byte> part : {std::as_bytes(std::span(&header, 1)), words, records, cures})
        if (const Status written = file->write(part); !written)
            return written;
    return file->commit(FileWriter::Durability::Process);
}

namespace {

/// Whether the runs of so many blocks may stay open, or are opened for each look into them: of the files that a process
/// may have open, 1024 as a rule, half are left to others.
bool canStayOpen(std::uint64_t blocks)
{
    struct rlimit limit {};
    return ::getrlimit(RLIMIT_NOFILE, &limit) == 0 && blocks <= limit.rlim_cur / 2;
}

constexpr std::size_t checkedAtOnce = 1 << 18;

bool belongs(const BlockRunHeader& header, std::uint64_t fingerprint, std::uint32_t block, std::uint64_t fileBytes)
{
    const std::uint32_t most = 1u << 31;
    return header.magic == BlockRunHeader().magic && header.fingerprint == fingerprint && header.block == block &&
           (header.recordBytes == sizeof(NarrowTetrahedron) || header.recordBytes == sizeof(WarpedTetrahedron) ||
            header.recordBytes == sizeof(WideTetrahedron)) &&
           header.wordCount < most && header.tetrahedronCount < 2ull * most && header.cureCount < most &&
           fileBytes == runBytes(header);
}

std::uint64_t fileSize(int descriptor)
{
    struct stat status {};
    return ::fstat(descriptor, &status) == 0 ? static_cast<std::uint64_t>(status.st_size) : 0;
}

} // namespace

/// Closes a file at the end of a block of code.
class RunFiles::OpenFile {
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
    int release() noexcept { return std::exchange(descriptor_, -1); }

private:
    int descriptor_;
};

std::uint64_t runBytes(const BlockRunHeader& header) noexcept
{
    return sizeof header + header.wordCount * sizeof(std::uint32_t) + header.tetrahedronCount * header.recordBytes +
           header.cureCount * sizeof(FaceCure);
}

Status checkMeshSize(std::uint64_t tetrahedra, std::uint64_t expected)
{
    constexpr std::uint64_t most = std::numeric_limits<std::uint32_t>::max(); // FORMAT.md: mesh sizes
    constexpr std::uint64_t farTooMany = most + most / 4;                     // what is expected is not known so well
    if (tetrahedra <= most && expected <= farTooMany)
        return {};
    return Error{ErrorKind::OutOfResource,
                 Message::say("The finest mesh would have about %1 tetrahedra, and a model holds meshes of at most %2. "
                              "Choose a larger error, or take a part of the dataset.",
                              std::max(tetrahedra, expected), most)};
}

RunFiles::RunFiles(std::filesystem::path folder, std::uint64_t fingerprint, std::uint32_t blockCount)
    : folder_(std::move(folder)), fingerprint_(fingerprint), fingerprints_(blockCount, fingerprint),
      headers_(blockCount)
{
}

void RunFiles::setCures(std::uint32_t block, std::span<const FaceCure> cures)
{
    fingerprints_[block] = cures.empty() ? fingerprint_ : fingerprint_ ^ checksum(std::as_bytes(cures));
}

RunFiles::~RunFiles()
{
    close();
}

void RunFiles::close() noexcept
{
    for (const int descriptor : descriptors_)
        if (descriptor >= 0)
            ::close(descriptor);
    descriptors_.clear();
}

std::filesystem::path RunFiles::path(std::uint32_t block) const
{
    return folder_ / ("block-" + std::to_string(block) + ".run");
}

bool RunFiles::intact(std::uint32_t block) const
{
    const OpenFile file(path(block));
    const Result<BlockRunHeader> header = readHeader(file, block);
    if (!header)
        return false;
    Checksum checksum;
    checksum.add(std::as_bytes(std::span(&*header, 1)).first(offsetof(BlockRunHeader, checksum)));
    std::vector<std::byte> bytes(checkedAtOnce);
    std::uint64_t offset = sizeof *header;
    for (std::uint64_t left = runBytes(*header) - sizeof *header; left > 0;) {
        const std::span<std::byte> part(bytes.data(), std::min<std::uint64_t>(left, bytes.size()));
        if (readFully(file.descriptor(), offset, part) != 0)
            return false;
        checksum.add(part);
        offset += part.size();
        left -= part.size();
    }
    return checksum.value() == header->checksum;
}

Result<BlockRunHeader> RunFiles::readHeader(std::uint32_t block) const
{
    const OpenFile file(path(block));
    return readHeader(file, block);
}

Result<BlockRunHeader> RunFiles::readHeader(const OpenFile& file, std::uint32_t block) const
{
    BlockRunHeader header;
    if (file.descriptor() < 0)
        return unreadable(block, errno);
    if (readFully(file.descriptor(), 0, std::as_writable_bytes(std::span(&header, 1))) != 0 ||
        !belongs(header, fingerprints_[block], block, fileSize(file.descriptor())))
        return damaged(block);
    return header;
}

Result<std::vector<FaceCure>> RunFiles::readCures(std::uint32_t block) const
{
    const OpenFile file(path(block));
    const Result<BlockRunHeader> header = readHeader(file, block);
    if (!header)
        return header.error();
    std::vector<FaceCure> cures(header->cureCount);
    const std::span<std::byte> bytes = std::as_writable_bytes(std::span(cures));
    if (const int problem = readFully(file.descriptor(), runBytes(*header) - bytes.size(), bytes); problem != 0)
        return unreadable(block, problem);
    return cures;
}

Status RunFiles::open()
{
    close();
    const bool staysOpen = canStayOpen(blockCount());
    for (std::uint32_t block = 0; block < blockCount(); ++block) {
        OpenFile file(path(block));
        const Result<BlockRunHeader> header = readHeader(file, block);
        if (!header)
            return header.error();
        headers_[block] = *header;
        if (staysOpen)
            descriptors_.push_back(file.release());
    }
    return {};
}

Status RunFiles::readWords(std::uint32_t block, std::uint64_t first, std::span<std::uint32_t> words) const
{
    if (first + words.size() > headers_[block].wordCount)
        return damaged(block);
    return read(block, sizeof(BlockRunHeader) + first * sizeof(std::uint32_t), std::as_writable_bytes(words));
}

Status RunFiles::readTetrahedra(std::uint32_t block, std::uint64_t first, std::uint64_t count,
                                std::span<std::byte> to) const
{
    const BlockRunHeader& header = headers_[block];
    if (first + count > header.tetrahedronCount)
        return damaged(block);
    return read(block, sizeof(BlockRunHeader) + header.wordCount * sizeof(std::uint32_t) + first * header.recordBytes,
                to);
}

Status RunFiles::read(std::uint32_t block, std::uint64_t offset, std::span<std::byte> to) const
{
    int problem = 0;
    if (!descriptors_.empty()) {
        problem = readFully(descriptors_[block], offset, to);
    } else {
        const OpenFile file(path(block));
        problem = file.descriptor() < 0 ? errno : readFully(file.descriptor(), offset, to);
    }
    if (problem != 0)
        return unreadable(block, problem);
    return {};
}

Error RunFiles::unreadable(std::uint32_t block, int systemError) const
{
    const Message reason = systemErrorText(systemError);
    return unreadable(block, isLackOfResources(systemError) ? Message::say("%1. %2", reason, resourceRemedy)
                                                            : Message::say("%1. Start the build again.", reason));
}

Error RunFiles::damaged(std::uint32_t block) const
{
    return unreadable(block, Message::say("it is not what was written. Start the build again."));
}

Error RunFiles::unreadable(std::uint32_t block, const Message& why) const
{
    return {ErrorKind::OutOfResource,
            Message::say("Cannot read '%1', which this build wrote: %2", path(block).string(), why), path(block)};
}

} // namespace tetra
