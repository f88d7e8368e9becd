// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/lattice/lattice_reader.h"
#include "tests/plugins/as_loaded.h"
#include "tests/plugins/readers/lattice/header_files.h"
#include "tests/plugins/readers/lattice/volume_files.h"
#include "tests/plugins/readers/world_function.h"

#include <tan/data.h>

#include <QByteArray>

#include <array>
#include <functional>
#include <map>
#include <string>

namespace tetra {

/// For the tests of formats that describe a volume: files made by hand, of known functions of the place.

/// What a volume holds at each point: at origin + steps (i, j, k).
struct WorldVolume {
    std::array<std::uint32_t, 3> size{4, 5, 6};
    Eigen::Matrix3d steps = Eigen::Matrix3d::Identity();
    Eigen::Vector3d origin{0, 0, 0};
    double scale = 1;

    double at(std::uint32_t i, std::uint32_t j, std::uint32_t k) const
    {
        return worldFunction(origin + steps * Eigen::Vector3d(i, j, k), scale);
    }
    /// What `write(value)` makes of each value, the last index running fastest.
    template <class Write> QByteArray lastFastest(const Write& write) const
    {
        QByteArray all;
        for (std::uint32_t i = 0; i < size[0]; ++i)
            for (std::uint32_t j = 0; j < size[1]; ++j)
                for (std::uint32_t k = 0; k < size[2]; ++k)
                    all += write(at(i, j, k));
        return all;
    }
    /// The same, the first one running fastest.
    template <class Write> QByteArray firstFastest(const Write& write) const
    {
        QByteArray all;
        for (std::uint32_t k = 0; k < size[2]; ++k)
            for (std::uint32_t j = 0; j < size[1]; ++j)
                for (std::uint32_t i = 0; i < size[0]; ++i)
                    all += write(at(i, j, k));
        return all;
    }
};

inline QByteArray textNumber(double value)
{
    return QByteArray::number(value, 'e', 17) + ' ';
}
inline QByteArray littleFloat(double value)
{
    return numberBytes(static_cast<float>(value));
}

/// Three numbers with blanks between them.
inline QByteArray threeNumbers(const Eigen::Vector3d& numbers)
{
    QByteArray text;
    for (const double number : numbers)
        text += textNumber(number);
    return text;
}

inline QByteArray takenWords(const std::vector<Taken>& taken)
{
    QByteArray all;
    for (const Taken& one : taken)
        all += QByteArray::fromStdString(takenText(one).text()) + "\n";
    return all;
}

inline QByteArray sentences(const std::vector<Message>& messages)
{
    QByteArray all;
    for (const Message& message : messages)
        all += QByteArray::fromStdString(message.text()) + "\n";
    return all;
}

/// The dataset, or null where it is refused, with the reason in `text`.
inline std::optional<Dataset> readFormat(const std::filesystem::path& path, QByteArray& text,
                                         const ParameterValues& values = {})
{
    const auto& reader = asLoaded<LatticeReader>();
    const Result<Dataset> dataset = reader.read(path, values, {});
    if (!dataset) {
        text = QByteArray::fromStdString(dataset.error().text());
        return {};
    }
    const auto contents = reader.probe(path, values, {});
    if (!contents || takenWords(contents->taken) != takenWords(dataset->source.taken) ||
        sentences(contents->leftOut) != sentences(dataset->source.leftOut)) {
        text = "the probe tells something else";
        return {};
    }
    return *dataset;
}

/// Empty if the file is refused in a sentence that has all the words; else what was wrong.
inline QByteArray refusalFault(const std::filesystem::path& path, const QList<QByteArray>& words,
                               const ParameterValues& values = {})
{
    const auto& reader = asLoaded<LatticeReader>();
    const Result<Dataset> dataset = reader.read(path, values, {});
    if (dataset)
        return "it was read";
    const QByteArray text = QByteArray::fromStdString(dataset.error().text());
    if (!text.endsWith('.') && !text.endsWith(").")) // a sentence
        return "no sentence: " + text;
    for (const QByteArray& word : words)
        if (!text.contains(word))
            return "lacks '" + word + "': " + text;
    return {};
}

} // namespace tetra
