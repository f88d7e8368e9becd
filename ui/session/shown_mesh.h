// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/history/error_meaning.h"

#include <tan/model.h>
#include <tan/query.h>
#include <tan/transfer.h>

#include <Eigen/Geometry>

#include <QString>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace tetra {

/// What is known of the mesh that a picture shows.
struct ShownMesh {
    MeshQuery query;            ///< that it answers
    std::uint64_t vertices = 0; ///< that are drawn, and pieces of what a window cuts
    std::uint64_t tetrahedra = 0;
    std::uint32_t wholeSites = 0; ///< before window and values, as in ExtractedMesh
    std::uint64_t wholeTetrahedra = 0;
    std::uint64_t keptSites = 0; ///< of what is drawn, as in ExtractedMesh
    std::uint64_t keptTetrahedra = 0;
    bool isBlended = false; ///< of two meshes, both are counted; the whole one is that outside the focus
    double scale = 1;       ///< as in ExtractedMesh
    ErrorMeaning errorMeaning = ErrorMeaning::Only;
    std::optional<double> errorInSpace{};   ///< the largest one, %, where it was measured beside one in the grid
    std::optional<ValueRange> logarithms{}; ///< the model's range, if its values are logarithms: errors are factors
    Eigen::AlignedBox3d bounds{};           ///< of what is drawn, if window or values leave something out; else empty
    std::shared_ptr<const ValueHistogram> histogram{}; ///< of its vertices' values, over the model's range
    /// The same of the values' natural logarithms; none if the range is not positive.
    std::shared_ptr<const ValueHistogram> logarithmicHistogram{};
};

/// The errors that the mesh keeps: "error 0.5 % in the focus, 4 % outside", in the words for which error it is, with
/// the one in space beside that in the grid where it was measured, and of logarithms with the factor that each is.
QString errorText(const ShownMesh& mesh);
/// The same as the beginning of a line, as it is written over pictures: UTF-8.
std::string accuracyText(const ShownMesh& mesh);

/// What is beside the name "Error": "in the grid; in space up to 7.3 %". Empty where there is one error only.
QString errorPlaceText(ErrorMeaning meaning, const std::optional<double>& errorInSpace);

/// What that promises, in a sentence or two, and how the error in space becomes known where it is not. Empty where
/// there is one error only.
QString errorPromiseText(ErrorMeaning meaning, bool isMeasured);

/// How many pieces the window cuts its tetrahedra into; empty if it cuts none.
QString piecesText(const ShownMesh& mesh);

/// What holds of the mesh that is shown, in a sentence or two: the errors, what limits them, and which part of it is
/// seen.
QString meshText(const ShownMesh& mesh, const Model& model);

} // namespace tetra
