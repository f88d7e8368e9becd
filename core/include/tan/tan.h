// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// tan/tan.h: the whole face. Programs that use a part of it build more quickly with that part's own header.
///
/// ~~~{.cpp}
/// /// How many tetrahedra show a model, from a path or an address, with an error of at most 1 %.
/// tetra::Result<std::uint64_t> sizeOfOnePercent(const std::string& place)
/// {
///     const auto found = tetra::openModel(place);
///     if (!found)
///         return found.error();
///     return tetra::meshSizeAt(*found->model, {.error = 1}).tetrahedra;
/// }
/// ~~~

#include <tan/base.h>
#include <tan/build.h>
#include <tan/data.h>
#include <tan/fwd.h>
#include <tan/mesh.h>
#include <tan/model.h>
#include <tan/open.h>
#include <tan/packed.h>
#include <tan/parameter.h>
#include <tan/picture.h>
#include <tan/query.h>
#include <tan/render.h>
#include <tan/transfer.h>
#include <tan/verify.h>
#include <tan/version.h>
#include <tan/view.h>
#include <tan/zones.h>
