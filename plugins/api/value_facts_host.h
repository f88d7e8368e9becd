// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/data.h>

#include <string>

namespace tetra {

/// What the data say of their values besides the range.
struct ValueFacts {
    std::string unit{}; ///< empty: they do not say
    SampleType sampleType = SampleType::Float32;
};

/// What the window that is an EditorHost is besides, as ValueScaleHost: an editor asks it by dynamic_cast.
class ValueFactsHost {
public:
    virtual ~ValueFactsHost() = default;
    /// Of the model.
    virtual ValueFacts valueFacts() const = 0;
    /// Whether the present rendering mode shows the isovalues' surfaces.
    virtual bool showsIsovalues() const = 0;
};

} // namespace tetra
