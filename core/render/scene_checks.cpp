// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/scene_checks.h"

#include <tan/render.h>

#include <algorithm>

namespace tetra {

Status checkMesh(const TriangleMesh& mesh)
{
    if (mesh.normals.size() != mesh.positions.size())
        return Error{ErrorKind::WrongUsage,
                     Message::say("A surface of the scene does not have one normal for each vertex.")};
    const auto fits = [&](std::size_t count) { return count == 0 || count == mesh.positions.size(); };
    if (!fits(mesh.values.size()) || !fits(mesh.colours.size()))
        return Error{ErrorKind::WrongUsage,
                     Message::say("A surface of the scene does not have one value or colour for each vertex.")};
    for (const auto& triangle : mesh.triangles)
        if (std::ranges::max(triangle) >= mesh.positions.size())
            return Error{ErrorKind::WrongUsage,
                         Message::say("A triangle of the scene has a corner that does not exist.")};
    return {};
}

Status checkLines(const LineSet& lines)
{
    for (const auto& segment : lines.segments)
        if (std::ranges::max(segment) >= lines.points.size())
            return Error{ErrorKind::WrongUsage, Message::say("A line of the scene has an end that does not exist.")};
    return {};
}

Status checkOptions(const PictureOptions& options)
{
    if (std::min(options.width, options.height) < 1 || std::max(options.width, options.height) > largestPictureSide)
        return Error{ErrorKind::WrongUsage,
                     Message::say("A picture cannot be %1 x %2 pixels. Each side must be 1 to %3.", options.width,
                                  options.height, largestPictureSide)};
    const auto isWithin = [](int first, int count, int all) {
        return first >= 0 && count >= 1 && count <= all - first;
    };
    if (const auto& part = options.part; part && !(isWithin(part->left, part->width, options.width) &&
                                                   isWithin(part->top, part->height, options.height)))
        return Error{ErrorKind::WrongUsage, Message::say("The part of a picture to be drawn must lie within it.")};
    if (options.samplesPerAxis < 1 || options.samplesPerAxis > 4)
        return Error{ErrorKind::WrongUsage, Message::say("The samples per axis of a pixel must be 1 to 4.")};
    if (options.threads < 0)
        return Error{ErrorKind::WrongUsage, Message::say("The number of threads must not be negative; 0 means all.")};
    return {};
}

PixelRectangle drawnPart(const PictureOptions& options)
{
    return options.part.value_or(PixelRectangle{0, 0, options.width, options.height});
}

} // namespace tetra
