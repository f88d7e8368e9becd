// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/cells/cells_file.h"

#include "core/base/text.h"

namespace tetra {

Result<int> componentOf(const CellsRequest& request, int components)
{
    if (components == 1)
        return 0;
    if (request.component.empty() || request.component == "magnitude")
        return -1;
    const auto number = parseNumber<int>(request.component);
    if (number && *number >= 0 && *number < components)
        return *number;
    return Error{ErrorKind::WrongUsage, "'" + request.component + "' is no component of an array that has " +
                                            std::to_string(components) + ": say 'magnitude', or a number from 0 to " +
                                            std::to_string(components - 1) + "."};
}

Error unknownArray(const std::string& name, const std::vector<FileArray>& arrays)
{
    std::string names;
    for (const FileArray& array : arrays)
        names += (names.empty() ? "" : ", ") + printable(array.name);
    if (names.empty())
        return {ErrorKind::BadInput, "it has no values, of points or of cells."};
    return {ErrorKind::WrongUsage, "it has no array '" + printable(name) + "'. There are: " + names + "."};
}

} // namespace tetra
