// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/plot3d/plot3d_writer.h"

#include "core/base/file_writer.h"
#include "core/data/dataset_checks.h"

#include <algorithm>
#include <bit>
#include <new>
#include <span>
#include <vector>

namespace tetra {

namespace {

static_assert(std::endian::native == std::endian::little, "numbers are written as they are");

bool fitsSingle(const Dataset& dataset)
{
    const SampleType type = dataset.values.type();
    return type != SampleType::UInt32 && type != SampleType::Int32 && type != SampleType::Float64 &&
           (dataset.positions ? fitFloats(*dataset.positions) : false);
}

/// Writes numbers in the precision `Real`, some at a time.
template <class Real> class RealWriter {
public:
    RealWriter(FileWriter& file, std::uint64_t total, const Progress& progress)
        : file_(file), total_(total), progress_(progress)
    {
    }

    /// numberAt(i) for i below `count`.
    template <class Function> Status write(std::uint64_t count, Function&& numberAt)
    {
        for (std::uint64_t begin = 0; begin < count; begin += numbersAtOnce) {
            if (progress_.cancelled())
                return cancelledError(Message::marked("Writing"));
            const std::uint64_t end = std::min(count, begin + numbersAtOnce);
            numbers_.clear();
            for (std::uint64_t i = begin; i < end; ++i)
                numbers_.push_back(static_cast<Real>(numberAt(i)));
            if (const Status written = file_.write(std::as_bytes(std::span(numbers_))); !written)
                return written;
            done_ += end - begin;
            progress_.report(static_cast<double>(done_) / static_cast<double>(total_), Message::marked("Writing"));
        }
        return {};
    }

private:
    static constexpr std::uint64_t numbersAtOnce = 1 << 18;

    FileWriter& file_;
    std::uint64_t total_;
    const Progress& progress_;
    std::vector<Real> numbers_;
    std::uint64_t done_ = 0;
};

Status writeSize(const Lattice& lattice, FileWriter& file)
{
    return file.write(std::as_bytes(std::span(lattice.size)));
}

template <class Real> Status writeGrid(const Dataset& dataset, FileWriter& file, const Progress& progress)
{
    if (const Status written = writeSize(dataset.lattice, file); !written)
        return written;
    RealWriter<Real> reals(file, 3 * dataset.pointCount(), progress);
    for (Eigen::Index axis = 0; axis < 3; ++axis)
        if (const Status written =
                reals.write(dataset.pointCount(), [&](std::uint64_t point) { return dataset.position(point)[axis]; });
            !written)
            return written;
    return {};
}

/// A solution of a gas at rest whose density is the value.
template <class Real> Status writeSolution(const Dataset& dataset, FileWriter& file, const Progress& progress)
{
    constexpr std::uint64_t numbersOfAState = 4;
    constexpr std::uint64_t otherQuantities = 4;
    const auto zero = [](std::uint64_t) { return 0.0; };
    if (const Status written = writeSize(dataset.lattice, file); !written)
        return written;
    RealWriter<Real> reals(file, 5 * dataset.pointCount() + numbersOfAState, progress);
    if (const Status written = reals.write(numbersOfAState, zero); !written)
        return written;
    if (const Status written =
            reals.write(dataset.pointCount(), [&](std::uint64_t point) { return dataset.values.at(point); });
        !written)
        return written;
    return reals.write(otherQuantities * dataset.pointCount(), zero);
}

template <class Real>
Status writeBoth(const Dataset& dataset, FileWriter& grid, FileWriter& solution, const Progress& progress)
{
    if (const Status written = writeGrid<Real>(dataset, grid, progress.part(0, 0.375)); !written)
        return written;
    return writeSolution<Real>(dataset, solution, progress.part(0.375, 1));
}

} // namespace

std::vector<std::string> Plot3dWriter::nameFilters() const
{
    return {Message::marked("PLOT3D grid, with its solution beside it (*.xyz)")};
}

double Plot3dWriter::score(const std::filesystem::path& path) const
{
    return path.extension() == ".xyz" ? 1 : 0;
}

Status Plot3dWriter::write(const Dataset& dataset, const std::filesystem::path& path, const ParameterValues&,
                           const Progress& progress) const
try {
    if (dataset.domain != DomainClass::RegularLattice && dataset.domain != DomainClass::Curvilinear)
        return Error{ErrorKind::WrongUsage, Message::say("PLOT3D files hold points on a grid, and '%1' is not. Give "
                                                         "the file another ending, such as .csv for scattered points.",
                                                         dataset.source.name)};
    std::filesystem::path solutionPath = path;
    solutionPath.replace_extension(".q");
    Result<FileWriter> solution = FileWriter::create(solutionPath);
    if (!solution)
        return solution.error();
    Result<FileWriter> grid = FileWriter::create(path);
    if (!grid)
        return grid.error();
    const Status written = fitsSingle(dataset) ? writeBoth<float>(dataset, *grid, *solution, progress)
                                               : writeBoth<double>(dataset, *grid, *solution, progress);
    if (!written)
        return written;
    if (const Status committed = solution->commit(); !committed)
        return committed;
    return grid->commit();
} catch (const std::bad_alloc&) {
    return Error{ErrorKind::OutOfResource, Message::say("Not enough memory to write the file. Close other programs.")};
}

} // namespace tetra
