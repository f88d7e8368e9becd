// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/picture/shown_mesh.h"

#include <tan/model.h>

#include <QString>

#include <optional>

namespace tetra {

/// errorMessage() in the user's language.
QString errorText(const ShownMesh& mesh);

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
