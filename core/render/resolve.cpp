// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/resolve.h"

#include <tan/render.h>

#include <algorithm>

namespace tetra {
namespace {

std::uint8_t toByte(float channel)
{
    return static_cast<std::uint8_t>(std::clamp(channel, 0.0f, 1.0f) * 255 + 0.5f);
}

std::array<std::uint8_t, 4> straightBytes(const std::array<float, 4>& premultiplied)
{
    const float alpha = premultiplied[3];
    if (!(alpha > 0))
        return {0, 0, 0, 0};
    return {toByte(premultiplied[0] / alpha), toByte(premultiplied[1] / alpha), toByte(premultiplied[2] / alpha),
            toByte(alpha)};
}

} // namespace

void resolve(std::span<const std::array<float, 4>> samples, int rowLength, int samplesPerAxis, int left, int top,
             Picture& picture)
{
    const auto length = static_cast<std::size_t>(rowLength);
    const auto axis = static_cast<std::size_t>(samplesPerAxis);
    const std::size_t columns = length / axis;
    const std::size_t rows = samples.size() / length / axis;
    const float share = 1.0f / static_cast<float>(samplesPerAxis * samplesPerAxis);
    for (std::size_t row = 0; row < rows; ++row) {
        const std::size_t pictureRow = static_cast<std::size_t>(top) + row;
        auto* pixel =
            &picture.pixels[pictureRow * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(left)];
        for (std::size_t column = 0; column < columns; ++column) {
            std::array<float, 4> sum{};
            for (std::size_t y = row * axis; y < (row + 1) * axis; ++y)
                for (std::size_t x = column * axis; x < (column + 1) * axis; ++x)
                    for (std::size_t channel = 0; channel < sum.size(); ++channel)
                        sum[channel] += samples[y * length + x][channel];
            for (float& channel : sum)
                channel *= share;
            *pixel++ = straightBytes(sum);
        }
    }
}

void resolveDepth(std::span<const float> samples, int rowLength, int samplesPerAxis, int left, int top,
                  Picture& picture)
{
    const auto length = static_cast<std::size_t>(rowLength);
    const auto axis = static_cast<std::size_t>(samplesPerAxis);
    const std::size_t rows = samples.size() / length / axis;
    std::vector<float> ofPixel;
    for (std::size_t row = 0; row < rows; ++row)
        for (std::size_t column = 0; column < length / axis; ++column) {
            ofPixel.clear();
            for (std::size_t y = row * axis; y < (row + 1) * axis; ++y)
                for (std::size_t x = column * axis; x < (column + 1) * axis; ++x)
                    ofPixel.push_back(samples[y * length + x]);
            const auto middle = ofPixel.begin() + static_cast<std::ptrdiff_t>((ofPixel.size() - 1) / 2);
            std::ranges::nth_element(ofPixel, middle);
            picture.depth[(static_cast<std::size_t>(top) + row) * static_cast<std::size_t>(picture.width) +
                          static_cast<std::size_t>(left) + column] = *middle;
        }
}

namespace {

/// Copies `height` rows of `width` pixels.
template <class Value> void copyRows(const std::vector<Value>& from, int fromWidth, int fromLeft, int fromTop,
                                     int width, int height, std::vector<Value>& to, int toWidth, int toLeft, int toTop)
{
    if (from.empty() || to.empty())
        return;
    const auto place = [](int row, int length, int column) {
        return static_cast<std::ptrdiff_t>(row) * length + column;
    };
    for (int row = 0; row < height; ++row)
        std::copy_n(from.begin() + place(fromTop + row, fromWidth, fromLeft), width,
                    to.begin() + place(toTop + row, toWidth, toLeft));
}

} // namespace

Picture cutOut(Picture picture, const PixelRectangle& part)
{
    if (part.width == picture.width && part.height == picture.height)
        return picture;
    const auto pixels = static_cast<std::size_t>(part.width) * static_cast<std::size_t>(part.height);
    Picture cut{part.width, part.height, {}};
    cut.pixels.resize(pixels);
    cut.depth.resize(picture.depth.empty() ? 0 : pixels);
    copyRows(picture.pixels, picture.width, part.left, part.top, part.width, part.height, cut.pixels, cut.width, 0, 0);
    copyRows(picture.depth, picture.width, part.left, part.top, part.width, part.height, cut.depth, cut.width, 0, 0);
    return cut;
}

void putInto(const Picture& part, int left, int top, Picture& picture)
{
    copyRows(part.pixels, part.width, 0, 0, part.width, part.height, picture.pixels, picture.width, left, top);
    copyRows(part.depth, part.width, 0, 0, part.width, part.height, picture.depth, picture.width, left, top);
}

} // namespace tetra
