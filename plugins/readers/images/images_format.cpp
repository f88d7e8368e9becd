// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/images/images_format.h"

#include <tan/base.h>

#include <string_view>

namespace tetra {
namespace {

bool hasAt(std::string_view bytes, std::size_t place, std::string_view wanted)
{
    return bytes.size() >= place + wanted.size() && bytes.substr(place, wanted.size()) == wanted;
}

bool isTiff(std::string_view bytes)
{
    using namespace std::string_view_literals;
    return hasAt(bytes, 0, "II*\0"sv) || hasAt(bytes, 0, "MM\0*"sv) || hasAt(bytes, 0, "II+\0"sv) ||
           hasAt(bytes, 0, "MM\0+"sv);
}

/// Old DICOM files begin with their elements: of group 8, or of group 2.
bool isBareDicom(std::string_view bytes)
{
    using namespace std::string_view_literals;
    return hasAt(bytes, 0, "DICM") || hasAt(bytes, 0, "\2\0\0\0UL\4\0"sv) || hasAt(bytes, 0, "\x8\0\0\0UL\4\0"sv) ||
           hasAt(bytes, 0, "\x8\0\0\0\4\0\0\0"sv) || hasAt(bytes, 0, "\x8\0\5\0CS"sv) ||
           hasAt(bytes, 0, "\x8\0\x8\0CS"sv) || hasAt(bytes, 0, "\x8\0\x16\0UI"sv);
}

} // namespace

ImagesGuess guessImagesFormat(const std::filesystem::path& path, std::span<const std::byte> firstBytes)
{
    constexpr double bySignature = 0.9, byBareElements = 0.7, byName = 0.6;
    const std::string_view bytes(reinterpret_cast<const char*>(firstBytes.data()), firstBytes.size());
    if (hasAt(bytes, 128, "DICM"))
        return {ImagesFormat::Dicom, bySignature};
    if (isTiff(bytes))
        return {ImagesFormat::Tiff, bySignature};
    if (isBareDicom(bytes))
        return {ImagesFormat::Dicom, byBareElements};
    const std::string ending = fileEnding(path);
    if (ending == ".dcm" || ending == ".dicom")
        return {ImagesFormat::Dicom, byName};
    if (ending == ".tif" || ending == ".tiff")
        return {ImagesFormat::Tiff, byName};
    return {};
}

std::vector<std::string> imagesNameFilters()
{
    return {std::string(Message::marked("DICOM series (*.dcm *.dicom)")),
            std::string(Message::marked("TIFF stack (*.tif *.tiff)"))};
}

} // namespace tetra
