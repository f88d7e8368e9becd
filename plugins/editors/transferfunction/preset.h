// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/transfer.h>

#include <QIcon>
#include <QString>

#include <functional>
#include <vector>

namespace tetra {

/// A transfer function to begin with, or the colours of one.
struct Preset {
    QString id;     ///< stable: "preset.sequential", "colours.viridis"; of the user's own ones the file's name
    QString name;   ///< for people
    QString source; ///< whose it is, and the licence; empty if it is ours
    /// For these values, with this unit distance.
    std::function<TransferFunction(const TransferLimits& range, double unitDistance)> make;
    bool hasOpacities = true;
    bool isOwn = false; ///< the user has saved it, and may delete it
    /// In diagonals of the domain; none: the unit distance stays.
    std::optional<double> unitDistance{};
};

enum class PresetPart { Both, Colours, Opacities };

/// Those that come with the program: two functions, and the colour maps of core/transfer.
std::vector<Preset> suppliedPresets();

/// The function with a preset's look, or with its colours or opacities alone, spread over `range`. `diagonal` is the
/// domain's. Of a preset without opacities only the colours can be had: asked for its opacities it changes nothing.
TransferFunction withPreset(const TransferFunction& function, const Preset& preset, PresetPart part,
                            const TransferLimits& range, double diagonal);

/// What it looks like: its colours from left to right, as opaque as they are.
QIcon presetIcon(const Preset& preset, QSize size);

/// As a preset keeps it: values from 0 to 1, lengths in diagonals of the domain. `range` must have an extent.
TransferFunction presetOf(const TransferFunction& function, const TransferLimits& range, double diagonal);

} // namespace tetra
