// SPDX-License-Identifier: GPL-3.0-or-later
// The format: DICOM PS3.5 (data structures and encoding) and PS3.10 (files).
#include "plugins/readers/vtk/checks/format_checks.h"

#include "plugins/readers/vtk/checks/slice_names.h"

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string_view>

namespace tetra {
namespace {

namespace fs = std::filesystem;

enum DicomTag : std::uint64_t {
    storageClass = 0x00020002,
    transferSyntax = 0x00020010,
    modality = 0x00080060,
    photometric = 0x00280004,
    rowCount = 0x00280010,
    columnCount = 0x00280011,
    bitsAllocated = 0x00280100,
    pixelData = 0x7fe00010
};

struct DicomImage {
    bool isDicom = false;
    bool isDirectory = false; ///< DICOMDIR
    bool hasPixels = false;
    bool isPacked = false;
    std::string modality;
    std::uint64_t rows = 0, columns = 0, bits = 0, samples = 1;
    std::uint64_t pixelBytes = 0;

    std::array<std::uint64_t, 4> shape() const { return {rows, columns, bits, samples}; }
};

class DicomElements {
public:
    explicit DicomElements(std::string_view bytes) : bytes_(bytes) {}

    /// Nothing if an element reaches behind the end of the file.
    std::optional<DicomImage> read()
    {
        constexpr std::size_t preamble = 128;
        constexpr std::string_view magic = "DICM";
        if (bytes_.starts_with(magic))
            at_ = magic.size();
        else if (bytes_.size() >= preamble + magic.size() && bytes_.substr(preamble, magic.size()) == magic)
            at_ = preamble + magic.size();
        else
            return image_;
        image_.isDicom = true;
        while (at_ < bytes_.size() && !image_.hasPixels)
            if (!element())
                return std::nullopt;
        return image_;
    }

private:
    std::uint64_t number(std::size_t place, std::size_t size, bool big) const
    {
        std::uint64_t value = 0;
        for (std::size_t i = 0; i < size; ++i)
            value = value << 8U | static_cast<unsigned char>(bytes_[place + (big ? i : size - 1 - i)]);
        return value;
    }

    bool element()
    {
        constexpr std::string_view shortKinds = "AW AE AS CS UI DA DS DT IS LO LT PN ST TM UT SH FL SL AT UL US SS FD";
        constexpr std::string_view longKinds = "OB OW UN SQ OD OF OL OV UC UR SV UV";
        constexpr std::uint64_t undefined = 0xffffffff;
        if (bytes_.size() - at_ < 8)
            return false;
        const bool big = big_ && number(at_, 2, false) != 2; // the first group is always little-endian
        const std::uint64_t tag = number(at_, 2, big) << 16U | number(at_ + 2, 2, big);
        const std::string_view kind = bytes_.substr(at_ + 4, 2);
        std::uint64_t length = 0;
        if (isAmong(kind, shortKinds)) {
            length = number(at_ + 6, 2, big);
            at_ += 8;
        } else if (isAmong(kind, longKinds)) {
            if (bytes_.size() - at_ < 12)
                return false;
            length = number(at_ + 8, 4, big);
            at_ += 12;
        } else {
            length = number(at_ + 4, 4, big);
            at_ += 8;
        }
        if (length == undefined && tag == pixelData) {
            image_.hasPixels = image_.isPacked = true;
            return true;
        }
        if (length == undefined) // what it holds comes next
            return true;
        if (length > bytes_.size() - at_)
            return false;
        keep(tag, bytes_.substr(at_, length), big);
        at_ += length;
        return true;
    }

    static bool isAmong(std::string_view kind, std::string_view kinds)
    {
        return kind.find(' ') == std::string_view::npos && kinds.find(kind) != std::string_view::npos;
    }

    void keep(std::uint64_t tag, std::string_view value, bool big)
    {
        const auto whole = [&] {
            return value.size() >= 2 ? number(static_cast<std::size_t>(value.data() - bytes_.data()), 2, big) : 0;
        };
        const std::string_view text = value.substr(0, value.find_last_not_of(std::string_view(" \0", 2)) + 1);
        switch (tag) {
        case storageClass: image_.isDirectory = text == "1.2.840.10008.1.3.10"; break;
        case transferSyntax: big_ = text == "1.2.840.10008.1.2.2"; break;
        case modality: image_.modality = text; break;
        case photometric: image_.samples = text == "RGB" ? 3 : 1; break;
        case rowCount: image_.rows = whole(); break;
        case columnCount: image_.columns = whole(); break;
        case bitsAllocated: image_.bits = whole(); break;
        case pixelData:
            image_.hasPixels = true;
            image_.pixelBytes = value.size();
            break;
        default: break;
        }
    }

    std::string_view bytes_;
    std::size_t at_ = 0;
    bool big_ = false;
    DicomImage image_;
};

/// Objects that stand beside images and have none.
bool isWithoutPixels(std::string_view modality)
{
    constexpr std::array<std::string_view, 10> kinds = {"SR",     "PR",       "KO",       "DOC", "REG",
                                                        "RTPLAN", "RTSTRUCT", "RTRECORD", "FID", "PLAN"};
    return std::ranges::find(kinds, modality) != kinds.end();
}

Status checkDicomImage(const DicomImage& image, std::uint64_t fileBytes)
{
    if (!image.hasPixels)
        return Error{
            ErrorKind::BadInput,
            Message::say(
                "it has no pixels. It is cut short, or no image: copy it again, or take it out of the folder.")};
    if (image.isPacked)
        return Error{ErrorKind::BadInput,
                     Message::say("its pixels are compressed, which VTK does not read. Unpack it first, for instance "
                                  "with 'gdcmconv --raw IN OUT' or 'dcmdjpeg IN OUT'.")};
    if (image.bits != 8 && image.bits != 16)
        return Error{
            ErrorKind::BadInput,
            Message::say("its pixels have %1 bits, and VTK reads those of 8 or 16. Write them with 16.", image.bits)};
    const std::uint64_t needed = image.rows * image.columns * image.samples * (image.bits / 8);
    if (needed == 0)
        return wrongHeader(Message::say("it has no rows or columns."));
    if (image.pixelBytes < needed)
        return Error{ErrorKind::BadInput,
                     Message::say("it has %1 bytes of pixels of %2 (of %3 in all). It is damaged: copy the file again.",
                                  image.pixelBytes, needed, fileBytes)};
    return {};
}

} // namespace

Result<CheckedFile> checkDicom(const fs::path& path)
{
    CheckedFile checked;
    std::optional<std::pair<fs::path, DicomImage>> first;
    const auto ofFile = [](const fs::path& at, const Error& error) {
        return Error{error.kind, Message::say("the file %1 of its series: %2", nameOf(at), error.message)};
    };
    const std::vector<fs::path> slices = numberedBeside(path);
    std::error_code problem;
    for (const fs::path& beside : pathsIn(path.parent_path(), problem)) {
        std::error_code ignored;
        if (!fs::is_regular_file(beside, ignored))
            continue;
        const bool isSlice = std::ranges::find(slices, beside) != slices.end();
        const auto file = MappedFile::open(beside);
        if (!file)
            return file.error();
        const std::string_view bytes(reinterpret_cast<const char*>((*file)->bytes().data()), (*file)->bytes().size());
        const auto image = DicomElements(bytes).read();
        if (!image || (!image->isDicom && isSlice))
            return ofFile(beside, Error{ErrorKind::BadInput, Message::say("it ends too early. Copy the file again.")});
        if (!image->isDicom || image->isDirectory || (!image->hasPixels && isWithoutPixels(image->modality)))
            continue;
        if (const Status whole = checkDicomImage(*image, bytes.size()); !whole)
            return ofFile(beside, whole.error());
        if (!first)
            first.emplace(beside, *image);
        if (image->shape() != first->second.shape())
            return Error{ErrorKind::BadInput,
                         Message::say("its folder holds images of several sizes or types, such as %1 and %2. Put the "
                                      "images of one series alone into a folder.",
                                      nameOf(first->first), nameOf(beside))};
        checked.bytes = boundedSum(checked.bytes, bytes.size());
    }
    return checked;
}

} // namespace tetra
