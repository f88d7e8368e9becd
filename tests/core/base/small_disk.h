// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTemporaryDir>

#include <filesystem>
#include <string>

#include <sys/mount.h>

namespace tetra {

/// A disk of a few kilobytes, mounted for as long as this lives, so that tests can fill one. Needs the right to mount.
class SmallDisk {
public:
    explicit SmallDisk(std::size_t bytes)
    {
        const std::string size = "size=" + std::to_string(bytes);
        mounted_ = mountPoint_.isValid() && ::mount("tmpfs", folder().c_str(), "tmpfs", 0, size.c_str()) == 0;
    }
    ~SmallDisk()
    {
        if (mounted_)
            ::umount2(folder().c_str(), MNT_DETACH);
    }
    SmallDisk(const SmallDisk&) = delete;
    SmallDisk& operator=(const SmallDisk&) = delete;

    bool ok() const { return mounted_; }
    std::filesystem::path folder() const { return mountPoint_.path().toStdString(); }

private:
    QTemporaryDir mountPoint_;
    bool mounted_ = false;
};

} // namespace tetra
