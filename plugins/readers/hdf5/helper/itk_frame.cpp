// SPDX-License-Identifier: GPL-3.0-or-later
// The format: Modules/IO/HDF5/src/itkHDF5ImageIO.cxx in ITK.
#include "plugins/readers/hdf5/helper/itk_frame.h"

namespace tetra {
namespace {

/// Numbers of a small array; empty if it is not there or has another length.
std::vector<double> numbersOf(hid_t file, const std::string& path, hssize_t count)
{
    if (H5Lexists(file, path.c_str(), H5P_DEFAULT) <= 0)
        return {};
    const Hdf5Id array = openArray(file, path);
    const Hdf5Id space(array ? H5Dget_space(array) : H5I_INVALID_HID, H5Sclose);
    if (!space || H5Sget_simple_extent_npoints(space) != count || H5Dget_storage_size(array) == 0)
        return {};
    std::vector<double> numbers(static_cast<std::size_t>(count));
    return H5Dread(array, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data()) < 0 ? std::vector<double>()
                                                                                                : numbers;
}

} // namespace

std::optional<ItkFrame> itkFrameOf(hid_t file, const Hdf5Array& array, const ArrayAxes& axes)
{
    const auto slash = array.path.rfind('/');
    if (array.path.substr(slash) != "/VoxelData" || array.size.size() < 3 || array.size.size() > 4)
        return std::nullopt;
    const std::string group = array.path.substr(0, slash);
    const auto origin = numbersOf(file, group + "/Origin", 3), spacing = numbersOf(file, group + "/Spacing", 3),
               directions = numbersOf(file, group + "/Directions", 9);
    if (origin.empty() || spacing.empty() || directions.empty() ||
        axes.space != std::array<std::size_t, 3>{0, 1, 2}) // components come last
        return std::nullopt;
    return ItkFrame{Eigen::Vector3d(origin.data()), Eigen::Vector3d(spacing.data()),
                    Eigen::Matrix3d(directions.data())}; // columns of Eigen are its rows
}

} // namespace tetra
