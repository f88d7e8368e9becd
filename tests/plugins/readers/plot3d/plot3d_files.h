// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <vector>

namespace tetra {

/// How the test's own PLOT3D files are written: everything that binary files of this kind differ in.
struct Plot3dStyle {
    std::endian order = std::endian::little;
    bool marks = false;
    bool multiGrid = false;
    bool doubles = false;
    bool iblank = false;
    std::int32_t grids = 1;
};

/// Writes PLOT3D files of the given style, record by record, sharing nothing with what reads them.
class Plot3dBytes {
public:
    explicit Plot3dBytes(const Plot3dStyle& style) : style_(style) {}

    void integer(std::int32_t number) { append(static_cast<std::uint32_t>(number)); }
    void real(double number)
    {
        if (style_.doubles)
            append(std::bit_cast<std::uint64_t>(number));
        else
            append(std::bit_cast<std::uint32_t>(static_cast<float>(number)));
    }
    void endRecord()
    {
        const auto length = static_cast<std::uint32_t>(record_.size());
        const QByteArray content = record_;
        record_.clear();
        append(length);
        const QByteArray mark = record_;
        record_.clear();
        bytes_ += style_.marks ? mark + content + mark : content;
    }
    const QByteArray& bytes() const { return bytes_; }

private:
    template <class Bits> void append(Bits bits)
    {
        for (std::size_t byte = 0; byte < sizeof bits; ++byte) {
            const std::size_t place = style_.order == std::endian::little ? byte : sizeof bits - 1 - byte;
            record_ += static_cast<char>(bits >> (8 * place) & 0xff);
        }
    }

    Plot3dStyle style_;
    QByteArray record_;
    QByteArray bytes_;
};

/// The grid of the tests, 3 x 4 x 5 points, more for later grids: point n lies at testPosition(n).
inline std::vector<std::int32_t> testSize(std::int32_t grid)
{
    return {3 + grid, 4, 5};
}
inline double testCoordinate(int axis, int n, std::int32_t grid)
{
    const int ni = 3 + grid;
    const int index[] = {n % ni, n / ni % 4, n / ni / 4};
    return index[axis] * (axis + 1) + 0.125 * index[(axis + 1) % 3] + 100 * grid;
}
/// Quantity 0 to 4 of point n.
inline double testQuantity(int quantity, int n)
{
    return quantity == 0 ? 1 + 0.25 * (n % 7) : quantity == 4 ? 30 + n : 0.5 * (n % (quantity + 2));
}

inline QByteArray testFile(
    const Plot3dStyle& style, bool solution, const std::function<std::int32_t(int)>& iblankOf = [](int) { return 1; })
{
    Plot3dBytes file(style);
    if (style.multiGrid) {
        file.integer(style.grids);
        file.endRecord();
    }
    for (std::int32_t grid = 0; grid < style.grids; ++grid)
        for (const std::int32_t number : testSize(grid))
            file.integer(number);
    file.endRecord();
    for (std::int32_t grid = 0; grid < style.grids; ++grid) {
        const int points = (3 + grid) * 20;
        if (solution) {
            for (int i = 0; i < 4; ++i)
                file.real(i);
            file.endRecord();
        }
        for (int component = 0; component < (solution ? 5 : 3); ++component)
            for (int n = 0; n < points; ++n)
                file.real(solution ? testQuantity(component, n) : testCoordinate(component, n, grid));
        if (style.iblank && !solution)
            for (int n = 0; n < points; ++n)
                file.integer(iblankOf(n));
        file.endRecord();
    }
    return file.bytes();
}

/// The same in text, five numbers a line. `style` may ask for several grids and iblank.
inline QByteArray testText(
    const Plot3dStyle& style, bool solution, const std::function<std::int32_t(int)>& iblankOf = [](int) { return 1; })
{
    QByteArray text;
    int column = 0;
    const auto add = [&](double number) {
        constexpr int columns = 5;
        text += " " + QByteArray::number(number, 'g', 9) + (++column % columns == 0 ? "\n" : "");
    };
    const auto endLine = [&] {
        text += "\n";
        column = 0;
    };
    if (style.multiGrid)
        text += QByteArray::number(style.grids) + "\n";
    for (std::int32_t grid = 0; grid < style.grids; ++grid) {
        for (const std::int32_t number : testSize(grid))
            add(number);
        endLine();
    }
    for (std::int32_t grid = 0; grid < style.grids; ++grid) {
        const int points = (3 + grid) * 20;
        if (solution)
            for (int i = 0; i < 4; ++i)
                add(i);
        endLine();
        for (int component = 0; component < (solution ? 5 : 3); ++component)
            for (int n = 0; n < points; ++n)
                add(solution ? testQuantity(component, n) : testCoordinate(component, n, grid));
        endLine();
        if (style.iblank && !solution)
            for (int n = 0; n < points; ++n)
                add(iblankOf(n));
        endLine();
    }
    return text;
}

} // namespace tetra
