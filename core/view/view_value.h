// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/view.h>

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace tetra {

/// Of other data: without what was said of these, such as their name.
TAN_INTERNAL AnnotationState ofOtherData(AnnotationState annotations);

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
    using Part = std::variant<QueryState, std::string, TransferFunction, ParameterValues, std::vector<Isovalue>,
                              AnnotationState, Animation, Camera, std::optional<Colour>, LensState, ToolValues>;
    std::vector<Part> parts_; ///< in that order
};

} // namespace tetra
