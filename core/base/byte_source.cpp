// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/byte_source.h"

#include <algorithm>
#include <memory>

namespace tetra {

Result<ByteSource> fileSource(const std::filesystem::path& path)
{
    auto file = MappedFile::open(path);
    if (!file)
        return file.error();
    ByteSource source;
    source.size = (*file)->bytes().size();
    source.isLocal = true;
    source.read = [mapped = *std::move(file)](std::uint64_t offset, std::span<std::byte> to,
                                              const Progress&) -> Status {
        const std::span<const std::byte> bytes = mapped->bytes();
        const bool isThere = offset <= bytes.size() && to.size() <= bytes.size() - offset;
        if (isThere)
            std::ranges::copy(bytes.subspan(offset, to.size()), to.begin());
        if (isThere && !mapped->damaged())
            return {};
        return Error{ErrorKind::BadInput,
                     Message::say("'%1' was cut short or changed while it was read. Copy the file again.",
                                  mapped->path().string())};
    };
    source.fetch = [](std::span<const ByteRange>, const Progress&) { return Status(); };
    return source;
}

} // namespace tetra
