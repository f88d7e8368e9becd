// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/json.h"

#include <tan/model.h>
#include <tan/query.h>

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace tetra {

// What there is to tell of a mesh that a query gave; the same at a server and at hand.

/// What a mesh was extracted from, and how, for the file that it is written into: MeshFacts of the writers. Which error
/// a number is they tell where there are two; `errorInSpace`: the largest one in %, if it was measured.
std::vector<std::pair<std::string, std::variant<double, std::string>>>
meshFacts(const Model& model, const MeshQuery& query, const ExtractedMesh& mesh,
          const std::optional<double>& errorInSpace = {});

/// Its size, what it keeps, and what it was chosen from, for programs.
JsonObject meshFigures(const Model& model, const MeshQuery& query, const ExtractedMesh& mesh);

/// An error (WrongUsage) if the mesh that the query's window and values chose from a model has no tetrahedra, which is
/// hardly what was meant.
Status checkNotEmpty(const MeshQuery& query, const Model& model, const TetrahedralMesh& mesh);

} // namespace tetra
