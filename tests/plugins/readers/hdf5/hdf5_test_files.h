// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/readers/hdf5/hdf5_reader.h"

#include <tan/data.h>

#include <QTemporaryDir>

#include <hdf5.h>

#include <filesystem>
#include <string>
#include <type_traits>
#include <vector>

namespace tetra {

/// The reader with the program of this build, as TAn has it.
const Reader& builtHdf5Reader();

/// How an array is stored.
struct Hdf5Storage {
    hid_t type = H5I_INVALID_HID; ///< in the file; without it that of the values
    std::vector<hsize_t> chunk{}; ///< else in one piece
    bool isPacked = false;        ///< by gzip, shuffled, with checksums
    std::vector<double> fill{};   ///< one number, or none
    bool isFilled = true;         ///< false: what nobody wrote is undefined
};

/// A file that the HDF5 library writes; closed at the end of its life.
class Hdf5TestFile {
public:
    explicit Hdf5TestFile(const std::filesystem::path& path, hsize_t userBlock = 0);
    Hdf5TestFile(const Hdf5TestFile&) = delete;
    Hdf5TestFile& operator=(const Hdf5TestFile&) = delete;
    ~Hdf5TestFile();

    hid_t id() const { return file_; }
    void group(const std::string& path);
    /// An array that nobody writes.
    void define(const std::string& path, const std::vector<hsize_t>& size, const Hdf5Storage& storage);
    template <class T> void add(const std::string& path, const std::vector<hsize_t>& size, const std::vector<T>& values,
                                Hdf5Storage storage = {})
    {
        if (storage.type < 0)
            storage.type = typeOf<T>();
        define(path, size, storage);
        write(path, typeOf<T>(), values.data());
    }
    void write(const std::string& path, hid_t type, const void* values);
    template <class T> void numbers(const std::string& object, const char* name, const std::vector<T>& values)
    {
        attribute(object, name, typeOf<T>(), values.size(), values.data());
    }
    void texts(const std::string& object, const char* name, const std::vector<std::string>& texts);
    /// A text of which each letter is an entry.
    void letters(const std::string& object, const char* name, const std::string& text);
    /// Attaches an array of coordinates to a dimension, as H5DSattach_scale() does.
    void attachScales(const std::string& array, const std::vector<std::string>& scales);

    template <class T> static hid_t typeOf()
    {
        if constexpr (std::is_floating_point_v<T>)
            return sizeof(T) == 4 ? H5T_NATIVE_FLOAT : H5T_NATIVE_DOUBLE;
        else if constexpr (std::is_signed_v<T>)
            return sizeof(T) == 1   ? H5T_NATIVE_INT8
                   : sizeof(T) == 2 ? H5T_NATIVE_INT16
                   : sizeof(T) == 4 ? H5T_NATIVE_INT32
                                    : H5T_NATIVE_INT64;
        else
            return sizeof(T) == 1   ? H5T_NATIVE_UINT8
                   : sizeof(T) == 2 ? H5T_NATIVE_UINT16
                   : sizeof(T) == 4 ? H5T_NATIVE_UINT32
                                    : H5T_NATIVE_UINT64;
    }

private:
    void attribute(const std::string& object, const char* name, hid_t type, std::size_t count, const void* values);

    hid_t file_ = H5I_INVALID_HID;
};

/// Fails the program: a test file could not be written.
void mustBeDone(bool isDone);

/// The part of what was taken, or "" if the file left no choice; with " ?" behind a guess.
std::string takenOf(const std::vector<Taken>& taken, TakenPart part);

std::string textOf(const std::vector<Message>& messages);

/// first, first + step ...
template <class T> std::vector<T> steps(std::size_t count, double first, double step)
{
    std::vector<T> values;
    for (std::size_t at = 0; at < count; ++at)
        values.push_back(static_cast<T>(first + static_cast<double>(at) * step));
    return values;
}

class Hdf5Folder {
public:
    std::filesystem::path path(const char* name) const
    {
        return std::filesystem::path(folder_.path().toStdString()) / name;
    }

private:
    QTemporaryDir folder_;
};

} // namespace tetra
