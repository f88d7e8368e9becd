// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/data/grid_checks.h"

#include "core/data/grid_handedness.h"

#include <string>

namespace tetra {

namespace {

constexpr double farthestCoordinate = 1e100; ///< volumes of such coordinates are still numbers

std::string pointText(const Lattice& lattice, std::uint64_t point)
{
    const auto c = lattice.coordinates(point);
    return "(" + std::to_string(c[0]) + ", " + std::to_string(c[1]) + ", " + std::to_string(c[2]) + ")";
}

} // namespace

Status checkGrid(const Dataset& dataset)
{
    for (std::uint64_t point = 0; point < dataset.pointCount(); ++point)
        if (!((*dataset.positions)[point].cwiseAbs().maxCoeff() <= farthestCoordinate) ||
            !(*dataset.positions)[point].allFinite())
            return Error{ErrorKind::BadInput, "the position of point " + pointText(dataset.lattice, point) +
                                                  " is no number, or far beyond what can be reckoned with. Repair the "
                                                  "file."};
    if (dataset.values.notFiniteCount() > 0)
        return Error{ErrorKind::BadInput, std::to_string(dataset.values.notFiniteCount()) +
                                              " values are too large for single precision, or no numbers. Choose "
                                              "another array."};
    const CellCornerSigns signs = cellCornerSigns(dataset);
    if (signs.positive == 0 && signs.negative == 0)
        return Error{ErrorKind::BadInput,
                     "all its points lie in a plane or closer, so that no cell has a volume. TAn takes volumes."};
    return {};
}

} // namespace tetra
