// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/lattice/header_formats.h"

#include "plugins/readers/lattice/field_text.h"
#include "plugins/readers/lattice/metaimage_volume.h"
#include "plugins/readers/lattice/mrc_header.h"
#include "plugins/readers/lattice/mrc_volume.h"
#include "plugins/readers/lattice/nifti_header.h"
#include "plugins/readers/lattice/nifti_volume.h"
#include "plugins/readers/lattice/volume_errors.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace tetra {

namespace fs = std::filesystem;

HeaderFormat formatBySignature(const fs::path& path, std::span<const std::byte> firstBytes)
{
    if (looksLikeNifti(firstBytes) || (extension(path) == ".hdr" && looksLikeAnalyze(firstBytes)))
        return HeaderFormat::Nifti;
    if (looksLikeMrc(firstBytes))
        return HeaderFormat::Mrc;
    return looksLikeMetaImage(asText(firstBytes)) ? HeaderFormat::MetaImage : HeaderFormat::None;
}

HeaderFormat formatByName(const fs::path& path)
{
    constexpr std::array<std::pair<std::string_view, HeaderFormat>, 7> names = {{{".mhd", HeaderFormat::MetaImage},
                                                                                 {".mha", HeaderFormat::MetaImage},
                                                                                 {".nii", HeaderFormat::Nifti},
                                                                                 {".hdr", HeaderFormat::Nifti},
                                                                                 {".mrc", HeaderFormat::Mrc},
                                                                                 {".ccp4", HeaderFormat::Mrc},
                                                                                 {".map", HeaderFormat::Mrc}}};
    const auto* const found =
        std::ranges::find(names, extension(path), &std::pair<std::string_view, HeaderFormat>::first);
    return found != names.end() ? found->second : HeaderFormat::None;
}

fs::path pairedHeader(const fs::path& path)
{
    if (extension(path) != ".img")
        return {};
    for (const fs::path& name : niftiPartners(path)) {
        std::error_code ignored;
        if (!fs::is_regular_file(name, ignored))
            continue;
        const auto file = MappedFile::open(name);
        if (file && formatBySignature(name, (*file)->bytes()) == HeaderFormat::Nifti)
            return name;
    }
    return {};
}

Result<std::optional<HeaderFile>> headerFileOf(const fs::path& path, const std::shared_ptr<const MappedFile>& file)
{
    const HeaderFormat bySignature = formatBySignature(path, file->bytes());
    const HeaderFormat format = bySignature != HeaderFormat::None ? bySignature : formatByName(path);
    if (format != HeaderFormat::None)
        return std::optional<HeaderFile>({format, path, file});
    const fs::path paired = pairedHeader(path);
    if (paired.empty())
        return std::optional<HeaderFile>();
    const auto opened = openVolumeFile(paired);
    if (!opened)
        return opened.error();
    return std::optional<HeaderFile>({HeaderFormat::Nifti, paired, *opened});
}

Result<StoredVolume> describedVolume(const HeaderFile& header, const VolumeChoice& choice)
{
    const auto bytes = header.file->bytes();
    switch (header.format) {
    case HeaderFormat::MetaImage: return metaImageVolume(asText(bytes), header.path, choice);
    case HeaderFormat::Mrc: return mrcVolume(bytes, header.path, choice);
    default: return niftiVolume(bytes, header.path, choice);
    }
}

std::vector<fs::path> headerCompanions(const fs::path& path, std::span<const std::byte> file)
{
    const HeaderFormat signature = formatBySignature(path, file);
    const HeaderFormat format = signature == HeaderFormat::None ? formatByName(path) : signature;
    if (format == HeaderFormat::MetaImage)
        return metaImageCompanions(asText(file), path);
    if (format == HeaderFormat::Nifti) {
        const auto header = parseNiftiHeader(file);
        return header && header->isPair ? niftiPartners(path) : std::vector<fs::path>();
    }
    return extension(path) == ".img" ? niftiPartners(path) : std::vector<fs::path>();
}

} // namespace tetra
