// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/whole_file.h"

#include "core/base/file_writer.h"

namespace tetra {

Status writeWholeFile(const std::filesystem::path& path, std::span<const std::byte> content)
{
    auto file = FileWriter::create(path);
    if (!file)
        return file.error();
    if (const Status written = file->write(content); !written)
        return written;
    return file->commit();
}

} // namespace tetra
