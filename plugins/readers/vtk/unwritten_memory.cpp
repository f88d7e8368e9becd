// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/vtk/unwritten_memory.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include <malloc.h>

namespace tetra {
namespace {

/// Memory that malloc() gives from now on is filled. Blocks below a kilobyte that were used before are given as they
/// are, unless unwrittenMemoryEnvironment says otherwise.
void fillMemory([[maybe_unused]] int pattern)
{
#ifdef M_PERTURB
    mallopt(M_PERTURB, pattern);
#endif
}

/// A number for bytes in their order, which another order or another bit changes.
class ByteSum {
public:
    void add(const void* data, std::size_t bytes)
    {
        for (const auto* place = static_cast<const std::byte*>(data); bytes > 0;) {
            std::uint64_t word = bytes;
            const std::size_t taken = std::min(bytes, sizeof word);
            std::memcpy(&word, place, taken);
            sum_ = (sum_ ^ word) * 0x9e3779b97f4a7c15;
            sum_ ^= sum_ >> 32U;
            place += taken;
            bytes -= taken;
        }
    }
    template <class List> void addAll(const List& values) { add(values.data(), values.size() * sizeof values[0]); }
    std::uint64_t value() const { return sum_; }

private:
    std::uint64_t sum_ = 0;
};

bool isUsed(const VtkFindings& found, std::size_t cell)
{
    return (found.blanked.empty() || found.blanked[cell] == 0) && found.shapes[cell] != CellShape::Flat;
}

/// The points at which a cell is that is used: what others hold does not matter.
std::vector<bool> pointsOfCells(const VtkFindings& found)
{
    std::vector<bool> points(found.positions.size(), false);
    for (std::size_t cell = 0; cell < found.shapes.size(); ++cell) {
        if (!isUsed(found, cell))
            continue;
        std::uint64_t passed = 0; // of a polyhedron the numbers of points that stand before those of its faces
        for (auto at = found.offsets[cell]; at < found.offsets[cell + 1]; ++at)
            if (found.shapes[cell] == CellShape::Polyhedron && passed == 0)
                passed = found.corners[at];
            else {
                points.at(found.corners[at]) = true;
                passed -= passed > 0 ? 1 : 0;
            }
    }
    return points;
}

std::uint64_t sumOf(const VtkFindings& found)
{
    ByteSum sum;
    sum.addAll(found.shapes);
    sum.addAll(found.offsets);
    sum.addAll(found.corners);
    sum.addAll(found.blanked);
    if (found.kind != VtkDataKind::Cells) {
        sum.addAll(found.samples);
        sum.addAll(found.positions);
        return sum.value();
    }
    const std::vector<bool> points = pointsOfCells(found);
    const auto addSample = [&](std::size_t number) {
        if ((number + 1) * sizeof(double) <= found.samples.size())
            sum.add(found.samples.data() + number * sizeof(double), sizeof(double));
    };
    for (std::size_t point = 0; point < points.size(); ++point)
        if (points[point]) {
            sum.add(found.positions[point].data(), 3 * sizeof(double));
            if (!found.perCell)
                addSample(point);
        }
    for (std::size_t cell = 0; found.perCell && cell < found.shapes.size(); ++cell)
        if (isUsed(found, cell))
            addSample(cell);
    return sum.value();
}

} // namespace

bool mayBeUnwritten(VtkFormat format)
{
    switch (format) {
    case VtkFormat::EnSight:
    case VtkFormat::Cgns:
    case VtkFormat::Gambit:
    case VtkFormat::Fluent:
    case VtkFormat::OpenFoam: return true;
    default: return false;
    }
}

Result<VtkFindings> readTwice(const std::function<Result<VtkFindings>()>& read)
{
    constexpr int firstPattern = 128, secondPattern = 85;
    fillMemory(firstPattern);
    std::uint64_t first = 0;
    {
        const auto found = read();
        if (!found)
            return found;
        first = sumOf(*found);
    }
    fillMemory(secondPattern);
    auto found = read();
    if (found && sumOf(*found) != first)
        return Error{ErrorKind::BadInput,
                     Message::say("VTK reads different values each time: where the file has none, it returns what was "
                                  "in memory. The file is incomplete, or of a kind that VTK reads wrongly. Export it "
                                  "again, or in another format (.vtu, .vti).")};
    return found;
}

} // namespace tetra
