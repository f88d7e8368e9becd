// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/remote/piece_store.h"

#include "core/base/checksum.h"
#include "core/base/positioned_io.h"
#include "core/base/system_error.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <string>

#include <fcntl.h>
#include <unistd.h>

namespace tetra {

namespace {

struct StoreHead {
    std::array<char, 8> magic{'T', 'A', 'N', 'P', 'C', 'S', '0', '1'};
    std::uint64_t size = 0;
    std::uint64_t keyBytes = 0;
    std::uint64_t sum = 0;
};

/// A head with the key behind it.
std::vector<std::byte> headBytes(std::string_view key, std::uint64_t size)
{
    StoreHead head;
    head.size = size;
    head.keyBytes = key.size();
    Checksum sum;
    sum.add(std::as_bytes(std::span(&head, 1)));
    sum.add(std::as_bytes(std::span(key)));
    head.sum = sum.value();
    std::vector<std::byte> bytes(sizeof head + key.size());
    std::memcpy(bytes.data(), &head, sizeof head);
    std::memcpy(bytes.data() + sizeof head, key.data(), key.size());
    return bytes;
}

constexpr std::uint64_t roundedUp(std::uint64_t number, std::uint64_t multiple)
{
    return (number + multiple - 1) / multiple * multiple;
}

Error cannotKeep(const std::filesystem::path& path, int systemError)
{
    return {isLackOfResources(systemError) ? ErrorKind::OutOfResource : ErrorKind::CannotWrite,
            Message::say("Cannot write '%1': %2. %3", path.string(), systemErrorText(systemError),
                         diskRemedy(systemError))};
}

/// Never 0, which stands for a piece that is not there.
std::uint64_t sumOf(std::span<const std::byte> piece)
{
    return std::max<std::uint64_t>(checksum(piece), 1);
}

/// How much is written before the folder is asked again whether there is room.
std::uint64_t stepOfGrowth(std::uint64_t limit)
{
    return std::clamp<std::uint64_t>(limit / 64, PieceStore::pieceBytes, std::uint64_t(16) << 20);
}

} // namespace

Result<std::shared_ptr<PieceStore>> PieceStore::open(const CacheFolder& folder, std::string_view key,
                                                     std::uint64_t size, bool temporary, const Progress& progress)
{
    const std::vector<std::byte> head = headBytes(key, size);
    const auto make = [&](const std::filesystem::path& path, const Progress&) -> Status {
        const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
        int problem = descriptor < 0 ? errno : writeFully(descriptor, 0, head);
        if (descriptor >= 0 && ::close(descriptor) != 0 && problem == 0)
            problem = errno;
        return problem == 0 ? Status() : cannotKeep(path, problem);
    };
    for (int attempt = 0;; ++attempt) {
        Result<CachedFile> file = folder.take(key, pieceBytes, make, progress);
        if (!file)
            return file.error();
        std::vector<std::byte> found(head.size());
        if (readFully(file->descriptor(), 0, found) == 0 && found == head) {
            const std::shared_ptr<PieceStore> store(new PieceStore(folder, std::move(*file)));
            store->size_ = size;
            store->sumsAt_ = roundedUp(head.size(), 4096);
            store->piecesAt_ = roundedUp(store->sumsAt_ + store->pieces() * sizeof(std::uint64_t), pieceBytes);
            store->temporary_ = temporary;
            return store;
        }
        ::unlink(file->path().c_str()); // damaged; whoever has it open goes on with what it has
        if (attempt == 3)
            return cannotKeep(file->path(), EIO);
    }
}

PieceStore::~PieceStore()
{
    if (temporary_)
        ::unlink(file_.path().c_str());
}

ByteRange PieceStore::rangeOf(std::uint64_t piece) const noexcept
{
    const std::uint64_t offset = piece * pieceBytes;
    return {offset, std::min(pieceBytes, size_ - offset)};
}

std::vector<std::uint64_t> PieceStore::missing(std::span<const ByteRange> ranges) const
{
    std::vector<std::uint64_t> found;
    std::vector<std::uint64_t> sums;
    for (const ByteRange& range : ranges) {
        if (range.size == 0)
            continue;
        const std::uint64_t first = range.offset / pieceBytes, last = (range.offset + range.size - 1) / pieceBytes;
        // They lie before the pieces: where the file ends among them, there is no piece yet.
        sums.resize(last - first + 1);
        if (readFully(file_.descriptor(), sumsAt_ + first * sizeof sums[0], std::as_writable_bytes(std::span(sums))) !=
            0)
            std::ranges::fill(sums, 0);
        for (std::uint64_t piece = first; piece <= last; ++piece)
            if (sums[piece - first] == 0)
                found.push_back(piece);
    }
    std::ranges::sort(found);
    found.erase(std::ranges::unique(found).begin(), found.end());
    return found;
}

bool PieceStore::read(std::uint64_t piece, std::span<std::byte> to) const
{
    std::uint64_t sum = 0;
    const int file = file_.descriptor();
    return readFully(file, sumsAt_ + piece * sizeof sum, std::as_writable_bytes(std::span(&sum, 1))) == 0 && sum != 0 &&
           readFully(file, piecesAt_ + piece * pieceBytes, to) == 0 && sumOf(to) == sum;
}

Status PieceStore::write(std::uint64_t piece, std::span<const std::byte> bytes)
{
    {
        const std::lock_guard lock(growing_);
        if (room_ < bytes.size()) {
            // Far ahead where there is room, or else for this piece and its sum alone.
            const std::uint64_t step = stepOfGrowth(folder_.limit()), one = bytes.size() + 4096;
            const bool isAhead = folder_.makeRoom(step).ok();
            if (const Status made = isAhead ? Status() : folder_.makeRoom(one); !made)
                return made;
            room_ = isAhead ? step : one;
        }
        room_ -= std::min<std::uint64_t>(room_, bytes.size());
    }
    if (const Status written = put(bytes, piecesAt_ + piece * pieceBytes); !written)
        return written;
    const std::uint64_t sum = sumOf(bytes);
    return put(std::as_bytes(std::span(&sum, 1)), sumsAt_ + piece * sizeof sum);
}

void PieceStore::clear()
{
    // A piece that is being written now has its sum without its bytes, or neither.
    if (::ftruncate(file_.descriptor(), static_cast<off_t>(sumsAt_)) != 0)
        ::unlink(file_.path().c_str());
}

Status PieceStore::put(std::span<const std::byte> bytes, std::uint64_t offset)
{
    const int problem = writeFully(file_.descriptor(), offset, bytes);
    return problem == 0 ? Status() : cannotKeep(file_.path(), problem);
}

} // namespace tetra
