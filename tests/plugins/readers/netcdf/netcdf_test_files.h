// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/netcdf/netcdf_reader.h"

#include <tan/data.h>

#include <QTemporaryDir>

#include <netcdf.h>

#include <filesystem>
#include <string>
#include <type_traits>
#include <vector>

namespace tetra {

/// The reader with the program of this build, as TAn has it.
const Reader& builtNetCdfReader();

/// A file that the NetCDF library writes; closed at the end of its life.
class NetCdfTestFile {
public:
    explicit NetCdfTestFile(const std::filesystem::path& path, int mode = NC_64BIT_OFFSET);
    NetCdfTestFile(const NetCdfTestFile&) = delete;
    NetCdfTestFile& operator=(const NetCdfTestFile&) = delete;
    ~NetCdfTestFile();

    int group(const char* name);                         ///< from now on all goes into it
    int dimension(const char* name, std::size_t length); ///< 0: without limit
    int define(const char* name, int type, const std::vector<int>& dimensions);
    void text(int variable, const char* name, const std::string& text); ///< an attribute
    template <class T>
    void numbers(int variable, const char* name, const std::vector<T>& values, int type = typeOf<T>())
    {
        define();
        check(nc_put_att(current_, variable, name, type, values.size(), values.data()));
    }
    /// All of a variable, or of one with records the first ones.
    template <class T> void put(int variable, const std::vector<T>& values)
    {
        putBytes(variable, values.data(), values.size());
    }
    template <class T>
    int add(const char* name, const std::vector<int>& dimensions, const std::vector<T>& values, const char* units = "")
    {
        const int variable = define(name, typeOf<T>(), dimensions);
        if (*units != 0)
            text(variable, "units", units);
        put(variable, values);
        return variable;
    }

    template <class T> static constexpr int typeOf()
    {
        if constexpr (std::is_same_v<T, char>)
            return NC_CHAR;
        else if constexpr (std::is_floating_point_v<T>)
            return sizeof(T) == 4 ? NC_FLOAT : NC_DOUBLE;
        else if constexpr (std::is_signed_v<T>)
            return sizeof(T) == 1 ? NC_BYTE : sizeof(T) == 2 ? NC_SHORT : sizeof(T) == 4 ? NC_INT : NC_INT64;
        else
            return sizeof(T) == 1 ? NC_UBYTE : sizeof(T) == 2 ? NC_USHORT : sizeof(T) == 4 ? NC_UINT : NC_UINT64;
    }

private:
    void define() const;
    void putBytes(int variable, const void* values, std::size_t count) const;
    static void check(int code);

    int file_ = -1;
    int current_ = -1;
};

/// The part of what was taken, or "" if the file left no choice; with " ?" behind a guess.
std::string takenOf(const std::vector<Taken>& taken, TakenPart part);

/// first, first + step ...
template <class T> std::vector<T> steps(std::size_t count, double first, double step)
{
    std::vector<T> values;
    for (std::size_t at = 0; at < count; ++at)
        values.push_back(static_cast<T>(first + static_cast<double>(at) * step));
    return values;
}

class NetCdfFolder {
public:
    std::filesystem::path path(const char* name) const
    {
        return std::filesystem::path(folder_.path().toStdString()) / name;
    }

private:
    QTemporaryDir folder_;
};

} // namespace tetra
