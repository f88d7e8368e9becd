// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/datasets.h"

#include "app/command_line/plugin_options.h"
#include "app/command_line/table.h"
#include "core/base/number_text.h"
#include "plugins/host/dataset_opening.h"

#include <QJsonArray>

namespace tetra {
namespace {

/// The dataset class of all lattices (R1).
constexpr const char* regular = "regular";

} // namespace

Result<Dataset> openDatasetWithOptions(const Invocation& invocation, const std::filesystem::path& path,
                                       const Progress& progress)
{
    const auto reader = chooseReader(invocation.host, path);
    if (!reader)
        return reader.error();
    const auto parameters = reader->plugin->parameters();
    if (const Status known = checkPluginOptions(invocation.arguments, allParameters(invocation.host.readers()),
                                                parameters, "reader '" + reader->id + "' of '" + path.string() + "'");
        !known)
        return known.error();
    const auto values = pluginValues(invocation.arguments, parameters);
    if (!values)
        return values.error();
    return openDataset(invocation.host, path, *values, progress);
}

QJsonObject latticeFigures(const Lattice& lattice, SampleType type, const ValueRange& range)
{
    QJsonArray size;
    QJsonArray spacing;
    QJsonArray origin;
    for (int axis = 0; axis < 3; ++axis) {
        size.append(static_cast<qint64>(lattice.size[axis]));
        spacing.append(lattice.spacing[axis]);
        origin.append(lattice.origin[axis]);
    }
    return {{"kind", regular},
            {"points", static_cast<qint64>(lattice.pointCount())},
            {"cells", static_cast<qint64>(lattice.cellCount())},
            {"range", QJsonArray{range.minimum, range.maximum}},
            {"type", QString::fromStdString(std::string(sampleTypeName(type)))},
            {"size", size},
            {"spacing", spacing},
            {"origin", origin}};
}

std::string latticeText(const Lattice& lattice, SampleType type, const ValueRange& range)
{
    std::string text = "lattice of ";
    for (int axis = 0; axis < 3; ++axis)
        text += (axis == 0 ? "" : " x ") + std::to_string(lattice.size[axis]);
    text += " points (" + std::string(sampleTypeName(type)) + "), spacing";
    for (int axis = 0; axis < 3; ++axis)
        text += (axis == 0 ? " " : " x ") + rounded(lattice.spacing[axis]);
    return text + ", values " + formatNumber(range.minimum) + " to " + formatNumber(range.maximum);
}

} // namespace tetra
