// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/data.h>
#include <tan/render.h>
#include <tan/transfer.h>
#include <tan/view.h>

#include <QFont>
#include <QString>

#include <optional>
#include <string>
#include <vector>

namespace tetra {

class Model;
struct ShownMesh;

/// What the annotations of a picture say: a value, painted in any thread.
struct AnnotationContent {
    AnnotationState state{};
    ValueRange range{};                               ///< of the data: that of the colour bar, if it has no other ends
    std::optional<TransferFunction> transfer{};       ///< none where the picture does not follow one
    std::string transferParameter{};                  ///< id of the renderer's parameter that it is
    std::optional<std::vector<Isovalue>> isovalues{}; ///< that are seen; none where the picture has no surfaces
    /// The values are logarithms to base 10: the bar's axis tells what they are of, and `field` names that.
    bool logarithms = false;
    QString field{};      ///< name of the values
    QString space{};      ///< ModelDescription::space: the letters of the axes, if there are three
    QString lengthUnit{}; ///< ModelDescription::lengthUnit; empty if it is not known
    QString title{};
    QString accuracy{}; ///< empty if nothing is known
    Camera camera{};
    Colour background{}; ///< the ink is dark or light after it
    QFont font{};        ///< the window's
};

/// Of a picture of a model, seen by this view. `parameters`: those of its renderer that matter as they are set. `mesh`:
/// that is shown; none if that is not known yet. The background is that of the view if it has one.
AnnotationContent annotationContent(const Model& model, const std::vector<Parameter>& parameters, const ViewValue& view,
                                    const ShownMesh* mesh);

/// The same picture's in another view, as of a film; the accuracy is that of `mesh`.
AnnotationContent inView(AnnotationContent content, const ViewValue& view, const ShownMesh& mesh);

} // namespace tetra
