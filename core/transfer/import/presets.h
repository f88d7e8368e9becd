// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/transfer/import/curves.h"

#include <string>
#include <string_view>
#include <vector>

namespace tetra {

struct JsonValue;

/// ParaView's files of colour maps and opacities, read and written (R18). Reading gives presets that checkCurves()
/// accepts, at least one. Errors say which preset and what is wrong with it, or where the text is none.

/// JSON as ParaView 4.2 and later write it: a list of objects with "Name", "ColorSpace", "RGBPoints" (value, red,
/// green, blue, ...), "Points" (value, opacity, midpoint, sharpness, ...), "UseLogScale" and "HSVWrap"; members of
/// other names are skipped. Categories ("IndexedColors") and the space Lab/CIEDE2000 are refused.
Result<std::vector<CurvePreset>> presetsFromJson(const JsonValue& root);

/// XML as older ParaViews wrote it and colour-map galleries still do: ColorMap elements with Points x, o, r, g, b.
/// Opacities that are all 1 count as none, because files of colours alone have them.
Result<std::vector<CurvePreset>> presetsFromXml(std::string_view text);

/// JSON that ParaView reads.
std::string presetToJson(const CurvePreset& preset);

} // namespace tetra
