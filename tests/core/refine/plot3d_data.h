// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <QByteArray>
#include <QFile>
#include <QtEndian>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace tetra {

/// A PLOT3D grid of the shared datasets (big-endian floats) with one scalar.
struct Plot3dData {
    std::array<std::uint32_t, 3> size{};
    std::vector<Eigen::Vector3d> positions;
    std::vector<float> values;
};

/// `name` is "bluntfin", whose scalar is the density, or "post", whose scalar is 0.4 * (energy - speed^2 / 2). Nothing
/// if the files are not there.
inline std::optional<Plot3dData> readPlot3d(const QString& name)
{
    const QString path = TAN_SOURCE_DIR "/../shared/data/" + name + "/" + name;
    const auto read = [](const QString& from) {
        QFile file(from);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    };
    const QByteArray grid = read(path + "xyz.bin"), solution = read(path + "q.bin");
    if (grid.isEmpty() || solution.isEmpty())
        return std::nullopt;
    Plot3dData data;
    for (std::size_t axis = 0; axis < 3; ++axis)
        data.size[axis] = qFromBigEndian<std::uint32_t>(grid.constData() + 4 * axis);
    const std::size_t count = std::size_t(data.size[0]) * data.size[1] * data.size[2];
    const auto number = [&](const QByteArray& bytes, std::size_t header, std::size_t block, std::size_t point) {
        return double(qFromBigEndian<float>(bytes.constData() + header + 4 * (block * count + point)));
    };
    for (std::size_t point = 0; point < count; ++point) {
        data.positions.emplace_back(number(grid, 12, 0, point), number(grid, 12, 1, point), number(grid, 12, 2, point));
        const auto component = [&](std::size_t block) { return number(solution, 28, block, point); };
        const double squaredSpeed =
            component(1) * component(1) + component(2) * component(2) + component(3) * component(3);
        data.values.push_back(
            static_cast<float>(name == "post" ? 0.4 * (component(4) - squaredSpeed / 2) : component(0)));
    }
    return data;
}

} // namespace tetra
