// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/lattice/volume_formats.h"

#include "plugins/readers/lattice/arrays/bov_file.h"
#include "plugins/readers/lattice/arrays/npy_file.h"
#include "plugins/readers/lattice/headers/header_text.h"
#include "plugins/readers/lattice/metaimage/metaimage_volume.h"
#include "plugins/readers/lattice/mrc/mrc_header.h"
#include "plugins/readers/lattice/mrc/mrc_volume.h"
#include "plugins/readers/lattice/nifti/nifti_header.h"
#include "plugins/readers/lattice/nifti/nifti_volume.h"
#include "plugins/readers/lattice/nrrd/nrrd_fields.h"
#include "plugins/readers/lattice/nrrd/nrrd_volume.h"
#include "plugins/readers/lattice/raw/raw_volume.h"
#include "plugins/readers/lattice/text/cube_file.h"
#include "plugins/readers/lattice/text/dx_file.h"

#include <algorithm>
#include <initializer_list>

namespace tetra {

namespace {

namespace fs = std::filesystem;
using FirstBytes = std::span<const std::byte>;

constexpr double sure = 0.95, byName = 0.8, toSayWhatIsWrong = 0.4, ofRawName = 0.3, ofUnknownHeader = 0.2;

bool hasEnding(const fs::path& path, std::initializer_list<std::string_view> endings)
{
    return std::ranges::find(endings, fileEnding(path)) != endings.end();
}

double nrrdScore(const fs::path& path, FirstBytes beginning)
{
    constexpr double byNameOfNrrd = 0.9; // to say what is wrong with it
    return looksLikeNrrd(asText(beginning)) ? 1 : hasEnding(path, {".nrrd", ".nhdr"}) ? byNameOfNrrd : 0;
}

double metaImageScore(const fs::path& path, FirstBytes beginning)
{
    return looksLikeMetaImage(asText(beginning)) ? sure : hasEnding(path, {".mhd", ".mha"}) ? byName : 0;
}

/// A header of Analyze has little to know it by but its name, and other formats have the same.
double niftiScore(const fs::path& path, FirstBytes beginning)
{
    if (isNiftiHeader(path, beginning) || !niftiHeaderBeside(path, beginning).empty())
        return sure;
    return hasEnding(path, {".nii"}) ? byName : hasEnding(path, {".hdr"}) ? ofUnknownHeader : 0;
}

double mrcScore(const fs::path& path, FirstBytes beginning)
{
    return looksLikeMrc(beginning) ? sure : hasEnding(path, {".mrc", ".ccp4", ".map"}) ? byName : 0;
}

double npyScore(const fs::path& path, FirstBytes beginning)
{
    return looksLikeNpy(asText(beginning)) ? sure : hasEnding(path, {".npy"}) ? toSayWhatIsWrong : 0;
}

/// The beginnings of cubes and of OpenDX may be other texts', too.
double cubeScore(const fs::path& path, FirstBytes beginning)
{
    return !hasEnding(path, {".cube", ".cub"}) ? 0 : looksLikeCube(asText(beginning)) ? sure : toSayWhatIsWrong;
}

double dxScore(const fs::path& path, FirstBytes beginning)
{
    return !hasEnding(path, {".dx"}) ? 0 : looksLikeDx(asText(beginning)) ? sure : toSayWhatIsWrong;
}

double bovScore(const fs::path& path, FirstBytes beginning)
{
    return looksLikeBov(asText(beginning)) ? sure : hasEnding(path, {".bov"}) ? toSayWhatIsWrong : 0;
}

double rawScore(const fs::path& path, FirstBytes)
{
    return hasEnding(path, {".raw", ".bin", ".binary", ".dat", ".img", ".vol"}) ? ofRawName : 0;
}

constexpr std::array<VolumeFormat, 9> formats{{
    {Message::marked("NRRD volume (*.nrrd *.nhdr)"), nrrdScore, {"component", "time"}, nrrdVolume, nrrdCompanions},
    {Message::marked("MetaImage (*.mhd *.mha)"),
     metaImageScore,
     {"component", "time"},
     metaImageVolume,
     metaImageCompanions},
    {Message::marked("NIfTI (*.nii *.hdr)"),
     niftiScore,
     {"component", "time"},
     niftiVolume,
     niftiCompanions,
     niftiHeaderBeside},
    {Message::marked("MRC and CCP4 maps (*.mrc *.ccp4 *.map)"), mrcScore, {"component", "time"}, mrcVolume},
    {Message::marked("NumPy array (*.npy)"), npyScore, {"array", "component", npyAxesId}, describeNpy},
    {Message::marked("Gaussian cube (*.cube *.cub)"), cubeScore, {"array", "component"}, describeCube},
    {Message::marked("OpenDX (*.dx)"), dxScore, {"array", "component"}, describeDx, companionsOfDx},
    {Message::marked("Brick of values (*.bov)"), bovScore, {"array", "component"}, describeBov, companionsOfBov},
    {Message::marked("Raw volume (*.raw *.bin *.binary *.dat *.img *.vol)"),
     rawScore,
     {"size", "type", "byte-order", "skip"},
     rawVolume,
     niftiCompanions}, // the header of samples "head.img" may be packed, so that nothing is known of it yet
}};

} // namespace

std::span<const VolumeFormat> volumeFormats()
{
    return formats;
}

const VolumeFormat* volumeFormatOf(const fs::path& path, FirstBytes beginning, double& score)
{
    const VolumeFormat* best = nullptr;
    score = 0;
    for (const VolumeFormat& format : formats)
        if (const double its = format.score(path, beginning); its > score) {
            best = &format;
            score = its;
        }
    return best;
}

} // namespace tetra
