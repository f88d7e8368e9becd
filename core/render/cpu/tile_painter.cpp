// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/cpu/tile_painter.h"

#include "core/render/focus_weight.h"
#include "core/render/shading.h"
#include "core/render/volume/cell_setup.h"

#include <tan/render.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace tetra {
namespace {

/// One side of a triangle as an affine function of the sample, positive inside.
struct TriangleSide {
    std::int64_t value = 0; ///< at the first sample
    std::int64_t perX = 0;
    std::int64_t perY = 0;
    std::int64_t bias = 0; ///< 0 if samples exactly on the side belong to the triangle, else -1

    /// Directed from `a` to `b`; `x` and `y` in the vertices' steps. A sample on the side belongs to the triangle that
    /// it would belong to after an infinitely small shift to the right and a still smaller one down: of the triangles
    /// that share the side, or a corner, exactly one.
    TriangleSide(const ScreenVertex& a, const ScreenVertex& b, std::int64_t x, std::int64_t y)
    {
        const std::int64_t dx = std::int64_t(b.x) - a.x;
        const std::int64_t dy = std::int64_t(b.y) - a.y;
        value = dx * (y - a.y) - dy * (x - a.x);
        perX = -dy * subsampleSteps;
        perY = dx * subsampleSteps;
        bias = dy < 0 || (dy == 0 && dx > 0) ? 0 : -1;
    }
};

/// Calls visit(x, y, b, c) for each sample of `within` that the triangle covers; b and c are the barycentric weights of
/// its second and third corner in the picture. Either orientation; a triangle without area covers nothing. Exact for
/// coordinates up to 2^30.
template <class Visit> void rasterizeTriangle(const DrawList& list, const ScreenTriangle& triangle,
                                              const SampleRectangle& within, Visit&& visit)
{
    const SampleRectangle box = samplesUnder(list, triangle, within);
    if (box.width() <= 0 || box.height() <= 0)
        return;
    const ScreenVertex& a = list.vertices[triangle.vertices[0]];
    const ScreenVertex& b = list.vertices[triangle.vertices[1]];
    const ScreenVertex& c = list.vertices[triangle.vertices[2]];
    const std::int64_t area =
        (std::int64_t(b.x) - a.x) * (std::int64_t(c.y) - a.y) - (std::int64_t(b.y) - a.y) * (std::int64_t(c.x) - a.x);
    if (area == 0)
        return;
    const std::int64_t x0 = std::int64_t(box.left) * subsampleSteps + subsampleSteps / 2;
    const std::int64_t y0 = std::int64_t(box.top) * subsampleSteps + subsampleSteps / 2;
    // The side opposite to each corner, all turned so that inside is positive.
    TriangleSide sideA = area > 0 ? TriangleSide(b, c, x0, y0) : TriangleSide(c, b, x0, y0);
    TriangleSide sideB = area > 0 ? TriangleSide(c, a, x0, y0) : TriangleSide(a, c, x0, y0);
    TriangleSide sideC = area > 0 ? TriangleSide(a, b, x0, y0) : TriangleSide(b, a, x0, y0);
    const float scale = 1.0f / static_cast<float>(area > 0 ? area : -area);

    for (int y = box.top; y < box.bottom; ++y) {
        std::int64_t inA = sideA.value + sideA.bias;
        std::int64_t inB = sideB.value + sideB.bias;
        std::int64_t inC = sideC.value + sideC.bias;
        for (int x = box.left; x < box.right; ++x) {
            if ((inA | inB | inC) >= 0)
                visit(x, y, static_cast<float>(inB - sideB.bias) * scale, static_cast<float>(inC - sideC.bias) * scale);
            inA += sideA.perX;
            inB += sideB.perX;
            inC += sideC.perX;
        }
        sideA.value += sideA.perY;
        sideB.value += sideB.perY;
        sideC.value += sideC.perY;
    }
}

/// What shines through less than this cannot change an 8-bit channel.
constexpr float smallestTransparency = 1.0f / 4096;

/// Adds what lies behind `front`, of whose light `transparency` is let through; updates both.
void addBehind(PremultipliedColour& front, float& transparency, const PremultipliedColour& back)
{
    for (std::size_t channel = 0; channel < front.size(); ++channel)
        front[channel] += transparency * back[channel];
    transparency *= 1 - back[3];
}

/// Calls visit(sample, nearness, b, c) for each sample of the tile that the triangle covers.
template <class Visit>
void forEachCoveredSample(const DrawList& list, std::uint32_t triangle, const SampleRectangle& tile, Visit&& visit)
{
    const ScreenTriangle& corners = list.triangles[triangle];
    const float a = list.vertices[corners.vertices[0]].nearness;
    const float b = list.vertices[corners.vertices[1]].nearness - a;
    const float c = list.vertices[corners.vertices[2]].nearness - a;
    rasterizeTriangle(list, corners, tile, [&](int x, int y, float weightB, float weightC) {
        const std::size_t sample = static_cast<std::size_t>(y - tile.top) * static_cast<std::size_t>(tile.width()) +
                                   static_cast<std::size_t>(x - tile.left);
        visit(sample, a + weightB * b + weightC * c, weightB, weightC);
    });
}

} // namespace

void TilePainter::clear(const SampleRectangle& tile)
{
    tile_ = tile;
    const auto samples = static_cast<std::size_t>(tile.width()) * static_cast<std::size_t>(tile.height());
    opaque_.assign(samples, {-std::numeric_limits<float>::infinity(), none, 0, 0});
    heads_.assign(samples, none);
    listed_.clear();
    fragmentCount_ = 0;
    shown_.clear();
    if (!clips_.empty())
        for (int row = tile.top; row < tile.bottom; ++row)
            for (int column = tile.left; column < tile.right; ++column)
                shown_.push_back(clips_.at(column, row));
}

bool TilePainter::shows(std::size_t sample, float nearness, bool clipped) const
{
    const bool inside = !clipped || (nearness <= shown_[sample].front && nearness >= shown_[sample].back);
    return nearness > opaque_[sample].nearness && inside;
}

void TilePainter::drawOpaque(std::uint32_t triangle)
{
    const bool clipped = !shown_.empty() && list_.looks[list_.triangles[triangle].look].clipped;
    forEachCoveredSample(list_, triangle, tile_, [&](std::size_t sample, float nearness, float b, float c) {
        if (!shows(sample, nearness, clipped))
            return;
        opaque_[sample] = {nearness, triangle, b, c};
        ++fragmentCount_;
    });
}

void TilePainter::collectTranslucent(std::uint32_t triangle)
{
    const bool clipped = !shown_.empty() && list_.looks[list_.triangles[triangle].look].clipped;
    forEachCoveredSample(list_, triangle, tile_, [&](std::size_t sample, float nearness, float b, float c) {
        if (!shows(sample, nearness, clipped))
            return;
        const auto place = static_cast<std::uint32_t>(listed_.size());
        listed_.push_back({{nearness, triangle, b, c}, heads_[sample]});
        heads_[sample] = place;
    });
}

/// Of a fragment whose vertices have colours.
Colour TilePainter::ownColour(const Fragment& fragment) const
{
    const ScreenTriangle& triangle = list_.triangles[fragment.triangle];
    const std::array<float, 3> shares = {1 - fragment.b - fragment.c, fragment.b, fragment.c};
    Colour sum;
    float whole = 0;
    for (std::size_t corner = 0; corner < shares.size(); ++corner) {
        const std::uint32_t vertex = triangle.vertices[corner];
        const float share = shares[corner] * list_.vertices[vertex].weight;
        sum.red += share * list_.colours[vertex].red;
        sum.green += share * list_.colours[vertex].green;
        sum.blue += share * list_.colours[vertex].blue;
        whole += share;
    }
    return {sum.red / whole, sum.green / whole, sum.blue / whole};
}

/// In the dataset.
Eigen::Vector3d TilePainter::placeOf(const Fragment& fragment, std::size_t sample) const
{
    const auto width = static_cast<std::size_t>(tile_.width());
    const double x = tile_.left + static_cast<int>(sample % width) + view_.firstX();
    const double y = tile_.top + static_cast<int>(sample / width) + view_.firstY();
    const double w = view_.perspective ? 1.0 / fragment.nearness : -fragment.nearness;
    const Eigen::Vector3d image = view_.perspective ? Eigen::Vector3d(x * w, y * w, w) : Eigen::Vector3d(x, y, w);
    return worldFromImage_ * (image - view_.imageFromWorld.col(3));
}

namespace {

/// `normal` and `towardsEye` of any length.
Falling<float> surfaceLight(const Eigen::Matrix3f& cameraFromWorld, const Eigen::Vector3f& normal,
                            const Eigen::Vector3f& towardsEye)
{
    const float along = normal.dot(towardsEye);
    const float length = normal.norm();
    const float lengths = length * towardsEye.norm();
    if (!(lengths > 0))
        return lightOn<float>(0, 0, 1, 1);
    const Eigen::Vector3f towards = cameraFromWorld * normal * (along < 0 ? -1 / length : 1 / length);
    return lightOn(towards.x(), towards.y(), towards.z(), std::min(1.0f, std::abs(along) / lengths));
}

} // namespace

PremultipliedColour TilePainter::lit(const Fragment& fragment, std::size_t sample) const
{
    const ScreenTriangle& triangle = list_.triangles[fragment.triangle];
    const SurfaceLook& look = list_.looks[triangle.look];
    Colour colour = look.coloured ? ownColour(fragment) : look.colour;
    if (look.lit) {
        const ScreenVertex& a = list_.vertices[triangle.vertices[0]];
        const ScreenVertex& b = list_.vertices[triangle.vertices[1]];
        const ScreenVertex& c = list_.vertices[triangle.vertices[2]];
        const Eigen::Vector3f normal = (1 - fragment.b - fragment.c) * a.weight * a.normal +
                                       fragment.b * b.weight * b.normal + fragment.c * c.weight * c.normal;
        const auto width = static_cast<std::size_t>(tile_.width());
        const float x = static_cast<float>(part_.left + tile_.left + static_cast<int>(sample % width)) + 0.5f;
        const float y = static_cast<float>(part_.top + tile_.top + static_cast<int>(sample / width)) + 0.5f;
        const Eigen::Vector3f towardsEye =
            transform_.towardsEye + x * transform_.towardsEyePerX + y * transform_.towardsEyePerY;
        colour = shaded(colour, surfaceLight(transform_.cameraFromWorld, normal, towardsEye));
    }
    const float opacity =
        look.share == nullptr ? look.opacity : opacityAt(look.opacity, look.share, placeOf(fragment, sample));
    return {colour.red * opacity, colour.green * opacity, colour.blue * opacity, opacity};
}

void TilePainter::sortTranslucent(std::size_t sample)
{
    sorted_.clear();
    for (std::uint32_t place = heads_[sample]; place != none; place = listed_[place].next)
        sorted_.push_back(listed_[place].fragment);
    std::ranges::sort(sorted_, [](const Fragment& one, const Fragment& other) {
        return one.nearness != other.nearness ? one.nearness > other.nearness : one.triangle < other.triangle;
    });
}

template <class Visit> void TilePainter::forEachLit(std::size_t sample, Visit&& visit)
{
    sortTranslucent(sample);
    float transparency = 1;
    for (const Fragment& fragment : sorted_) {
        const PremultipliedColour colour = lit(fragment, sample);
        if (!(colour[3] > 0))
            continue; // another one has all of the place
        visit(fragment.nearness, colour);
        transparency *= 1 - colour[3];
        if (transparency < smallestTransparency)
            break;
    }
    const Fragment& last = opaque_[sample];
    if (last.triangle != none)
        visit(last.nearness, lit(last, sample));
}

void TilePainter::draw(const SampleRectangle& tile, std::span<const std::uint32_t> triangles)
{
    clear(tile);
    const auto isOpaque = [&](std::uint32_t triangle) {
        return list_.looks[list_.triangles[triangle].look].isOpaque();
    };
    for (const std::uint32_t triangle : triangles)
        if (isOpaque(triangle))
            drawOpaque(triangle);
    for (const std::uint32_t triangle : triangles)
        if (!isOpaque(triangle))
            collectTranslucent(triangle);
    fragmentCount_ += listed_.size();
}

std::span<const PremultipliedColour> TilePainter::colours(const PremultipliedColour& background)
{
    colours_.assign(opaque_.size(), {});
    halfNearness_.assign(opaque_.size(), neverHalf);
    for (std::size_t sample = 0; sample < colours_.size(); ++sample) {
        float transparency = 1;
        forEachLit(sample, [&](float nearness, const PremultipliedColour& colour) {
            const bool before = transparency > 0.5f;
            addBehind(colours_[sample], transparency, colour);
            if (before && transparency <= 0.5f)
                halfNearness_[sample] = nearness;
        });
        addBehind(colours_[sample], transparency, background);
    }
    return colours_;
}

const SurfaceFragments& TilePainter::fragments()
{
    fragments_.fragments.clear();
    fragments_.first.clear();
    for (std::size_t sample = 0; sample < opaque_.size(); ++sample) {
        fragments_.first.push_back(static_cast<std::uint32_t>(fragments_.fragments.size()));
        forEachLit(sample, [&](float nearness, const PremultipliedColour& colour) {
            fragments_.fragments.push_back({nearness, colour});
        });
        fragments_.fragments.push_back({-farBound, {}});
    }
    fragments_.empty = fragments_.fragments.size() == opaque_.size();
    return fragments_;
}

} // namespace tetra
