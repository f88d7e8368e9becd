// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/transfer.h>

#include <optional>

namespace tetra {

/// The values of what there is to see beside a background, as objectOutline() takes it: those on the surface's side of
/// `surface`, and those that are opaque in the function that volumes have at first, some way off the background.
class TAN_INTERNAL ObjectValues {
public:
    ObjectValues(const ValueHistogram& volumes, std::optional<double> surface);

    /// Whether there is a background; without one everything is of interest, and has() is true of all values.
    bool isBesideBackground() const noexcept { return background_.has_value(); }
    bool has(double value) const;
    /// Whether all values beyond the isovalue, away from the background, are of the object.
    bool hasAllBeyond(double isovalue) const;
    /// Whether what is opaque in a function, and more so than in that which volumes have at first, is of the object.
    bool hasAllSeenOf(const TransferFunction& function) const;

private:
    std::optional<BackgroundValues> background_;
    std::optional<double> surface_;
    double least_ = 0;
    double largest_ = 0;
    double beside_ = 0; ///< the background
    TransferFunction function_;
    double most_ = 0; ///< its largest extinction
};

} // namespace tetra
