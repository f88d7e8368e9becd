// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/packed/parts.h"

namespace tetra {

Result<PackReport> packParts(const Model& model, PackedFileWriter&, const Progress&)
{
    return Error{ErrorKind::BadInput,
                 Message::say("'%1' cannot be packed: it is not what refining the samples that it holds makes.",
                              model.path().string())};
}

Result<UnpackReport> unpackParts(const PackedFile& file, const std::filesystem::path&, const Progress&)
{
    return file.damaged(Message::say("it is packed by parts"));
}

Status unpackPrefixOfParts(const PackedFile& file, std::size_t, const std::filesystem::path&, const Progress&)
{
    return file.damaged(Message::say("it is packed by parts"));
}

} // namespace tetra
