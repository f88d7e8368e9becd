// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture/shown_error.h"

#include <algorithm>

namespace tetra {
namespace {

/// % of the range where the data have this value, as it was asked for.
double askedPercentAt(const MeshQuery& query, double value)
{
    if (query.range)
        return std::max(query.range->one.error, query.range->other.error);
    const bool isOfValue = query.error.dependsOnValue() && !query.error.dependsOnPlace();
    return isOfValue ? query.error.at(Eigen::Vector3d::Zero(), value) : query.error.bounds().maximum;
}

} // namespace

double shownErrorAt(const MeshQuery& query, double scale, const ValueRange& range, double value)
{
    const double percent = keptPercent(askedPercentAt(query, value), query.range ? 1 : scale);
    return std::min(percent, anyError) / 100 * range.extent();
}

double plannedScale(const MeshQuery& query, const Model& model)
{
    if (query.range)
        return 1;
    const Accuracy asked{query.error.bounds().maximum, query.warping.bounds().maximum};
    if (!query.budget)
        return std::max(1.0, scaleReached(meshSizeAt(model, asked), asked));
    const auto size = meshSizeWithin(model, asked, *query.budget);
    return size ? std::max(1.0, scaleReached(*size, asked)) : 1;
}

FieldExtent seenWith(FieldExtent field, const MeshQuery& query, const Model& model)
{
    const double scale = plannedScale(query, model);
    const auto background = backgroundValues(field.volumes);
    field.error = 0;
    if (background)
        for (const double value : {background->least, background->commonest, background->largest})
            field.error = std::max(field.error, shownErrorAt(query, scale, field.range, value));
    return field;
}

FieldExtent seenWith(FieldExtent field, const QueryState& query, const Model& model)
{
    QueryState outside = query;
    outside.focus.shape = FocusState::Shape::None;
    return seenWith(std::move(field), meshQuery(outside, model), model);
}

std::vector<ErrorRemark> shownErrorRemarks(const FieldExtent& field, const MeshQuery& query, double scale,
                                           std::span<const double> isovalues, const TransferFunction* transfer)
{
    return errorRemarks({.range = {field.range.minimum, field.range.maximum},
                         .background = backgroundValues(field.volumes),
                         .isovalues = isovalues,
                         .transfer = transfer,
                         .errorAt = [&](double value) { return shownErrorAt(query, scale, field.range, value); }});
}

} // namespace tetra
