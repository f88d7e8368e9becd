// SPDX-License-Identifier: GPL-3.0-or-later
#include <tan/packed.h>

#include "core/base/guarded.h"
#include "core/base/mapped_file.h"
#include "core/build/model_build.h"
#include "core/packed/packed_file.h"
#include "core/packed/parts.h"
#include "core/packed/replay.h"

#include <utility>

namespace tetra {

namespace {

constexpr MarkedText noMemoryToUnpack =
    Message::marked("Not enough memory to unpack '%1'. Close other programs, or unpack it on a larger machine.");

} // namespace

PackedModel::PackedModel(std::unique_ptr<const PackedFile> file) : file_(std::move(file))
{
    const ModelDescription& about = file_->description();
    const double extent = about.range.extent(), diagonal = about.bounds.diagonal().norm();
    for (const format::PackedLevelEntry& level : file_->levels())
        levels_.push_back({extent > 0 ? 100 * static_cast<double>(level.error) / extent : 0,
                           diagonal > 0 ? 100 * static_cast<double>(level.warping) / diagonal : 0, level.sites,
                           file_->chunks().offset + level.chunkBytes});
}

PackedModel::~PackedModel() = default;

Result<std::shared_ptr<const PackedModel>> PackedModel::open(const std::filesystem::path& path)
{
    auto source = fileSource(path);
    if (!source)
        return source.error();
    return open(*std::move(source), path);
}

Result<std::shared_ptr<const PackedModel>> PackedModel::open(ByteSource source, const std::filesystem::path& name,
                                                             const Progress& progress)
{
    const auto opened = [&]() -> Result<std::shared_ptr<const PackedModel>> {
        auto file = PackedFile::open(std::move(source), name, progress);
        if (!file)
            return file.error();
        return std::shared_ptr<const PackedModel>(new PackedModel(*std::move(file)));
    };
    return guarded(noMemoryToUnpack, opened, name.native());
}

const std::filesystem::path& PackedModel::path() const noexcept
{
    return file_->name();
}

std::uint64_t PackedModel::fileSize() const noexcept
{
    return file_->size();
}

PackMethod PackedModel::method() const noexcept
{
    return static_cast<PackMethod>(file_->facts().method);
}

const ModelDescription& PackedModel::description() const noexcept
{
    return file_->description();
}

std::uint32_t PackedModel::siteCount() const noexcept
{
    return file_->header().siteCount;
}

std::uint64_t PackedModel::tetrahedronCount() const noexcept
{
    return file_->header().tetrahedronCount;
}

std::uint64_t PackedModel::unpackedBytes() const noexcept
{
    return file_->facts().fileBytes;
}

bool isPacked(const std::filesystem::path& path)
{
    constexpr std::size_t frontBytes = 16 << 10;
    const auto file = RegularFile::open(path);
    const auto front = file ? file->front(frontBytes) : file.error();
    if (!front)
        return false;
    const auto bytes = std::as_bytes(std::span(*front));
    return beginsLikeModel(bytes) && isFrontOfPacked(bytes);
}

namespace {

Result<PackReport> packInto(const Model& model, const std::filesystem::path& output, const Progress& progress)
{
    if (const Status safe = checkModelOutput(output); !safe)
        return safe.error();
    const auto finished = [&](PackedFileWriter& file, PackReport report) -> Result<PackReport> {
        report.fileBytes = file.size();
        report.other = report.fileBytes - report.positions - report.values - report.accuracy - report.ownErrors;
        if (const Status intact = model.checkIntact(); !intact)
            return intact.error();
        if (const Status written = file.finish(); !written)
            return written.error();
        return report;
    };
    const bool tried = mayBeReplayed(model);
    if (tried) {
        const auto file = PackedFileWriter::create(output, model, PackMethod::Replayed);
        if (!file)
            return file.error();
        const auto report = packReplayed(model, **file, progress);
        if (!report)
            return report.error();
        if (*report)
            return finished(**file, **report);
    }
    const auto file = PackedFileWriter::create(output, model, PackMethod::StoredByParts);
    if (!file)
        return file.error();
    const auto report = packParts(model, **file, progress.part(tried ? triedAt : 0, 1));
    if (!report)
        return report.error();
    return finished(**file, *report);
}

} // namespace

Result<PackReport> packModel(const Model& model, const std::filesystem::path& output, const Progress& progress)
{
    return guarded(
        Message::marked("Not enough memory to pack '%1'. Close other programs, or pack it on a larger "
                        "machine."),
        [&] { return packInto(model, output, progress); }, model.path().native());
}

Result<UnpackReport> unpackModel(const PackedModel& packed, const std::filesystem::path& output,
                                 const Progress& progress)
{
    if (const Status safe = checkModelOutput(output); !safe)
        return safe.error();
    return guarded(
        noMemoryToUnpack,
        [&]() -> Result<UnpackReport> {
            if (const Status right = packed.file().checkChunks(progress); !right)
                return right.error();
            return packed.method() == PackMethod::Replayed ? unpackReplayed(packed.file(), output, progress)
                                                           : unpackParts(packed.file(), output, progress);
        },
        packed.path().native());
}

Status unpackPrefix(const PackedModel& packed, std::size_t level, const std::filesystem::path& output,
                    const Progress& progress)
{
    if (level >= packed.levels().size())
        return Error{ErrorKind::WrongUsage, Message::say("'%1' has %2 levels, and level %3 is none of them.",
                                                         packed.path().string(), packed.levels().size(), level)};
    if (const Status safe = checkModelOutput(output); !safe)
        return safe;
    return guarded(
        noMemoryToUnpack,
        [&] {
            if (const Status right = packed.file().checkChunks(progress); !right)
                return right;
            return packed.method() == PackMethod::Replayed
                       ? unpackPrefixOfReplayed(packed.file(), level, output, progress)
                       : unpackPrefixOfParts(packed.file(), level, output, progress);
        },
        packed.path().native());
}

} // namespace tetra
