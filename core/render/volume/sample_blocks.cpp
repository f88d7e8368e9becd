// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/volume/sample_blocks.h"

#include "core/render/order/cell_geometry.h"
#include "core/render/volume/tile_picture.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace tetra {
namespace {

constexpr int blockColumns = volumeTileSide / blockWidth;
constexpr int blockRows = volumeTileSide / blockHeight;

/// The samples of a tile along an axis.
struct AxisSamples {
    float squares[volumeTileSide]; ///< of the slopes of their rays
    float inside[volumeTileSide];  ///< 1 if the tile has them, else 0
};

AxisSamples axisSamples(double first, double samplesPerSlope, int count)
{
    AxisSamples samples;
    for (int i = 0; i < volumeTileSide; ++i) {
        const double slope = (first + i) / samplesPerSlope;
        samples.squares[i] = static_cast<float>(slope * slope);
        samples.inside[i] = i < count ? 1.0f : 0.0f;
    }
    return samples;
}

TETRA_SIMD_INLINE Float8 acrossBlock(const float* values)
{
    Float4 four;
    std::memcpy(&four, values, sizeof four);
    return __builtin_shufflevector(four, four, 0, 1, 2, 3, 0, 1, 2, 3);
}
TETRA_SIMD_INLINE Float8 downBlock(const float* values)
{
    return Float8{values[0], values[0], values[0], values[0], values[1], values[1], values[1], values[1]};
}

TETRA_SIMD_INLINE void fillBlocks(const AxisSamples& across, const AxisSamples& down, bool perspective,
                                  SampleBlock* blocks)
{
    for (int row = 0; row < blockRows; ++row)
        for (int column = 0; column < blockColumns; ++column) {
            SampleBlock& block = blocks[row * blockColumns + column];
            const Float8 squares =
                acrossBlock(across.squares + column * blockWidth) + downBlock(down.squares + row * blockHeight) + 1.0f;
            float lengths[blockWidth * blockHeight];
            std::memcpy(lengths, &squares, sizeof lengths);
            for (float& length : lengths)
                length = std::sqrt(length);
            block.red = block.green = block.blue = Float8{};
            block.transmittance =
                acrossBlock(across.inside + column * blockWidth) * downBlock(down.inside + row * blockHeight);
            block.depth = Float8{} + noDepth;
            std::memcpy(&block.ray, lengths, sizeof lengths);
            if (!perspective)
                block.ray = Float8{} + 1.0f;
        }
}

TETRA_SIMD_INLINE void coloursOfBlocks(const SampleBlock* blocks, const SampleRectangle& tile,
                                       PremultipliedColour* colours)
{
    for (int top = 0; top < tile.height(); top += blockHeight)
        for (int left = 0; left < tile.width(); left += blockWidth) {
            const SampleBlock& block = blocks[top / blockHeight * blockColumns + left / blockWidth];
            Float4 samples[blockWidth * blockHeight];
            transposeBack(block.red, block.green, block.blue, 1.0f - block.transmittance, samples);
            const int width = std::min(blockWidth, tile.width() - left);
            const int height = std::min(blockHeight, tile.height() - top);
            for (int y = 0; y < height; ++y)
                std::memcpy(colours + (top + y) * tile.width() + left, samples + y * blockWidth,
                            static_cast<std::size_t>(width) * sizeof *samples);
        }
}

} // namespace

void clearBlocks(const VolumeView& view, const SampleRectangle& tile, std::span<SampleBlock> blocks)
{
    const AxisSamples across = axisSamples(tile.left + view.firstX(), view.samplesPerSlope.x(), tile.width());
    const AxisSamples down = axisSamples(tile.top + view.firstY(), view.samplesPerSlope.y(), tile.height());
    dispatch<fillBlocks>(across, down, view.perspective, blocks.data());
}

void takeColours(std::span<const SampleBlock> blocks, const SampleRectangle& tile,
                 std::span<PremultipliedColour> colours)
{
    dispatch<coloursOfBlocks>(blocks.data(), tile, colours.data());
}

} // namespace tetra
