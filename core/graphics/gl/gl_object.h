// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/graphics/gl/gl_functions.h"

#include <utility>

namespace tetra {

/// An object of OpenGL that is made and deleted by functions of this shape: a buffer, a texture ... The context must be
/// current when it goes. Moves, does not copy.
class GlObject {
public:
    GlObject() = default;
    GlObject(GlFunctions::Function<GlFunctions::Names> generate,
             GlFunctions::Function<GlFunctions::ConstantNames> deleteNames)
        : deleteNames_(deleteNames)
    {
        generate(1, &name_);
    }
    GlObject(GlObject&& other) noexcept : deleteNames_(other.deleteNames_), name_(std::exchange(other.name_, 0)) {}
    GlObject& operator=(GlObject&& other) noexcept
    {
        std::swap(deleteNames_, other.deleteNames_);
        std::swap(name_, other.name_);
        return *this;
    }
    ~GlObject()
    {
        if (name_ != 0)
            deleteNames_(1, &name_);
    }

    unsigned name() const noexcept { return name_; }

private:
    GlFunctions::Function<GlFunctions::ConstantNames> deleteNames_ = nullptr;
    unsigned name_ = 0;
};

} // namespace tetra
