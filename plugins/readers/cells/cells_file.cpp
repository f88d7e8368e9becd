// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/cells/cells_file.h"

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
    return Error{
        ErrorKind::WrongUsage,
        Message::say("'%1' is not a component of an array that has %2: give 'magnitude', or a number from 0 to %3.",
                     request.component, components, components - 1)};
}

std::string takenName(const FileArray& array, int component)
{
    if (array.components == 1)
        return array.name;
    return array.name + (component < 0 ? " (magnitude)" : " (component " + std::to_string(component) + ")");
}

std::vector<Taken> takenOf(const CellsRequest& request, const FileArray& array, int component, bool isGuess)
{
    std::vector<Taken> taken;
    if (!array.name.empty())
        taken.push_back({TakenPart::Array, Message(printable(array.name)), request.array.empty() && isGuess});
    if (array.components > 1)
        taken.push_back({TakenPart::Component,
                         component < 0 ? Message(Message::marked("magnitude")) : Message(std::to_string(component)),
                         request.component.empty()});
    if (!array.unit.empty())
        taken.push_back({TakenPart::Unit, Message(printable(array.unit)), false});
    return taken;
}

Error unknownArray(const std::string& name, const std::vector<FileArray>& arrays)
{
    std::string names;
    for (const FileArray& array : arrays)
        names += (names.empty() ? "" : ", ") + printable(array.name);
    if (names.empty())
        return {ErrorKind::BadInput, Message::say("it has no values, of points or of cells. Write it with some.")};
    return {ErrorKind::WrongUsage, Message::say("it has no array '%1'. Available: %2.", printable(name), names)};
}

} // namespace tetra
