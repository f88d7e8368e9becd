// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/netcdf/helper/netcdf_file.h"
#include "plugins/readers/netcdf/netcdf_request.h"

#include <tan/base.h>
#include <tan/data.h>

#include <array>
#include <map>
#include <optional>

namespace tetra {

/// A variable with a value at each point of three dimensions of space.
struct NetCdfField {
    const NetCdfVariable* variable = nullptr;
    std::array<std::size_t, 3> space{}; ///< places in variable->dimensions, the slowest first
    std::optional<std::size_t> time{};  ///< likewise
    std::vector<std::size_t> further{}; ///< likewise: of several points, and of no part in space or time
    bool isCoordinate = false;          ///< it says where others lie
};

/// All of a file, those last that are coordinates of others.
std::vector<NetCdfField> fieldsOf(const NetCdfFile& file);

/// Why a file has none, and what to do.
Error noFields(const NetCdfFile& file);

/// The one that is asked for by its path, its name alone, its standard_name or long_name if no other one has that, or
/// its number from 1. Error (WrongUsage): the list.
Result<NetCdfField> chooseField(const NetCdfFile& file, const std::vector<NetCdfField>& fields,
                                const std::string& wanted);

/// How many points it has along x, y, z of its own indices: the fastest dimension first.
std::array<std::uint64_t, 3> sizeOf(const NetCdfFile& file, const NetCdfField& field);

std::uint64_t lengthOf(const NetCdfFile& file, const NetCdfField& field, std::size_t place);

/// Times along the field's dimension of time, or numbers from 0 where the file does not say; empty without one.
Result<std::vector<double>> timesOf(const NetCdfFile& file, const NetCdfField& field);

/// What is read of a field for a request: one time step, one index of each further dimension.
struct FieldPart {
    NetCdfPart part;            ///< of the variable
    std::size_t timeIndex = 0;  ///< from 0
    std::vector<Taken> taken{}; ///< TimeStep and Block
};

Result<FieldPart> partOf(const NetCdfFile& file, const NetCdfField& field, const NetCdfRequest& request);

} // namespace tetra
