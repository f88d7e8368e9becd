// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/model_statistics.h"

#include "core/history/whole_elsewhere.h"
#include "core/view/accuracy_scale.h"
#include "plugins/widgets/number_text.h"
#include "ui/session/files.h"
#include "ui/session/logarithm_text.h"
#include "ui/session/message_text.h"
#include "ui/session/shown_mesh_text.h"

#include <tan/query.h>
#include <tan/view.h>

#include <QCoreApplication>
#include <QFileInfo>
#include <QLocale>
#include <QStringList>

namespace tetra {
namespace {

class Statistics {
    Q_DECLARE_TR_FUNCTIONS(Statistics)
};

/// Position, value and site of a vertex; four vertices of a tetrahedron.
constexpr std::uint64_t bytesOfVertex = 3 * sizeof(double) + sizeof(float) + sizeof(std::uint32_t);
constexpr std::uint64_t bytesOfTetrahedron = 4 * sizeof(std::uint32_t);

} // namespace

std::vector<LevelStatistics> levelStatistics(const Model& model, std::optional<double> secondsPerTetrahedron,
                                             const WarpingChoice& warping)
{
    const auto most = static_cast<double>(meshSizeAt(model, bothWithin(0)).tetrahedra);
    const auto logarithms = logarithmsOf(model.description());
    std::vector<LevelStatistics> levels;
    for (const double error : accuracyPresets) {
        const MeshSize size = meshSizeAt(model, warping.with(error));
        const auto tetrahedra = static_cast<double>(size.tetrahedra);
        LevelStatistics level{.error = error,
                              .inUnits = error / 100 * model.description().range.extent(),
                              .factor = logarithms ? factorNumber(error, *logarithms) : QString(),
                              .sites = size.sites,
                              .tetrahedra = size.tetrahedra,
                              .share = most > 0 ? 100 * tetrahedra / most : 0,
                              .seconds = {},
                              .bytes = size.sites * bytesOfVertex + size.tetrahedra * bytesOfTetrahedron};
        if (secondsPerTetrahedron)
            level.seconds = *secondsPerTetrahedron * tetrahedra;
        levels.push_back(level);
    }
    return levels;
}

std::optional<double> secondsPerTetrahedron(const BuiltScene& scene)
{
    if (scene.extractionSeconds <= 0 || scene.mesh.wholeTetrahedra == 0)
        return std::nullopt;
    return scene.extractionSeconds / static_cast<double>(scene.mesh.wholeTetrahedra);
}

QStringList levelColumns(ErrorMeaning meaning, bool ofLogarithms)
{
    // What counts least comes last, where a narrow panel hides it.
    return {translatedText(textFor(errorLabels, meaning)),
            Statistics::tr("Vertices"),
            Statistics::tr("Tetrahedra"),
            Statistics::tr("Share"),
            Statistics::tr("Time"),
            Statistics::tr("Memory"),
            ofLogarithms ? Statistics::tr("Factor") : Statistics::tr("± value")};
}

QStringList levelTexts(const LevelStatistics& level)
{
    return {percentText(level.error),
            countText(level.sites),
            countText(level.tetrahedra),
            percentText(level.share),
            level.seconds ? durationText(*level.seconds) : QString(QChar(0x2013)),
            bytesText(level.bytes),
            level.factor.isEmpty() ? QLocale().toString(level.inUnits, 'g', 3) : level.factor};
}

std::vector<StatisticsFact> modelFacts(const Model& model)
{
    const ValueRange range = model.description().range;
    std::vector<StatisticsFact> facts{
        {Statistics::tr("Model"), shownText(model.path().filename().string())},
        {Statistics::tr("Values"), Statistics::tr("%1 to %2")
                                       .arg(dataValueText(range.minimum, model.description()),
                                            dataValueText(range.maximum, model.description()))},
        {Statistics::tr("Total vertices"), countText(wholeSites(model))},
        {Statistics::tr("File"), bytesText(wholeBytes(model))}};
    if (const auto logarithms = logarithmsOf(model.description()))
        facts.insert(facts.begin() + 2,
                     {Statistics::tr("Scale"),
                      Statistics::tr("logarithmic; an error of 1 % is %1").arg(factorWords(1, *logarithms))});
    if (const QString place = errorPlaceText(errorMeaning(model.description()), {}); !place.isEmpty())
        facts.push_back({Statistics::tr("Error"), place});
    if (const std::uint64_t faulty = faultyCellCount(model); faulty > 0)
        facts.push_back({Statistics::tr("Faulty cells"), countText(faulty)});
    const ModelDescription& description = model.description();
    if (const QStringList lines = provenanceLines(description.taken, {}); !lines.isEmpty())
        facts.push_back({Statistics::tr("Used from the file"), lines.join('\n')});
    if (const QStringList lines = provenanceLines({}, description.leftOut); !lines.isEmpty())
        facts.push_back({Statistics::tr("Not used from the file"), lines.join('\n')});
    return facts;
}

namespace {

QString cyclesText(const OrderFaults& faults)
{
    if (faults == OrderFaults{})
        return countText(0);
    const QString cut = countText(faults.cutCells);
    if (faults.brokenCycles == 0)
        return Statistics::tr("tetrahedra cut: %1").arg(cut);
    return Statistics::tr("tetrahedra cut: %1; overlapping groups, drawn by distance: %2")
        .arg(cut, countText(faults.brokenCycles));
}

} // namespace

std::vector<StatisticsFact> sceneFacts(const BuiltScene& scene, double frameSeconds,
                                       const std::optional<OrderFaults>& faults)
{
    std::vector<StatisticsFact> facts{
        {Statistics::tr("Shown"), Statistics::tr("%1 vertices, %2 tetrahedra")
                                      .arg(countText(scene.mesh.keptSites), countText(scene.mesh.keptTetrahedra))},
        {Statistics::tr("Guaranteed"), errorText(scene.mesh)}};
    if (const QString pieces = piecesText(scene.mesh); !pieces.isEmpty())
        facts.push_back({Statistics::tr("Cut"), pieces});
    if (scene.faultyCells)
        facts.push_back({Statistics::tr("Faulty cells outlined"), countText(*scene.faultyCells)});
    if (scene.triangles > 0)
        facts.push_back({Statistics::tr("Triangles"), countText(scene.triangles)});
    if (scene.extractionSeconds > 0)
        facts.push_back({Statistics::tr("Extraction"), durationText(scene.extractionSeconds)});
    facts.push_back({Statistics::tr("Preparation"), durationText(scene.sceneSeconds)});
    if (frameSeconds > 0)
        facts.push_back({Statistics::tr("A frame"), durationText(frameSeconds)});
    if (faults)
        facts.push_back({Statistics::tr("Visibility cycles"), cyclesText(*faults)});
    return facts;
}

QString statisticsText(const std::vector<StatisticsFact>& facts, const std::vector<LevelStatistics>& levels,
                       ErrorMeaning meaning)
{
    QString text;
    for (const auto& [name, value] : facts)
        text += name + '\t' + value + '\n';
    const bool ofLogarithms = !levels.empty() && !levels.front().factor.isEmpty();
    text += '\n' + levelColumns(meaning, ofLogarithms).join('\t') + '\n';
    for (const LevelStatistics& level : levels)
        text += levelTexts(level).join('\t') + '\n';
    return text;
}

} // namespace tetra
