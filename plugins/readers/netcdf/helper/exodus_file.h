// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/netcdf/helper/netcdf_file.h"

#include <tan/base.h>
#include <tan/data.h>

#include <Eigen/Core>

#include <optional>

namespace tetra {

/// Exodus II, a convention of NetCDF (https://sandialabs.github.io/seacas-docs/exodusII-new.pdf): nodes, element blocks
/// of one shape each, variables at nodes and of elements over times. Numbers of nodes are from 1; maps of other numbers
/// are not used. Values are in the type that the file stores them in, whatever its attributes say of types.

/// The name of a dimension or variable of which there are several: "connect2".
std::string numbered(const char* name, std::size_t number);

/// Whether a file is by this convention.
bool isExodus(const NetCdfFile& file);

struct ExodusBlock {
    std::size_t number = 0; ///< from 1, in the names of its variables
    std::int64_t id = 0;
    std::string name{}; ///< empty: the file gives none
    std::string type{}; ///< "HEX8", as the file has it, in capitals
    std::uint64_t elements = 0;
    std::uint64_t nodesPerElement = 0; ///< 0 of polygons and polyhedra
};

/// "block 10", or its name.
std::string blockName(const ExodusBlock& block);

/// One variable, or several whose names differ in a last x, y, z alone, which are one of several components.
struct ExodusArray {
    std::string name;
    std::vector<std::string> parts{};   ///< the names of the variables
    std::vector<std::size_t> numbers{}; ///< of the variables, from 1
    bool perCell = false;
};

struct ExodusFile {
    const NetCdfFile* file = nullptr;
    int dimensions = 3; ///< of space
    std::uint64_t nodes = 0;
    std::vector<ExodusBlock> blocks{}; ///< those that have elements
    std::vector<ExodusArray> arrays{}; ///< those at nodes first
    std::vector<double> times{};
};

/// Errors (BadInput): what contradicts itself, the library's.
Result<ExodusFile> exodusFile(const NetCdfFile& file);

/// Where the nodes lie; of flat meshes z is 0.
Result<std::vector<Eigen::Vector3d>> nodePositions(const ExodusFile& exodus);

/// The type in which a variable at nodes, or of elements of the block, is stored.
SampleType storedType(const ExodusFile& exodus, const ExodusArray& array);

/// Numbers of a variable, NaN where it has none.
struct ExodusValues {
    std::vector<double> numbers{};
    std::optional<long double> noNumber{}; ///< which stored number stood there, if any did
    bool isGuessed = false;                ///< the file does not name it: it is the library's
};

/// A variable at all nodes at one time step, from 0.
Result<ExodusValues> nodeValues(const ExodusFile& exodus, std::size_t variable, std::size_t step);

/// A variable of a block's elements; nothing where the block has none.
Result<std::optional<ExodusValues>> elementValues(const ExodusFile& exodus, std::size_t variable,
                                                  const ExodusBlock& block, std::size_t step);

/// The array at nodes by which meshes are moved: "disp..." of a component for each dimension; null without one.
const ExodusArray* displacement(const ExodusFile& exodus);

} // namespace tetra
