// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/host/input_file.h"

#include "core/build/model_build.h"

#include <tan/open.h>

#include <algorithm>
#include <span>

namespace tetra {

Result<Buffer<std::byte>> firstBytesOf(const std::filesystem::path& path)
{
    const auto bad = [&](Message what) { return Error{ErrorKind::BadInput, std::move(what), path}; };
    std::error_code problem;
    const auto status = std::filesystem::status(path, problem);
    if (!std::filesystem::exists(status) && isAddress(path.string()))
        return bad(Message::say("'%1' is an address, and datasets are read from this computer only. Download it and "
                                "give the file.",
                                path.string()));
    if (!std::filesystem::exists(status))
        return bad(
            Message::say("'%1' does not exist, or its folder may not be entered. Check the name.", path.string()));
    if (std::filesystem::exists(path / "system" / "controlDict", problem))
        return bad(
            Message::say("'%1' is the folder of an OpenFOAM case. Open 'system/controlDict' in it.", path.string()));
    if (std::filesystem::is_directory(status))
        return bad(Message::say("'%1' is a folder. Choose a file inside it.", path.string()));
    if (!std::filesystem::is_regular_file(status))
        return bad(Message::say("'%1' is a device or a pipe. Give a file.", path.string()));

    const auto file = MappedFile::open(path);
    if (!file)
        return file.error();
    const std::span<const std::byte> bytes = (*file)->bytes();
    const auto front = bytes.first(std::min(bytes.size(), shownToReaders));
    return Buffer<std::byte>(front.begin(), front.end());
}

Error emptyFile(const std::filesystem::path& path)
{
    return {ErrorKind::BadInput,
            Message::say("'%1' is empty. The copy may be incomplete: copy the file again.", path.string()), path};
}

bool isModelFile(const std::filesystem::path& path)
{
    if (path.extension() == ".tan")
        return true;
    const auto bytes = firstBytesOf(path);
    return bytes && beginsLikeModel(*bytes);
}

} // namespace tetra
