// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture/mesh_remarks.h"

#include "core/data/value_scale.h"
#include "plugins/host/value_arrays.h"

namespace tetra {

Message nothingFinerRemark()
{
    return Message::say("The model has no finer mesh than this, which keeps less than requested.");
}

Message movedBoundaryRemark()
{
    return Message::say("Points that the moved boundary leaves outside the mesh are compared with a place within the "
                        "warping; at the nearest place they may be off by more, which 'tan verify' measures.");
}

Message logarithmsRemark(std::string_view logarithms)
{
    return Message::say("Between vertices interpolate '%1', and take the power of ten afterwards: the factor holds for "
                        "that. '%2', interpolated itself, may be off by much more.",
                        valueArrayName(logarithms), valueArrayName(nameOfLogarithms(logarithms)));
}

std::vector<Message> meshRemarks(const ModelDescription& model, const MeshQuery& query, const ExtractedMesh& mesh,
                                 bool isMeasured, bool hasArrays)
{
    std::vector<Message> remarks;
    if (mesh.scale > 1 && !query.budget && !query.range)
        remarks.push_back(nothingFinerRemark());
    const bool boundaryMoves = model.warpingWeight > 0 && model.domain != DomainClass::Curvilinear;
    if (boundaryMoves && mesh.reached && mesh.reached->warping > 0 && !isMeasured)
        remarks.push_back(movedBoundaryRemark());
    if (hasArrays && holdsLogarithms(model.parameters))
        remarks.push_back(logarithmsRemark(model.valueName));
    return remarks;
}

} // namespace tetra
