// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/model.h>
#include <tan/query.h>

#include <string_view>
#include <vector>

namespace tetra {

/// Of a mesh that keeps less than was asked for, though nothing else limits it.
Message nothingFinerRemark();

/// Of a mesh with the moved boundary of irregular data: what its error does not promise of points outside.
Message movedBoundaryRemark();

/// Of a file with logarithms and with the values they are of: which array keeps what is promised between vertices.
Message logarithmsRemark(std::string_view logarithms);

/// What the numbers of a mesh do not say by themselves, for those who save it. `isMeasured`: its error was also
/// measured at the nearest place; `hasArrays`: the file that is written has the values between vertices, too.
std::vector<Message> meshRemarks(const ModelDescription& model, const MeshQuery& query, const ExtractedMesh& mesh,
                                 bool isMeasured, bool hasArrays);

} // namespace tetra
