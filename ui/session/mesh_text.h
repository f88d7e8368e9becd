// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/shown_mesh.h"

#include <tan/model.h>

#include <QString>

namespace tetra {

/// The errors that the mesh keeps: "error 0.5 % in the focus, 4 % outside".
QString errorText(const ShownMesh& mesh);

/// How many pieces the window cuts its tetrahedra into; empty if it cuts none.
QString piecesText(const ShownMesh& mesh);

/// What holds of the mesh that is shown, in a sentence or two: the errors, what limits them, and which part of it is
/// seen.
QString meshText(const ShownMesh& mesh, const Model& model);

} // namespace tetra
