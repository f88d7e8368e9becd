// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/model.h>
#include <tan/render.h>
#include <tan/view.h>

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace tetra {

/// Of other data: without what was said of these, such as their name.
TAN_INTERNAL AnnotationState ofOtherData(AnnotationState annotations);

/// The direction that data are seen from at first. Images that say nothing of their place in the world, with steps of 1
/// from 0, are seen as they are made, slice by slice, the first axis to the right and the second one up, and a little
/// turned; what is flat along z from higher up.
TAN_INTERNAL Camera usualCamera(const ModelDescription& description);

/// How many times as far as where the box just fits the eye is, so that the axes with numbers find room around it: in a
/// picture as high as most, a margin of two lines. 1 without them.
inline double roomAroundBox(const AnnotationState& annotations)
{
    constexpr double shareOfMargins = 0.16, mostShare = 0.6;
    if (!annotations[AnnotationKind::BoxAxes].shown)
        return 1;
    return 1 / (1 - std::min(mostShare, shareOfMargins * annotations.textSize / usualTextSize));
}

/// The view's camera fitted to the box of all data, with room for what stands around it.
inline Camera fittedToBox(const ViewValue& view, const Eigen::AlignedBox3d& box, double aspectRatio)
{
    return zoomed(fitted(view.camera, box, aspectRatio), roomAroundBox(view.annotations));
}

/// The view's camera fitted to what there is to see, if it is known where that is (FieldExtent::object); else to the
/// box of all data, and so if that has axes.
inline Camera framed(const ViewValue& view, const Eigen::AlignedBox3d& box, std::span<const Eigen::Vector3d> object,
                     double aspectRatio)
{
    if (object.empty() || view.annotations[AnnotationKind::BoxAxes].shown)
        return fittedToBox(view, box, aspectRatio);
    return fitted(view.camera, object, aspectRatio);
}

/// Some parts of a view, and no more: what a long history of edits keeps of each.
class TAN_INTERNAL PartialView {
public:
    PartialView(const ViewValue& view, ViewParts parts);
    ViewValue putInto(ViewValue view) const;
    ViewParts parts() const;
    /// Adds the parts of `others` that it lacks.
    void complete(const PartialView& others);
    bool operator==(const PartialView&) const = default;

private:
    /// Each part is of a type of its own, in the order of ViewPart.
    using Part =
        std::variant<QueryState, std::string, TransferFunction, ParameterValues, std::vector<Isovalue>, AnnotationState,
                     Animation, Camera, std::optional<Colour>, LensState, ToolValues, std::vector<Bookmark>>;
    std::vector<Part> parts_; ///< in that order
};

} // namespace tetra
