// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture/text_file.h"

#include "core/base/file_writer.h"
#include "core/base/mapped_file.h"

#include <cstddef>
#include <span>
#include <system_error>

namespace tetra {
namespace {

constexpr std::size_t largestFile = std::size_t(64) << 20; // a session with a long film has some megabytes

} // namespace

Result<std::string> readTextFile(const std::filesystem::path& path)
{
    std::error_code problem;
    if (std::filesystem::is_regular_file(path, problem) && std::filesystem::file_size(path, problem) > largestFile)
        return Error{ErrorKind::BadInput,
                     Message::say("The file '%1' is larger than 64 MiB. Choose a session, camera or transfer function.",
                                  path.string())};
    return wholeText(path, largestFile);
}

Status writeTextFile(const std::filesystem::path& path, std::string_view text)
{
    return writeWholeFile(path, std::as_bytes(std::span(text)));
}

} // namespace tetra
