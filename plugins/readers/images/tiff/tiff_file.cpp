// SPDX-License-Identifier: GPL-3.0-or-later
// The format: TIFF Revision 6.0, Adobe 1992; BigTIFF: http://www.awaresystems.be/imaging/tiff/bigtiff.html
#include "plugins/readers/images/tiff/tiff_file.h"

#include <tiffio.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <fstream>

namespace tetra {
namespace {

namespace fs = std::filesystem;

/// libtiff's last words; its handlers have no other way to somebody's data.
std::string& lastWords()
{
    static std::string words;
    return words;
}

void keepWords(const char*, const char* format, va_list arguments)
{
    std::array<char, 256> text{};
    std::vsnprintf(text.data(), text.size(), format, arguments);
    lastWords() = text.data();
}

Error libtiffError()
{
    const std::string words = lastWords().empty() ? "-" : printable(lastWords());
    return {ErrorKind::BadInput, Message::say("libtiff says: %1. The file is damaged, or of a kind that libtiff does "
                                              "not support: copy or export it again.",
                                              words)};
}

Error damaged(const Message& what)
{
    return {ErrorKind::BadInput, Message::say("%1 The file is damaged: copy or export it again.", what)};
}

Error behindEnd(const Message& what, std::uint64_t bytes)
{
    return {ErrorKind::BadInput,
            Message::say("%1 lies beyond its end, at %2 bytes. It is cut short: copy the file again.", what, bytes)};
}

template <class Number> Number fieldOf(TIFF* file, std::uint32_t tag, Number ifMissing)
{
    Number value = ifMissing;
    return TIFFGetFieldDefaulted(file, tag, &value) == 1 ? value : ifMissing;
}

/// A strip or tile, as pixels of the page.
struct TiffPiece {
    std::uint32_t x = 0, y = 0, width = 0, height = 0; ///< what counts of it
    std::uint64_t rowBytes = 0;                        ///< from row to row in its memory
};

/// How a page is divided: strips are tiles as wide as the page.
struct TiffDivision {
    std::uint32_t width = 0, height = 0; ///< of a piece
    std::uint64_t across = 1, down = 1;
    std::uint64_t planes = 1; ///< each with all pieces: of one sample, if not of all
    std::uint64_t pieceBytes = 0, rowBytes = 0;
    bool isTiled = false;

    std::uint64_t perPlane() const { return across * down; }
};

Result<TiffDivision> divisionOf(TIFF* file, const TiffSamples& samples)
{
    TiffDivision division;
    division.isTiled = TIFFIsTiled(file) != 0;
    if (division.isTiled) {
        division.width = fieldOf<std::uint32_t>(file, TIFFTAG_TILEWIDTH, 0);
        division.height = fieldOf<std::uint32_t>(file, TIFFTAG_TILELENGTH, 0);
    } else {
        division.width = samples.width;
        division.height = std::min(fieldOf<std::uint32_t>(file, TIFFTAG_ROWSPERSTRIP, samples.height), samples.height);
    }
    if (division.width == 0 || division.height == 0)
        return damaged(Message::say("it is divided into pieces of no size."));
    division.across = (std::uint64_t(samples.width) - 1) / division.width + 1;
    division.down = (std::uint64_t(samples.height) - 1) / division.height + 1;
    const bool isSeparate = fieldOf<std::uint16_t>(file, TIFFTAG_PLANARCONFIG, 1) == PLANARCONFIG_SEPARATE;
    division.planes = isSeparate ? samples.samples : 1;
    division.rowBytes = division.isTiled ? TIFFTileRowSize64(file) : TIFFScanlineSize64(file);
    division.pieceBytes = division.isTiled ? TIFFTileSize64(file) : TIFFStripSize64(file);
    const std::uint64_t rowBits = std::uint64_t(division.width) * samples.bits * (isSeparate ? 1 : samples.samples);
    if (division.rowBytes < rowBits / 8 || division.pieceBytes / division.height < division.rowBytes)
        return damaged(Message::say("its pieces have an impossible size."));
    return division;
}

/// The most bytes that one byte of a piece can stand for, as far as that is known.
std::optional<std::uint64_t> mostUnpacked(std::uint16_t compression)
{
    switch (compression) {
    case COMPRESSION_NONE: return 1;
    case COMPRESSION_LZW:
    case COMPRESSION_PACKBITS:
    case COMPRESSION_DEFLATE:
    case COMPRESSION_ADOBE_DEFLATE: return 4096; // a little more than 1000
    default: return std::nullopt;
    }
}

/// Whether each piece lies in the file, with all its bytes if it is not packed, else with as many as it needs at least.
Status checkPieces(TIFF* file, const TiffDivision& division, const TiffSamples& samples, std::uint64_t fileBytes,
                   const Message& page)
{
    const auto most = mostUnpacked(fieldOf<std::uint16_t>(file, TIFFTAG_COMPRESSION, 1));
    const std::uint64_t pieces = division.perPlane() * division.planes;
    if (pieces > fileBytes) // each has a place in a list
        return behindEnd(Message::say("a piece of %1", page), fileBytes);
    for (std::uint64_t piece = 0; piece < pieces; ++piece) {
        const auto number = static_cast<std::uint32_t>(piece);
        int failed = 0;
        const std::uint64_t at = TIFFGetStrileOffsetWithErr(file, number, &failed);
        const std::uint64_t bytes = TIFFGetStrileByteCount(file, number);
        if (failed != 0)
            return behindEnd(Message::say("a piece of %1", page), fileBytes);
        const std::uint64_t row = piece % division.perPlane() / division.across;
        const std::uint64_t rows =
            division.isTiled ? division.height
                             : std::min<std::uint64_t>(division.height, samples.height - row * division.height);
        const std::uint64_t wanted = rows * division.rowBytes;
        if (bytes == 0 || (most == 1 && bytes < wanted))
            return damaged(Message::say("a piece of %1 has %2 bytes and should have %3.", page, bytes, wanted));
        if (most && bytes < wanted / *most)
            return damaged(Message::say("a piece of %1 has %2 bytes, which cannot hold the %3 that its size requires.",
                                        page, bytes, wanted));
        if (at > fileBytes || bytes > fileBytes - at)
            return behindEnd(Message::say("a piece of %1", page), fileBytes);
    }
    return {};
}

/// Where the pixels lie, if nothing is to be done to them but to turn bytes.
std::optional<std::uint64_t> plainPixels(TIFF* file, const TiffDivision& division, const TiffSamples& samples)
{
    const bool isPlain = fieldOf<std::uint16_t>(file, TIFFTAG_COMPRESSION, 1) == COMPRESSION_NONE &&
                         !division.isTiled && division.planes == 1 && samples.bits % 8 == 0 && samples.samples == 1;
    if (!isPlain)
        return std::nullopt;
    const std::uint64_t begin = TIFFGetStrileOffset(file, 0);
    std::uint64_t next = begin;
    for (std::uint32_t strip = 0; strip < division.down; ++strip) {
        if (TIFFGetStrileOffset(file, strip) != next)
            return std::nullopt;
        next += TIFFGetStrileByteCount(file, strip);
    }
    return begin;
}

Result<TiffPage> pageOf(TIFF* file, std::uint64_t fileBytes, std::size_t number)
{
    const Message name = Message::say("page %1", number);
    TiffPage page;
    page.directory = TIFFCurrentDirOffset(file);
    TiffSamples& samples = page.samples;
    samples.width = fieldOf<std::uint32_t>(file, TIFFTAG_IMAGEWIDTH, 0);
    samples.height = fieldOf<std::uint32_t>(file, TIFFTAG_IMAGELENGTH, 0);
    samples.samples = fieldOf<std::uint16_t>(file, TIFFTAG_SAMPLESPERPIXEL, 1);
    samples.bits = fieldOf<std::uint16_t>(file, TIFFTAG_BITSPERSAMPLE, 1);
    samples.format = fieldOf<std::uint16_t>(file, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_UINT);
    samples.photometric = fieldOf<std::uint16_t>(file, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
    const auto kind = fieldOf<std::uint32_t>(file, TIFFTAG_SUBFILETYPE, 0);
    page.isReduced = (kind & (FILETYPE_REDUCEDIMAGE | FILETYPE_MASK)) != 0;
    std::uint16_t copies = 0;
    void* places = nullptr;
    page.hasCopies = TIFFGetField(file, TIFFTAG_SUBIFD, &copies, &places) == 1 && copies > 0;
    if (samples.width == 0 || samples.height == 0 || samples.samples == 0 || samples.bits == 0)
        return damaged(Message::say("%1 has no size.", name));
    if (page.isReduced)
        return page;
    if (samples.photometric == PHOTOMETRIC_YCBCR &&
        fieldOf<std::uint16_t>(file, TIFFTAG_COMPRESSION, 1) == COMPRESSION_JPEG) {
        TIFFSetField(file, TIFFTAG_JPEGCOLORMODE, JPEGCOLORMODE_RGB);
        samples.photometric = PHOTOMETRIC_RGB;
    }
    const auto division = divisionOf(file, samples);
    if (!division)
        return division.error();
    if (const Status there = checkPieces(file, *division, samples, fileBytes, name); !there)
        return there.error();
    page.pixelsAt = plainPixels(file, *division, samples);
    return page;
}

TiffTexts textsOf(TIFF* file)
{
    TiffTexts texts;
    const char* description = nullptr;
    if (TIFFGetField(file, TIFFTAG_IMAGEDESCRIPTION, &description) == 1 && description != nullptr)
        texts.description = description;
    texts.resolutionUnit = fieldOf<std::uint16_t>(file, TIFFTAG_RESOLUTIONUNIT, RESUNIT_INCH);
    for (std::size_t axis = 0; axis < 2; ++axis) {
        float perUnit = 0;
        const std::uint32_t tag = axis == 0 ? TIFFTAG_XRESOLUTION : TIFFTAG_YRESOLUTION;
        if (TIFFGetField(file, tag, &perUnit) == 1 && std::isfinite(perUnit) && perUnit > 0)
            texts.pixelsPerUnit[axis] = perUnit;
    }
    return texts;
}

/// libtiff takes a text or a resolution whose bytes lie behind the end of the file for one that is not there, with no
/// more than a warning. The texts of ImageJ and OME, which tell what the pages are, often lie at the end.
Status checkTexts(TIFF* file, const fs::path& path, std::uint64_t fileBytes)
{
    constexpr std::array used = {TIFFTAG_IMAGEDESCRIPTION, TIFFTAG_XRESOLUTION, TIFFTAG_YRESOLUTION};
    const bool isBig = TIFFIsBigTIFF(file) != 0, isTurned = TIFFIsByteSwapped(file) != 0;
    std::ifstream stream(path, std::ios::binary);
    stream.seekg(static_cast<std::streamoff>(TIFFCurrentDirOffset(file)));
    const auto next = [&]<class Number>(Number number) -> std::uint64_t {
        stream.read(reinterpret_cast<char*>(&number), sizeof number);
        if (isTurned)
            std::reverse(reinterpret_cast<char*>(&number), reinterpret_cast<char*>(&number + 1));
        return number;
    };
    const auto nextPlace = [&] { return isBig ? next(std::uint64_t()) : next(std::uint32_t()); };
    const std::uint64_t inPlace = isBig ? 8 : 4; // bytes that stand in the directory itself
    const std::uint64_t entries = isBig ? next(std::uint64_t()) : next(std::uint16_t());
    for (std::uint64_t entry = 0; entry < entries && stream; ++entry) {
        const std::uint64_t tag = next(std::uint16_t()), type = next(std::uint16_t());
        const std::uint64_t count = nextPlace(), at = nextPlace();
        const std::uint64_t width = type <= TIFF_IFD8 ? TIFFDataWidth(static_cast<TIFFDataType>(type)) : 0;
        const bool isUsed = stream.good() && std::ranges::find(used, tag) != used.end();
        if (isUsed && width > 0 && count > inPlace / width && (at > fileBytes || count > (fileBytes - at) / width))
            return behindEnd(Message::say("its description, or its resolution,"), fileBytes);
    }
    return {};
}

float floatOfHalf(std::uint16_t half)
{
    const int exponent = half >> 10U & 0x1f;
    const double mantissa = half & 0x3ff;
    const double sign = (half & 0x8000) != 0 ? -1 : 1;
    if (exponent == 0x1f)
        return mantissa == 0 ? static_cast<float>(sign * HUGE_VAL) : std::nanf("");
    return static_cast<float>(sign *
                              (exponent == 0 ? std::ldexp(mantissa, -24) : std::ldexp(1024 + mantissa, exponent - 25)));
}

/// Whole numbers of any number of bits, the first bit the highest.
std::uint32_t packedNumber(const std::byte* row, std::uint64_t index, unsigned bits)
{
    std::uint64_t number = 0;
    const std::uint64_t begin = index * bits, end = begin + bits;
    for (std::uint64_t byte = begin / 8; byte < (end + 7) / 8; ++byte)
        number = number << 8U | std::to_integer<std::uint64_t>(row[byte]);
    const auto behind = static_cast<unsigned>((8 - end % 8) % 8);
    return static_cast<std::uint32_t>(number >> behind & ((std::uint64_t(1) << bits) - 1));
}

template <class Stored> struct StoredNumber {
    double operator()(const std::byte* row, std::uint64_t index) const
    {
        Stored number{};
        std::memcpy(&number, row + index * sizeof number, sizeof number);
        return static_cast<double>(number);
    }
};

/// Calls `take` with a function of a row and an index in it that gives the stored number.
template <class Take> void withNumbers(const TiffSamples& samples, const Take& take)
{
    const bool isFloat = samples.format == SAMPLEFORMAT_IEEEFP, isSigned = samples.format == SAMPLEFORMAT_INT;
    const unsigned bits = samples.bits;
    if (isFloat && bits == 16)
        take([](const std::byte* row, std::uint64_t index) {
            std::uint16_t half = 0;
            std::memcpy(&half, row + index * 2, 2);
            return static_cast<double>(floatOfHalf(half));
        });
    else if (isFloat)
        bits == 32 ? take(StoredNumber<float>()) : take(StoredNumber<double>());
    else if (bits == 8)
        isSigned ? take(StoredNumber<std::int8_t>()) : take(StoredNumber<std::uint8_t>());
    else if (bits == 16)
        isSigned ? take(StoredNumber<std::int16_t>()) : take(StoredNumber<std::uint16_t>());
    else if (bits == 32)
        isSigned ? take(StoredNumber<std::int32_t>()) : take(StoredNumber<std::uint32_t>());
    else if (bits == 64)
        isSigned ? take(StoredNumber<std::int64_t>()) : take(StoredNumber<std::uint64_t>());
    else
        take([bits](const std::byte* row, std::uint64_t index) {
            return static_cast<double>(packedNumber(row, index, bits));
        });
}

} // namespace

struct TiffFile::Content {
    fs::path path;
    TIFF* file = nullptr;
    std::uint64_t bytes = 0;
    std::vector<TiffPage> pages;
    TiffTexts texts;

    ~Content()
    {
        if (file != nullptr)
            TIFFClose(file);
    }
};

TiffFile::TiffFile(std::unique_ptr<Content> content) : content_(std::move(content)) {}
TiffFile::~TiffFile() = default;
TiffFile::TiffFile(TiffFile&&) noexcept = default;
TiffFile& TiffFile::operator=(TiffFile&&) noexcept = default;

std::span<const TiffPage> TiffFile::pages() const
{
    return content_->pages;
}

const TiffTexts& TiffFile::texts() const
{
    return content_->texts;
}

std::uint64_t TiffFile::bytes() const
{
    return content_->bytes;
}

Result<TiffFile> TiffFile::open(const fs::path& path)
{
    TIFFSetErrorHandler(keepWords);
    TIFFSetWarningHandler(nullptr);
    lastWords().clear();
    auto content = std::make_unique<Content>();
    content->path = path;
    std::error_code problem;
    content->bytes = fs::file_size(path, problem);
    if (problem)
        return Error{ErrorKind::BadInput, Message::say("it cannot be read.")};
    content->file = TIFFOpen(path.c_str(), "rm"); // not mapped: the file may be cut meanwhile
    if (content->file == nullptr)
        return libtiffError();
    if (const Status there = checkTexts(content->file, path, content->bytes); !there)
        return there.error();
    content->texts = textsOf(content->file);
    while (true) {
        const auto page = pageOf(content->file, content->bytes, content->pages.size() + 1);
        if (!page)
            return page.error();
        content->pages.push_back(*page);
        if (TIFFLastDirectory(content->file) != 0)
            break;
        if (TIFFReadDirectory(content->file) == 0) // without a word where pages follow each other in a circle
            return lastWords().empty() ? damaged(Message::say("page %1 is followed by no page, or by an earlier one.",
                                                              content->pages.size()))
                                       : libtiffError();
    }
    return TiffFile(std::move(content));
}

std::optional<SampleType> typeOf(const TiffSamples& samples)
{
    const unsigned bits = samples.bits;
    if (samples.format == SAMPLEFORMAT_IEEEFP) {
        if (bits == 16 || bits == 32)
            return SampleType::Float32;
        return bits == 64 ? std::optional(SampleType::Float64) : std::nullopt;
    }
    if (bits == 64 && samples.format <= SAMPLEFORMAT_INT)
        return SampleType::Float64;
    if (samples.format == SAMPLEFORMAT_INT)
        return bits == 8    ? std::optional(SampleType::Int8)
               : bits == 16 ? std::optional(SampleType::Int16)
               : bits == 32 ? std::optional(SampleType::Int32)
                            : std::nullopt;
    if (samples.format != SAMPLEFORMAT_UINT && samples.format != SAMPLEFORMAT_VOID)
        return std::nullopt;
    return bits <= 8    ? std::optional(SampleType::UInt8)
           : bits <= 16 ? std::optional(SampleType::UInt16)
           : bits <= 32 ? std::optional(SampleType::UInt32)
                        : std::nullopt;
}

namespace {

/// Puts what a piece holds of the component into its place in the page.
template <class T> class PageTarget {
public:
    PageTarget(const TiffSamples& samples, const TiffWanted& wanted, T* target, std::uint64_t& rounded)
        : samples_(samples), wanted_(wanted), target_(target), rounded_(rounded)
    {
        if (!wanted.component)
            squares_.assign(std::size_t(samples.width) * samples.height, 0);
    }
    /// `sample`: the one that the piece holds alone; none: all of them side by side.
    void put(const std::byte* piece, const TiffPiece& at, std::optional<std::uint16_t> sample)
    {
        const std::uint64_t stride = sample ? 1 : samples_.samples;
        withNumbers(samples_, [&](const auto& number) {
            for (std::uint32_t y = 0; y < at.height; ++y)
                for (std::uint32_t x = 0; x < at.width; ++x) {
                    const std::byte* row = piece + y * at.rowBytes;
                    const std::size_t pixel = std::size_t(at.y + y) * samples_.width + at.x + x;
                    if (wanted_.component)
                        set(pixel, number(row, x * stride + (sample ? 0 : *wanted_.component)));
                    else
                        for (std::uint64_t each = 0; each < (sample ? 1 : wanted_.colours); ++each) {
                            const double value = number(row, x * stride + each);
                            squares_[pixel] += value * value;
                        }
                }
        });
    }
    void finish()
    {
        for (std::size_t pixel = 0; pixel < squares_.size(); ++pixel)
            set(pixel, std::sqrt(squares_[pixel]));
    }

private:
    void set(std::size_t pixel, double value)
    {
        constexpr double mostWhole = 9007199254740992; // doubles hold all whole numbers up to it
        rounded_ += samples_.bits == 64 && samples_.format != SAMPLEFORMAT_IEEEFP && std::abs(value) >= mostWhole;
        target_[pixel] = static_cast<T>(value + wanted_.offset);
    }

    const TiffSamples& samples_;
    const TiffWanted& wanted_;
    T* target_;
    std::uint64_t& rounded_;
    std::vector<double> squares_;
};

/// Pages behind the first one that nothing describes.
Status readRaw(const fs::path& path, std::uint64_t at, const TiffSamples& samples, bool isTurned,
               std::vector<std::byte>& bytes)
{
    bytes.resize(std::size_t(samples.width) * samples.height * (samples.bits / 8));
    std::ifstream stream(path, std::ios::binary);
    stream.seekg(static_cast<std::streamoff>(at));
    stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    if (!stream)
        return Error{ErrorKind::BadInput, Message::say("it ends too early. Copy the file again.")};
    const std::size_t size = samples.bits / 8;
    for (std::size_t sample = 0; isTurned && sample < bytes.size(); sample += size)
        std::reverse(bytes.begin() + static_cast<std::ptrdiff_t>(sample),
                     bytes.begin() + static_cast<std::ptrdiff_t>(sample + size));
    return {};
}

template <class T>
Status readPieces(TIFF* file, const TiffSamples& samples, const TiffWanted& wanted, PageTarget<T>& target)
{
    const auto division = divisionOf(file, samples);
    if (!division)
        return division.error();
    Buffer<std::byte> memory(division->pieceBytes);
    for (std::uint64_t plane = 0; plane < division->planes; ++plane) {
        const bool isSeparate = division->planes > 1;
        if (isSeparate && (wanted.component ? *wanted.component != plane : plane >= wanted.colours))
            continue;
        for (std::uint64_t number = 0; number < division->perPlane(); ++number) {
            const auto piece = static_cast<std::uint32_t>(plane * division->perPlane() + number);
            TiffPiece at;
            at.x = static_cast<std::uint32_t>(number % division->across) * division->width;
            at.y = static_cast<std::uint32_t>(number / division->across) * division->height;
            at.width = std::min(division->width, samples.width - at.x);
            at.height = std::min(division->height, samples.height - at.y);
            at.rowBytes = division->rowBytes;
            const auto whole =
                static_cast<tmsize_t>(division->isTiled ? division->pieceBytes : at.height * division->rowBytes);
            const tmsize_t got = division->isTiled ? TIFFReadEncodedTile(file, piece, memory.data(), whole)
                                                   : TIFFReadEncodedStrip(file, piece, memory.data(), whole);
            if (got < whole)
                return libtiffError();
            target.put(memory.data(), at, isSeparate ? std::optional(static_cast<std::uint16_t>(plane)) : std::nullopt);
        }
    }
    return {};
}

} // namespace

Status TiffFile::read(std::uint64_t page, const TiffWanted& wanted, std::byte* target, std::uint64_t& rounded) const
{
    TIFF* file = content_->file;
    const bool isDescribed = page < content_->pages.size();
    const TiffPage& described = isDescribed ? content_->pages[page] : content_->pages.front();
    const TiffSamples& samples = described.samples;
    lastWords().clear();
    return visitSampleType(wanted.type, [&]<class T>() -> Status {
        PageTarget<T> place(samples, wanted, reinterpret_cast<T*>(target), rounded);
        if (!isDescribed) {
            std::vector<std::byte> bytes;
            const std::uint64_t pageBytes = std::uint64_t(samples.width) * samples.height * (samples.bits / 8);
            if (const Status read = readRaw(content_->path, described.pixelsAt.value_or(0) + page * pageBytes, samples,
                                            TIFFIsByteSwapped(file) != 0, bytes);
                !read)
                return read;
            const std::uint64_t rowBytes = std::uint64_t(samples.width) * (samples.bits / 8);
            place.put(bytes.data(), {0, 0, samples.width, samples.height, rowBytes}, std::nullopt);
        } else {
            if (TIFFSetSubDirectory(file, described.directory) == 0)
                return libtiffError();
            if (fieldOf<std::uint16_t>(file, TIFFTAG_PHOTOMETRIC, 0) == PHOTOMETRIC_YCBCR)
                TIFFSetField(file, TIFFTAG_JPEGCOLORMODE, JPEGCOLORMODE_RGB);
            if (const Status read = readPieces(file, samples, wanted, place); !read)
                return read;
        }
        place.finish();
        return {};
    });
}

} // namespace tetra
