// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/vtk/helper/provenance.h"

#include <vtkFieldData.h>

#include <algorithm>
#include <iterator>

namespace tetra {
namespace {

/// Whether the active scalars of VTK are what the file says, and not what its reader has made so.
bool marksArrays(VtkFormat format)
{
    return format == VtkFormat::Xml || format == VtkFormat::Legacy || format == VtkFormat::Hdf ||
           format == VtkFormat::Series;
}

std::string namesOf(const std::vector<VtkLeaf>& leaves, const std::vector<std::size_t>& parts)
{
    std::vector<std::string> names;
    for (const std::size_t part : parts)
        names.push_back(leaves[part].name);
    return namesToldOf(names);
}

/// Tables that belong to no point or cell. What readers of other formats keep there is their own.
void tellFieldData(vtkDataSet& data, const VtkRequest& request, std::vector<Message>& leftOut)
{
    if (!marksArrays(request.format))
        return;
    std::vector<std::string> names;
    vtkFieldData& fields = *data.GetFieldData();
    for (int number = 0; number < fields.GetNumberOfArrays(); ++number)
        if (const char* name = fields.GetArrayName(number); name != nullptr && *name != 0)
            names.emplace_back(name);
    if (!names.empty())
        leftOut.push_back(
            Message::say("Field data, which belong to no point or cell, are not read: %1.", namesToldOf(names)));
}

} // namespace

void addTaken(Taken one, Provenance& provenance)
{
    auto& taken = provenance.taken;
    if (const auto same = std::ranges::find(taken, one.part, &Taken::part); same != taken.end()) {
        same->what = Message::say("%1, %2", one.what, same->what);
        same->guessed = same->guessed || one.guessed;
        return;
    }
    taken.insert(std::ranges::upper_bound(taken, one.part, {}, &Taken::part), std::move(one));
}

std::string namesToldOf(const std::vector<std::string>& names)
{
    constexpr std::size_t most = 20;
    std::string text;
    for (std::size_t i = 0; i < std::min(most, names.size()); ++i)
        text += (text.empty() ? "" : ", ") + printable(names[i]);
    return text + (names.size() > most ? " ..." : "");
}

void tellArray(const std::vector<VtkArray>& all, const VtkArray& chosen, const VtkRequest& request,
               Provenance& provenance)
{
    const auto offered = std::ranges::count(all, chosen.isHelping, &VtkArray::isHelping);
    const bool isAsked = !request.array.empty() && request.array != "automatic";
    const bool isMarked = chosen.active && marksArrays(request.format);
    if (!chosen.isUnnamed || offered > 1)
        addTaken({TakenPart::Array, printable(chosen.name), !isAsked && !isMarked && offered > 1}, provenance);
    if (chosen.components > 1)
        addTaken({TakenPart::Component,
                  request.component.empty() || request.component == "magnitude" ? Message(Message::marked("magnitude"))
                                                                                : Message(request.component),
                  request.component.empty()},
                 provenance);
}

void tellParts(const std::vector<VtkLeaf>& leaves, const VtkSelection& selection, Provenance& provenance)
{
    std::vector<std::size_t> others;
    for (std::size_t part = 0; part < leaves.size(); ++part)
        if (std::ranges::find(selection.parts, part) == selection.parts.end() &&
            std::ranges::find(selection.partsWithoutArray, part) == selection.partsWithoutArray.end())
            others.push_back(part);
    if (others.empty() && selection.partsWithoutArray.empty())
        return;
    addTaken({TakenPart::Block, namesOf(leaves, selection.parts), selection.isGuess}, provenance);
    const std::string array = printable(selection.array.name);
    if (const auto& without = selection.partsWithoutArray; without.size() == 1)
        provenance.leftOut.push_back(
            Message::say("1 other part has no '%1' and is not read: %2.", array, namesOf(leaves, without)));
    else if (!without.empty())
        provenance.leftOut.push_back(Message::say("%1 other parts have no '%2' and are not read: %3.", without.size(),
                                                  array, namesOf(leaves, without)));
    if (others.size() == 1)
        provenance.leftOut.push_back(Message::say("1 other part is not read: %1.", namesOf(leaves, others)));
    else if (!others.empty())
        provenance.leftOut.push_back(
            Message::say("%1 other parts are not read: %2.", others.size(), namesOf(leaves, others)));
}

void tellTimeStep(std::span<const double> times, const VtkRequest& request, const std::string& file,
                  Provenance& provenance)
{
    const auto step = static_cast<std::size_t>(std::max<std::int64_t>(1, request.timeStep));
    if (times.size() < 2 || step > times.size())
        return;
    const std::string time = formatNumber(times[step - 1]);
    addTaken({TakenPart::TimeStep,
              file.empty() ? Message::say("%1 of %2, time %3", step, times.size(), time)
                           : Message::say("%1 of %2, time %3, file '%4'", step, times.size(), time, printable(file)),
              request.timeStep == 0},
             provenance);
}

Provenance provenanceOf(const std::vector<VtkLeaf>& leaves, const VtkSelection& selection, const VtkRequest& request)
{
    Provenance provenance;
    const VtkLeaf& first = leaves[selection.parts.front()];
    tellArray(arraysOf(*first.data), selection.array, request, provenance);
    tellParts(leaves, selection, provenance);
    for (const std::size_t part : selection.parts) {
        std::vector<Message> told = arraysOfOtherLength(*leaves[part].data);
        tellFieldData(*leaves[part].data, request, told);
        for (Message& message : told) // parts of one file often say the same
            if (std::ranges::find(provenance.leftOut, message) == provenance.leftOut.end())
                provenance.leftOut.push_back(std::move(message));
    }
    return provenance;
}

} // namespace tetra
