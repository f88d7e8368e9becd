// SPDX-License-Identifier: GPL-3.0-or-later
// The presets that come with the program. Values in Hounsfield units are those of air (-1000), lung (-900 to -500), fat
// (-120 to -60), water (0), muscle (40 to 80), blood with contrast medium (150 to 450), bone (300 to 1500), enamel
// (above 2000) and metal (above 2500); elsewhere they are shares of the range. The unit distance stays.
#include "plugins/editors/transferfunction/preset.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace tetra {
namespace {

struct Stop {
    double value;
    std::uint32_t colour; ///< 0xRRGGBB
    float opacity;
};

struct Listed {
    const char* id;
    const char* name;  ///< marked for translators
    const char* words; ///< in English, German and Italian
    std::vector<Stop> stops;
};

constexpr std::uint32_t bone = 0xe8dcc4, paleBone = 0xfffaf0, marrow = 0xb0764a, skin = 0xe0ac8e, flesh = 0xbe5c50,
                        blood = 0xb03a2e, fat = 0xf2d16b, steel = 0xb0bac6, bright = 0xf0f6fc, stone = 0x968e84;

/// In Hounsfield units.
std::vector<Listed> tomographs()
{
    return {
        {"ct-bone",
         QT_TRANSLATE_NOOP("PresetNames", "CT: bone"),
         "bones skeleton Knochen Skelett osso ossa scheletro TC",
         {{150, marrow, 0}, {300, marrow, 0.45F}, {600, bone, 0.9F}, {1500, paleBone, 0.98F}}},
        {"ct-skin-bone",
         QT_TRANSLATE_NOOP("PresetNames", "CT: skin and bone"),
         "head Haut Knochen Kopf pelle osso ossa testa TC",
         {{-650, skin, 0},
          {-350, skin, 0.28F},
          {-120, skin, 0.04F},
          {100, flesh, 0.03F},
          {220, marrow, 0.08F},
          {450, bone, 0.9F},
          {1500, paleBone, 0.98F}}},
        {"ct-skin",
         QT_TRANSLATE_NOOP("PresetNames", "CT: skin"),
         "surface face Haut Gesicht Oberfläche pelle viso superficie TC",
         {{-700, skin, 0}, {-450, skin, 0.6F}, {-200, skin, 0.95F}, {400, skin, 0.95F}}},
        {"ct-soft-tissue",
         QT_TRANSLATE_NOOP("PresetNames", "CT: muscle and soft tissue"),
         "Muskel Weichteile Gewebe muscoli tessuti molli TC",
         {{-30, flesh, 0},
          {20, flesh, 0.2F},
          {70, blood, 0.5F},
          {160, skin, 0.4F},
          {350, bone, 0.3F},
          {1200, bone, 0.35F}}},
        {"ct-fat",
         QT_TRANSLATE_NOOP("PresetNames", "CT: fat"),
         "adipose Fett Fettgewebe grasso adiposo TC",
         {{-180, fat, 0}, {-120, fat, 0.35F}, {-60, fat, 0.35F}, {-10, fat, 0}, {250, bone, 0}, {1200, bone, 0.1F}}},
        {"ct-lung",
         QT_TRANSLATE_NOOP("PresetNames", "CT: lung"),
         "lungs airways thorax chest Lunge Atemwege Brust polmone polmoni vie aeree torace TC",
         {{-960, 0x7fb2d9, 0},
          {-880, 0x7fb2d9, 0.05F},
          {-700, 0xc98f9b, 0.16F},
          {-500, 0xd9a6a0, 0.22F},
          {-250, skin, 0.01F},
          {250, bone, 0.01F},
          {500, bone, 0.2F},
          {1200, paleBone, 0.25F}}},
    };
}

/// In Hounsfield units, too.
std::vector<Listed> tomographsWithMore()
{
    return {
        {"ct-vessels",
         QT_TRANSLATE_NOOP("PresetNames", "CT: vessels with contrast medium"),
         "angiography arteries aorta Gefäße Angiographie Kontrastmittel Arterien vasi angiografia contrasto arterie TC",
         {{120, blood, 0},
          {180, blood, 0.25F},
          {300, 0xe05a47, 0.8F},
          {450, 0xf0b8a0, 0.85F},
          {900, bone, 0.7F},
          {1500, paleBone, 0.7F}}},
        {"ct-heart",
         QT_TRANSLATE_NOOP("PresetNames", "CT: heart with contrast medium"),
         "cardiac coronary Herz Koronarien Kontrastmittel cuore cardiaca coronarie contrasto TC",
         {{50, 0x9e2f2f, 0},
          {120, 0x9e2f2f, 0.1F},
          {220, 0xd9604c, 0.45F},
          {400, 0xf2c7a5, 0.8F},
          {900, paleBone, 0.85F}}},
        {"ct-organs",
         QT_TRANSLATE_NOOP("PresetNames", "CT: organs of the abdomen"),
         "liver kidney belly Organe Bauch Leber Niere organi addome fegato reni TC",
         {{-20, 0x8f4a3a, 0},
          {30, 0x8f4a3a, 0.08F},
          {60, 0xb8604c, 0.22F},
          {110, 0xd98c6a, 0.35F},
          {180, 0xe8b88f, 0.5F},
          {350, bone, 0.75F},
          {1200, paleBone, 0.9F}}},
        {"ct-teeth",
         QT_TRANSLATE_NOOP("PresetNames", "CT: teeth"),
         "tooth enamel dental Zahn Zähne Zahnschmelz dente denti smalto TC",
         {{700, marrow, 0}, {1200, bone, 0.25F}, {1900, 0xfff6e0, 0.9F}, {2800, 0xffffff, 0.98F}}},
        {"ct-metal",
         QT_TRANSLATE_NOOP("PresetNames", "CT: metal and implants"),
         "prosthesis screw steel Metall Implantat Prothese Schraube metallo impianti protesi viti TC",
         {{250, bone, 0}, {700, bone, 0.07F}, {2200, bone, 0.1F}, {2600, steel, 0.9F}, {3071, bright, 0.98F}}},
        {"ct-x-ray",
         QT_TRANSLATE_NOOP("PresetNames", "CT: like an X-ray picture"),
         "radiograph xray Röntgen Röntgenbild durchsichtig radiografia raggi trasparente TC",
         {{-900, 0xdfe8f0, 0},
          {-200, 0xdfe8f0, 0.005F},
          {100, 0xeef3f7, 0.02F},
          {400, 0xffffff, 0.07F},
          {1500, 0xffffff, 0.25F}}},
    };
}

/// In shares of the range, as what follows.
std::vector<Listed> scans()
{
    return {
        {"mr-head",
         QT_TRANSLATE_NOOP("PresetNames", "MR: head"),
         "MRI magnetic skin Kopf Haut Kernspin MRT testa pelle risonanza RM",
         {{0.07, skin, 0}, {0.15, skin, 0.25F}, {0.3, flesh, 0.3F}, {0.6, 0xe8d0b8, 0.5F}, {1, paleBone, 0.75F}}},
        {"mr-brain",
         QT_TRANSLATE_NOOP("PresetNames", "MR: brain"),
         "MRI magnetic Gehirn Hirn Kernspin MRT cervello encefalo risonanza RM",
         {{0.18, 0xb07a7a, 0},
          {0.3, 0xb07a7a, 0.04F},
          {0.42, 0xd8a8a0, 0.35F},
          {0.6, 0xf0dcd0, 0.7F},
          {1, 0xffffff, 0.8F}}},
        {"mr-vessels",
         QT_TRANSLATE_NOOP("PresetNames", "MR: vessels (angiography)"),
         "MRI MRA arteries Gefäße Angiographie Kernspin MRT vasi angiografia risonanza RM",
         {{0.3, blood, 0}, {0.45, blood, 0.15F}, {0.65, 0xe0604c, 0.8F}, {1, 0xffd8b0, 0.95F}}},
        {"mr-bright",
         QT_TRANSLATE_NOOP("PresetNames", "MR: bright tissue"),
         "MRI grey gray Kernspin MRT hell grau risonanza chiaro grigio RM",
         {{0.2, 0x707070, 0}, {0.5, 0xa0a0a0, 0.05F}, {0.8, 0xe0e0e0, 0.4F}, {1, 0xffffff, 0.9F}}},
        {"metal",
         QT_TRANSLATE_NOOP("PresetNames", "Metal part"),
         "steel casting industrial Metall Stahl Guss Bauteil metallo acciaio fusione pezzo",
         {{0.3, steel, 0}, {0.5, steel, 0.9F}, {1, bright, 0.98F}}},
        {"metal-pores",
         QT_TRANSLATE_NOOP("PresetNames", "Metal and pores"),
         "porosity cavities casting defects Metall Poren Lunker Guss Fehler metallo pori porosità cavità difetti",
         {{0.06, 0xe69f00, 0},
          {0.16, 0xe69f00, 0.6F},
          {0.32, 0xd55e00, 0.5F},
          {0.48, steel, 0.05F},
          {1, steel, 0.05F}}},
        {"stone-pores",
         QT_TRANSLATE_NOOP("PresetNames", "Stone and pores"),
         "rock core sandstone porosity Stein Gestein Bohrkern Poren roccia pietra pori carota porosità",
         {{0, 0x2060a0, 0.6F},
          {0.15, 0x4fa3d8, 0.5F},
          {0.3, stone, 0.04F},
          {0.6, stone, 0.06F},
          {0.8, 0xc8beb0, 0.12F},
          {1, 0xf0e8d8, 0.6F}}},
    };
}

std::vector<Listed> fields()
{
    return {
        {"fire",
         QT_TRANSLATE_NOOP("PresetNames", "Fire: glowing where values are large"),
         "flame heat temperature Feuer Flamme Hitze fuoco fiamma calore",
         {{0, 0x100000, 0},
          {0.25, 0x600800, 0.02F},
          {0.5, 0xc02a00, 0.1F},
          {0.75, 0xff9a00, 0.3F},
          {1, 0xffffc0, 0.7F}}},
        {"smoke",
         QT_TRANSLATE_NOOP("PresetNames", "Smoke and clouds"),
         "fog density Rauch Wolken Nebel fumo nuvole nebbia",
         {{0.02, 0x808890, 0}, {0.2, 0x90989e, 0.05F}, {0.6, 0xc4c8cc, 0.18F}, {1, 0xf4f5f6, 0.4F}}},
        {"water",
         QT_TRANSLATE_NOOP("PresetNames", "Water"),
         "liquid concentration Wasser Flüssigkeit acqua liquido",
         {{0.1, 0xbfe3f2, 0}, {0.35, 0x8cc8e6, 0.05F}, {0.7, 0x3f86bf, 0.25F}, {1, 0x173f73, 0.7F}}},
        {"layers",
         QT_TRANSLATE_NOOP("PresetNames", "Layers: five shells"),
         "isosurfaces bands onion Schichten Schalen Isoflächen strati gusci",
         {{0.08, 0x440154, 0},
          {0.1, 0x440154, 0.3F},
          {0.12, 0x440154, 0},
          {0.28, 0x3b528b, 0},
          {0.3, 0x3b528b, 0.4F},
          {0.32, 0x3b528b, 0},
          {0.48, 0x21918c, 0},
          {0.5, 0x21918c, 0.5F},
          {0.52, 0x21918c, 0},
          {0.68, 0x5ec962, 0},
          {0.7, 0x5ec962, 0.6F},
          {0.72, 0x5ec962, 0},
          {0.88, 0xfde725, 0},
          {0.9, 0xfde725, 0.7F},
          {0.92, 0xfde725, 0}}},
        {"small",
         QT_TRANSLATE_NOOP("PresetNames", "Sequential: opaque where values are small"),
         "low viridis klein niedrig piccoli bassi",
         {{0, 0x440154, 0.8F},
          {0.125, 0x472d7b, 0.5F},
          {0.25, 0x3b528b, 0.3F},
          {0.375, 0x2c728e, 0.18F},
          {0.5, 0x21918c, 0.1F},
          {0.625, 0x28ae80, 0.06F},
          {0.75, 0x5ec962, 0.03F},
          {0.875, 0xaddc30, 0.01F},
          {1, 0xfde725, 0}}},
    };
}

TransferFunction functionOf(const std::vector<Stop>& stops, const TransferLimits& of, const TransferLimits& range,
                            double unitDistance)
{
    const auto channel = [](std::uint32_t colour, int shift) {
        return static_cast<float>(colour >> shift & 0xff) / 255;
    };
    std::vector<TransferPoint> points;
    for (const Stop& stop : stops) {
        const double share = (stop.value - of.least) / (of.largest - of.least);
        points.push_back({std::lerp(range.least, range.largest, share),
                          {channel(stop.colour, 16), channel(stop.colour, 8), channel(stop.colour, 0)},
                          stop.opacity});
    }
    return transferFunctionFromPoints(points, unitDistance);
}

Preset presetOf(const Listed& listed, bool isHounsfield)
{
    const TransferLimits of = isHounsfield ? hounsfieldRange : TransferLimits{};
    Preset preset;
    preset.id = QString("preset.") + listed.id;
    preset.name = QCoreApplication::translate("PresetNames", listed.name);
    preset.words = QString::fromUtf8(listed.words);
    preset.isHounsfield = isHounsfield;
    preset.make = [stops = listed.stops, of](const TransferLimits& range, double unitDistance) {
        return functionOf(stops, of, range, unitDistance);
    };
    return preset;
}

/// What the map is called in the user's language: names that are known everywhere stay.
QString colourMapName(const std::string& id)
{
    if (id == "cool-warm")
        return QCoreApplication::translate("PresetNames", "Cool to warm");
    if (id == "grey")
        return QCoreApplication::translate("PresetNames", "Grey");
    if (id == "blue-orange")
        return QCoreApplication::translate("PresetNames", "Blue to orange");
    if (id == "categories")
        return QCoreApplication::translate("PresetNames", "Categories");
    return QString::fromStdString(id);
}

QString colourMapWords(const std::string& id)
{
    if (id == "turbo")
        return "rainbow jet Regenbogen arcobaleno";
    if (id == "grey")
        return "gray Graustufen Schwarz Weiß grigio bianco nero";
    if (id == "cool-warm" || id == "blue-orange")
        return "diverging divergierend blau rot orange divergente blu rosso arancione";
    if (id == "categories")
        return "categorical qualitative labels segments Kategorien Klassen Segmente categorie etichette segmenti";
    return "sequential sequentiell sequenziale";
}

const ColourMap& mapNamed(std::string_view id)
{
    return *std::ranges::find(colourMaps(), id, &ColourMap::id);
}

/// The colours of a map, opaque where values are large or, `evenly`, everywhere alike.
Preset opaque(const char* mapId, const char* name, bool evenly)
{
    Preset preset;
    preset.id = QString("preset.") + mapId;
    preset.name = QCoreApplication::translate("PresetNames", name);
    preset.source = QString::fromStdString(mapNamed(mapId).source);
    preset.words = colourMapWords(mapId);
    preset.make = [&map = mapNamed(mapId), evenly](const TransferLimits& range, double unitDistance) {
        constexpr double steepness = 2.5;
        constexpr float largest = 0.8F, even = 0.25F;
        constexpr int parts = 8;
        TransferFunction function;
        function.unitDistance = unitDistance;
        for (int part = 0; part <= parts; ++part) {
            const double share = static_cast<double>(part) / parts;
            function.opacities.push_back({std::lerp(range.least, range.largest, share),
                                          evenly ? even : static_cast<float>(largest * std::pow(share, steepness)),
                                          {}});
        }
        return withColourMap(function, map, range);
    };
    return preset;
}

/// Opaque everywhere.
TransferFunction functionOf(const ColourMap& map, const TransferLimits& range, double unitDistance)
{
    TransferFunction function;
    function.opacities = {{range.least, 1}};
    function.unitDistance = unitDistance;
    return withColourMap(function, map, range);
}

/// Made of the range alone, whatever the values are.
Preset general(const char* id, const char* name, const char* words,
               TransferFunction (*make)(double least, double largest, double unitDistance))
{
    Preset preset;
    preset.id = id;
    preset.name = QCoreApplication::translate("PresetNames", name);
    preset.words = words;
    preset.make = [make](const TransferLimits& range, double unit) { return make(range.least, range.largest, unit); };
    return preset;
}

} // namespace

std::vector<Preset> suppliedPresets()
{
    std::vector<Preset> presets{
        general("preset.sequential", QT_TRANSLATE_NOOP("PresetNames", "Sequential: opaque where values are large"),
                "viridis sequentiell groß sequenziale grandi", &sequentialTransferFunction),
        general("preset.diverging", QT_TRANSLATE_NOOP("PresetNames", "Diverging: opaque at both ends"),
                "blue orange divergierend blau divergente blu arancione", &divergingTransferFunction)};
    for (const auto& list : {tomographs(), tomographsWithMore()})
        for (const Listed& listed : list)
            presets.push_back(presetOf(listed, true));
    for (const auto& list : {scans(), fields()})
        for (const Listed& listed : list)
            presets.push_back(presetOf(listed, false));
    presets.push_back(
        opaque("plasma", QT_TRANSLATE_NOOP("PresetNames", "Plasma: opaque where values are large"), false));
    presets.push_back(opaque("turbo", QT_TRANSLATE_NOOP("PresetNames", "Turbo: opaque where values are large"), false));
    presets.push_back(
        opaque("categories", QT_TRANSLATE_NOOP("PresetNames", "Categories: seven colours, evenly opaque"), true));
    for (const ColourMap& map : colourMaps()) {
        Preset preset;
        preset.id = QString::fromStdString("colours." + map.id);
        preset.name = colourMapName(map.id);
        preset.source = QString::fromStdString(map.source);
        preset.words = colourMapWords(map.id);
        preset.make = [&map](const TransferLimits& range, double unit) { return functionOf(map, range, unit); };
        preset.hasOpacities = false;
        presets.push_back(std::move(preset));
    }
    return presets;
}

} // namespace tetra
