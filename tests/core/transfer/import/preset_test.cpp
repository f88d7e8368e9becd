// SPDX-License-Identifier: GPL-3.0-or-later
// ParaView's colour maps and opacities: what they look like there, they look like here, and the other way round. The
// judge is VTK, whose classes ParaView uses.
#include "core/base/json.h"
#include "core/transfer/import/presets.h"
#include "tests/core/transfer/import/looks.h"
#include "tests/lacks.h"

#include <tan/transfer.h>

#include <QTest>

#include <algorithm>
#include <cmath>
#include <random>

using namespace tetra;

namespace {

CurvePreset randomPreset(std::mt19937& random, ColourSpace space)
{
    std::uniform_real_distribution<double> unit(0, 1);
    CurvePreset preset;
    preset.name = "random";
    preset.colours.space = space;
    preset.colours.logarithmic = random() % 4 == 0;
    double value = 0.1 + unit(random);
    for (std::size_t node = 2 + random() % 5; node > 0; --node, value += 0.2 + unit(random))
        preset.colours.nodes.push_back({value, {unit(random), unit(random), unit(random)}});
    value = 0.1 + unit(random);
    for (std::size_t node = 2 + random() % 5; node > 0; --node, value += 0.2 + unit(random)) {
        const bool bent = random() % 2 == 0;
        preset.opacities.push_back(
            {value, unit(random), bent ? 0.1 + 0.8 * unit(random) : 0.5, bent ? 0.9 * unit(random) : 0});
    }
    return preset;
}

} // namespace

class PresetTest : public QObject {
    Q_OBJECT

private slots:
    void presetsLookAsInVtk_data();
    void presetsLookAsInVtk();
    void functionsLookTheSameInVtk();
    void jsonComesBackToTheSameBits();
    void xml();
    void whatAPresetLacksIsKept();
    void opacitiesReplaceTheMask();
    void badFilesAreRefused_data();
    void badFilesAreRefused();
};

void PresetTest::presetsLookAsInVtk_data()
{
    QTest::addColumn<int>("space");
    QTest::newRow("RGB") << int(ColourSpace::Rgb);
    QTest::newRow("HSV") << int(ColourSpace::Hsv);
    QTest::newRow("HSV wrapped") << int(ColourSpace::HsvWrapped);
    QTest::newRow("Lab") << int(ColourSpace::Lab);
    QTest::newRow("Diverging") << int(ColourSpace::Diverging);
    QTest::newRow("Step") << int(ColourSpace::Step);
}

void PresetTest::presetsLookAsInVtk()
{
    QFETCH(int, space);
    std::mt19937 random(static_cast<unsigned>(7 + space));
    QJsonArray requests;
    std::vector<TransferFunction> functions;
    std::vector<std::vector<double>> values;
    for (int round = 0; round < 40; ++round) {
        const std::string file = presetToJson(randomPreset(random, static_cast<ColourSpace>(space)));
        const auto presets = presetsFromJson(parseJson(file).value());
        QVERIFY2(presets, presets ? "" : presets.error().text().c_str());
        functions.push_back(transferFunctionOf(presets->front(), {}));
        QVERIFY(checkTransferFunction(functions.back()));
        values.push_back(valuesOver(transferPoints(functions.back()).front().value - 0.05,
                                    transferPoints(functions.back()).back().value + 0.05));
        requests.append(request(file, values.back()));
    }
    const auto theirs =
        looksIn("/usr/bin/python3", {TAN_SOURCE_DIR "/tests/core/transfer/import/looks_in_vtk.py"}, requests);
    if (!theirs)
        QSKIP_WITHOUT("python3-vtk9");
    for (std::size_t round = 0; round < functions.size(); ++round) {
        const double worst = worstDifference(functions[round], values[round], (*theirs)[qsizetype(round)].toArray());
        QVERIFY2(worst <= withinByte, qPrintable(QString("round %1: %2 of 255").arg(round).arg(255 * worst)));
    }
}

void PresetTest::functionsLookTheSameInVtk()
{
    std::mt19937 random(3);
    QJsonArray requests;
    std::vector<TransferFunction> functions;
    std::vector<std::vector<double>> values;
    for (int round = 0; round < 100; ++round) {
        functions.push_back(randomFunctionInParaview(random));
        QVERIFY(checkTransferFunction(functions.back()));
        values.push_back(valuesOver(transferPoints(functions.back()).front().value + 1e-3,
                                    transferPoints(functions.back()).back().value + 0.1));
        requests.append(request(presetToJson(curvesOf(functions.back(), "ours")), values.back()));
    }
    const auto theirs =
        looksIn("/usr/bin/python3", {TAN_SOURCE_DIR "/tests/core/transfer/import/looks_in_vtk.py"}, requests);
    if (!theirs)
        QSKIP_WITHOUT("python3-vtk9");
    for (std::size_t round = 0; round < functions.size(); ++round) {
        const double worst = worstDifference(functions[round], values[round], (*theirs)[qsizetype(round)].toArray());
        QVERIFY2(worst <= withinByte, qPrintable(QString("round %1: %2 of 255").arg(round).arg(255 * worst)));
    }
}

void PresetTest::jsonComesBackToTheSameBits()
{
    std::mt19937 random(11);
    for (int round = 0; round < 100; ++round) {
        const CurvePreset preset = randomPreset(random, static_cast<ColourSpace>(random() % 6));
        const std::string file = presetToJson(preset);
        const auto presets = presetsFromJson(parseJson(file).value());
        QVERIFY(presets);
        QCOMPARE(presetToJson(presets->front()), file);
    }
}

void PresetTest::xml()
{
    const auto presets = presetsFromXml(R"(<?xml version="1.0"?>
        <ColorMaps><ColorMap name="two &amp; three" space="HSV" indexedLookup="false">
        <Point x="-1" o="1" r="1" g="0" b="0"/><Point x="1" o="1" r="0" g="0" b="1"/>
        <NaN r="0.5" g="0.5" b="0.5"/></ColorMap>
        <ColorMap name="clear" space="RGB"><Point x="0" o="0" r="0" g="0" b="0"/>
        <Point x="2" o="0.5" r="1" g="1" b="1"/></ColorMap></ColorMaps>)");
    QVERIFY(presets);
    QCOMPARE(presets->size(), std::size_t(2));
    const CurvePreset &first = presets->front(), &second = presets->back();
    QCOMPARE(first.name, std::string("two & three"));
    QVERIFY(first.colours.space == ColourSpace::Hsv && first.opacities.empty());
    QCOMPARE(first.colours.nodes[1].colour, (SrgbColour{0, 0, 1}));
    QCOMPARE(second.opacities.size(), std::size_t(2));
    QCOMPARE(second.opacities[1].opacity, 0.5);
}

void PresetTest::whatAPresetLacksIsKept()
{
    std::mt19937 random(5);
    for (int round = 0; round < 50; ++round) {
        const TransferFunction present = randomFunctionInParaview(random);
        CurvePreset preset = randomPreset(random, ColourSpace::Rgb);
        preset.opacities.clear();
        const TransferFunction coloured = transferFunctionOf(preset, present);
        QCOMPARE(coloured.unitDistance, present.unitDistance);
        for (const double value : valuesOver(-4, 6)) {
            const double expected = evaluate(present, value).extinction, found = evaluate(coloured, value).extinction;
            const auto opacity = [&](double extinction) { return -std::expm1(-extinction * present.unitDistance); };
            QVERIFY2(std::abs(opacity(expected) - opacity(found)) <= withinByte / 2,
                     qPrintable(QString("at %1: %2, not %3").arg(value).arg(opacity(found)).arg(opacity(expected))));
        }
    }
}

/// Colours alone leave opacities and mask as they are.
void PresetTest::opacitiesReplaceTheMask()
{
    const TransferFunction present{
        {{0, {1, 0, 0}}, {1, {0, 1, 0}}}, {{0, 0.5F}, {1, 0.5F}}, 1, TransferMask{0.25, 0.75}};
    CurvePreset colours;
    colours.colours.nodes = {{0, {0, 0, 0}}, {1, {1, 1, 1}}};
    QVERIFY(transferFunctionOf(colours, present).mask == present.mask);
    CurvePreset both = colours;
    both.opacities = {{0, 0}, {1, 1}};
    QVERIFY(!transferFunctionOf(both, present).mask);
}

void PresetTest::badFilesAreRefused_data()
{
    QTest::addColumn<QByteArray>("file");
    QTest::addColumn<QByteArray>("told");
    const auto row = [](const char* name, const char* file, const char* told) {
        QTest::newRow(name) << QByteArray(file) << QByteArray(told);
    };
    row("nothing", "", "cannot be read");
    row("a table of colours", "0,0.2,0.1,0.9\n1,0.3,0.4,0.5\n", "presets in JSON, and ParaView's colour maps in XML");
    row("empty list", "[]", "empty");
    row("a number", "[3]", "object");
    row("no curves", "[{\"Name\": \"bare\"}]", "neither colours nor opacities");
    row("categories", "[{\"Name\": \"cats\", \"IndexedColors\": [0, 0, 1]}]", "categories");
    row("cut points", "[{\"RGBPoints\": [0, 1, 1]}]", "4 for each point");
    row("text for a number", "[{\"RGBPoints\": [0, 1, 1, \"x\"]}]", "not a number");
    row("too large a number", "[{\"RGBPoints\": [1e999, 1, 1, 1]}]", "not a number");
    row("channel", "[{\"Name\": \"loud\", \"RGBPoints\": [0, 1, 2, 1]}]", "'loud'");
    row("descending", "[{\"RGBPoints\": [1, 0, 0, 0, 0.5, 1, 1, 1]}]", "0.5 comes after 1");
    row("colour space", "[{\"ColorSpace\": \"Lab/CIEDE2000\", \"RGBPoints\": [0, 0, 0, 0]}]", "CIEDE2000");
    row("logarithm of zero", "[{\"UseLogScale\": 1, \"RGBPoints\": [0, 0, 0, 0, 1, 1, 1, 1]}]", "logarithm");
    row("opacity", "[{\"Points\": [0, 1.5, 0.5, 0]}]", "opacity");
    row("sharpness", "[{\"Points\": [0, 1, 0.5, -1]}]", "sharpness");
    row("damaged JSON", "[{\"RGBPoints\": [0, 0, 0", "line 1");
    row("a name in Latin 1", "[{\"Name\": \"gr\xfcn\", \"RGBPoints\": [0, 1, 1, 1]}]", "UTF-8");
    row("XML with a name in Latin 1",
        "<ColorMap name='gr\xfcn'><Point x='0' r='0' g='0' b='0'/><Point x='1' r='0' g='0' b='0'/></ColorMap>",
        "UTF-8");
    row("damaged XML", "<ColorMaps><ColorMap", "damaged at byte");
    row("other XML", "<svg/>", "no ColorMap");
    row("XML without x", "<ColorMap><Point r='0' g='0' b='0'/></ColorMap>", "'x'");
    row("XML with words", "<ColorMap><Point x='0' r='zero' g='0' b='0'/></ColorMap>", "'zero'");
    row("XML colour space", "<ColorMap space='Spectral'><Point x='0' r='0' g='0' b='0'/></ColorMap>", "Spectral");
}

void PresetTest::badFilesAreRefused()
{
    QFETCH(QByteArray, file);
    QFETCH(QByteArray, told);
    const auto presets = importTransferFunctions({file.constData(), std::size_t(file.size())}, {});
    QVERIFY(!presets);
    QVERIFY2(QByteArray::fromStdString(presets.error().text()).contains(told), presets.error().text().c_str());
}

QTEST_APPLESS_MAIN(PresetTest)
#include "preset_test.moc"
