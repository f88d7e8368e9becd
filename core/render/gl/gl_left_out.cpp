// SPDX-License-Identifier: GPL-3.0-or-later
// In place of this folder's other sources where the option TAN_GL is off.
#include <tan/render.h>

namespace tetra {

Result<std::unique_ptr<RenderBackend>> makeGlBackend()
{
    return Error{ErrorKind::OutOfResource,
                 Message::say("This TAn was built without OpenGL (TAN_GL). Use the CPU back end.")};
}

} // namespace tetra
