// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QFile>
#include <QString>

#include <cstring>
#include <limits>

namespace tetra {

inline bool writeFile(const QString& path, const QByteArray& bytes)
{
    QFile file(path);
    return file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size();
}

/// All of a file; nothing of one that cannot be read.
inline QByteArray readFile(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// An attached NRRD file: the fields of its header, and its samples.
inline QByteArray nrrd(const QByteArray& type, const QByteArray& sizes, const QByteArray& samples)
{
    return "NRRD0004\ntype: " + type + "\ndimension: 3\nsizes: " + sizes + "\nencoding: raw\nendian: little\n\n" +
           samples;
}

/// `count` samples that are all different as far as bytes can be, without a pattern that makes the mesh degenerate.
inline QByteArray bytes(int count)
{
    QByteArray samples(count, '\0');
    unsigned state = 1;
    for (char& sample : samples) {
        state = state * 1664525u + 1013904223u;
        sample = static_cast<char>(state >> 24);
    }
    return samples;
}

/// `count` floats, one of them not a number.
inline QByteArray floatsWithNaN(int count)
{
    QByteArray samples(count * 4, '\0');
    const float nan = std::numeric_limits<float>::quiet_NaN();
    std::memcpy(samples.data() + 4 * (count / 2), &nan, 4);
    return samples;
}

} // namespace tetra
