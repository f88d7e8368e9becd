// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/packed/replay.h"

namespace tetra {

bool mayBeReplayed(const Model&)
{
    return false;
}

Result<std::optional<PackReport>> packReplayed(const Model&, PackedFileWriter&, const Progress&)
{
    return std::optional<PackReport>();
}

Result<UnpackReport> unpackReplayed(const PackedFile& file, const std::filesystem::path&, const Progress&)
{
    return file.damaged(Message::say("it is packed by replay"));
}

Status unpackPrefixOfReplayed(const PackedFile& file, std::size_t, const std::filesystem::path&, const Progress&)
{
    return file.damaged(Message::say("it is packed by replay"));
}

} // namespace tetra
