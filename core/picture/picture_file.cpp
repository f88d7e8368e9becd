// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture/picture_file.h"

#include "core/base/file_writer.h"
#include "core/picture/drawing/pdf_page.h"

#include <array>
#include <utility>

namespace tetra {
namespace {

constexpr int usualDotsPerInch = 150;

struct Ending {
    const char* ending;
    PictureFormat format;
};
constexpr std::array endings{Ending{".png", PictureFormat::Png},   Ending{".tif", PictureFormat::Tiff},
                             Ending{".tiff", PictureFormat::Tiff}, Ending{".jpg", PictureFormat::Jpeg},
                             Ending{".jpeg", PictureFormat::Jpeg}, Ending{".pdf", PictureFormat::Pdf}};

bool isWritten(PictureFormat format)
{
    switch (format) {
    case PictureFormat::Tiff: return writesTiff();
    case PictureFormat::Jpeg: return writesJpeg();
    case PictureFormat::Pdf: return writesPdf();
    default: return true;
    }
}

Result<std::vector<std::byte>> bytesOf(const Picture& picture, PictureFormat format, const PngFacts& facts)
{
    switch (format) {
    case PictureFormat::Tiff: return tiffOf(picture, facts);
    case PictureFormat::Jpeg: return jpegOf(picture, facts);
    default: return pngOf(picture, facts);
    }
}

std::string textOf(const PngFacts& facts, const std::string& keyword)
{
    const auto found = facts.texts.find(keyword);
    return found != facts.texts.end() ? found->second : std::string();
}

/// Those that a PDF file has no place of their own for.
std::string otherTexts(PngFacts facts)
{
    for (const char* const keyword : {"Title", "Description", "Software"})
        facts.texts.erase(keyword);
    return textsInLines(facts);
}

} // namespace

std::optional<PictureFormat> pictureFormatOf(const std::filesystem::path& file)
{
    const std::string ending = fileEnding(file);
    for (const Ending& known : endings)
        if (ending == known.ending)
            return known.format;
    return std::nullopt;
}

Status checkPictureFormat(const std::filesystem::path& file, bool transparent)
{
    const auto format = pictureFormatOf(file);
    if (!format)
        return Error{ErrorKind::WrongUsage, Message::say("'%1' does not end in .png, .tif, .tiff, .jpg, .jpeg or .pdf, "
                                                         "the formats in which pictures are written.",
                                                         file.string())};
    if (!isWritten(*format))
        return Error{ErrorKind::WrongUsage,
                     Message::say("'%1' cannot be written: this TAn was built without the library for its format. Save "
                                  "the picture as PNG.",
                                  file.string())};
    if (transparent && *format == PictureFormat::Jpeg)
        return Error{ErrorKind::WrongUsage,
                     Message::say("'%1' cannot be transparent, as JPEG pictures have no transparency. Save it as PNG, "
                                  "TIFF or PDF, or with a background.",
                                  file.string())};
    return {};
}

std::string textsInLines(const PngFacts& facts, const std::string& without)
{
    std::string lines;
    for (const auto& [keyword, text] : facts.texts)
        if (!text.empty() && keyword != without)
            lines += (lines.empty() ? "" : "\n") + keyword + ": " + text;
    return lines;
}

Status writePicture(const Picture& picture, const std::filesystem::path& target, const PngFacts& facts)
{
    const auto known = pictureFormatOf(target);
    if (known)
        if (const Status good = checkPictureFormat(target, facts.transparent); !good)
            return good;
    const PictureFormat format = known.value_or(PictureFormat::Png);
    if (format == PictureFormat::Pdf) {
        const VectorDrawing nothing;
        return writePdf(picture, {nothing}, target, facts);
    }
    const auto bytes = bytesOf(picture, format, facts);
    return bytes ? writeWholeFile(target, *bytes) : Status(bytes.error());
}

Status writePdf(const Picture& picture, const DrawingOver& over, const std::filesystem::path& target,
                const PngFacts& facts)
{
    const auto bytes = pdfOf(picture, over.drawing,
                             {.pixelsPerInch = double(facts.dotsPerInch > 0 ? facts.dotsPerInch : usualDotsPerInch),
                              .pixelsPerUnit = over.unit,
                              .transparent = facts.transparent,
                              .title = textOf(facts, "Title"),
                              .subject = textOf(facts, "Description"),
                              .creator = textOf(facts, "Software"),
                              .keywords = otherTexts(facts)});
    return bytes ? writeWholeFile(target, *bytes) : Status(bytes.error());
}

} // namespace tetra
