// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/host/input_file.h"

#include "core/base/system_error.h"
#include "core/build/model_build.h"

#include <tan/open.h>

#include <cerrno>
#include <fstream>
#include <span>

namespace tetra {

Result<Buffer<std::byte>> firstBytesOf(const std::filesystem::path& path)
{
    const auto bad = [](Message what) { return Error{ErrorKind::BadInput, std::move(what)}; };
    std::error_code problem;
    const auto status = std::filesystem::status(path, problem);
    if (!std::filesystem::exists(status) && isAddress(path.string()))
        return bad(Message::say("'%1' is an address, and datasets are read from this computer only. Download it and "
                                "give the file.",
                                path.string()));
    if (!std::filesystem::exists(status))
        return bad(
            Message::say("'%1' does not exist, or its folder may not be entered. Check the name.", path.string()));
    if (std::filesystem::is_directory(status))
        return bad(Message::say("'%1' is a folder. Choose a file inside it.", path.string()));
    if (!std::filesystem::is_regular_file(status))
        return bad(Message::say("'%1' is a device or a pipe. Give a file.", path.string()));

    std::ifstream file(path, std::ios::binary);
    if (!file.is_open() && isLackOfResources(errno))
        return Error{ErrorKind::OutOfResource, Message::say("'%1' cannot be read: %2. %3", path.string(),
                                                            systemErrorText(errno), resourceRemedy)};
    Buffer<std::byte> bytes(shownToReaders);
    file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(shownToReaders));
    if (file.gcount() == 0)
        return bad(file.eof()
                       ? Message::say("'%1' is empty. The copy may be incomplete: copy the file again.", path.string())
                       : Message::say("'%1' cannot be read: %2.", path.string(), systemErrorText(errno)));
    bytes.resize(static_cast<std::size_t>(file.gcount()));
    return bytes;
}

bool isModelFile(const std::filesystem::path& path)
{
    if (path.extension() == ".tan")
        return true;
    const auto bytes = firstBytesOf(path);
    return bytes && beginsLikeModel(*bytes);
}

} // namespace tetra
