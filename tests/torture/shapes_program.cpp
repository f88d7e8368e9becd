// SPDX-License-Identifier: GPL-3.0-or-later
// tan-torture-shapes grid|mesh SEED: a dataset made at random, in the folder that it runs in, and a line that says what
// it is. A grid: grid.xyz with grid.q beside it, even, folded, wrapped or collapsed, and every third one with holes,
// not folded then, as it becomes a mesh. A mesh: mesh.vtu, tetrahedra of which up to a thousandth are damaged.
#include "tests/core/data/cells/damaged_cells.h"
#include "tests/core/history/folded_grids.h"
#include "tests/core/refine/bent_grids.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <random>
#include <string_view>
#include <vector>

using namespace tetra;

namespace {

static_assert(std::endian::native == std::endian::little);

template <class Number> void put(std::ofstream& file, Number number)
{
    file.write(reinterpret_cast<const char*>(&number), sizeof number);
}

/// Some points alone, some boxes of points; never all of a grid.
std::vector<std::int32_t> blanks(const BentGrid& grid, std::mt19937& random)
{
    std::vector<std::int32_t> kept(grid.values.size(), 1);
    for (auto hole = 1 + random() % 3; hole > 0; --hole) {
        const auto middle = grid.place(random() % grid.values.size());
        const auto reach = static_cast<std::int64_t>(random() % 3);
        for (std::size_t point = 0; point < kept.size(); ++point) {
            const auto place = grid.place(point);
            std::int64_t away = 0;
            for (std::size_t axis = 0; axis < 3; ++axis)
                away = std::max(away, std::abs(std::int64_t(place[axis]) - std::int64_t(middle[axis])));
            if (away <= reach)
                kept[point] = 0;
        }
    }
    return kept;
}

bool writeGrid(std::uint32_t seed)
{
    std::mt19937 random(seed);
    BentGrid grid = randomGrid(random);
    const bool holes = random() % 3 == 0;
    constexpr std::size_t few = 100;
    while (holes && (grid.values.size() < few || SlowGrid(grid).foldedCells() > 0))
        grid = randomGrid(random);
    std::ofstream places("grid.xyz", std::ios::binary), solution("grid.q", std::ios::binary);
    for (std::ofstream* file : {&places, &solution})
        for (const std::uint32_t count : grid.size)
            put(*file, static_cast<std::int32_t>(count));
    for (int axis = 0; axis < 3; ++axis)
        for (const Eigen::Vector3d& position : grid.positions)
            put(places, static_cast<float>(position[axis]));
    if (holes)
        for (const std::int32_t kept : blanks(grid, random))
            put(places, kept);
    for (int number = 0; number < 4; ++number)
        put(solution, 1.0F);
    for (int quantity = 0; quantity < 5; ++quantity)
        for (const double value : grid.values)
            put(solution, quantity == 0 ? static_cast<float>(value) : 1.0F);
    std::puts(holes ? "holes" : "whole");
    return places.flush().good() && solution.flush().good();
}

void putNumber(std::ofstream& file, double number)
{
    if (std::isnan(number))
        file << "nan ";
    else
        file << number << ' ';
}

bool writeMesh(std::uint32_t seed)
{
    const DamagedCells damaged(9 + seed % 5, seed);
    const CellComplex& complex = damaged.complex();
    std::ofstream file("mesh.vtu");
    file.precision(std::numeric_limits<double>::max_digits10);
    const auto array = [&file](const char* kind, const char* name, const char* rest, const auto& write) {
        file << "<DataArray type=\"" << kind << "\" Name=\"" << name << "\"" << rest << " format=\"ascii\">\n";
        write();
        file << "\n</DataArray>\n";
    };
    file << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
            "<UnstructuredGrid>\n<Piece NumberOfPoints=\""
         << complex.positions.size() << "\" NumberOfCells=\"" << complex.shapes.size()
         << "\">\n<PointData Scalars=\"value\">\n";
    array("Float64", "value", "", [&] {
        for (const double value : damaged.values().values)
            putNumber(file, value);
    });
    file << "</PointData>\n<CellData>\n";
    array("UInt8", "vtkGhostType", "", [&] {
        constexpr int hidden = 32;
        for (const auto blanked : complex.blanked)
            file << (blanked != 0 ? hidden : 0) << ' ';
    });
    file << "</CellData>\n<Points>\n";
    array("Float64", "Points", " NumberOfComponents=\"3\"", [&] {
        for (const Eigen::Vector3d& position : complex.positions)
            file << position.x() << ' ' << position.y() << ' ' << position.z() << '\n';
    });
    file << "</Points>\n<Cells>\n";
    array("Int64", "connectivity", "", [&] {
        for (const auto corner : complex.corners)
            file << corner << ' ';
    });
    array("Int64", "offsets", "", [&] {
        for (std::size_t cell = 1; cell <= complex.shapes.size(); ++cell)
            file << 4 * cell << ' ';
    });
    array("UInt8", "types", "", [&] {
        constexpr int tetrahedron = 10;
        for (std::size_t cell = 0; cell < complex.shapes.size(); ++cell)
            file << tetrahedron << ' ';
    });
    file << "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
    std::puts("damaged");
    return file.flush().good();
}

} // namespace

int main(int argumentCount, char** arguments)
{
    if (argumentCount != 3)
        return 2;
    const auto seed = static_cast<std::uint32_t>(std::strtoul(arguments[2], nullptr, 10));
    return (std::string_view(arguments[1]) == "grid" ? writeGrid(seed) : writeMesh(seed)) ? 0 : 1;
}
