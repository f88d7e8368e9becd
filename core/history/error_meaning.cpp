// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/history/error_meaning.h"

#include "core/history/build_facts.h"

namespace tetra {

ErrorMeaning errorMeaning(const ModelDescription& model)
{
    if (model.domain != DomainClass::Curvilinear)
        return ErrorMeaning::Only;
    return buildFacts(model).claimsInSpace ? ErrorMeaning::InSpace : ErrorMeaning::InGrid;
}

ErrorMeaning errorMeaning(const ModelDescription& model, const MeshQuery& query)
{
    const bool isUniform = query.range || (query.error.isConstant() && query.warping.isConstant());
    const ErrorMeaning kept = errorMeaning(model);
    return kept == ErrorMeaning::InSpace && !isUniform ? ErrorMeaning::InGrid : kept;
}

} // namespace tetra
