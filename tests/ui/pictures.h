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

/// Compares a picture with tests/ui/baselines/NAME.png. Empty if it is the same within the tolerance; else says how it
/// differs and where both pictures and their difference were kept (in the build folder). With TAN_UPDATE_BASELINES set,
/// the picture becomes the baseline.
///
/// Tolerance: a mean of 1 of 255, and 0.5 % of the pixels strikingly different. The CPU back end is deterministic, but
/// an edge that falls on a sample position may fall to the other side with another compiler or processor.
QString compareWithBaseline(const QImage& picture, const QString& name);

} // namespace tetra
