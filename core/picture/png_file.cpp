// SPDX-License-Identifier: GPL-3.0-or-later
// PNG by libpng, into memory and from there: files then come whole or not at all, as all of TAn's do. libpng leaves a
// function that fails by longjmp(), so that no object with a destructor may live between setjmp() and its calls, and no
// exception may pass through them.
#include "core/picture/png_file.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <csetjmp>
#include <cstring>
#include <memory>
#include <new>

#include <png.h>

namespace tetra {
namespace {

constexpr double inchesPerMetre = 1 / 0.0254;
constexpr std::size_t longestPlainText = 40;               ///< longer ones are compressed
constexpr std::size_t largestText = std::size_t(64) << 20; ///< a session with a long film has some megabytes

/// What there is to write: rows of `rowBytes`, one after the other.
struct Rows {
    const png_byte* first = nullptr;
    std::size_t rowBytes = 0;
    png_uint_32 width = 0;
    png_uint_32 height = 0;
    int bitDepth = 8;
    int colourType = PNG_COLOR_TYPE_RGB_ALPHA;
    bool dropsFourth = false; ///< of four bytes a pixel
};

[[noreturn]] void failPng(png_structp png, png_const_charp)
{
    png_longjmp(png, 1);
}

void ignorePng(png_structp, png_const_charp) {}

void appendBytes(png_structp png, png_bytep data, std::size_t size)
{
    auto& bytes = *static_cast<std::vector<std::byte>*>(png_get_io_ptr(png));
    bool isDone = true;
    try {
        const auto* const first = reinterpret_cast<const std::byte*>(data);
        bytes.insert(bytes.end(), first, first + size);
    } catch (const std::bad_alloc&) {
        isDone = false;
    }
    if (!isDone)
        png_error(png, "");
}

void keepBytes(png_structp) {}

bool isAscii(const std::string& text)
{
    return std::ranges::all_of(text, [](char character) { return static_cast<unsigned char>(character) < 0x80; });
}

/// They refer to `texts`.
std::vector<png_text> chunksOf(const std::map<std::string, std::string>& texts)
{
    std::vector<png_text> chunks;
    for (const auto& [keyword, text] : texts) {
        const bool isLong = text.size() >= longestPlainText;
        png_text chunk{};
        // What is not ASCII is said in UTF-8, for which there is a chunk of its own.
        if (isAscii(text))
            chunk.compression = isLong ? PNG_TEXT_COMPRESSION_zTXt : PNG_TEXT_COMPRESSION_NONE;
        else
            chunk.compression = isLong ? PNG_ITXT_COMPRESSION_zTXt : PNG_ITXT_COMPRESSION_NONE;
        chunk.key = const_cast<char*>(keyword.c_str()); // it is only read
        chunk.text = const_cast<char*>(text.c_str());
        chunks.push_back(chunk);
    }
    return chunks;
}

/// Whether all went well. Objects with destructors are the caller's.
bool writeRows(png_structp png, png_infop info, const Rows& rows, std::span<const png_text> texts, png_uint_32 perMetre)
{
    if (setjmp(png_jmpbuf(png)) != 0)
        return false;
    png_set_IHDR(png, info, rows.width, rows.height, rows.bitDepth, rows.colourType, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (perMetre > 0)
        png_set_pHYs(png, info, perMetre, perMetre, PNG_RESOLUTION_METER);
    if (!texts.empty())
        png_set_text(png, info, texts.data(), static_cast<int>(texts.size()));
    png_write_info(png, info);
    if (rows.dropsFourth)
        png_set_filler(png, 0, PNG_FILLER_AFTER);
    if (rows.bitDepth > 8 && std::endian::native == std::endian::little)
        png_set_swap(png);
    for (png_uint_32 row = 0; row < rows.height; ++row)
        png_write_row(png, rows.first + row * rows.rowBytes);
    png_write_end(png, info);
    return true;
}

Error pngNeedsMemory()
{
    return {ErrorKind::OutOfResource, Message::say("There is not enough memory for a picture of this size.")};
}

Result<std::vector<std::byte>> pngOf(const Rows& rows, const PngFacts& facts)
try {
    std::vector<std::byte> bytes;
    const std::vector<png_text> texts = chunksOf(facts.texts);
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, failPng, ignorePng);
    png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;
    bool isDone = false;
    if (info != nullptr) {
        png_set_write_fn(png, &bytes, appendBytes, keepBytes);
        isDone = writeRows(png, info, rows, texts,
                           static_cast<png_uint_32>(std::lround(facts.dotsPerInch * inchesPerMetre)));
    }
    png_destroy_write_struct(&png, &info);
    return isDone ? Result<std::vector<std::byte>>(std::move(bytes)) : pngNeedsMemory();
} catch (const std::bad_alloc&) {
    return pngNeedsMemory();
}

void takeBytes(png_structp png, png_bytep data, std::size_t size)
{
    auto& rest = *static_cast<std::span<const std::byte>*>(png_get_io_ptr(png));
    if (rest.size() < size)
        png_error(png, "");
    std::memcpy(data, rest.data(), size);
    rest = rest.subspan(size);
}

/// The chunk of a keyword before the pixels; null if there is none, or what comes before it is damaged.
const png_text* findText(png_structp png, png_infop info, const char* keyword)
{
    if (setjmp(png_jmpbuf(png)) != 0)
        return nullptr;
    png_read_info(png, info);
    png_textp texts = nullptr;
    int count = 0;
    png_get_text(png, info, &texts, &count);
    for (int i = 0; i < count; ++i)
        if (std::strcmp(texts[i].key, keyword) == 0)
            return &texts[i];
    return nullptr;
}

std::string utf8Of(std::string_view latin1)
{
    std::string text;
    for (const char character : latin1) {
        const auto code = static_cast<unsigned char>(character);
        if (code < 0x80) {
            text += character;
        } else {
            text += static_cast<char>(0xc0 | code >> 6);
            text += static_cast<char>(0x80 | (code & 0x3f));
        }
    }
    return text;
}

std::string contentOf(const png_text& chunk)
{
    const bool isUtf8 =
        chunk.compression == PNG_ITXT_COMPRESSION_NONE || chunk.compression == PNG_ITXT_COMPRESSION_zTXt;
    const std::string_view content(chunk.text, isUtf8 ? chunk.itxt_length : chunk.text_length);
    return isUtf8 ? std::string(content) : utf8Of(content);
}

} // namespace

Result<std::vector<std::byte>> pngOf(const Picture& picture, const PngFacts& facts)
{
    constexpr std::size_t channels = 4;
    return pngOf({.first = reinterpret_cast<const png_byte*>(picture.pixels.data()),
                  .rowBytes = static_cast<std::size_t>(picture.width) * channels,
                  .width = static_cast<png_uint_32>(picture.width),
                  .height = static_cast<png_uint_32>(picture.height),
                  .colourType = facts.transparent ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB,
                  .dropsFourth = !facts.transparent},
                 facts);
}

Result<std::vector<std::byte>> pngOfGreys(std::span<const std::uint16_t> greys, int width, int height,
                                          const PngFacts& facts)
{
    return pngOf({.first = reinterpret_cast<const png_byte*>(greys.data()),
                  .rowBytes = static_cast<std::size_t>(width) * sizeof(std::uint16_t),
                  .width = static_cast<png_uint_32>(width),
                  .height = static_cast<png_uint_32>(height),
                  .bitDepth = 16,
                  .colourType = PNG_COLOR_TYPE_GRAY},
                 facts);
}

std::string textInPng(std::span<const std::byte> file, std::string_view keyword)
{
    const std::string name(keyword);
    std::string content;
    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, failPng, ignorePng);
    png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;
    if (info != nullptr) {
        png_set_chunk_malloc_max(png, largestText);
        png_set_read_fn(png, &file, takeBytes);
        if (const png_text* const found = findText(png, info, name.c_str()))
            content = contentOf(*found);
    }
    png_destroy_read_struct(&png, &info, nullptr);
    return content;
}

} // namespace tetra
