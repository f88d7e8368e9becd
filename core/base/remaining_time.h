// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

namespace tetra {

/// Guesses how long work will still take from the fractions that it reports. Recent speed counts most, so that a slow
/// second half is noticed; a short stall moves the guess little. Knows no clock: the caller says what time it is.
class RemainingTime {
public:
    /// `fraction` in [0, 1] was reached `seconds` after the start. Calls that go back in either are ignored.
    void update(double fraction, double seconds) noexcept;

    /// Seconds left after the last update; nothing until a second has passed and something was done.
    std::optional<double> seconds() const noexcept;

private:
    double fraction_ = 0;
    double seconds_ = 0;
    double speed_ = 0;  ///< fraction a second, recent intervals weighing more
    double weight_ = 0; ///< how much of speed_ is measured; the rest is still the zero that it started from
};

} // namespace tetra
