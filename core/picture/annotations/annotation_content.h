// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/picture/annotations/annotation_language.h"
#include "core/picture/drawing/fonts.h"

#include <tan/data.h>
#include <tan/model.h>
#include <tan/parameter.h>
#include <tan/render.h>
#include <tan/transfer.h>
#include <tan/view.h>

#include <Eigen/Geometry>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tetra {

/// What the annotations of a picture say: a value, painted in any thread. Texts are UTF-8, in the language of who reads
/// the picture.
struct AnnotationContent {
    AnnotationState state{};
    ValueRange range{};                               ///< of the data: that of the colour bar, if it has no other ends
    std::optional<TransferFunction> transfer{};       ///< none where the picture does not follow one
    std::string transferParameter{};                  ///< id of the renderer's parameter that it is
    std::optional<std::vector<Isovalue>> isovalues{}; ///< that are seen; none where the picture has no surfaces
    /// The values are logarithms to base 10: the bar's axis tells what they are of, and `field` names that.
    bool logarithms = false;
    std::string field{};       ///< name of the values, unless the state has another one
    std::string unit{};        ///< of the values, unless the state has another one; empty if it is not known
    std::string space{};       ///< ModelDescription::space: the letters of the axes, if there are three
    std::string lengthUnit{};  ///< ModelDescription::lengthUnit; empty if it is not known
    Eigen::AlignedBox3d box{}; ///< of all points of the data; empty: there is nothing to put axes along
    std::string title{};       ///< unless the state has another one
    std::string accuracy{};    ///< empty if nothing is known
    Camera camera{};
    Colour background{};                  ///< the ink is dark or light after it
    AnnotationLanguage language{};        ///< of the words and numbers that are none of the texts above
    std::shared_ptr<const Fonts> fonts{}; ///< null: the system's sans-serif, opened for each picture anew
};

/// What the values of a model and their unit are called at a colour bar, and the model in a title, as long as nobody
/// calls them otherwise.
std::string usualQuantity(const ModelDescription& description, const AnnotationLanguage& language);
std::string usualUnit(const ModelDescription& description);
std::string usualTitle(const Model& model);

/// Of a picture of a model, seen by this view. `parameters`: those of its renderer that matter as they are set. The
/// background is that of the view if it has one. Without `fonts`.
AnnotationContent annotationContent(const Model& model, const std::vector<Parameter>& parameters, const ViewValue& view,
                                    const std::string& accuracy, const AnnotationLanguage& language);

/// The same picture's in another view, as of a film, with the accuracy of that.
AnnotationContent inView(AnnotationContent content, const ViewValue& view, const std::string& accuracy);

} // namespace tetra
