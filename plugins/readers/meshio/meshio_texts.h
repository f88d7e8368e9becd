// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <array>

namespace tetra {

/// The sentences of tan-read-meshio.py, which translators' tools do not read: each stands there as it does here.
inline constexpr std::array meshioTexts = {
    Message::marked("it refers to the file '%1', which is not in its folder. Put the files into one folder."),
    Message::marked("it names '%1', which is not a regular file. Copy its content into one first."),
    Message::marked(
        "the values of its array '%1' lie in other files or arrays, which are not opened. Copy them into an "
        "array of their own, for instance with h5py."),
    Message::marked("it holds a mesh, and no values at its points or cells. Export the results with the mesh, as .vtu "
                    "if the program can."),
    Message::marked("it has no array '%1'. Available: %2."),
    Message::marked("its array '%1' has the components 0 to %2, and no component %3."),
    Message::marked("one of its cells has a corner that is not one of its %1 points. It is damaged."),
    Message::marked("its points lie in a plane. A three-dimensional mesh is needed."),
    Message::marked("%1 of %2, time %3"),
    Message::marked("%1 cells of the kind '%2' were left out: TAn does not support them."),
    Message::marked("it has one time step, and number %1 was requested. Leave '--time' out."),
    Message::marked("it has %1 time steps, and number %2 was requested. Give one from 1 to %1."),
    Message::marked("its values '%1' refer to a node or an element %2, which it does not have."),
    Message::marked("'%1' has %2 steps; the last one is read."),
    Message::marked("Its values '%1' at the corners of elements are not read: elements that share a node may have "
                    "different ones there."),
    Message::marked("meshio, which reads such files, is not installed. Install it with 'apt install python3-meshio' "
                    "(other systems: 'pip install meshio'), or write the mesh as .vtu."),
    Message::marked("meshio needs the Python module '%1' for it. Install it with 'apt install python3-%1', or write "
                    "the mesh as .vtu."),
    Message::marked("the system says: %1. Check that the file and those that it refers to can be read."),
    Message::marked("meshio does not understand it (%1). Open it in the program that wrote it, and export it again, as "
                    ".vtu if the program can."),
};

} // namespace tetra
