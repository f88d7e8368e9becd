// SPDX-License-Identifier: GPL-3.0-or-later
// JPEG by libjpeg, into memory: files then come whole or not at all. libjpeg leaves a function that fails by longjmp(),
// so that no object with a destructor may live between setjmp() and its calls.
#include "core/picture/picture_file.h"

#include <algorithm>
#include <array>
#include <csetjmp>
#include <cstdio>
#include <memory>
#include <new>
#include <span>
#include <utility>

#include <jpeglib.h>

namespace tetra {
namespace {

constexpr int quality = 95;
constexpr std::size_t longestComment = 65'533; ///< of one; longer texts are several

/// libjpeg's, and where to go on after an error.
struct Failing {
    jpeg_error_mgr manager{}; ///< first, as libjpeg knows nothing else
    std::jmp_buf place{};
};

[[noreturn]] void failJpeg(j_common_ptr info)
{
    std::longjmp(reinterpret_cast<Failing*>(info->err)->place, 1);
}

void ignoreJpeg(j_common_ptr, int) {}

/// Where libjpeg puts what it has made, piece by piece.
struct Target {
    jpeg_destination_mgr manager{}; ///< first, as libjpeg knows nothing else
    std::vector<std::byte> bytes{};
    std::array<JOCTET, 65'536> piece{};
};

Target& targetOf(j_compress_ptr file)
{
    return *reinterpret_cast<Target*>(file->dest);
}

void beginPiece(j_compress_ptr file)
{
    Target& target = targetOf(file);
    target.manager.next_output_byte = target.piece.data();
    target.manager.free_in_buffer = target.piece.size();
}

void append(j_compress_ptr file, std::size_t size)
{
    Target& target = targetOf(file);
    bool isDone = true;
    try {
        const auto* const first = reinterpret_cast<const std::byte*>(target.piece.data());
        target.bytes.insert(target.bytes.end(), first, first + size);
    } catch (const std::bad_alloc&) {
        isDone = false;
    }
    if (!isDone)
        failJpeg(reinterpret_cast<j_common_ptr>(file));
}

boolean endPiece(j_compress_ptr file)
{
    append(file, targetOf(file).piece.size());
    beginPiece(file);
    return TRUE;
}

void endPieces(j_compress_ptr file)
{
    append(file, targetOf(file).piece.size() - targetOf(file).manager.free_in_buffer);
}

void describe(jpeg_compress_struct& file, const Picture& picture, int dotsPerInch)
{
    file.image_width = static_cast<JDIMENSION>(picture.width);
    file.image_height = static_cast<JDIMENSION>(picture.height);
    file.input_components = 3;
    file.in_color_space = JCS_RGB;
    jpeg_set_defaults(&file);
    jpeg_set_quality(&file, quality, TRUE);
    file.optimize_coding = TRUE;
    // Colours of thin lines and letters would run otherwise.
    for (jpeg_component_info& component : std::span(file.comp_info, static_cast<std::size_t>(file.num_components)))
        component.h_samp_factor = component.v_samp_factor = 1;
    if (dotsPerInch > 0) {
        file.density_unit = 1; // per inch
        file.X_density = file.Y_density = static_cast<UINT16>(std::min(dotsPerInch, 65'535));
    }
}

/// Whether all went well. Objects with destructors are the caller's; `row` has room for a row.
bool compress(jpeg_compress_struct& file, Failing& failing, Target& target, const Picture& picture, int dotsPerInch,
              std::span<const unsigned char> comment, std::span<unsigned char> row)
{
    if (setjmp(failing.place) != 0)
        return false;
    jpeg_create_compress(&file);
    file.dest = &target.manager;
    describe(file, picture, dotsPerInch);
    jpeg_start_compress(&file, TRUE);
    for (std::size_t from = 0; from < comment.size(); from += longestComment)
        jpeg_write_marker(&file, JPEG_COM, comment.data() + from,
                          static_cast<unsigned>(std::min(longestComment, comment.size() - from)));
    for (int y = 0; y < picture.height; ++y) {
        const auto* pixel =
            picture.pixels.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width);
        for (std::size_t at = 0; at < row.size(); at += 3, ++pixel)
            std::copy_n(pixel->begin(), 3, row.begin() + static_cast<std::ptrdiff_t>(at));
        JSAMPROW first = row.data();
        jpeg_write_scanlines(&file, &first, 1);
    }
    jpeg_finish_compress(&file);
    return true;
}

Error jpegNeedsMemory()
{
    return {ErrorKind::OutOfResource, Message::say("There is not enough memory for a picture of this size.")};
}

} // namespace

bool writesJpeg()
{
    return true;
}

Result<std::vector<std::byte>> jpegOf(const Picture& picture, const PngFacts& facts)
try {
    if (facts.transparent)
        return Error{ErrorKind::WrongUsage, Message::say("JPEG pictures have no transparency. Save it as PNG, TIFF or "
                                                         "PDF, or with a background.")};
    const std::string comment = textsInLines(facts);
    std::vector<unsigned char> row(static_cast<std::size_t>(picture.width) * 3);
    Failing failing;
    jpeg_compress_struct file{};
    file.err = jpeg_std_error(&failing.manager);
    failing.manager.error_exit = failJpeg;
    failing.manager.emit_message = ignoreJpeg;
    const auto target = std::make_unique<Target>();
    target->manager.init_destination = beginPiece;
    target->manager.empty_output_buffer = endPiece;
    target->manager.term_destination = endPieces;
    const bool isDone =
        compress(file, failing, *target, picture, facts.dotsPerInch,
                 {reinterpret_cast<const unsigned char*>(comment.data()), comment.size()}, std::span(row));
    jpeg_destroy_compress(&file);
    return isDone ? Result<std::vector<std::byte>>(std::move(target->bytes)) : jpegNeedsMemory();
} catch (const std::bad_alloc&) {
    return jpegNeedsMemory();
}

} // namespace tetra
