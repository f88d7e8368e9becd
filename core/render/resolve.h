// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/render.h>

#include <array>
#include <span>

namespace tetra {

/// Makes pixels of a rectangle of samples: each the mean of samplesPerAxis squared samples, from premultiplied to
/// straight alpha, rounded to 8 bits. `samples` has rows of `rowLength`, its upper left pixel is (left, top) of
/// `picture`; both sides of the rectangle are multiples of samplesPerAxis.
void resolve(std::span<const std::array<float, 4>> samples, int rowLength, int samplesPerAxis, int left, int top,
             Picture& picture);

/// The same for depths of Picture: each pixel gets the least by which at least half of its samples have lost half of
/// their light.
void resolveDepth(std::span<const float> samples, int rowLength, int samplesPerAxis, int left, int top,
                  Picture& picture);

/// The pixels of a part of a picture.
Picture cutOut(Picture picture, const PixelRectangle& part);
/// Puts a picture into its place in a larger one.
void putInto(const Picture& part, int left, int top, Picture& picture);

} // namespace tetra
