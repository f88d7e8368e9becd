// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/history/error_meaning.h"
#include "core/picture/annotations/annotation_language.h"

#include <tan/base.h>
#include <tan/model.h>
#include <tan/query.h>
#include <tan/transfer.h>

#include <Eigen/Geometry>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace tetra {

/// What the volume of a picture is drawn from.
enum class ShownField {
    Mesh,
    Data,       ///< the samples of a lattice
    Difference, ///< of the pictures of both
};

/// For what the mesh is shown where data were asked for.
enum class MeshInstead { No, OfRange, OfWindow, OfValues, OfFocus };

/// What is known of the mesh that a picture shows.
struct ShownMesh {
    MeshQuery query;            ///< that it answers
    std::uint64_t vertices = 0; ///< that are drawn, and pieces of what a window cuts
    std::uint64_t tetrahedra = 0;
    std::uint32_t wholeSites = 0; ///< before window and values, as in ExtractedMesh
    std::uint64_t wholeTetrahedra = 0;
    std::uint64_t keptSites = 0; ///< of what is drawn, as in ExtractedMesh
    std::uint64_t keptTetrahedra = 0;
    ShownField shown = ShownField::Mesh; ///< what is in the picture in its place
    MeshInstead instead = MeshInstead::No;
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

/// The range of a model's values if these are logarithms to base 10 (core/data/value_scale.h); else nothing.
std::optional<ValueRange> logarithmsOf(const ModelDescription& model);

/// The factor that an error of so many percent of the range of logarithms is: "1.26", and with two digits of the
/// difference if it is hardly more than 1.
std::string factorNumber(double percent, const ValueRange& logarithms, const NumberSigns& signs);

/// "0.5 %", or of logarithms "0.5 % (a factor of 1.12)".
Message errorNumber(double percent, const std::optional<ValueRange>& logarithms, const NumberSigns& signs = {});

/// The errors that the mesh keeps: "error 0.5 % in the focus, 4 % outside", in the words for which error it is, with
/// the one in space beside that in the grid where it was measured, and of logarithms with the factor that each is.
/// Where data are seen in the place of the mesh, that; and where they were asked for and are not, why.
Message errorMessage(const ShownMesh& mesh, const NumberSigns& signs = {});

/// The same as a text that stands alone, in a language: as annotations tell it.
std::string accuracyText(const ShownMesh& mesh, const AnnotationLanguage& language = {});

} // namespace tetra
