// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/lattice/stored/volume_errors.h"

namespace tetra {

Result<std::shared_ptr<const MappedFile>> openVolumeFile(const std::filesystem::path& path)
{
    Result<std::shared_ptr<const MappedFile>> file = MappedFile::open(path);
    if (file && (*file)->bytes().empty())
        return inFile(path, {ErrorKind::BadInput, Message::say("it is empty. Get or make the file again.")});
    return file;
}

Error inFile(const std::filesystem::path& path, const Error& error)
{
    if (error.kind == ErrorKind::Cancelled || error.kind == ErrorKind::OutOfResource)
        return error;
    return {error.kind, Message::say("Cannot read '%1': %2", visibleText(path.string()), error.message), path};
}

Error withHeader(const std::filesystem::path& header, Error error)
{
    if (error.kind == ErrorKind::BadInput)
        error.message =
            Message::say("%1 The header '%2' names it as its data file.", error.message, visibleText(header.string()));
    return error;
}

Error inVolume(const std::filesystem::path& path, const std::filesystem::path& dataFile, const Error& error)
{
    const Error named = inFile(dataFile, error);
    return dataFile == path ? named : withHeader(path, named);
}

} // namespace tetra
