// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <QJsonObject>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tetra {

/// A folder of which files are read, and nothing that lies elsewhere, whatever names its own files give and wherever
/// its links lead. Names are paths from the folder, with '/' between their parts; "" is the folder itself. Errors are
/// sentences about "it", the folder.
class ZarrFolder {
public:
    static Result<ZarrFolder> open(const std::filesystem::path& path);

    /// The file of this name; null if there is none. Errors: a name that leads out of the folder, a link that does, or
    /// leads nowhere; what is no file; what cannot be read.
    Result<std::shared_ptr<const MappedFile>> file(const std::string& name) const;

    /// How many bytes it has; nothing if there is none. Errors as above.
    Result<std::optional<std::uint64_t>> fileSize(const std::string& name) const;

    /// The object that a file of JSON holds; nothing if there is none. Errors as above; no JSON, or too much.
    Result<std::optional<QJsonObject>> json(const std::string& name) const;

    /// The names of the folders in a folder, sorted; those that are links are passed over.
    std::vector<std::string> folders(const std::string& name) const;

private:
    Result<std::filesystem::path> placeOf(const std::string& name) const;

    std::filesystem::path root_; ///< without links
};

/// "a/b" of "a" and "b"; "b" of "" and "b".
std::string zarrPath(const std::string& folder, const std::string& name);

} // namespace tetra
