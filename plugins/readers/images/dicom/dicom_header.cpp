// SPDX-License-Identifier: GPL-3.0-or-later
// The format: DICOM PS3.3 (what the elements mean), PS3.5 (encoding), PS3.10 (files).
#include "plugins/readers/images/dicom/dicom_header.h"

#include "plugins/readers/images/dicom/dicom_extent.h"

#include <gdcmByteValue.h>
#include <gdcmDataSet.h>
#include <gdcmReader.h>
#include <gdcmSequenceOfItems.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <span>
#include <string_view>

namespace tetra {
namespace {

namespace fs = std::filesystem;

using gdcm::DataSet;
using gdcm::Tag;

const Tag pixelData(0x7fe0, 0x0010), floatPixels(0x7fe0, 0x0008), doublePixels(0x7fe0, 0x0009);

/// The bytes of an element's value; empty without one.
std::string_view bytesOf(const DataSet& data, const Tag& tag)
{
    if (!data.FindDataElement(tag))
        return {};
    const gdcm::ByteValue* value = data.GetDataElement(tag).GetByteValue();
    return value == nullptr || value->GetPointer() == nullptr
               ? std::string_view()
               : std::string_view(value->GetPointer(), static_cast<std::size_t>(value->GetLength()));
}

std::string_view trimmed(std::string_view text)
{
    constexpr std::string_view filling(" \t\0", 3);
    text.remove_prefix(std::min(text.find_first_not_of(filling), text.size()));
    return text.substr(0, text.find_last_not_of(filling) + 1);
}

std::string textOf(const DataSet& data, const Tag& tag)
{
    return std::string(trimmed(bytesOf(data, tag)));
}

/// Numbers that stand in texts, with backslashes between them; those that are none are left out with all behind them.
std::vector<double> decimalsOf(const DataSet& data, const Tag& tag)
{
    std::vector<double> numbers;
    std::string_view rest = bytesOf(data, tag);
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find('\\'), rest.size());
        const auto number = parseNumber<double>(trimmed(rest.substr(0, end)));
        if (!number || !std::isfinite(*number))
            break;
        numbers.push_back(*number);
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return numbers;
}

std::optional<double> decimalOf(const DataSet& data, const Tag& tag)
{
    const auto numbers = decimalsOf(data, tag);
    return numbers.empty() ? std::nullopt : std::optional(numbers.front());
}

/// A number in binary, in the machine's byte order: GDCM has seen to that.
template <class Number> std::optional<Number> binaryOf(const DataSet& data, const Tag& tag)
{
    const std::string_view bytes = bytesOf(data, tag);
    Number number{};
    if (bytes.size() < sizeof number)
        return std::nullopt;
    std::memcpy(&number, bytes.data(), sizeof number);
    return number;
}

/// The items of a sequence.
class DicomItems {
public:
    DicomItems(const DataSet& data, const Tag& tag)
    {
        if (data.FindDataElement(tag))
            items_ = data.GetDataElement(tag).GetValueAsSQ();
    }
    std::size_t count() const { return items_ == nullptr ? 0 : items_->GetNumberOfItems(); }
    /// From 0; null if there is none.
    const DataSet* item(std::size_t number) const
    {
        return number < count() ? &items_->GetItem(number + 1).GetNestedDataSet() : nullptr;
    }

private:
    gdcm::SmartPointer<gdcm::SequenceOfItems> items_{};
};

/// What is said of one picture: in its own functional groups, in those that it shares with others, or of the file.
class FrameGroups {
public:
    FrameGroups(const DataSet& file, const DataSet* shared, const DataSet* own)
        : file_(file), shared_(shared), own_(own)
    {
    }
    /// Gives `take` the places where the element `tag` may stand, the one that counts first, until it takes it.
    template <class Take> bool find(const Tag& sequence, const Tag& tag, const Take& take) const
    {
        for (const DataSet* groups : {own_, shared_}) {
            if (groups == nullptr)
                continue;
            const DicomItems items(*groups, sequence);
            if (const DataSet* item = items.item(0); item != nullptr && item->FindDataElement(tag) && take(*item))
                return true;
        }
        return file_.FindDataElement(tag) && take(file_);
    }
    std::vector<double> decimals(const Tag& sequence, const Tag& tag) const
    {
        std::vector<double> numbers;
        find(sequence, tag, [&](const DataSet& data) { return !(numbers = decimalsOf(data, tag)).empty(); });
        return numbers;
    }
    std::optional<double> decimal(const Tag& sequence, const Tag& tag) const
    {
        const auto numbers = decimals(sequence, tag);
        return numbers.empty() ? std::nullopt : std::optional(numbers.front());
    }
    std::string text(const Tag& sequence, const Tag& tag) const
    {
        std::string found;
        find(sequence, tag, [&](const DataSet& data) { return !(found = textOf(data, tag)).empty(); });
        return found;
    }
    template <class Number> std::string number(const Tag& sequence, const Tag& tag) const
    {
        std::string found;
        find(sequence, tag, [&](const DataSet& data) {
            const auto value = binaryOf<Number>(data, tag);
            found = value ? formatNumber(static_cast<double>(*value)) : std::string();
            return value.has_value();
        });
        return found;
    }

private:
    const DataSet& file_;
    const DataSet* shared_;
    const DataSet* own_;
};

std::optional<std::array<Eigen::Vector3d, 2>> axesOf(const std::vector<double>& cosines)
{
    constexpr double roundingOfCosines = 0.01;
    if (cosines.size() != 6)
        return std::nullopt;
    std::array<Eigen::Vector3d, 2> axes = {Eigen::Vector3d(cosines.data()), Eigen::Vector3d(cosines.data() + 3)};
    for (Eigen::Vector3d& axis : axes) {
        if (std::abs(axis.norm() - 1) > roundingOfCosines)
            return std::nullopt;
        if ((axis.array() != 0).count() > 1)
            axis.normalize();
    }
    return axes[0].cross(axes[1]).norm() > 0.5 ? std::optional(axes) : std::nullopt;
}

std::optional<double> positive(std::optional<double> number)
{
    return number && *number > 0 ? number : std::nullopt;
}

/// PixelSpacing says first how far rows lie apart.
void readSpacing(const FrameGroups& groups, DicomFrame& frame, DicomHeader& header)
{
    const Tag measures(0x0028, 0x9110);
    auto numbers = groups.decimals(measures, Tag(0x0028, 0x0030));
    if (numbers.size() < 2) {
        numbers = groups.decimals(measures, Tag(0x0018, 0x1164));
        header.isImagerSpacing = numbers.size() >= 2;
    }
    if (numbers.size() >= 2 && numbers[0] > 0 && numbers[1] > 0)
        frame.pixelSpacing = Eigen::Vector2d(numbers[1], numbers[0]);
    frame.thickness = positive(groups.decimal(measures, Tag(0x0018, 0x0050)));
    frame.distance = groups.decimal(measures, Tag(0x0018, 0x0088));
    frame.height = groups.decimal(measures, Tag(0x0020, 0x1041));
}

void readPlace(const FrameGroups& groups, const DataSet& file, DicomFrame& frame)
{
    const Tag position(0x0020, 0x0032), orientation(0x0020, 0x0037);
    auto place = groups.decimals(Tag(0x0020, 0x9113), position);
    auto axes = groups.decimals(Tag(0x0020, 0x9116), orientation);
    const DicomItems detectors(file, Tag(0x0054, 0x0022)); // of nuclear medicine
    if (const DataSet* detector = detectors.item(0); detector != nullptr && place.empty() && axes.empty()) {
        place = decimalsOf(*detector, position);
        axes = decimalsOf(*detector, orientation);
    }
    if (place.size() == 3)
        frame.position = Eigen::Vector3d(place.data());
    frame.axes = axesOf(axes);
}

void readValues(const FrameGroups& groups, const DataSet& file, DicomFrame& frame)
{
    const Tag transformation(0x0028, 0x9145);
    frame.slope = groups.decimal(transformation, Tag(0x0028, 0x1053)).value_or(1);
    frame.intercept = groups.decimal(transformation, Tag(0x0028, 0x1052)).value_or(0);
    frame.unit = groups.text(transformation, Tag(0x0028, 0x1054));
    if (frame.unit == "US") // "unspecified"
        frame.unit.clear();
    if (const std::string unit = textOf(file, Tag(0x0054, 0x1001)); !unit.empty())
        frame.unit = unit;
    if (const auto dose = decimalOf(file, Tag(0x3004, 0x000e))) {
        frame.slope = *dose;
        frame.intercept = 0;
        frame.unit = textOf(file, Tag(0x3004, 0x0002));
    }
}

void readMarks(const FrameGroups& groups, DicomFrame& frame)
{
    const Tag none(0, 0);
    const auto first = [](std::string one, std::string other) { return one.empty() ? std::move(other) : one; };
    const auto put = [&](DicomMark mark, std::string text) {
        frame.marks[static_cast<std::size_t>(mark)] = std::move(text);
    };
    const Tag content(0x0020, 0x9111);
    frame.stack = groups.text(content, Tag(0x0020, 0x9056));
    put(DicomMark::TemporalPosition,
        first(groups.number<std::uint32_t>(content, Tag(0x0020, 0x9128)), groups.text(none, Tag(0x0020, 0x0100))));
    put(DicomMark::Echo,
        first(groups.number<double>(Tag(0x0018, 0x9114), Tag(0x0018, 0x9082)), groups.text(none, Tag(0x0018, 0x0081))));
    put(DicomMark::DiffusionWeight, groups.number<double>(Tag(0x0018, 0x9117), Tag(0x0018, 0x9087)));
    put(DicomMark::TriggerTime,
        first(groups.number<double>(Tag(0x0018, 0x9118), Tag(0x0020, 0x9153)), groups.text(none, Tag(0x0018, 0x1060))));
    put(DicomMark::ReferenceTime, groups.text(none, Tag(0x0054, 0x1300)));
    const Tag frameType(0x0008, 0x9007);
    put(DicomMark::ImageType,
        first(groups.text(Tag(0x0018, 0x9226), frameType),
              first(groups.text(Tag(0x0018, 0x9329), frameType), groups.text(none, Tag(0x0008, 0x0008)))));
    put(DicomMark::Acquisition, groups.text(none, Tag(0x0020, 0x0012)));
    put(DicomMark::AcquisitionTime, groups.text(none, Tag(0x0008, 0x0032)));
    put(DicomMark::ContentTime, groups.text(none, Tag(0x0008, 0x0033)));
}

/// The pictures of a dose lie where its vector says: as distances from the first one, or as places along z. False
/// without one.
bool placeByOffsets(const DataSet& file, std::vector<DicomFrame>& frames)
{
    const auto offsets = decimalsOf(file, Tag(0x3004, 0x000c));
    if (offsets.size() != frames.size() || !frames.front().position || !frames.front().axes)
        return false;
    const auto& axes = *frames.front().axes;
    const Eigen::Vector3d normal = axes[0].cross(axes[1]).normalized();
    const bool alongZ = offsets[0] != 0 && std::abs(normal[2]) > 0.5;
    for (std::size_t frame = 0; frame < frames.size(); ++frame)
        *frames[frame].position +=
            (offsets[frame] - offsets[0]) * (alongZ ? normal * (normal[2] < 0 ? -1 : 1) : normal);
    return true;
}

Status readFrames(const DataSet& file, DicomHeader& header)
{
    constexpr double mostFrames = 1 << 20;
    const double count = decimalOf(file, Tag(0x0028, 0x0008)).value_or(1);
    if (!(count >= 1 && count <= mostFrames))
        return Error{
            ErrorKind::BadInput,
            Message::say("its number of frames is %1. It is damaged: copy the file again.", formatNumber(count))};
    const DicomItems shared(file, Tag(0x5200, 0x9229)), own(file, Tag(0x5200, 0x9230));
    header.frames.resize(static_cast<std::size_t>(count));
    if (own.count() > 0 && own.count() < header.frames.size())
        return Error{ErrorKind::BadInput,
                     Message::say("it has %1 frames and describes %2 of them. It is damaged: copy the file again.",
                                  header.frames.size(), own.count())};
    const bool areAlike = own.count() == 0;
    for (std::size_t number = 0; number < header.frames.size(); ++number) {
        DicomFrame& frame = header.frames[number];
        if (areAlike && number > 0) {
            frame = header.frames.front();
            continue;
        }
        const FrameGroups groups(file, shared.item(0), own.item(number));
        readSpacing(groups, frame, header);
        readPlace(groups, file, frame);
        readValues(groups, file, frame);
        readMarks(groups, frame);
    }
    if (areAlike && header.frames.size() > 1) {
        header.areStacked = !placeByOffsets(file, header.frames);
        header.isFilm = file.FindDataElement(Tag(0x0018, 0x1063)) || file.FindDataElement(Tag(0x0018, 0x1065));
    }
    return {};
}

std::optional<double> paddingOf(const DataSet& data, bool isSigned)
{
    const Tag padding(0x0028, 0x0120);
    if (isSigned) {
        const auto value = binaryOf<std::int16_t>(data, padding);
        return value ? std::optional<double>(*value) : std::nullopt;
    }
    const auto value = binaryOf<std::uint16_t>(data, padding);
    return value ? std::optional<double>(*value) : std::nullopt;
}

void readImage(const DataSet& data, DicomHeader& header)
{
    const auto whole = [&](const Tag& tag, std::uint64_t ifMissing) {
        return std::uint64_t(binaryOf<std::uint16_t>(data, tag).value_or(static_cast<std::uint16_t>(ifMissing)));
    };
    header.photometric = textOf(data, Tag(0x0028, 0x0004));
    header.samples = whole(Tag(0x0028, 0x0002), 1);
    header.rows = whole(Tag(0x0028, 0x0010), 0);
    header.columns = whole(Tag(0x0028, 0x0011), 0);
    header.allocatedBits = whole(Tag(0x0028, 0x0100), 0);
    header.storedBits = whole(Tag(0x0028, 0x0101), header.allocatedBits);
    header.highBit = whole(Tag(0x0028, 0x0102), header.storedBits - 1);
    header.isSigned = whole(Tag(0x0028, 0x0103), 0) == 1;
    header.padding = paddingOf(data, header.isSigned);
    header.hasTable = DicomItems(data, Tag(0x0028, 0x3000)).count() > 0;
    header.lostInPacking = textOf(data, Tag(0x0028, 0x2110)) == "01";
}

void readIdentity(const DataSet& data, DicomHeader& header)
{
    header.kind = textOf(data, Tag(0x0008, 0x0016));
    header.instance = textOf(data, Tag(0x0008, 0x0018));
    header.modality = textOf(data, Tag(0x0008, 0x0060));
    header.description = textOf(data, Tag(0x0008, 0x103e));
    header.series = textOf(data, Tag(0x0020, 0x000e));
    header.seriesNumber = textOf(data, Tag(0x0020, 0x0011));
    header.number = parseNumber<std::int64_t>(textOf(data, Tag(0x0020, 0x0013)));
    header.isMosaic = textOf(data, Tag(0x0008, 0x0008)).find("MOSAIC") != std::string::npos;
}

Error endsTooEarly()
{
    return {ErrorKind::BadInput, Message::say("it ends too early. Copy the file again.")};
}

std::uint64_t littleNumber(std::istream& stream, std::size_t bytes)
{
    std::array<unsigned char, 8> read{};
    stream.read(reinterpret_cast<char*>(read.data()), static_cast<std::streamsize>(bytes));
    std::uint64_t number = 0;
    for (std::size_t byte = bytes; byte-- > 0;)
        number = number << 8U | read[byte];
    return number;
}

/// Goes through the pieces of packed pixels, which must all lie in the file up to the mark of their end.
Status checkPieces(std::istream& stream, std::uint64_t fileBytes)
{
    constexpr std::uint64_t item = 0xe000fffe, end = 0xe0ddfffe;
    while (stream) {
        const std::uint64_t tag = littleNumber(stream, 4), length = littleNumber(stream, 4);
        if (!stream)
            break;
        if (tag == end)
            return {};
        if (tag != item)
            return Error{ErrorKind::BadInput,
                         Message::say("the pieces of its packed pixels are damaged. Copy the file again.")};
        if (length > fileBytes - std::min<std::uint64_t>(fileBytes, static_cast<std::uint64_t>(stream.tellg())))
            break;
        stream.seekg(static_cast<std::streamoff>(length), std::ios::cur);
    }
    return endsTooEarly();
}

/// The length that stands right before the pixels, where reading the header ended; nothing if it ended elsewhere.
std::optional<std::uint32_t> pixelBytes(std::istream& stream, bool isBigEndian)
{
    constexpr std::streamoff element = 12; // at most: tag, kind, length
    const std::streamoff at = stream.tellg();
    if (!stream || at < element)
        return std::nullopt;
    std::array<unsigned char, element> before{};
    stream.seekg(at - element);
    stream.read(reinterpret_cast<char*>(before.data()), element);
    const auto number = [&](std::size_t place, std::size_t bytes) {
        std::uint32_t value = 0;
        for (std::size_t byte = 0; byte < bytes; ++byte)
            value = value << 8U | before[place + (isBigEndian ? byte : bytes - 1 - byte)];
        return value;
    };
    const auto isTag = [&](std::size_t place) { return number(place, 2) == 0x7fe0 && number(place + 2, 2) == 0x0010; };
    return stream && (isTag(0) || isTag(4)) ? std::optional(number(8, 4)) : std::nullopt;
}

/// Behind the header: whether the pixels that it promises are there.
Status checkPixels(const gdcm::File& file, std::istream& stream, DicomHeader& header)
{
    constexpr std::uint32_t undefined = 0xffffffff;
    const gdcm::TransferSyntax syntax = file.GetHeader().GetDataSetTransferSyntax();
    if (syntax == gdcm::TransferSyntax::DeflatedExplicitVRLittleEndian) { // its bytes are others; zlib finds their end
        header.hasPixels = header.rows > 0;
        return {};
    }
    const auto length = pixelBytes(stream, syntax == gdcm::TransferSyntax::ExplicitVRBigEndian);
    header.hasPixels = length.has_value();
    if (!length)
        return {};
    header.isPacked = *length == undefined;
    if (header.isPacked)
        return checkPieces(stream, header.bytes);
    const auto begin = static_cast<std::uint64_t>(std::max<std::streamoff>(0, stream.tellg()));
    const std::uint64_t there = std::min<std::uint64_t>(*length, header.bytes - std::min(begin, header.bytes));
    const std::uint64_t bits = header.rows * header.columns * header.samples * header.allocatedBits;
    const double needed = std::ceil(static_cast<double>(bits) / 8 * static_cast<double>(header.frames.size()));
    if (there < *length || static_cast<double>(there) < needed)
        return Error{ErrorKind::BadInput,
                     Message::say("it has %1 bytes of pixels of %2 (of %3 in all). It is damaged: copy the file again.",
                                  there, std::max<std::uint64_t>(*length, static_cast<std::uint64_t>(needed)),
                                  header.bytes)};
    return {};
}

/// Before GDCM reads: it takes memory for all that unpacks, whatever it holds.
Status checkExtent(std::string_view bytes)
{
    constexpr std::uint64_t least = 1U << 28U, timesPacked = 100;
    const DicomExtent extent = dicomExtent(bytes);
    if (!extent.isWhole)
        return endsTooEarly();
    const std::uint64_t most = least + timesPacked * bytes.size();
    if (extent.deflatedAt && !unpacksWithin(bytes.substr(*extent.deflatedAt), most))
        return Error{ErrorKind::BadInput, Message::say("it unpacks to more than %1, which pictures of so few bytes do "
                                                       "not. It is damaged; if not, export it without compression.",
                                                       neededBytesText(most))};
    return {};
}

} // namespace

MarkedText dicomMarkText(DicomMark mark) noexcept
{
    constexpr std::array<MarkedText, dicomMarks> texts = {
        Message::marked("temporal position"), Message::marked("echo"),        Message::marked("diffusion weight"),
        Message::marked("trigger time"),      Message::marked("time"),        Message::marked("image type"),
        Message::marked("acquisition"),       Message::marked("acquired at"), Message::marked("made at")};
    return texts[static_cast<std::size_t>(mark)];
}

bool looksLikeDicom(const fs::path& path)
{
    constexpr std::size_t preamble = 128;
    std::array<char, preamble + 4> bytes{};
    std::ifstream stream(path, std::ios::binary);
    stream.read(bytes.data(), bytes.size());
    const std::string_view read(bytes.data(), static_cast<std::size_t>(stream.gcount()));
    if (read.size() == bytes.size() && read.substr(preamble) == "DICM")
        return true;
    // Without the preamble: an element of group 2 or 8, and one of the first ones.
    return read.starts_with("DICM") ||
           (read.size() > 8 && (read[0] == 2 || read[0] == 8) && read[1] == 0 && read[3] == 0 &&
            (read.substr(4, 2) == "UL" || read.substr(4, 2) == "UI" || read.substr(4, 2) == "CS" ||
             (read[5] == 0 && read[6] == 0 && read[7] == 0)));
}

DicomHeader dicomHeader(const fs::path& path)
{
    DicomHeader header;
    header.path = path;
    std::error_code problem;
    header.bytes = fs::file_size(path, problem);
    std::ifstream stream(path, std::ios::binary);
    if (problem || !stream) {
        header.fault = Message::say("it cannot be read.");
        return header;
    }
    const auto mapped = MappedFile::open(path);
    const auto bytes = mapped ? (*mapped)->bytes() : std::span<const std::byte>();
    if (const Status sound = checkExtent({reinterpret_cast<const char*>(bytes.data()), bytes.size()}); !sound) {
        header.fault = sound.error().message;
        return header;
    }
    gdcm::Reader reader;
    reader.SetStream(stream);
    const bool isRead = reader.ReadUpToTag(pixelData, {pixelData});
    const DataSet& data = reader.GetFile().GetDataSet();
    readIdentity(data, header);
    if (header.kind.empty())
        header.kind = textOf(reader.GetFile().GetHeader(), Tag(0x0002, 0x0002));
    readImage(data, header);
    header.hasFloats = data.FindDataElement(floatPixels) || data.FindDataElement(doublePixels);
    Status sound = isRead ? readFrames(data, header)
                          : Error{ErrorKind::BadInput,
                                  Message::say("it is not a DICOM file, or ends too early. Copy the file again.")};
    if (sound)
        sound = checkPixels(reader.GetFile(), stream, header);
    if (!sound)
        header.fault = sound.error().message;
    return header;
}

} // namespace tetra
