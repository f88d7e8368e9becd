// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/api/plugin.h"
#include "plugins/api/writer.h"

#include <algorithm>

namespace tetra {
namespace {

/// Of a state and of the other four quantities of a solution.
constexpr std::uint64_t numbersOfAState = 4, otherQuantities = 4;

bool fitsSingle(const Dataset& dataset)
{
    const SampleType type = dataset.values.type();
    return type != SampleType::UInt32 && type != SampleType::Int32 && type != SampleType::Float64 &&
           dataset.positions && fitFloats(*dataset.positions);
}

/// numberAt(i) for i below `count`, in the precision `Real`.
template <class Real, class Function> Status writeReals(std::uint64_t count, OutputFile& file, Function&& numberAt)
{
    return file.records(count, sizeof(Real), [&](std::uint64_t index, std::byte* where) {
        putNumber(where, static_cast<Real>(numberAt(index)));
    });
}

template <class Real> Status writeGrid(const Dataset& dataset, OutputFile& file)
{
    if (const Status written = file.bytes(std::as_bytes(std::span(dataset.lattice.size))); !written)
        return written;
    for (Eigen::Index axis = 0; axis < 3; ++axis)
        if (const Status written = writeReals<Real>(dataset.pointCount(), file,
                                                    [&](std::uint64_t point) { return dataset.position(point)[axis]; });
            !written)
            return written;
    return {};
}

/// A solution of a gas at rest whose density is the value.
template <class Real> Status writeSolution(const Dataset& dataset, OutputFile& file)
{
    const auto zero = [](std::uint64_t) { return 0.0; };
    if (const Status written = file.bytes(std::as_bytes(std::span(dataset.lattice.size))); !written)
        return written;
    if (const Status written = writeReals<Real>(numbersOfAState, file, zero); !written)
        return written;
    if (const Status written =
            writeReals<Real>(dataset.pointCount(), file, [&](std::uint64_t point) { return dataset.values.at(point); });
        !written)
        return written;
    return writeReals<Real>(otherQuantities * dataset.pointCount(), file, zero);
}

template <class Real> Status writeBoth(const Dataset& dataset, OutputFile& grid, OutputFile& solution)
{
    grid.expect((8 * dataset.pointCount() + numbersOfAState) * sizeof(Real));
    if (const Status written = writeGrid<Real>(dataset, grid); !written)
        return written;
    return writeSolution<Real>(dataset, solution);
}

} // namespace

/// `.xyz`, binary PLOT3D: the grid, curvilinear or regular, and the solution beside it (.q) with the values as its
/// density and nothing else in it. Little-endian, one grid, no record marks, no iblank; single precision if that holds
/// positions and values exactly. Reading gives the same positions and values.
class Plot3dWriter : public Writer {
public:
    std::vector<FileFormat> formats() const override
    {
        return {{WrittenContent::Dataset, Message::marked("PLOT3D grids with a solution file"), {".xyz"}}};
    }

    Status writeDataset(const Dataset& dataset, OutputFile& file, const ParameterValues& /*values*/) const override
    {
        if (dataset.domain != DomainClass::RegularLattice && dataset.domain != DomainClass::Curvilinear)
            return Error{ErrorKind::WrongUsage,
                         Message::say("PLOT3D files hold points on a grid, and '%1' is not. Give the file another "
                                      "ending, such as .csv for scattered points.",
                                      dataset.source.name)};
        std::filesystem::path solutionPath = file.target();
        solutionPath.replace_extension(".q");
        const auto solution = file.another(solutionPath);
        if (!solution)
            return solution.error();
        return fitsSingle(dataset) ? writeBoth<float>(dataset, file, **solution)
                                   : writeBoth<double>(dataset, file, **solution);
    }
};

} // namespace tetra

TAN_PLUGIN(tetra::Plot3dWriter, tetra::Writer)
