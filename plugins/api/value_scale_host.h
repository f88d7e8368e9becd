// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace tetra {

/// What the window that is an EditorHost is besides: an editor asks it by dynamic_cast, and a host that is none has
/// values as they are.
class ValueScaleHost {
public:
    virtual ~ValueScaleHost() = default;
    /// Whether the model's values are logarithms to base 10. All values that the host gives and takes are these;
    /// people read and type what they are the logarithms of.
    virtual bool holdsLogarithms() const = 0;
};

} // namespace tetra
