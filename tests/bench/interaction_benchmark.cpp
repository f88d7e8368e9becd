// SPDX-License-Identifier: GPL-3.0-or-later
// A scripted turntable, as if somebody dragged the picture round once and let go (R23): how many pictures a second the
// CPU back end shows, how many of them keep within the budget of 15, and how long the full picture takes afterwards.
// The choice of mesh and picture size is the window's own, without the window. Then, with the window, what the undo
// step of a drag costs beside its pictures, and how long it is from an edit of the transfer function to a picture of
// it. With --events what the window takes for its events, in place of all that.

#include "tests/bench/bench_report.h"
#include "tests/bench/camera_drag.h"
#include "tests/bench/edit_to_picture.h"
#include "tests/bench/gui_events.h"

#include "plugins/host/dataset_opening.h"
#include "plugins/host/model_building.h"
#include "plugins/samples/samples.h"
#include "ui/animation/frame_pacer.h"
#include "ui/scenes/picture_image.h"
#include "ui/work/steady_heap.h"

#include <tan/query.h>
#include <tan/render.h>
#include <tan/transfer.h>
#include <tan/view.h>

#include <QApplication>
#include <QCommandLineParser>
#include <QFileInfo>
#include <QImage>
#include <QStandardPaths>
#include <QTemporaryDir>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace tetra {
namespace {

constexpr int frames = 200;
constexpr int compared = 12; ///< views in which the moving picture is compared with the full one
constexpr int fineSamples = 2;
constexpr double movingTolerance = 4; ///< degrees, as in the window
constexpr double wantedRate = 15;
constexpr double unitDistances = 40; ///< in the diagonal

/// How it is drawn.
struct Look {
    int width = 800;
    int height = 600;
    bool lit = false; ///< and with the function that volumes have at first, else a plain one

    double pixels() const { return static_cast<double>(width) * height; }
};

struct Level {
    std::shared_ptr<const Scene> scene;
    std::uint64_t tetrahedra = 0;
};

TransferFunction functionOf(const Look& look, const ModelDescription& description, const TetrahedralMesh& mesh)
{
    constexpr int parts = 256;
    const double least = description.range.minimum, largest = description.range.maximum;
    const double unitDistance = description.bounds.diagonal().norm() / unitDistances;
    return look.lit ? fittedTransferFunction(volumeHistogram(mesh, least, largest, parts), unitDistance)
                    : sequentialTransferFunction(least, largest, unitDistance);
}

Result<Level> makeLevel(const std::shared_ptr<const Model>& model, MeshExtractor& extractor, const MeshQuery& query,
                        const Look& look)
{
    const auto mesh = extractor.extract(query);
    if (!mesh)
        return mesh.error();
    const ModelDescription& description = model->description();
    VolumeCache maker({*mesh, &(*mesh)->mesh});
    const auto volume = maker.update(functionOf(look, description, (*mesh)->mesh), look.lit);
    if (!volume)
        return volume.error();
    auto scene = std::make_shared<Scene>();
    scene->bounds = description.bounds;
    scene->drawables.push_back({.id = "volume", .shape = *volume});
    return Level{scene, (*mesh)->mesh.tetrahedra.size()};
}

/// The mesh that the window would show and those for moving pictures.
Result<std::vector<Level>> makeLevels(const std::shared_ptr<const Model>& model, double error, const Look& look)
{
    MeshExtractor extractor(model);
    MeshQuery query;
    query.error = error;
    std::vector<Level> levels;
    auto finest = makeLevel(model, extractor, query, look);
    if (!finest)
        return finest.error();
    levels.push_back(*finest);
    for (const std::uint64_t budget : coarserMeshes(finest->tetrahedra)) {
        query.budget = budget;
        auto level = makeLevel(model, extractor, query, look);
        if (!level)
            return level.error();
        levels.push_back(*level);
    }
    return levels;
}

PictureOptions optionsFor(const Look& look, double reduction, int samplesPerAxis, double tolerance, int threads)
{
    PictureOptions options;
    options.width = static_cast<int>(std::lround(look.width / reduction));
    options.height = static_cast<int>(std::lround(look.height / reduction));
    options.samplesPerAxis = samplesPerAxis;
    options.orderTolerance = tolerance;
    options.threads = threads;
    return options;
}

double samplesOf(const PictureOptions& options)
{
    return static_cast<double>(options.width) * options.height * options.samplesPerAxis * options.samplesPerAxis;
}

/// Draws as the window does and lets the pacer learn from it. Returns the seconds.
double draw(RenderBackend& backend, FramePacer& pacer, std::size_t index, const Level& level, const Camera& camera,
            const PictureOptions& options)
{
    const double seconds = secondsOf([&] {
        if (!backend.render(*level.scene, camera, options).ok())
            qFatal("A picture failed.");
    });
    pacer.learn(index, samplesOf(options), backend.statistics(), seconds);
    return seconds;
}

struct Turn {
    std::vector<double> seconds; ///< of each picture
    double meanTetrahedra = 0;
    double meanReduction = 0;
    double shareInBudget = 0; ///< after the first second
};

Turn turnRound(FramePacer& pacer, RenderBackend& backend, const std::vector<Level>& levels, Camera camera,
               const Look& look, int threads)
{
    Turn turn;
    double clock = 0;
    int counted = 0;
    int inBudget = 0;
    for (int frame = 0; frame < frames; ++frame) {
        camera = turned(camera, 360.0 / frames, 0);
        const FramePlan plan = pacer.nextFrame(look.pixels());
        const Level& level = levels[plan.level];
        turn.seconds.push_back(draw(backend, pacer, plan.level, level, camera,
                                    optionsFor(look, plan.reduction, 1, movingTolerance, threads)));
        if (clock >= 1) {
            ++counted;
            inBudget += turn.seconds.back() <= 1 / wantedRate ? 1 : 0;
        }
        clock += turn.seconds.back();
        turn.meanTetrahedra += static_cast<double>(level.tetrahedra) / frames;
        turn.meanReduction += plan.reduction / frames;
    }
    turn.shareInBudget = counted > 0 ? static_cast<double>(inBudget) / counted : 1;
    return turn;
}

/// The steps up to the full picture after letting go; the last one's time is that of the full picture alone.
std::vector<double> refine(FramePacer& pacer, const Level& finest, const Camera& camera, const Look& look, int threads)
{
    const auto backend = makeCpuBackend();
    std::vector<double> seconds;
    const auto steps = pacer.refinement(look.pixels(), fineSamples);
    for (const RefinementStep& step : steps) {
        const double tolerance = step == steps.back() ? 0 : movingTolerance;
        seconds.push_back(draw(*backend, pacer, 0, finest, camera,
                               optionsFor(look, step.reduction, step.samplesPerAxis, tolerance, threads)));
    }
    return seconds;
}

QImage imageOf(RenderBackend& backend, const Level& level, const Camera& camera, const PictureOptions& options)
{
    const auto picture = backend.render(*level.scene, camera, options);
    if (!picture)
        qFatal("%s", picture.error().text().c_str());
    return tetra::imageOf(*picture).convertToFormat(QImage::Format_RGB32);
}

/// The mean difference of the channels of two pictures of one size, of 255.
double meanDifference(const QImage& one, const QImage& other)
{
    double sum = 0;
    for (int y = 0; y < one.height(); ++y)
        for (int x = 0; x < one.width(); ++x) {
            const QRgb a = one.pixel(x, y), b = other.pixel(x, y);
            sum += std::abs(qRed(a) - qRed(b)) + std::abs(qGreen(a) - qGreen(b)) + std::abs(qBlue(a) - qBlue(b));
        }
    return sum / (3.0 * one.width() * one.height());
}

/// Between the moving pictures, as large as the window shows them, and the full ones of the same views.
double differenceOfMoving(FramePacer& pacer, const std::vector<Level>& levels, Camera camera, const Look& look,
                          int threads)
{
    const auto backend = makeCpuBackend();
    const FramePlan plan = pacer.nextFrame(look.pixels());
    double sum = 0;
    for (int view = 0; view < compared; ++view) {
        camera = turned(camera, 360.0 / compared, 0);
        const QImage moving = imageOf(*backend, levels[plan.level], camera,
                                      optionsFor(look, plan.reduction, 1, movingTolerance, threads));
        const QImage full = imageOf(*backend, levels.front(), camera, optionsFor(look, 1, fineSamples, 0, threads));
        sum += meanDifference(moving.scaled(full.size(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation), full);
    }
    return sum / compared;
}

BenchCase measure(const std::shared_ptr<const Model>& model, const QString& name, double error, const Look& look,
                  int threads)
{
    Result<std::vector<Level>> levels = std::vector<Level>{};
    const double preparing = secondsOf([&] { levels = makeLevels(model, error, look); });
    if (!levels)
        qFatal("%s", levels.error().text().c_str());
    FramePacer pacer;
    pacer.setFrameRate(wantedRate);
    std::vector<FrameLevel> sizes;
    for (const Level& level : *levels)
        sizes.push_back({static_cast<double>(level.tetrahedra), true, 0});
    pacer.setLevels(std::move(sizes));

    const Camera camera = fitted(Camera(), model->description().bounds, static_cast<double>(look.width) / look.height);
    const auto backend = makeCpuBackend();
    const Turn turn = turnRound(pacer, *backend, *levels, camera, look, threads);
    const std::vector<double> steps = refine(pacer, levels->front(), camera, look, threads);
    double sum = 0;
    for (const double seconds : turn.seconds)
        sum += seconds;
    double refining = 0;
    for (const double seconds : steps)
        refining += seconds;

    BenchCase one;
    one.name = name + QString(", %1 %, %2 threads, median frame").arg(error).arg(threads);
    one.seconds = median(turn.seconds);
    one.yardstick = "the budget of 15 frames a second";
    one.yardstickSeconds = 1 / wantedRate;
    one.more = {{"frames_per_second", frames / sum},
                {"share_in_budget", turn.shareInBudget},
                {"full_picture_seconds", refining},
                {"first_refinement_seconds", steps.front()},
                {"refinement_steps", static_cast<qint64>(steps.size())},
                {"tetrahedra", static_cast<qint64>(levels->front().tetrahedra)},
                {"moving_tetrahedra", turn.meanTetrahedra},
                {"moving_reduction", turn.meanReduction},
                {"moving_difference", differenceOfMoving(pacer, *levels, camera, look, threads)},
                {"preparing_seconds", preparing}};
    return one;
}

/// The dataset's model, built at `target`.
Result<std::shared_ptr<const Model>> modelOf(PluginHost& host, const Dataset& dataset, const QString& path)
{
    const std::filesystem::path target = path.toStdString();
    if (const auto built = buildModel(host, dataset, "refinement", {}, target, {}); !built)
        return built.error();
    return Model::open(target);
}

std::vector<std::pair<QString, Result<std::shared_ptr<const Model>>>>
modelsOf(PluginHost& host, const QCommandLineParser& parser, const QTemporaryDir& folder)
{
    std::vector<std::pair<QString, Result<std::shared_ptr<const Model>>>> models;
    for (const QString& file : parser.values("model"))
        models.emplace_back(QFileInfo(file).fileName(), Model::open(file.toStdString()));
    if (!models.empty())
        return models;
    const QStringList names = parser.value("models").split(',');
    if (names.contains("c60")) {
        const std::uint32_t size = std::max(2u, parser.value("size").toUInt());
        models.emplace_back(QString("c60 %1^3").arg(size),
                            modelOf(host, *makeSample({"c60", size, SampleType::UInt8}), folder.filePath("c60.tan")));
    }
    const std::filesystem::path engine =
        (parser.value("data") + "/regular/engine_256x256x128_uint8.nrrd").toStdString();
    if (names.contains("engine") && std::filesystem::exists(engine))
        if (const auto dataset = openDataset(host, engine, {}, {}))
            models.emplace_back("engine 256x256x128", modelOf(host, *dataset, folder.filePath("engine.tan")));
    return models;
}

/// On both canvases, if there are both.
std::vector<BenchCase> eventCases(TimedApplication& application, PluginHost& host, const std::filesystem::path& model,
                                  const QString& name, int acts)
{
    std::vector<BenchCase> cases;
    for (const BackendChoice canvas : {BackendChoice::Cpu, BackendChoice::Gl})
        if (const auto found = eventsOfTheWindow(application, host, model, name, canvas, acts))
            cases.push_back(*found);
    if (cases.size() < 2)
        std::fputs(
            "OpenGL is not measured: there is none on this display. Run the program by tests/ui/run_under_x.sh.\n",
            stderr);
    return cases;
}

} // namespace
} // namespace tetra

int main(int argc, char** argv)
{
    using namespace tetra;
    if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM"))
        qputenv("QT_QPA_PLATFORM", "offscreen");
    TimedApplication application(argc, argv);
    QStandardPaths::setTestModeEnabled(true);
    QCoreApplication::setApplicationName("tan-bench-interaction");
    PluginHost host({.folders = {TAN_BINARY_DIR "/lib/tan/plugins"}});
    QCommandLineParser parser;
    parser.addHelpOption();
    parser.addOption({"json", "Print one JSON object."});
    parser.addOption({"threads", "Of the back end.", "N", "2"});
    parser.addOption({"models", "What to turn, with commas between.", "LIST", "c60,engine"});
    parser.addOption({"lit", "Turn a lit volume, with the transfer function that the window begins with."});
    parser.addOption({"picture", "Pixels of a turning picture.", "WxH", "800x600"});
    parser.addOption({"size", "Points of C60 along an axis.", "N", "128"});
    parser.addOption({"data", "The folder of the datasets.", "DIR", TAN_SOURCE_DIR "/../shared/data"});
    parser.addOption({"model", "Turn this model in place of these; may be repeated.", "FILE.tan"});
    parser.addOption({"error", "The mesh's, in %; without it what the window shows at first.", "PERCENT"});
    parser.addOption({"edits-only", "Measure edits alone."});
    parser.addOption({"turns-only", "Measure no edits."});
    parser.addOption({"events", "Measure what the window takes for its events, and nothing else."});
    parser.addOption({"acts", "How much is done in the window then.", "N", "1000"});
    parser.process(application);
    if (parser.isSet("events"))
        keepHeapSteady(); // as the program does
    const QTemporaryDir folder;
    std::vector<BenchCase> cases;
    for (const auto& [name, model] : modelsOf(host, parser, folder)) {
        if (!model) {
            std::fprintf(stderr, "%s\n", model.error().text().c_str());
            return 4;
        }
        if (parser.isSet("events")) {
            std::ranges::move(eventCases(application, host, (*model)->path(), name, parser.value("acts").toInt()),
                              std::back_inserter(cases));
            continue;
        }
        const double error = parser.isSet("error") ? parser.value("error").toDouble() : startingError(**model);
        const QStringList sides = parser.value("picture").split('x');
        const Look look{sides.value(0).toInt(), sides.value(1).toInt(), parser.isSet("lit")};
        if (look.width <= 0 || look.height <= 0)
            qFatal("--picture takes a size such as 1280x800.");
        if (!parser.isSet("edits-only"))
            cases.push_back(measure(*model, name, error, look, parser.value("threads").toInt()));
        if (parser.isSet("turns-only"))
            continue;
        cases.push_back(cameraDrag(host, (*model)->path(), name));
        std::ranges::move(editToPicture(host, (*model)->path(), name), std::back_inserter(cases));
    }
    printReport("interaction", cases, parser.isSet("json"));
    return 0;
}
