// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/images/images_reader.h"

#include <tan/data.h>

#include <QByteArray>
#include <QTemporaryDir>

#include <array>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace tetra {

/// The reader with the program of this build, as the program has it.
const Reader& builtImagesReader();

/// A folder for files that live as long as the test.
class PictureFolder {
public:
    std::filesystem::path path() const { return folder_.path().toStdString(); }
    std::filesystem::path write(const std::string& name, const QByteArray& content) const;

private:
    QTemporaryDir folder_;
};

/// All sentences in a row, to look for words in them.
std::string allText(const std::vector<Message>& messages);
/// What was taken of one part; empty if nothing is said of it.
std::string takenOf(const std::vector<Taken>& all, TakenPart part);

/// Elements by group and number, each as its bytes: explicit VR, little-endian.
using DicomElements = std::map<quint32, QByteArray>;

QByteArray dicomText(quint32 tag, const char* kind, const QByteArray& text);
QByteArray dicomShort(quint32 tag, quint16 value);
QByteArray dicomDouble(quint32 tag, double value);
QByteArray dicomSequence(quint32 tag, const std::vector<QByteArray>& items);
/// The elements one after the other: a file with its beginning, or an item of a sequence.
QByteArray dicomJoined(const DicomElements& elements);
QByteArray dicomFile(const DicomElements& elements);

/// A slice of 4 x 3 pixels of 16 bits, with sample n of function(n).
struct DicomSlice {
    Eigen::Vector3d position{0, 0, 0};
    Eigen::Vector3d row{1, 0, 0}, column{0, 1, 0};
    Eigen::Vector2d spacing{0.5, 0.7}; ///< along a row, along a column
    std::string series = "1.2.3";
    int number = 1;

    static constexpr int columns = 4, rows = 3;
    Eigen::Vector3d place(int pixel) const
    {
        return position + row * spacing[0] * (pixel % columns) + column * spacing[1] * (pixel / columns);
    }
    /// Samples are the whole number nearest to (function - intercept) / slope at each place.
    DicomElements elements(const std::function<double(const Eigen::Vector3d&)>& function, double slope = 1,
                           double intercept = 0) const;
};

/// One page of a TIFF file.
struct TiffPicture {
    std::array<int, 2> size{4, 3};
    int bits = 16, format = 1, samples = 1, photometric = 1;
    QByteArray bytes{}; ///< in the order of bytes of the file
    QByteArray description{};
    double pixelsPerUnit = 0; ///< no resolution
    int resolutionUnit = 2, kind = 0;
};

/// How a file is written.
struct TiffWriting {
    bool little = true, big = false, packed = false;
};

QByteArray tiffFile(const std::vector<TiffPicture>& pages, const TiffWriting& writing = {});

/// Numbers as they stand in files.
template <class T> QByteArray numberBytes(T value, bool little = true)
{
    QByteArray bytes(reinterpret_cast<const char*>(&value), sizeof value);
    if (!little)
        std::reverse(bytes.begin(), bytes.end());
    return bytes;
}

} // namespace tetra
