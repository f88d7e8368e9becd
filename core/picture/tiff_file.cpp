// SPDX-License-Identifier: GPL-3.0-or-later
// TIFF by libtiff, into memory: files then come whole or not at all, as all of TAn's do.
#include "core/picture/picture_file.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <memory>
#include <new>
#include <utility>

#include <tiffio.h>

namespace tetra {
namespace {

constexpr std::uint32_t rowsPerStrip = 64;

/// A file that grows where it is written to.
struct MemoryFile {
    std::vector<std::byte> bytes{};
    std::uint64_t place = 0;
    bool isFull = false; ///< there was not enough memory
};

struct Closing {
    void operator()(TIFF* file) const noexcept { TIFFClose(file); }
};
using TiffFile = std::unique_ptr<TIFF, Closing>;

MemoryFile& fileOf(thandle_t handle)
{
    return *static_cast<MemoryFile*>(handle);
}

tmsize_t readBytes(thandle_t handle, void* target, tmsize_t size)
{
    MemoryFile& file = fileOf(handle);
    const std::uint64_t end = file.bytes.size(), from = std::min(file.place, end);
    const auto read = std::min<std::uint64_t>(static_cast<std::uint64_t>(size), end - from);
    if (read > 0)
        std::memcpy(target, file.bytes.data() + from, read);
    file.place = from + read;
    return static_cast<tmsize_t>(read);
}

tmsize_t writeBytes(thandle_t handle, void* data, tmsize_t size)
{
    MemoryFile& file = fileOf(handle);
    const std::uint64_t end = file.place + static_cast<std::uint64_t>(size);
    try {
        if (end > file.bytes.size())
            file.bytes.resize(end);
    } catch (const std::bad_alloc&) {
        file.isFull = true;
        return 0;
    }
    std::memcpy(file.bytes.data() + file.place, data, static_cast<std::size_t>(size));
    file.place = end;
    return size;
}

toff_t seek(thandle_t handle, toff_t offset, int whence)
{
    MemoryFile& file = fileOf(handle);
    const std::uint64_t from = whence == SEEK_CUR ? file.place : whence == SEEK_END ? file.bytes.size() : 0;
    return file.place = from + offset;
}

int keepOpen(thandle_t)
{
    return 0;
}

toff_t sizeOf(thandle_t handle)
{
    return fileOf(handle).bytes.size();
}

void describe(TIFF* file, const Picture& picture, const PngFacts& facts)
{
    TIFFSetField(file, TIFFTAG_IMAGEWIDTH, static_cast<std::uint32_t>(picture.width));
    TIFFSetField(file, TIFFTAG_IMAGELENGTH, static_cast<std::uint32_t>(picture.height));
    TIFFSetField(file, TIFFTAG_BITSPERSAMPLE, 8);
    TIFFSetField(file, TIFFTAG_SAMPLESPERPIXEL, facts.transparent ? 4 : 3);
    if (facts.transparent) {
        constexpr std::uint16_t straight = EXTRASAMPLE_UNASSALPHA;
        TIFFSetField(file, TIFFTAG_EXTRASAMPLES, 1, &straight);
    }
    TIFFSetField(file, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_RGB);
    TIFFSetField(file, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
    TIFFSetField(file, TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT);
    TIFFSetField(file, TIFFTAG_ROWSPERSTRIP, rowsPerStrip);
    const bool canDeflate = TIFFIsCODECConfigured(COMPRESSION_ADOBE_DEFLATE) != 0;
    TIFFSetField(file, TIFFTAG_COMPRESSION, canDeflate ? COMPRESSION_ADOBE_DEFLATE : COMPRESSION_LZW);
    TIFFSetField(file, TIFFTAG_PREDICTOR, PREDICTOR_HORIZONTAL);
    if (facts.dotsPerInch > 0) {
        TIFFSetField(file, TIFFTAG_RESOLUTIONUNIT, RESUNIT_INCH);
        TIFFSetField(file, TIFFTAG_XRESOLUTION, static_cast<double>(facts.dotsPerInch));
        TIFFSetField(file, TIFFTAG_YRESOLUTION, static_cast<double>(facts.dotsPerInch));
    }
    if (const auto software = facts.texts.find("Software"); software != facts.texts.end())
        TIFFSetField(file, TIFFTAG_SOFTWARE, software->second.c_str());
    if (const std::string texts = textsInLines(facts, "Software"); !texts.empty())
        TIFFSetField(file, TIFFTAG_IMAGEDESCRIPTION, texts.c_str());
}

bool writeRows(TIFF* file, const Picture& picture, bool transparent)
{
    const std::size_t channels = transparent ? 4 : 3;
    std::vector<std::uint8_t> row(static_cast<std::size_t>(picture.width) * channels);
    for (int y = 0; y < picture.height; ++y) {
        const auto* pixel = picture.pixels.data() + static_cast<std::size_t>(y) * picture.width;
        for (std::size_t at = 0; at < row.size(); at += channels)
            std::memcpy(row.data() + at, (pixel++)->data(), channels);
        if (TIFFWriteScanline(file, row.data(), static_cast<std::uint32_t>(y)) != 1)
            return false;
    }
    return TIFFFlush(file) == 1;
}

Error tiffNeedsMemory()
{
    return {ErrorKind::OutOfResource, Message::say("There is not enough memory for a picture of this size.")};
}

} // namespace

bool writesTiff()
{
    return true;
}

Result<std::vector<std::byte>> tiffOf(const Picture& picture, const PngFacts& facts)
try {
    MemoryFile memory;
    TiffFile file(
        TIFFClientOpen("picture", "w", &memory, readBytes, writeBytes, seek, keepOpen, sizeOf, nullptr, nullptr));
    if (!file)
        return tiffNeedsMemory();
    describe(file.get(), picture, facts);
    const bool isDone = writeRows(file.get(), picture, facts.transparent);
    file.reset();
    return isDone && !memory.isFull ? Result<std::vector<std::byte>>(std::move(memory.bytes)) : tiffNeedsMemory();
} catch (const std::bad_alloc&) {
    return tiffNeedsMemory();
}

} // namespace tetra
