// SPDX-License-Identifier: GPL-3.0-or-later
// How the controls of the dock Build are driven.
#include "plugins/host/file_saving.h"
#include "plugins/host/model_building.h"
#include "plugins/samples/samples.h"
#include "tests/ui/driving/driver.h"
#include "tests/waiting.h"
#include "ui/panels/build_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>

#include <algorithm>

namespace tetra {
namespace {

/// So large that its build is seen at work.
constexpr std::uint32_t largeSide = 96;

void typeInto(QWidget& control, const QString& text)
{
    control.setFocus();
    QTest::keyClick(&control, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(&control, text);
    QTest::keyClick(&control, Qt::Key_Tab);
}

/// Until it is known what is there already.
void setTarget(const DrivenWindow& window, const QString& path)
{
    window.find<QLineEdit>("build.target").setText(path);
    if (!waitFor([&] { return !window.find<BuildPanel>("build").looking(); }, 30'000))
        qFatal("it is not known what is there already");
}

void chooseBuilder(DrivenWindow& window, const QString& id)
{
    window.raise("dock.build");
    auto& builder = window.find<QComboBox>("build.builder");
    builder.setCurrentIndex(builder.findData(id));
    setTarget(window, window.folder.filePath("driven.tan"));
    QCoreApplication::processEvents(); // the form of the builder is seen
}

Driver::Step withBuilder(const QString& id)
{
    return [id](DrivenWindow& window) { chooseBuilder(window, id); };
}

/// With a dataset on a curvilinear grid, for what only such data need; or with another sample, "part" for a mesh.
Driver::Step withGrid(const QString& builder, const std::string& sample = "bent-duct")
{
    return [builder, sample](DrivenWindow& window) {
        const auto path = window.folderPath() + (sample == "part" ? "/mesh.vtu" : "/grid.xyz");
        SampleRequest request;
        request.name = sample;
        request.size = 8;
        const auto grid = makeSample(request);
        if (!grid || !saveDataset(*window.host, *grid, path))
            qFatal("the grid could not be made");
        window.workbench.opening().datasets().importDataset(path, {}); // as if what the window asks were answered
        if (!waitFor([&] { return window.workbench.opening().datasets().dataset()->source.path == path; }, 30'000))
            qFatal("the grid did not open");
        chooseBuilder(window, builder);
    };
}

/// Another model comes of it, or none.
Driver building(const QString& name, Driver::Condition shows, Driver::Step prepare, Driver::Step use = {})
{
    Driver driver = showing(name, std::move(shows), std::move(prepare), std::move(use));
    driver.opensAnother = true;
    return driver;
}

bool isBuilt(const DrivenWindow& window)
{
    return !window.workbench.building().running() && window.session().model() &&
           window.session().model()->path().filename() == "driven.tan";
}

std::string parameterOf(const DrivenWindow& window, const std::string& id)
{
    const auto& parameters = window.session().model()->description().parameters;
    const auto found = std::ranges::find(parameters, id, &std::pair<std::string, std::string>::first);
    return found == parameters.end() ? std::string() : found->second;
}

/// The model says by what it was built.
Driver option(const QString& id, const Driver::Step& prepare, const std::string& expected,
              const std::function<void(QWidget&)>& use)
{
    const QString name = "build.option." + id;
    return building(
        name,
        [id, expected](const DrivenWindow& window) {
            return isBuilt(window) && parameterOf(window, id.toStdString()) == expected;
        },
        prepare,
        [name, use](DrivenWindow& window) {
            use(window.find<QWidget>(name));
            window.press("build.start", Qt::Key_Space);
        });
}

Driver steppedOption(const QString& id, const Driver::Step& prepare, const std::string& expected)
{
    return option(id, prepare, expected, &useByKeys);
}

Driver typedOption(const QString& id, const Driver::Step& prepare, const QString& text)
{
    return option(id, prepare, text.toStdString(), [text](QWidget& control) { typeInto(control, text); });
}

/// The model was built down to that error.
Driver detail(const QString& name, const std::string& error)
{
    return building(
        "build.detail." + name,
        [error](const DrivenWindow& window) { return isBuilt(window) && parameterOf(window, "error") == error; },
        [](DrivenWindow& window) {
            chooseBuilder(window, "refinement");
            window.find<QDoubleSpinBox>("build.option.error").setValue(50); // none is chosen
        },
        [name](DrivenWindow& window) {
            window.press("build.detail." + name, Qt::Key_Space);
            window.press("build.start", Qt::Key_Space);
        });
}

void openSample(DrivenWindow& window, std::uint32_t side)
{
    const auto path = writeNrrd(sampleDataset(side), window.folderPath());
    window.window.open(QString::fromStdString(path));
    if (!waitFor([&] { return window.workbench.opening().datasets().dataset()->source.path == path; }, 30'000))
        qFatal("the sample did not open");
    chooseBuilder(window, "refinement");
}

void beginBuilding(DrivenWindow& window, const QString& target)
{
    window.workbench.opening().models().close();
    openSample(window, largeSide);
    setTarget(window, window.folder.filePath(target));
    window.press("build.start", Qt::Key_Space);
    if (!waitFor([&] { return window.session().model() != nullptr; }, 60'000))
        qFatal("the build did not begin");
}

Driver::Step ofBuilding(const QString& target)
{
    return [target](DrivenWindow& window) { beginBuilding(window, target); };
}

/// One that was ordered so.
void beginResumable(DrivenWindow& window)
{
    window.raise("dock.build");
    window.find<QCheckBox>("build.resume").setChecked(false);
    window.press("build.resume", Qt::Key_Space);
    beginBuilding(window, "paused.tan");
}

void leaveBuild(DrivenWindow& window)
{
    openSample(window, 32);
    std::stop_source stop;
    const Progress progress(stop.get_token(), [&](double fraction, const Message&) {
        if (fraction > 0.1)
            stop.request_stop();
    });
    const auto path = window.folderPath() + "/left.tan";
    (void)buildModel(*window.host, *window.workbench.opening().datasets().dataset(), "refinement", {}, path, progress,
                     {.resume = true});
    setTarget(window, QString::fromStdString(path));
}

} // namespace

Drivers buildControls()
{
    const QString refinement = "refinement";
    const QString decimation = "decimation";
    return {
        opening("build.differently", "importDialog", inDock("dock.build")),
        showing(
            "build.builder",
            [](const DrivenWindow& window) {
                return window.find<QComboBox>("build.builder").currentData().toString() == "decimation";
            },
            withBuilder(refinement),
            [](DrivenWindow& window) {
                auto& builder = window.find<QComboBox>("build.builder");
                const bool isBelow = builder.findData("decimation") > builder.currentIndex();
                window.press("build.builder", isBelow ? Qt::Key_Down : Qt::Key_Up);
            }),
        showing(
            "build.target", [](const DrivenWindow& window) { return window.isOpen("build.targetHint"); },
            withBuilder(refinement),
            [](DrivenWindow& window) {
                typeInto(window.find<QWidget>("build.target"),
                         QString::fromStdString(window.session().model()->path().string()));
            }),
        opening("build.browse", "build.targetDialog", inDock("dock.build")),
        building("build.start", &isBuilt, withBuilder(refinement)),
        building(
            "build.cancel",
            [](const DrivenWindow& window) {
                return !window.workbench.building().running() && !window.session().model();
            },
            ofBuilding("driven.tan")),
        building("build.keep", &isBuilt, ofBuilding("driven.tan")),
        building(
            "build.openExisting",
            [](const DrivenWindow& window) {
                return window.session().model() && window.session().model()->path().filename() == "existing.tan";
            },
            [](DrivenWindow& window) {
                const auto existing = window.folderPath() + "/existing.tan";
                std::filesystem::copy_file(window.session().model()->path(), existing);
                chooseBuilder(window, "refinement");
                setTarget(window, QString::fromStdString(existing));
            }),
        building(
            "build.pause",
            [](const DrivenWindow& window) {
                return !window.workbench.building().running() && window.isOpen("build.interrupted");
            },
            &beginResumable),
        showing(
            "build.resume",
            [](const DrivenWindow& window) { return window.find<QCheckBox>("build.resume").isChecked(); },
            [](DrivenWindow& window) {
                chooseBuilder(window, "refinement");
                window.find<QCheckBox>("build.resume").setChecked(false);
            }),
        showing(
            "build.beginAnew", [](const DrivenWindow& window) { return !window.isOpen("build.interrupted"); },
            &leaveBuild),
        detail("quick", "1"),
        detail("good", "0.1"),
        detail("everything", "0"),
        typedOption("error", withBuilder(refinement), "1.5"),
        typedOption("warping", withGrid(refinement), "1.5"),
        steppedOption("by", withGrid(refinement), "error"),
        typedOption("block", withBuilder(refinement), "4"),
        steppedOption("selection", withGrid(refinement), "paper"),
        steppedOption("error-in", withGrid(refinement), "grid"),
        steppedOption("space", withGrid(refinement, "stretched"), "computational"),
        typedOption("weights", withBuilder(refinement), "value:50,20,0.5"),
        steppedOption("order", withBuilder(decimation), "paper"),
        steppedOption("distance", withGrid(decimation, "part"), "two-sided"),
        typedOption("finest", withBuilder(decimation), "1.5"),
    };
}

} // namespace tetra
