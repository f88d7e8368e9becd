// SPDX-License-Identifier: GPL-3.0-or-later
/// Each editor plugin has a dock, and edits the parameters of its type, whoever's they are (R18).
#include "tests/ui/window_fixture.h"

#include "plugins/widgets/colour_button.h"
#include "ui/panels/session_editor_host.h"
#include "ui/session/view_json.h"
#include "ui/viewport/value_pick.h"

#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLabel>

using namespace tetra;

namespace {

std::unique_ptr<PluginHost> hostWithExamples()
{
    return std::make_unique<PluginHost>(
        PluginHostOptions{.folders = {TAN_BINARY_DIR "/tests/ui-fixtures/editors", TAN_BINARY_DIR "/lib/tan/plugins"}});
}

} // namespace

class EditorDocksTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QCoreApplication::setOrganizationName("TAn");
        QCoreApplication::setApplicationName("editor docks");
        QSettings().clear();
        QLocale::setDefault(QLocale::c());
        model_ = QString::fromStdString(
            buildSampleModel(*hostOfThisBuild(), sampleDataset(10), folder_.path().toStdString()).string());
    }

    void init()
    {
        window_ = std::make_unique<WindowFixture>(BackendChoice::Cpu, hostWithExamples());
        window_->window.show();
        window_->window.open(model_);
        QTRY_VERIFY(session().model() && window_->settled());
    }

    void cleanup() { window_.reset(); }

    void everyEditorHasADock()
    {
        auto& dock = window_->find<QDockWidget>("dock.example.band-editor");
        QCOMPARE(dock.windowTitle(), QString("Band"));
        QCOMPARE(dock.whatsThis(), QString("Edits bands: the values between two limits."));
        QCOMPARE(window_->find<QDockWidget>("dock.transfer").windowTitle(), QString("Transfer"));
        QVERIFY(!dock.widget()->isEnabled()); // this mode has no band
        window_->find<QAction>("action.dock.example.band-editor").trigger();
        QVERIFY(dock.isHidden());
    }

    void anEditorThatFailsSaysSoInItsDock()
    {
        const QString text = window_->find<QLabel>("example.failing.missing").text();
        QVERIFY2(text.contains("no paper left") && text.contains("example.failing"), qPrintable(text));
    }

    void editsAParameterOfAnotherPlugin()
    {
        session().setMode("example.band");
        auto& low = window_->find<QDoubleSpinBox>("example.band.low");
        QTRY_VERIFY(low.isEnabled());
        const ValueRange range = session().range();
        QCOMPARE(low.minimum(), std::round(range.minimum * 100) / 100); // the box's decimals
        const int steps = session().undoStack().index();
        const double middle = (low.minimum() + low.maximum()) / 2;
        low.setValue(middle);
        const double shown = low.value();
        QCOMPARE(session().undoStack().index(), steps + 1);
        const auto band = std::get<OwnValue>(session().view().appearance.settings.at("band"));
        QCOMPARE(band.type, std::string("example.band"));
        QVERIFY(band.text.find("\"low\"") != std::string::npos);
        session().undoStack().undo();
        QCOMPARE(low.value(), low.minimum());
        session().undoStack().redo();
        QCOMPARE(low.value(), shown);

        // A session keeps it.
        QCOMPARE(settingsKept(), session().view().appearance.settings);
        session().setMode("isosurface");
        QVERIFY(!low.isEnabled());
    }

    void anEditorOfIsovaluesEditsThoseOfTheSession()
    {
        SessionEditorHost host(window_->workbench, window_->find<ValuePick>("viewport.pick"), "isovalues");
        QCOMPARE(host.parameters().size(), std::size_t(1));
        const std::string id = host.parameters().front().id;
        QVERIFY(std::get<std::vector<Isovalue>>(host.value(id)) == session().view().isovalues);
        QObject receiver;
        int told = 0;
        host.whenChanged(&receiver, [&told](EditorChange change) { told += change == EditorChange::Value ? 1 : 0; });
        std::vector<Isovalue> two = session().view().isovalues;
        two.push_back(two.front());
        two.back().value = session().range().minimum + session().range().extent() / 8;
        const int steps = session().undoStack().index();
        host.setValue(id, two);
        QVERIFY(session().view().isovalues == two);
        QCOMPARE(session().undoStack().index(), steps + 1);
        QCOMPARE(told, 1);
        QVERIFY(std::get<std::vector<Isovalue>>(host.value(id)) == two);
    }

    void coloursAndVectorsAreInTheForm()
    {
        session().setMode("example.band");
        auto& x = window_->find<QDoubleSpinBox>("rendering.setting.light.x");
        QCOMPARE(x.value(), 1.0);
        QCOMPARE(window_->find<QDoubleSpinBox>("rendering.setting.light.z").value(), 3.0);
        x.setValue(7);
        const auto& settings = session().view().appearance.settings;
        QCOMPARE(std::get<Eigen::Vector3d>(settings.at("light")), Eigen::Vector3d(7, 2, 3));
        auto& paint = window_->find<ColourButton>("rendering.setting.paint");
        QCOMPARE(paint.colour(), QColor(Qt::red));
        paint.setColour(Qt::blue);
        emit paint.colourChosen(Qt::blue);
        QCOMPARE(std::get<Colour>(session().view().appearance.settings.at("paint")), (Colour{0, 0, 1}));
        session().undoStack().undo();
        QCOMPARE(paint.colour(), QColor(Qt::red));
        session().undoStack().undo();
        QCOMPARE(x.value(), 1.0);
        session().undoStack().redo();
        session().undoStack().redo();
        QCOMPARE(settingsKept(), session().view().appearance.settings);
    }

private:
    Session& session() const { return window_->workbench.session(); }
    /// As a session that is saved and opened again has them.
    ParameterValues settingsKept() const
    {
        std::optional<Error> error;
        ViewValue again;
        readView(JsonFields(toJson(session().view()), {}, error), again);
        return error ? ParameterValues() : again.appearance.settings;
    }

    QTemporaryDir folder_;
    QString model_;
    std::unique_ptr<WindowFixture> window_;
};

QTEST_MAIN(EditorDocksTest)
#include "editor_docks_test.moc"
