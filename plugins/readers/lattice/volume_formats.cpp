// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/lattice/volume_formats.h"

#include "plugins/readers/lattice/bov_file.h"
#include "plugins/readers/lattice/cube_file.h"
#include "plugins/readers/lattice/dx_file.h"
#include "plugins/readers/lattice/npy_file.h"

#include <array>

namespace tetra {

namespace {

constexpr double sureScore = 0.95, scoreToSayWhatIsWrong = 0.4;

/// Of a format that is known by its ending, and whose beginning may be another one's.
double scoreByEnding(bool hasEnding, bool looksRight)
{
    return !hasEnding ? 0 : looksRight ? sureScore : scoreToSayWhatIsWrong;
}

constexpr std::array<VolumeFormat, 4> formatsOfVolumes{{
    {Message::marked("NumPy array (*.npy)"),
     [](std::string_view ending, std::string_view beginning) {
         return looksLikeNpy(beginning) ? sureScore : scoreByEnding(ending == ".npy", false);
     },
     describeNpy, nullptr},
    {Message::marked("Gaussian cube (*.cube *.cub)"),
     [](std::string_view ending, std::string_view beginning) {
         return scoreByEnding(ending == ".cube" || ending == ".cub", looksLikeCube(beginning));
     },
     describeCube, nullptr},
    {Message::marked("OpenDX (*.dx)"),
     [](std::string_view ending, std::string_view beginning) {
         return scoreByEnding(ending == ".dx", looksLikeDx(beginning));
     },
     describeDx, companionsOfDx},
    {Message::marked("Brick of values (*.bov)"),
     [](std::string_view ending, std::string_view beginning) {
         return looksLikeBov(beginning) ? sureScore : scoreByEnding(ending == ".bov", false);
     },
     describeBov, companionsOfBov},
}};

} // namespace

std::span<const VolumeFormat> volumeFormats()
{
    return formatsOfVolumes;
}

const VolumeFormat* volumeFormatOf(const std::filesystem::path& path, std::string_view beginning, double& score)
{
    const VolumeFormat* best = nullptr;
    score = 0;
    for (const VolumeFormat& format : formatsOfVolumes)
        if (const double its = format.score(fileEnding(path), beginning); its > score) {
            best = &format;
            score = its;
        }
    return best;
}

} // namespace tetra
