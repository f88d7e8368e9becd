// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/widgets/curves/copying.h"

#include "plugins/widgets/curves/selection.h"

#include <tan/transfer.h>

#include <cmath>

namespace tetra {
namespace {

JoinedFunction onlySelected(const JoinedFunction& function, const TransferSelection& selection)
{
    JoinedFunction copy{{}, function.unitDistance};
    for (const std::size_t i : selectionOf(function, selection))
        copy.points.push_back(function.points[i]);
    return copy;
}

EditedSelection withCopies(const JoinedFunction& function, JoinedFunction copies, double by,
                           const TransferLimits& limits)
{
    for (TransferPoint& point : copies.points) {
        point.value += by;
        if (!std::isfinite(point.value))
            return {function, {}};
        if (copies.unitDistance != function.unitDistance)
            point.opacity = static_cast<float>(
                -std::expm1(-extinctionOf(point.opacity, copies.unitDistance) * function.unitDistance));
    }
    return withMorePoints(function, std::move(copies.points), limits);
}

} // namespace

std::string copyOfSelected(const JoinedFunction& function, const TransferSelection& selection)
{
    return transferFunctionToText(separated(onlySelected(function, selection)));
}

Result<EditedSelection> pasted(const JoinedFunction& function, std::string_view text, std::optional<double> at,
                               const TransferLimits& limits)
{
    const Result<TransferFunction> copied = transferFunctionFromText(text);
    if (!copied)
        return copied.error();
    JoinedFunction copies = joined(*copied);
    const double by = at && !copies.points.empty() ? *at - copies.points.front().value : 0;
    return withCopies(function, std::move(copies), by, limits);
}

EditedSelection duplicated(const JoinedFunction& function, const TransferSelection& selection, double farther,
                           const TransferLimits& limits)
{
    return withCopies(function, onlySelected(function, selection), farther, limits);
}

} // namespace tetra
