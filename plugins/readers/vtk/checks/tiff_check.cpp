// SPDX-License-Identifier: GPL-3.0-or-later
// The format: TIFF Revision 6.0, Adobe 1992; BigTIFF: http://www.awaresystems.be/imaging/tiff/bigtiff.html
#include "plugins/readers/vtk/checks/format_checks.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <span>

namespace tetra {
namespace {

namespace fs = std::filesystem;

enum TiffTag : std::uint64_t {
    newSubfileType = 254,
    imageWidth = 256,
    imageLength = 257,
    bitsPerSample = 258,
    compressionTag = 259,
    stripOffsets = 273,
    samplesPerPixel = 277,
    rowsPerStrip = 278,
    stripByteCounts = 279,
    planarConfiguration = 284,
    tileWidth = 322,
    tileLength = 323,
    tileOffsets = 324,
    tileByteCounts = 325,
    sampleFormat = 339
};

/// The values of a tag: where they stand, how many, and how many bytes each has.
struct TiffValues {
    std::uint64_t place = 0;
    std::uint64_t count = 0;
    std::uint64_t size = 0;
};

struct TiffPage {
    std::array<std::uint64_t, 5> shape{}; ///< width, height, samples, bits, format
    std::optional<std::uint64_t> kind;    ///< of the file's other pages a reduced copy, or the like, if not 0
};

class TiffFile {
public:
    explicit TiffFile(std::span<const std::byte> bytes) : bytes_(bytes) {}

    Result<std::vector<TiffPage>> pages()
    {
        const bool little = bytes_.size() > 1 && bytes_[0] == std::byte('I');
        little_ = little;
        const std::uint64_t version = number(2, 2).value_or(0);
        if (version != 42 && version != 43)
            return wrongHeader(Message::say("it does not begin as a TIFF file does."));
        big_ = version == 43;
        std::vector<TiffPage> pages;
        std::set<std::uint64_t> seen;
        auto next = number(big_ ? 8 : 4, pointerSize());
        while (next && *next != 0) {
            if (!seen.insert(*next).second)
                return wrongHeader(Message::say("its pages name one another in a circle."));
            const auto page = pageAt(*next, pages.size() + 1);
            if (!page)
                return page.error();
            pages.push_back(*page);
            next = nextPage_;
        }
        if (!next || pages.empty())
            return missing(Message::say("page %1", pages.size() + 1));
        return pages;
    }

private:
    std::uint64_t pointerSize() const { return big_ ? 8 : 4; }

    std::optional<std::uint64_t> number(std::uint64_t place, std::uint64_t size) const
    {
        if (place > bytes_.size() || size > bytes_.size() - place)
            return std::nullopt;
        std::uint64_t value = 0;
        for (std::uint64_t i = 0; i < size; ++i)
            value = value << 8U | std::to_integer<std::uint64_t>(
                                      bytes_[static_cast<std::size_t>(place + (little_ ? size - 1 - i : i))]);
        return value;
    }

    Error missing(const Message& what) const
    {
        return {ErrorKind::BadInput,
                Message::say("%1 lies behind its end, at %2 bytes. It is cut short: copy the file again.", what,
                             bytes_.size())};
    }

    Result<TiffPage> pageAt(std::uint64_t place, std::uint64_t pageNumber)
    {
        const Message name = Message::say("page %1", pageNumber);
        const std::uint64_t countSize = big_ ? 8 : 2;
        const std::uint64_t entrySize = big_ ? 20 : 12;
        const auto entries = number(place, countSize);
        if (!entries || boundedProduct(*entries, entrySize) > bytes_.size())
            return missing(name);
        const std::uint64_t begin = place + countSize;
        nextPage_ = number(begin + *entries * entrySize, pointerSize());
        if (!nextPage_)
            return missing(name);
        tags_.clear();
        for (std::uint64_t entry = 0; entry < *entries; ++entry)
            if (const Status read = entryAt(begin + entry * entrySize, name); !read)
                return read.error();
        TiffPage page;
        page.shape = {valueOf(imageWidth, 0), valueOf(imageLength, 0), valueOf(samplesPerPixel, 1),
                      valueOf(bitsPerSample, 1), valueOf(sampleFormat, 1)};
        if (tags_.contains(newSubfileType))
            page.kind = valueOf(newSubfileType, 0);
        if (const Status there = checkPixels(page, name); !there)
            return there.error();
        return page;
    }

    Status entryAt(std::uint64_t place, const Message& page)
    {
        constexpr std::array<std::uint64_t, 19> sizes = {0, 1, 1, 2, 4, 8, 1, 1, 2, 4, 8, 4, 8, 4, 0, 0, 8, 8, 8};
        const std::uint64_t tag = *number(place, 2);
        const std::uint64_t type = *number(place + 2, 2);
        TiffValues values{0, *number(place + 4, pointerSize()), type < sizes.size() ? sizes[type] : 0};
        const std::uint64_t valueField = place + 4 + pointerSize();
        const std::uint64_t bytes = boundedProduct(values.count, values.size);
        values.place = bytes <= pointerSize() ? valueField : *number(valueField, pointerSize());
        if (values.size > 0 && boundedSum(values.place, bytes) > bytes_.size())
            return missing(Message::say("an entry of %1", page));
        tags_[tag] = values;
        return {};
    }

    std::uint64_t at(const TiffValues& values, std::uint64_t index) const
    {
        return number(values.place + index * values.size, values.size).value_or(0);
    }

    std::uint64_t valueOf(std::uint64_t tag, std::uint64_t ifMissing) const
    {
        const auto found = tags_.find(tag);
        return found == tags_.end() || found->second.count == 0 ? ifMissing : at(found->second, 0);
    }

    /// Each strip or tile must lie in the file, and have all its bytes if it is not packed.
    Status checkPixels(const TiffPage& page, const Message& name) const
    {
        const auto [width, height, samples, bits, format] = page.shape;
        if (width == 0 || height == 0 || samples == 0 || bits == 0)
            return wrongHeader(Message::say("%1 has no size.", name));
        const bool tiled = tags_.contains(tileOffsets);
        const auto offsets = tags_.find(tiled ? tileOffsets : stripOffsets);
        const auto counts = tags_.find(tiled ? tileByteCounts : stripByteCounts);
        if (offsets == tags_.end())
            return wrongHeader(Message::say("%1 does not say where its pixels are.", name));
        const std::uint64_t planes = valueOf(planarConfiguration, 1) == 2 ? samples : 1;
        const std::uint64_t rowWidth = tiled ? valueOf(tileWidth, 0) : width;
        const std::uint64_t rows = std::min(tiled ? valueOf(tileLength, 0) : valueOf(rowsPerStrip, height),
                                            tiled ? ~std::uint64_t(0) : height);
        if (rows == 0 || rowWidth == 0)
            return wrongHeader(Message::say("%1 is divided into pieces of no size.", name));
        const std::uint64_t across = tiled ? (width - 1) / rowWidth + 1 : 1;
        const std::uint64_t pieces = boundedProduct(boundedProduct(across, (height - 1) / rows + 1), planes);
        if (offsets->second.count < pieces)
            return wrongHeader(Message::say("%1 has %2 of its %3 pieces.", name, offsets->second.count, pieces));
        const bool packed = valueOf(compressionTag, 1) != 1;
        const std::uint64_t rowBits = boundedProduct(boundedProduct(rowWidth, bits), samples / planes);
        const std::uint64_t rowBytes = rowBits / 8 + (rowBits % 8 != 0 ? 1 : 0);
        for (std::uint64_t piece = 0; piece < pieces; ++piece) {
            const bool last = !tiled && (piece + 1) % (pieces / planes) == 0;
            const std::uint64_t rowsHere = last ? height - (height - 1) / rows * rows : rows;
            const std::uint64_t whole = boundedProduct(rowBytes, rowsHere);
            std::uint64_t bytes = counts != tags_.end() && piece < counts->second.count ? at(counts->second, piece) : 0;
            if (!packed && bytes != 0 && bytes < whole)
                return wrongHeader(Message::say("a piece of %1 has %2 bytes and should have %3.", name, bytes, whole));
            if (!packed && bytes == 0) // old programs leave it out
                bytes = whole;
            if (boundedSum(at(offsets->second, piece), bytes) > bytes_.size() ||
                at(offsets->second, piece) >= bytes_.size())
                return missing(Message::say("a piece of %1", name));
        }
        return {};
    }

    std::span<const std::byte> bytes_;
    bool little_ = true;
    bool big_ = false;
    std::optional<std::uint64_t> nextPage_;
    std::map<std::uint64_t, TiffValues> tags_; ///< of the page that is looked at
};

Status checkTogether(const std::vector<TiffPage>& pages)
{
    constexpr std::size_t samples = 2;
    if (pages.size() > 1 && pages[0].shape[samples] == 2)
        return Error{ErrorKind::BadInput, Message::say("its pages have two samples for each pixel, of which VTK reads "
                                                       "the first page only. Write it with one sample.")};
    const auto isMarked = [](const TiffPage& page) { return page.kind == 0; };
    const bool marked = std::ranges::any_of(pages, isMarked);
    for (std::size_t i = 0; i < pages.size(); ++i) {
        if (marked && pages[i].kind.value_or(0) != 0)
            continue; // a smaller copy of another page, which is passed over
        if (marked && !isMarked(pages[i]))
            return wrongHeader(
                Message::say("some of its pages say that they are part of the volume, and page %1 does not.", i + 1));
        if (pages[i].shape != pages[0].shape)
            return Error{ErrorKind::BadInput, Message::say("page %1 is of another size or type than page 1. Write a "
                                                           "file whose pages are layers of one volume.",
                                                           i + 1)};
    }
    return {};
}

} // namespace

Result<CheckedFile> checkTiff(const std::vector<fs::path>& paths)
{
    CheckedFile checked;
    std::vector<TiffPage> first;
    for (const fs::path& path : paths) {
        const auto file = MappedFile::open(path);
        if (!file)
            return file.error();
        const auto inFile = [&](const Error& error) {
            return paths.size() > 1 ? Error{error.kind, Message::say("its file %1: %2", nameOf(path), error.message)}
                                    : error;
        };
        const auto pages = TiffFile((*file)->bytes()).pages();
        if (!pages)
            return inFile(pages.error());
        if (const Status together = checkTogether(*pages); !together)
            return inFile(together.error());
        if (first.empty())
            first = *pages;
        else if (pages->front().shape != first.front().shape)
            return inFile({ErrorKind::BadInput,
                           Message::say("it is of another size or type than the first file of its stack, '%1'. Put "
                                        "the layers of one volume alone into a folder.",
                                        printable(paths.front().filename().string()))});
        const auto& shape = pages->front().shape;
        const std::uint64_t unpacked =
            boundedProduct(boundedProduct(shape[0], shape[1]),
                           boundedProduct(boundedProduct(shape[2], shape[3] / 8 + 1), pages->size()));
        checked.unpackedBytes = boundedSum(checked.unpackedBytes, unpacked);
        checked.bytes = boundedSum(checked.bytes, (*file)->bytes().size());
    }
    return checked;
}

} // namespace tetra
