// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>

namespace tetra {

/// How two pictures of the same size differ.
struct PictureDifference {
    double meanChannel = 0;    ///< mean difference of the colour channels, of 255
    double strikingPixels = 0; ///< share of the pixels with a channel that differs by more than 24 of 255
};

PictureDifference difference(const QImage& a, const QImage& b);

/// By how much a picture may differ from its baseline. Whoever makes one says why it is not less.
struct PictureTolerance {
    double meanChannel = 0;
    double strikingPixels = 0;
};

/// Of the CPU back end, which is deterministic: but an edge that falls on a sample position may fall to the other side
/// with another compiler or processor, which is a quarter of a pixel's colour. A tenth of the pixels lie on edges; one
/// in twenty of those is more than a compiler was ever seen to change, and far less than a wrong colour or an edge that
/// moves by a pixel.
inline constexpr PictureTolerance renderedTolerance{1, 0.005};
/// Of what QPainter draws: releases of Qt round the coverage of an edge otherwise, by a few of 255, which is not
/// striking. A line or a handle that is gone, or has moved by a pixel, changes more.
inline constexpr PictureTolerance paintedTolerance{0.5, 0.001};

/// Compares a picture with tests/ui/baselines/NAME.png. Empty if it is the same within the tolerance; else says how it
/// differs and where the picture, and one of the baseline, the picture and their difference side by side, were kept (in
/// the build folder). With TAN_UPDATE_BASELINES set the picture becomes the baseline, if it is another one; the same is
/// kept and told then, as a baseline changes only after a look.
QString compareWithBaseline(const QImage& picture, const QString& name, const PictureTolerance& tolerance);

} // namespace tetra
