// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/boundary_maker.h"

#include "core/graphics/boundary_extraction.h"
#include "core/graphics/value_colours.h"

#include <new>

namespace tetra {

Result<Surface> BoundaryMaker::plain(const BoundaryLook& look, const Progress& progress)
{
    if (!(look.opacity > 0 && look.opacity <= 1))
        return Error{ErrorKind::WrongUsage, "The boundary's opacity must be above 0 and at most 1."};
    if (!boundary_) {
        auto boundary = extractBoundary(*mesh_, usualFeatureAngle, progress);
        if (!boundary)
            return boundary.error();
        boundary_ = std::make_shared<const TriangleMesh>(*std::move(boundary));
    }
    return Surface{boundary_, look.colour, look.opacity, look.backFacesOnly};
}

Result<Surface> BoundaryMaker::coloured(const TransferFunction& function, const BoundaryLook& look,
                                        const Progress& progress)
try {
    if (const Status usable = checkTransferFunction(function); !usable)
        return usable.error();
    auto surface = plain(look, progress);
    if (!surface)
        return surface.error();
    if (!coloured_ || function_ != function) {
        coloured_ = std::make_shared<const TriangleMesh>(colouredByValue(*boundary_, function));
        function_ = function;
    }
    surface->mesh = coloured_;
    return surface;
} catch (const std::bad_alloc&) {
    return Error{ErrorKind::OutOfResource,
                 "Not enough memory for the boundary of the mesh. Lower the accuracy of the mesh."};
}

} // namespace tetra
