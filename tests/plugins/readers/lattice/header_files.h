// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <QByteArray>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <string>

namespace tetra {

/// Headers of NIfTI, MRC and MetaImage, put together byte by byte as the formats say; usually for 3 x 4 x 5 floats.

/// A number in a byte order.
template <class T> QByteArray numberBytes(T value, std::endian order = std::endian::little)
{
    auto bytes = std::bit_cast<std::array<char, sizeof(T)>>(value);
    if (order != std::endian::native)
        std::ranges::reverse(bytes);
    return {bytes.data(), static_cast<qsizetype>(bytes.size())};
}

/// Sample n is `first` + n.
template <class T> QByteArray counted(int count, T first, std::endian order = std::endian::little)
{
    QByteArray bytes;
    for (int n = 0; n < count; ++n)
        bytes += numberBytes(static_cast<T>(first + static_cast<T>(n)), order);
    return bytes;
}

/// Numbers of `size` bytes in the other order.
QByteArray turnedRound(QByteArray numbers, int size);

struct NiftiFields {
    int version = 1; ///< 1, 2; 0: Analyze 7.5
    std::endian order = std::endian::little;
    bool isPair = false;
    std::array<std::int64_t, 8> dim{3, 3, 4, 5, 1, 1, 1, 1};
    int type = 16;
    std::array<double, 8> pixdim{1, 1, 1, 1, 1, 1, 1, 1};
    double slope = 0, intercept = 0;
    int qform = 0, sform = 0;
    Eigen::Vector3d quaternion = Eigen::Vector3d::Zero(), qOffset = Eigen::Vector3d::Zero();
    Eigen::Matrix<double, 3, 4> rows = Eigen::Matrix<double, 3, 4>::Zero();
    int units = 2, intent = 0;
    double timeOffset = 0;
    QByteArray extension{};                   ///< behind the header, a multiple of 16 bytes
    std::array<std::int16_t, 3> originator{}; ///< of Analyze
};

/// Up to where the samples begin.
QByteArray niftiHeader(const NiftiFields& fields);

/// The sform of such steps.
NiftiFields niftiBySteps(const Eigen::Matrix3d& steps, const Eigen::Vector3d& origin);

struct MrcFields {
    std::endian order = std::endian::little;
    std::array<std::int32_t, 3> size{3, 4, 5};
    int mode = 2;
    std::array<std::int32_t, 3> start{};
    std::array<std::int32_t, 3> grid{3, 4, 5};
    std::array<float, 3> cell{3, 4, 5};
    std::array<float, 3> angles{90, 90, 90};
    std::array<std::int32_t, 3> axes{1, 2, 3};
    float least = 0, most = 0;
    int spaceGroup = 1;
    QByteArray extension{};
    std::array<float, 3> origin{};
    int imodFlags = -1; ///< -1: not of IMOD
    QByteArray stamp = "MAP ";
    QByteArray machine{}; ///< empty: that of the order
};

/// Up to where the samples begin.
QByteArray mrcHeader(const MrcFields& fields);

/// The header of a MetaImage of 3 x 4 x 5 samples, of three dimensions unless `fields` says otherwise: the fields, the
/// usual ones that they lack (floats), and as the last line the data file.
QByteArray metaHeader(const QByteArray& fields, const QByteArray& dataFile = "LOCAL");

} // namespace tetra
