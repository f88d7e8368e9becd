// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/plugins/readers/images/picture_files.h"

#include "plugins/host/plugin_guards.h"

#include <QFile>

#include <zlib.h>

#include <algorithm>
#include <cmath>

namespace tetra {
namespace {

QByteArray decimals(const std::vector<double>& numbers)
{
    QByteArray text;
    for (const double number : numbers)
        text += (text.isEmpty() ? "" : "\\") + QByteArray::number(number, 'g', 12);
    return text;
}

QByteArray tagBytes(quint32 tag)
{
    return numberBytes(quint16(tag >> 16)) + numberBytes(quint16(tag));
}

QByteArray longElement(quint32 tag, const char* kind, const QByteArray& value)
{
    return tagBytes(tag) + kind + QByteArray(2, '\0') + numberBytes(quint32(value.size())) + value;
}

} // namespace

const Reader& builtImagesReader()
{
    static const ImagesReader reader(std::filesystem::path(TAN_BINARY_DIR) / "lib/tan/plugins/tan-read-images");
    static const auto guard = guarded(reader, {"images", [](const Error&) {}});
    return *guard;
}

std::filesystem::path PictureFolder::write(const std::string& name, const QByteArray& content) const
{
    QFile file(folder_.filePath(QString::fromStdString(name)));
    if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size())
        qFatal("cannot write a test file");
    return file.fileName().toStdString();
}

std::string allText(const std::vector<Message>& messages)
{
    std::string text;
    for (const Message& message : messages)
        text += message.text() + "\n";
    return text;
}

std::string takenOf(const std::vector<Taken>& all, TakenPart part)
{
    const auto found = std::ranges::find(all, part, &Taken::part);
    return found == all.end() ? std::string() : takenText(*found).text();
}

QByteArray dicomText(quint32 tag, const char* kind, const QByteArray& text)
{
    const QByteArray value = text.size() % 2 != 0 ? text + ' ' : text;
    return tagBytes(tag) + kind + numberBytes(quint16(value.size())) + value;
}

QByteArray dicomShort(quint32 tag, quint16 value)
{
    return tagBytes(tag) + "US" + numberBytes(quint16(2)) + numberBytes(value);
}

QByteArray dicomDouble(quint32 tag, double value)
{
    return tagBytes(tag) + "FD" + numberBytes(quint16(8)) + numberBytes(value);
}

QByteArray dicomSequence(quint32 tag, const std::vector<QByteArray>& items)
{
    QByteArray value;
    for (const QByteArray& item : items)
        value += tagBytes(0xfffee000) + numberBytes(quint32(item.size())) + item;
    return longElement(tag, "SQ", value);
}

QByteArray dicomJoined(const DicomElements& elements)
{
    QByteArray bytes;
    for (const auto& [tag, element] : elements)
        bytes += element;
    return bytes;
}

QByteArray dicomFile(const DicomElements& elements)
{
    const QByteArray syntax = dicomText(0x00020010, "UI", QByteArray("1.2.840.10008.1.2.1") + '\0');
    const QByteArray length =
        tagBytes(0x00020000) + "UL" + numberBytes(quint16(4)) + numberBytes(quint32(syntax.size()));
    return QByteArray(128, '\0') + "DICM" + length + syntax + dicomJoined(elements);
}

DicomElements DicomSlice::elements(const std::function<double(const Eigen::Vector3d&)>& function, double slope,
                                   double intercept) const
{
    QByteArray pixels;
    for (int pixel = 0; pixel < columns * rows; ++pixel)
        pixels += numberBytes(qint16(std::lround((function(place(pixel)) - intercept) / slope)));
    DicomElements all;
    const auto put = [&](quint32 tag, const char* kind, const QByteArray& text) {
        all[tag] = dicomText(tag, kind, text);
    };
    put(0x00080016, "UI", "1.2.840.10008.5.1.4.1.1.2");
    put(0x00080060, "CS", "CT");
    put(0x0020000e, "UI", QByteArray::fromStdString(series));
    put(0x00200013, "IS", QByteArray::number(number));
    put(0x00200032, "DS", decimals({position[0], position[1], position[2]}));
    put(0x00200037, "DS", decimals({row[0], row[1], row[2], column[0], column[1], column[2]}));
    put(0x00280004, "CS", "MONOCHROME2");
    put(0x00280030, "DS", decimals({spacing[1], spacing[0]}));
    put(0x00281052, "DS", decimals({intercept}));
    put(0x00281053, "DS", decimals({slope}));
    for (const auto& [tag, value] : std::map<quint32, quint16>{{0x00280002, 1},
                                                               {0x00280010, rows},
                                                               {0x00280011, columns},
                                                               {0x00280100, 16},
                                                               {0x00280101, 16},
                                                               {0x00280102, 15},
                                                               {0x00280103, 1}})
        all[tag] = dicomShort(tag, value);
    all[0x7fe00010] = longElement(0x7fe00010, "OW", pixels);
    return all;
}

QByteArray tiffFile(const std::vector<TiffPicture>& pages, const TiffWriting& writing)
{
    const bool little = writing.little, big = writing.big;
    const auto pointer = [&](qint64 value) {
        return big ? numberBytes(quint64(value), little) : numberBytes(quint32(value), little);
    };
    QByteArray bytes = QByteArray(little ? "II" : "MM") + numberBytes(quint16(big ? 43 : 42), little);
    if (big)
        bytes += numberBytes(quint16(8), little) + numberBytes(quint16(0), little);
    qint64 link = bytes.size();
    bytes += pointer(0);
    for (const TiffPicture& page : pages) {
        const auto place = [&](const QByteArray& content) {
            bytes += QByteArray(bytes.size() % 2, '\0');
            const qint64 at = bytes.size();
            bytes += content;
            return at;
        };
        QByteArray pixels = page.bytes;
        if (writing.packed) {
            uLongf size = compressBound(uLong(pixels.size()));
            QByteArray packed(qsizetype(size), '\0');
            compress(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(pixels.constData()),
                     uLong(pixels.size()));
            pixels = packed.left(qsizetype(size));
        }
        struct Entry {
            quint16 tag, type;
            qint64 count, value;
        };
        const qint64 pixelsAt = place(pixels);
        std::vector<Entry> entries = {
            {254, 4, 1, page.kind}, {256, 3, 1, page.size[0]},           {257, 3, 1, page.size[1]},
            {258, 3, 1, page.bits}, {259, 3, 1, writing.packed ? 8 : 1}, {262, 3, 1, page.photometric}};
        if (page.samples > 1) { // a list, which stands elsewhere unless there are but two
            QByteArray list;
            for (int sample = 0; sample < page.samples; ++sample)
                list += numberBytes(quint16(page.bits), little);
            entries[3] = {258, 3, page.samples, place(list)};
        }
        if (!page.description.isEmpty())
            entries.push_back({270, 2, page.description.size() + 1, place(page.description + '\0')});
        entries.push_back({273, 4, 1, pixelsAt});
        entries.push_back({277, 3, 1, page.samples});
        entries.push_back({278, 3, 1, page.size[1]});
        entries.push_back({279, 4, 1, pixels.size()});
        if (page.pixelsPerUnit > 0) {
            const QByteArray ratio = numberBytes(quint32(std::lround(page.pixelsPerUnit * 1000)), little) +
                                     numberBytes(quint32(1000), little);
            const qint64 at = place(ratio);
            entries.push_back({282, 5, 1, at});
            entries.push_back({283, 5, 1, at});
            entries.push_back({296, 3, 1, page.resolutionUnit});
        }
        constexpr int palette = 3;
        if (page.photometric == palette) { // its colours, all black
            const qint64 numbers = 3 * (qint64(1) << page.bits);
            entries.push_back({320, 3, numbers, place(QByteArray(2 * numbers, '\0'))});
        }
        if (page.format != 1)
            entries.push_back({339, 3, 1, page.format});
        const qint64 directory = place({});
        bytes.replace(link, pointer(0).size(), pointer(directory));
        bytes += big ? numberBytes(quint64(entries.size()), little) : numberBytes(quint16(entries.size()), little);
        for (const Entry& entry : entries) {
            bytes += numberBytes(entry.tag, little) + numberBytes(entry.type, little) + pointer(entry.count);
            const bool isShort = entry.type == 3 && entry.count == 1;
            const QByteArray field = isShort           ? numberBytes(quint16(entry.value), little)
                                     : entry.type == 4 ? numberBytes(quint32(entry.value), little)
                                                       : pointer(entry.value);
            bytes += field.leftJustified(pointer(0).size(), '\0');
        }
        link = bytes.size();
        bytes += pointer(0);
    }
    return bytes;
}

} // namespace tetra
