// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/value_facts_host.h"

#include <tan/base.h>
#include <tan/transfer.h>

#include <QIcon>
#include <QString>

#include <functional>
#include <optional>
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
    QString words{};           ///< that it is found by besides its name, in every language of the program
    bool isHounsfield = false; ///< made over `hounsfieldRange`, for values in Hounsfield units
};

enum class PresetPart { Both, Colours, Opacities };

/// Those that come with the program: for values between any two, for scans in Hounsfield units, and last the colour
/// maps of core/transfer. In supplied_presets.cpp.
std::vector<Preset> suppliedPresets();

/// Whether a text that somebody types means the preset: each of its words is a part of the preset's name or words.
bool isMeant(const Preset& preset, const QString& text);

/// The values of scanners with twelve bits.
inline constexpr TransferLimits hounsfieldRange{-1024, 3071};

/// Whether values are Hounsfield units: the data say so, or they look like these, signed whole numbers that begin where
/// scanners do, or neither.
enum class HounsfieldUnits { Told, Likely, None };
HounsfieldUnits hounsfieldUnits(const ValueFacts& facts, const TransferLimits& range);

/// What a preset is made over, where the data have the values of `range`: that, or of a preset in Hounsfield units
/// their own range if the data have these.
TransferLimits rangeOf(const Preset& preset, HounsfieldUnits units, const TransferLimits& range);

/// What is assumed then that nobody has said; empty if nothing is.
std::optional<Message> assumptionOf(const Preset& preset, HounsfieldUnits units, const TransferLimits& range);

/// The function with a preset's look, or with its colours or opacities alone, spread over `range`. `diagonal` is the
/// domain's. Of a preset without opacities only the colours can be had: asked for its opacities it changes nothing.
TransferFunction withPreset(const TransferFunction& function, const Preset& preset, PresetPart part,
                            const TransferLimits& range, double diagonal);

/// What it looks like: its colours from left to right, as opaque as they are.
QIcon presetIcon(const Preset& preset, QSize size);

/// As a preset keeps it: values from 0 to 1, lengths in diagonals of the domain. `range` must have an extent.
TransferFunction presetOf(const TransferFunction& function, const TransferLimits& range, double diagonal);

} // namespace tetra
