// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/session.h"

#include <random>

namespace tetra {

/// What undo and redo have to bring back.
struct Seen {
    QueryState query;
    Look look;
    std::vector<Isovalue> isovalues;
    bool operator==(const Seen&) const = default;
};

Seen seen(const Session& session);

/// Edits a session as somebody would who tries everything: each setter, all edits of transfer functions, drags of many
/// edits, numbers that make no sense. The same seed makes the same edits.
class RandomEdits {
public:
    /// `modes`: ids of renderers.
    RandomEdits(Session& session, std::vector<std::string> modes, unsigned seed);

    /// One call of a setter; or the beginning or the end of a drag.
    void editOnce();
    /// Ends a drag that is going on.
    void finish();

private:
    double number(double least, double largest);
    /// In the range of the values, mostly.
    double value();
    std::size_t below(std::size_t count) { return random_() % count; }
    void editTransfer();
    void editQuery();
    void editLook();
    void editIsovalues();
    void dragOrNot();
    FocusState anyFocus();
    WindowState anyWindow();

    Session& session_;
    std::vector<std::string> modes_;
    std::mt19937 random_;
};

} // namespace tetra
