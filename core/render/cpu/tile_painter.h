// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/render/cpu/draw_list.h"
#include "core/render/cpu/tile_bins.h"
#include "core/render/tiles.h"
#include "core/render/view_transform.h"
#include "core/render/volume/clip_bounds.h"
#include "core/render/volume/volume_view.h"

#include <Eigen/LU>

#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// Draws the triangles of one tile: opaque ones into a depth buffer, translucent ones as fragments that are sorted by
/// depth in each sample and blended exactly. Remembers which triangle each sample shows and lights it at the end, so a
/// hidden surface costs no light. Keeps its memory from tile to tile; one object a thread.
class TilePainter {
public:
    /// All but `part` must outlive it. `transform` is of the whole picture, `view` of the part that the list is of.
    TilePainter(const DrawList& list, const ViewTransform& transform, const SampleRectangle& part,
                const VolumeView& view, const ClipBounds& clips)
        : list_(list), transform_(transform), part_(part), view_(view),
          worldFromImage_(view.imageFromWorld.leftCols<3>().inverse()), clips_(clips)
    {
    }

    /// Finds what the samples of the tile show. May throw std::bad_alloc.
    void draw(const SampleRectangle& tile, std::span<const std::uint32_t> triangles);
    /// The samples that what was drawn covers, counted as often as they are covered, but for what opaque triangles
    /// hide.
    std::size_t fragmentCount() const noexcept { return fragmentCount_; }

    /// The colour of each sample of the tile, row by row, over `background`; valid until the next call. May throw
    /// std::bad_alloc.
    std::span<const PremultipliedColour> colours(const PremultipliedColour& background);
    /// For each sample q (ViewTransform) where half of the light from behind is gone; `neverHalf` where it never is.
    /// Made by colours().
    std::span<const float> halfNearness() const noexcept { return halfNearness_; }
    static constexpr float neverHalf = -1e30f;

    /// The lit fragments, to be blended with something else; valid until the next call. May throw std::bad_alloc.
    const SurfaceFragments& fragments();

private:
    /// A triangle at a sample.
    struct Fragment {
        float nearness;
        std::uint32_t triangle;
        float b; ///< weights of the triangle's second and third corner
        float c;
    };
    struct ListedFragment {
        Fragment fragment;
        std::uint32_t next;
    };
    static constexpr std::uint32_t none = 0xffffffff;

    void clear(const SampleRectangle& tile);
    Eigen::Vector3d placeOf(const Fragment& fragment, std::size_t sample) const;
    void drawOpaque(std::uint32_t triangle);
    void collectTranslucent(std::uint32_t triangle);
    bool shows(std::size_t sample, float nearness, bool clipped) const;
    Colour ownColour(const Fragment& fragment) const;
    PremultipliedColour lit(const Fragment& fragment, std::size_t sample) const;
    void sortTranslucent(std::size_t sample);
    /// Calls visit(nearness, colour) for the lit fragments of a sample, front to back, until nothing shines through.
    template <class Visit> void forEachLit(std::size_t sample, Visit&& visit);

    const DrawList& list_;
    const ViewTransform& transform_;
    SampleRectangle part_;
    const VolumeView& view_;
    Eigen::Matrix3d worldFromImage_;
    const ClipBounds& clips_;
    SampleRectangle tile_;
    std::size_t fragmentCount_ = 0;
    std::vector<ClipBounds::Interval> shown_; ///< of each sample's ray, if there are clip planes
    std::vector<Fragment> opaque_;            ///< the nearest opaque fragment of each sample
    std::vector<std::uint32_t> heads_;        ///< of each sample's list of translucent fragments
    std::vector<ListedFragment> listed_;      ///< translucent fragments of all samples
    std::vector<Fragment> sorted_;            ///< of one sample
    std::vector<PremultipliedColour> colours_;
    std::vector<float> halfNearness_;
    SurfaceFragments fragments_;
};

} // namespace tetra
