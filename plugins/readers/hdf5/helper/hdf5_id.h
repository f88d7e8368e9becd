// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <hdf5.h>

#include <string>
#include <utility>

namespace tetra {

/// A thing that the HDF5 library opened or made, closed at the end of its life; empty where the library failed.
class Hdf5Id {
public:
    using Close = herr_t (*)(hid_t);
    Hdf5Id() = default;
    Hdf5Id(hid_t id, Close close) : id_(id), close_(close) {}
    Hdf5Id(Hdf5Id&& other) noexcept : id_(std::exchange(other.id_, H5I_INVALID_HID)), close_(other.close_) {}
    Hdf5Id& operator=(Hdf5Id&& other) noexcept
    {
        std::swap(id_, other.id_);
        std::swap(close_, other.close_);
        return *this;
    }
    ~Hdf5Id()
    {
        if (id_ >= 0)
            close_(id_);
    }
    explicit operator bool() const noexcept { return id_ >= 0; }
    operator hid_t() const noexcept { return id_; } // the library's functions take it as it is

private:
    hid_t id_ = H5I_INVALID_HID;
    Close close_ = nullptr;
};

/// The group or array of this path in the file; empty if there is none, or if it lies in another file.
Hdf5Id openGroup(hid_t file, const std::string& path);
Hdf5Id openArray(hid_t file, const std::string& path);

/// A library that opens no other file than it is told to, by no link and for no filter, and prints nothing.
void confineHdf5();

/// An error (BadInput) that gives the innermost reason of the library's last failure; `where` as in "its array 'a'".
Error hdf5Error(const Message& where);

} // namespace tetra
