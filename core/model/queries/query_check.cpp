// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/queries/query_check.h"

#include "core/base/number_text.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tetra {

namespace {

Error wrong(const std::string& text)
{
    return {ErrorKind::WrongUsage, text};
}

Status checkWindow(const Box& box)
{
    constexpr std::array<const char*, 3> axes = {"x", "y", "z"};
    for (int axis = 0; axis < 3; ++axis)
        if (!(box.least[axis] <= box.largest[axis]))
            return wrong("The window's smallest " + std::string(axes[axis]) +
                         " must not be larger than its largest: " + formatNumber(box.least[axis]) + " and " +
                         formatNumber(box.largest[axis]) + " are no such pair of numbers.");
    return {};
}

Status checkField(const ErrorField& field, const std::string& name)
{
    const ValueRange bounds = field.bounds();
    if (std::isnan(bounds.minimum) || std::isnan(bounds.maximum))
        return wrong("The " + name + " that is asked for is not a number somewhere. Use numbers of percent.");
    return {};
}

} // namespace

Status checkQuery(const Model& model, const MeshQuery& query)
{
    if (const Status error = checkField(query.error, "error"); !error)
        return error;
    if (const Status warping = checkField(query.warping, "warping"); !warping)
        return warping;
    if (query.budget == 0)
        return wrong("A budget of no tetrahedra allows no mesh of '" + model.path().string() + "'.");
    for (const ValueRange& range : query.values)
        if (!(range.minimum <= range.maximum))
            return wrong("A range of values must go from a smaller number to a larger one: " +
                         formatNumber(range.minimum) + " and " + formatNumber(range.maximum) + " do not.");
    return query.window ? checkWindow(query.window->box) : Status();
}

double scaleReached(const MeshSize& size, const Accuracy& asked)
{
    const auto over = [](double reached, double wanted) {
        if (reached <= wanted || std::isnan(wanted))
            return 1.0;
        return std::max(1 + std::numeric_limits<double>::epsilon(), reached / std::max(wanted, leastScaledPercent));
    };
    return std::max(over(size.error, asked.error), over(size.warping, asked.warping));
}

} // namespace tetra
