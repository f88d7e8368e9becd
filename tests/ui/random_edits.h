// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/session.h"

#include <random>

namespace tetra {

/// Edits a session as somebody would who tries everything: each part of the view, all edits of transfer functions,
/// drags of many edits, numbers that make no sense. The same seed makes the same edits.
class RandomEdits {
public:
    /// `modes`: ids of renderers.
    RandomEdits(Session& session, std::vector<std::string> modes, unsigned seed);

    /// One call of a setter; or the beginning or the end of a drag.
    void editOnce();
    /// One of the edits of transfer functions.
    void editTransfer();
    /// Ends a drag that is going on.
    void finish();

private:
    double number(double least, double largest);
    /// In the range of the values, mostly.
    double value();
    std::size_t below(std::size_t count) { return random_() % count; }
    void editQuery();
    void editLook();
    void editIsovalues();
    void editAnnotations();
    void editAnimation();
    void editCamera();
    void editTools();
    void editBookmarks();
    void dragOrNot();
    FocusState anyFocus();
    WindowState anyWindow();
    std::optional<Colour> anyBackground();

    Session& session_;
    std::vector<std::string> modes_;
    std::mt19937 random_;
    Gesture series_; ///< of camera moves
};

} // namespace tetra
