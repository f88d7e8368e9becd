// SPDX-License-Identifier: GPL-3.0-or-later
/// Each editor plugin has a dock, and edits the parameters of its type, whoever's they are and however many (R18).
#include "tests/ui/window_fixture.h"

#include "plugins/widgets/colour_button.h"
#include "ui/panels/session_editor_host.h"
#include "ui/viewport/value_pick.h"
#include "ui/widgets/mnemonics.h"

#include <tan/view.h>

#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLabel>

using namespace tetra;

namespace {

std::unique_ptr<PluginHost> hostWithExamples()
{
    return std::make_unique<PluginHost>(PluginHostOptions{.folders = {TAN_BINARY_DIR "/tests/ui-fixtures/editors",
                                                                      TAN_BINARY_DIR "/tests/ui-fixtures/renderers",
                                                                      TAN_BINARY_DIR "/lib/tan/plugins"}});
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
        QVERIFY(!window_->find<QDoubleSpinBox>("example.band.low").isEnabled()); // this mode has no band
        window_->find<QAction>("action.dock.example.band-editor").trigger();
        QVERIFY(dock.isHidden());
    }

    void aModeBringsItsEditorToTheFront()
    {
        const auto& band = window_->find<QDockWidget>("dock.example.band-editor");
        const auto& transfer = window_->find<QDockWidget>("dock.transfer");
        const auto& isovalues = window_->find<QDockWidget>("dock.isovalues");
        const auto isInFront = [](const QDockWidget& dock) { return !dock.visibleRegion().isEmpty(); };
        QTRY_VERIFY(isInFront(isovalues) && !isInFront(band) && !isInFront(transfer));
        chooseMode("example.band");
        QTRY_VERIFY(isInFront(band));
        chooseMode("volume");
        QTRY_VERIFY(isInFront(transfer) && !isInFront(band));
        chooseMode("isosurface");
        QTRY_VERIFY(isInFront(isovalues));
        window_->find<QAction>("action.dock.example.band-editor").trigger();
        window_->find<QAction>("action.dock.transfer").trigger();
        chooseMode("example.band");
        QVERIFY(band.isHidden()); // the user has closed it
        chooseMode("volume");
        QVERIFY(transfer.isHidden());
    }

    void anEditorSaysWhatTheModeLacks()
    {
        const auto& band = window_->find<QLabel>("example.band-editor.hint");
        const auto& transfer = window_->find<QLabel>("transfer.hint");
        const auto& low = window_->find<QDoubleSpinBox>("example.band.low");
        QVERIFY(!band.isHidden() && !transfer.isHidden());
        const QString mode = withoutMnemonic(window_->find<QAction>("action.mode.isosurface").text());
        QCOMPARE(band.text(), "The mode " + mode + " has nothing to edit here. Choose another mode.");
        QCOMPARE(transfer.text(),
                 "The mode " + mode + " does not use a transfer function. Changes appear in other modes.");
        QVERIFY(!low.isEnabled());
        QVERIFY(window_->find<QWidget>("transfer.canvas").isEnabled()); // it can be prepared
        chooseMode("example.band");
        QVERIFY(band.isHidden() && low.isEnabled() && !transfer.isHidden());
        chooseMode("volume");
        QVERIFY(!band.isHidden() && !low.isEnabled() && transfer.isHidden());
        window_->find<QAction>("action.close").trigger();
        QTRY_VERIFY(!session().model());
        QVERIFY(band.isHidden() && transfer.isHidden()); // there is no mode without a model
    }

    void theChosenTransferFunctionIsDraggedInThePicture()
    {
        session().setMode("example.two-functions");
        showEditor();
        QTRY_VERIFY(window_->settled() && widthOf("bones") > 0);
        const Appearance before = session().view().appearance;
        chooseFunction(Qt::Key_Down);
        dragInPicture({60, -20});
        QCOMPARE(chosenFunctions(), std::vector<std::string>{"veins"});
        QVERIFY(session().view().appearance.transfer == before.transfer);
        session().undoStack().undo();
        QVERIFY(session().view().appearance == before);
        chooseFunction(Qt::Key_Up);
        dragInPicture({60, -20});
        QCOMPARE(chosenFunctions(), std::vector<std::string>{"bones"});
        session().undoStack().undo();
        session().setMode("volume");
        dragInPicture({60, -20});
        QVERIFY(session().view().appearance.transfer != before.transfer);
        QVERIFY(chosenFunctions().empty());
    }

    void thePickedValueGoesToTheChosenTransferFunction()
    {
        session().setMode("volume");
        QTRY_VERIFY(window_->settled());
        auto& pick = window_->find<ValuePick>("viewport.pick");
        pick.pickAt(window_->viewport().rect().center());
        QTRY_VERIFY(pick.picked().has_value());
        const double value = pick.picked()->value;
        session().setMode("example.two-functions");
        showEditor();
        chooseFunction(Qt::Key_Down);
        const Appearance before = session().view().appearance;
        window_->find<QAction>("action.pointHere").trigger();
        QCOMPARE(chosenFunctions(), std::vector<std::string>{"veins"});
        QVERIFY(session().view().appearance.transfer == before.transfer);
        const auto points =
            transferPoints(std::get<TransferFunction>(session().view().appearance.settings.at("veins")));
        QVERIFY(std::ranges::find(points, value, &TransferPoint::value) != points.end());
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

    void ofSeveralTransferFunctionsOneIsChosen()
    {
        session().setMode("volume");
        const auto& chooser = window_->find<QComboBox>("transfer.function");
        const auto& unitDistance = window_->find<QDoubleSpinBox>("transfer.unitDistance");
        showEditor();
        QTRY_VERIFY(unitDistance.isVisible());
        QVERIFY(!chooser.isVisible());
        session().setMode("example.two-functions");
        QVERIFY(chooser.isVisible());
        QCOMPARE(chooser.count(), 2);
        QCOMPARE(chooser.itemText(0), QString("Bones"));
        QCOMPARE(chooser.itemText(1), QString("Veins"));
        QCOMPARE(chooser.currentIndex(), 0);
        const double ofBones = unitDistance.value();
        chooseFunction(Qt::Key_Down);
        QCOMPARE(chooser.currentIndex(), 1);
        QVERIFY(std::abs(unitDistance.value() - 2 * ofBones) < 0.02 * ofBones); // as numbers are shown
        session().setMode("volume");
        QVERIFY(!chooser.isVisible());
        session().setMode("example.two-functions");
        QCOMPARE(chooser.currentIndex(), 1); // it stays chosen
    }

    void theChosenTransferFunctionIsEdited()
    {
        session().setMode("example.two-functions");
        showEditor();
        QTRY_VERIFY(window_->settled() && widthOf("bones") > 0);
        const Appearance before = session().view().appearance;
        const float bones = widthOf("bones"), veins = widthOf("veins");
        chooseFunction(Qt::Key_Down);
        const int steps = session().undoStack().index();
        addPoint();
        QCOMPARE(session().undoStack().index(), steps + 1);
        QCOMPARE(session().undoStack().undoText(), QString("Change Transfer Function"));
        QVERIFY(session().view().appearance.transfer == before.transfer); // that of the other modes
        QCOMPARE(chosenFunctions(), std::vector<std::string>{"veins"});
        QTRY_VERIFY(window_->settled() && widthOf("veins") > veins);
        QCOMPARE(widthOf("bones"), bones);
        QCOMPARE(settingsKept(), session().view().appearance.settings);
        chooseFunction(Qt::Key_Up);
        addPoint();
        QCOMPARE(chosenFunctions(), (std::vector<std::string>{"bones", "veins"}));
        QTRY_VERIFY(window_->settled() && widthOf("bones") > bones);
        const auto colourBar = window_->workbench.scenes().annotations({}, {}).transfer;
        QVERIFY(colourBar == std::get<TransferFunction>(session().view().appearance.settings.at("bones")));
        session().undoStack().undo();
        session().undoStack().undo();
        QVERIFY(session().view().appearance == before);
        QTRY_VERIFY(window_->settled() && widthOf("veins") == veins);
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
    /// As the user does.
    void chooseMode(const char* mode) const { window_->find<QAction>(QString("action.mode.") + mode).trigger(); }
    /// With Ctrl.
    void dragInPicture(QPoint by) const
    {
        Viewport& viewport = window_->viewport();
        const QPoint from = viewport.rect().center();
        QTest::mousePress(&viewport, Qt::LeftButton, Qt::ControlModifier, from);
        QMouseEvent move(QEvent::MouseMove, from + by, viewport.mapToGlobal(from + by), Qt::NoButton, Qt::LeftButton,
                         Qt::ControlModifier);
        QCoreApplication::sendEvent(&viewport, &move);
        QTest::mouseRelease(&viewport, Qt::LeftButton, Qt::ControlModifier, from + by);
    }
    void showEditor() const
    {
        auto& dock = window_->find<QDockWidget>("dock.transfer");
        dock.show();
        dock.raise();
    }
    void chooseFunction(Qt::Key key) const { QTest::keyClick(&window_->find<QWidget>("transfer.function"), key); }
    void addPoint() const { QTest::keyClick(&window_->find<QWidget>("transfer.canvas"), Qt::Key_Insert); }
    /// Of a drawable of the scene that is seen, which is an outline.
    float widthOf(const char* drawable) const
    {
        const Drawable* found = drawableOf(*window_->viewport().scene(), drawable);
        const auto* lines = found != nullptr ? std::get_if<LineSet>(&found->shape) : nullptr;
        return lines != nullptr ? lines->width : 0;
    }
    std::vector<std::string> chosenFunctions() const
    {
        std::vector<std::string> ids;
        for (const auto& [id, value] : session().view().appearance.settings)
            if (std::holds_alternative<TransferFunction>(value))
                ids.push_back(id);
        return ids;
    }
    /// As a session that is saved and opened again has them.
    ParameterValues settingsKept() const
    {
        const auto again = viewFromText(viewToText(session().view()));
        return again ? again->appearance.settings : ParameterValues();
    }

    QTemporaryDir folder_;
    QString model_;
    std::unique_ptr<WindowFixture> window_;
};

QTEST_MAIN(EditorDocksTest)
#include "editor_docks_test.moc"
