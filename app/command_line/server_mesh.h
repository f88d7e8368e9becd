// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/json.h"
#include "core/packed/packed_mesh.h"
#include "core/serve/served_query.h"
#include "plugins/api/written_content.h"

#include <tan/base.h>

#include <string>
#include <string_view>

namespace tetra {

/// A mesh that `tan serve` found, and what it tells of it.
struct ServerMesh {
    UnpackedMesh content;
    JsonObject figures; ///< as meshFigures() gives them
    MeshFacts facts;    ///< as meshFacts()
    bool overlaps = false;

    /// One of the facts as text, empty if there is none of the name: "source" is that of the model's dataset.
    std::string fact(std::string_view name) const;
};

/// Asks a server for a mesh: of the model at http://HOST/NAME.tan, the one that the words ask for. Errors: those of
/// servedMesh(), and BadInput for a mesh without tetrahedra, which a server refuses.
Result<ServerMesh> meshAtServer(const std::string& model, const QueryWords& words, const std::string& token,
                                const Progress& progress = {});

/// A token: the first line of a file, of visible characters, however the line ends. Errors (WrongUsage): less than 16
/// characters or more than a server takes, and what no header can carry.
Result<std::string> tokenIn(const std::string& file);

} // namespace tetra
