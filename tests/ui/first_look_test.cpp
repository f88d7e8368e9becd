// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/host/dataset_opening.h"
#include "tests/lacks.h"
#include "tests/ui/window_fixture.h"
#include "ui/scenes/picture_image.h"
#include "ui/widgets/motion.h"

#include <tan/data.h>
#include <tan/render.h>

#include <QFileDialog>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>

#include <cmath>
#include <span>

using namespace tetra;

/// What is seen first of data that nobody has looked at: a surface that is one, in a picture that it fills, with smooth
/// edges, the right way up after a click, and colours that fit the whole of the data.
class FirstLookTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void init();
    void cleanup();
    void theIsovalueLiesOnASurface();
    void theIsovalueOfRealData_data();
    void theIsovalueOfRealData();
    void coloursFollowTheFinishedModel();
    void whatWasChosenWhileItGrewStays();
    void opacitiesBeginAboveTheErrorThatIsShown();
    void whatMayBeErrorAloneIsTold();
    void fitFillsTheFrame_data();
    void fitFillsTheFrame();
    void theFirstPictureFillsTheFrameOfAnyWindow();
    void edgesAreSmoothAtRest();
    void theHeadIsTurnedUpright();
    void theOrientationIsKeptInTheSession();

private:
    void open(const Dataset& dataset, double errorPercent);
    Session& session() const { return window_->workbench.session(); }
    void trigger(const QString& action) const;

    std::unique_ptr<WindowFixture> window_;
};

namespace {

/// A ball of 1000 in 0 with a slope between, and a speck of 4000: the middle of the range is nothing.
Dataset ballWithSpeck(std::uint32_t size)
{
    Dataset dataset;
    dataset.lattice.size = {size, size, size};
    dataset.source.name = "ball";
    const auto samples = allocateSamples(SampleType::Float32, dataset.lattice.pointCount());
    if (!samples)
        qFatal("%s", samples.error().text().c_str());
    auto* values = reinterpret_cast<float*>(samples->get());
    const double middle = (size - 1) / 2.0;
    for (std::uint64_t point = 0; point < dataset.lattice.pointCount(); ++point) {
        const double distance = (dataset.position(point) - Eigen::Vector3d::Constant(middle)).norm();
        values[point] = static_cast<float>(500 - 500 * std::tanh((distance - 0.6 * middle) / 1.5));
    }
    values[dataset.lattice.pointCount() / 2] = 4000;
    dataset.values = ScalarField(SampleType::Float32, dataset.lattice.pointCount(), *samples);
    return dataset;
}

/// By how much of half the picture's width and height the places reach from its middle.
double reachOf(const Camera& camera, std::span<const Eigen::Vector3d> places, double aspectRatio)
{
    Eigen::AlignedBox3d bounds;
    for (const Eigen::Vector3d& place : places)
        bounds.extend(place);
    double reach = 0;
    for (const Eigen::Vector3d& place : places) {
        const Eigen::Vector4d clip =
            projectionMatrix(camera, aspectRatio, bounds) * viewMatrix(camera) * place.homogeneous();
        reach = std::max(reach, clip.hnormalized().head<2>().cwiseAbs().maxCoeff());
    }
    return reach;
}

double shapeOf(const QWidget& view)
{
    return static_cast<double>(view.width()) / view.height();
}

} // namespace

void FirstLookTest::initTestCase()
{
    QCoreApplication::setOrganizationName("TAn");
    QCoreApplication::setApplicationName("first look");
    QLocale::setDefault(QLocale::c());
}

void FirstLookTest::init()
{
    QSettings().clear();
    setMotionReduced(true);
    window_ = std::make_unique<WindowFixture>();
    window_->window.show();
}

void FirstLookTest::cleanup()
{
    window_.reset();
}

void FirstLookTest::open(const Dataset& dataset, double errorPercent)
{
    const auto path = buildSampleModel(*window_->host, dataset, window_->folderPath(), errorPercent);
    window_->window.open(QString::fromStdString(path));
    QTRY_VERIFY_WITH_TIMEOUT(session().model() && window_->settled(), 60'000);
}

void FirstLookTest::trigger(const QString& action) const
{
    auto* found = window_->window.findChild<QAction*>(action);
    QVERIFY2(found != nullptr, qPrintable(action));
    QVERIFY2(found->isEnabled(), qPrintable(action));
    found->trigger();
}

void FirstLookTest::theIsovalueLiesOnASurface()
{
    open(ballWithSpeck(33), 0);
    const double value = session().view().isovalues.front().value;
    QVERIFY2(value > 200 && value < 800, qPrintable(QString::number(value)));
}

/// Skin or skull, the casting, the atoms' shells: what who knows the data would choose.
void FirstLookTest::theIsovalueOfRealData_data()
{
    QTest::addColumn<QString>("file");
    QTest::addColumn<double>("error");
    QTest::addColumn<double>("least");
    QTest::addColumn<double>("largest");
    QTest::newRow("headsq") << "regular/headsq_64x64x93_int16.nrrd" << 2.0 << 1100.0 << 1700.0;
    QTest::newRow("neghip") << "regular/neghip_64x64x64_uint8.nhdr" << 2.0 << 40.0 << 200.0;
    QTest::newRow("bucky") << "buckyball/bucky_32x32x32_uint8.nhdr" << 1.0 << 90.0 << 150.0;
    QTest::newRow("lobster") << "regular/lobster_120x120x34_uint8.nrrd" << 4.0 << 30.0 << 115.0;
}

void FirstLookTest::theIsovalueOfRealData()
{
    QFETCH(QString, file);
    QFETCH(double, error);
    QFETCH(double, least);
    QFETCH(double, largest);
    const QString path = TAN_SOURCE_DIR "/../shared/data/" + file;
    if (!QFile::exists(path))
        QSKIP_WITHOUT("data");
    const auto dataset = openDataset(*window_->host, path.toStdString());
    QVERIFY(dataset.ok());
    open(*dataset, error);
    const double value = session().view().isovalues.front().value;
    QVERIFY2(value > least && value < largest, qPrintable(QString::number(value)));
}

/// As they are when the same model is opened anew, however much of it was seen when it began to grow.
void FirstLookTest::coloursFollowTheFinishedModel()
{
    window_->window.open(QString::fromStdString(writeNrrd(sampleDataset(96), window_->folderPath())));
    QTRY_VERIFY(window_->workbench.opening().datasets().dataset());
    QSignalSpy grown(&session(), &Session::modelGrown);
    QTest::mouseClick(&window_->find<QPushButton>("build.start"), Qt::LeftButton);
    QTRY_VERIFY(session().model() != nullptr);
    trigger("action.mode.volume"); // looking at it otherwise is no choice of colours
    QTRY_VERIFY_WITH_TIMEOUT(!window_->workbench.building().running(), 60'000);
    QTRY_VERIFY(!window_->workbench.building().showsBuild() && !grown.isEmpty());
    const Appearance built = session().view().appearance;
    const auto isovalues = session().view().isovalues;

    const std::filesystem::path model = session().model()->path();
    WindowFixture fresh;
    fresh.workbench.opening().views().forget(model);
    fresh.window.open(QString::fromStdString(model.string()));
    QTRY_VERIFY(fresh.workbench.session().model() != nullptr);
    QVERIFY(built.transfer == fresh.workbench.scenes().startingView().appearance.transfer);
    QVERIFY(isovalues == fresh.workbench.scenes().startingView().isovalues);
    QCOMPARE(built.mode, std::string("volume"));
}

/// Of values from 0 to 4000, most of which are 0: until somebody edits the function.
void FirstLookTest::opacitiesBeginAboveTheErrorThatIsShown()
{
    open(ballWithSpeck(33), 0);
    trigger("action.mode.volume");
    const auto extinctionAt = [this](double value) {
        return evaluate(session().view().appearance.transfer, value).extinction;
    };
    session().setError(1);
    QCOMPARE(extinctionAt(40), 0.0);
    QVERIFY(extinctionAt(120) > 0);
    session().setError(4);
    QCOMPARE(extinctionAt(160), 0.0);
    QVERIFY(extinctionAt(400) > 0);
    QTRY_VERIFY(window_->settled());
    QVERIFY(!window_->find<QLabel>("status.remarks").isVisible());
    session().undoStack().undo();
    QVERIFY(extinctionAt(120) > 0);

    TransferFunction chosen = session().view().appearance.transfer;
    chosen.opacities.back().opacity = 0.7F;
    session().setTransfer(chosen);
    session().setError(4);
    QVERIFY(session().view().appearance.transfer == chosen);
    QTRY_VERIFY(window_->settled() && window_->find<QLabel>("status.remarks").isVisible());
}

void FirstLookTest::whatMayBeErrorAloneIsTold()
{
    open(ballWithSpeck(33), 0);
    session().setError(1);
    const auto& remarks = window_->find<QLabel>("status.remarks");
    QTRY_VERIFY(window_->settled());
    QVERIFY(!remarks.isVisible());
    Isovalue isovalue = session().view().isovalues.front();
    isovalue.value = 20;
    session().setIsovalue(0, isovalue);
    QTRY_VERIFY(remarks.isVisible());
    QVERIFY2(remarks.toolTip().contains("The isovalue 20 is within the displayed error, 40,"),
             qPrintable(remarks.toolTip()));
    session().setError(0.1);
    QTRY_VERIFY(!remarks.isVisible());
}

void FirstLookTest::whatWasChosenWhileItGrewStays()
{
    window_->window.open(QString::fromStdString(writeNrrd(sampleDataset(96), window_->folderPath())));
    QTRY_VERIFY(window_->workbench.opening().datasets().dataset());
    QTest::mouseClick(&window_->find<QPushButton>("build.start"), Qt::LeftButton);
    QTRY_VERIFY(session().model() != nullptr);
    TransferFunction chosen = session().view().appearance.transfer;
    chosen.opacities.front().opacity = 0.7F;
    session().setTransfer(chosen);
    Isovalue isovalue = session().view().isovalues.front();
    isovalue.value = 11;
    session().setIsovalue(0, isovalue);
    QTRY_VERIFY_WITH_TIMEOUT(!window_->workbench.building().running(), 60'000);
    QTRY_VERIFY(!window_->workbench.building().showsBuild());
    QVERIFY(session().view().appearance.transfer == chosen);
    QCOMPARE(session().view().isovalues.front().value, 11.0);
}

void FirstLookTest::fitFillsTheFrame_data()
{
    QTest::addColumn<QSize>("size");
    QTest::addColumn<bool>("perspective");
    for (const QSize size : {QSize(1280, 800), QSize(1100, 1000), QSize(1900, 700)})
        for (const bool perspective : {true, false})
            QTest::addRow("%dx%d %d", size.width(), size.height(), perspective) << size << perspective;
}

void FirstLookTest::fitFillsTheFrame()
{
    QFETCH(QSize, size);
    QFETCH(bool, perspective);
    open(sampleDataset(10), 0);
    window_->window.resize(size);
    Viewport& viewport = window_->viewport();
    QCoreApplication::processEvents();
    for (int turn = 0; turn < 12; ++turn) {
        Camera camera = turned(Camera(), 37 * turn, 13 * turn - 90);
        camera.perspective = perspective;
        viewport.setCamera(camera);
        trigger("action.fit");
        const double reach = reachOf(viewport.camera(), window_->workbench.scenes().extent().object, shapeOf(viewport));
        QVERIFY2(reach <= 1 && reach > 0.93, qPrintable(QString::number(reach)));
    }
}

/// Also when the window changes its shape before anybody has moved the camera; not after.
void FirstLookTest::theFirstPictureFillsTheFrameOfAnyWindow()
{
    open(sampleDataset(10), 0);
    Viewport& viewport = window_->viewport();
    const auto reach = [&] {
        return reachOf(viewport.camera(), window_->workbench.scenes().extent().object, shapeOf(viewport));
    };
    for (const QSize size : {QSize(1280, 800), QSize(1000, 1000), QSize(1800, 700)}) {
        window_->window.resize(size);
        QTRY_VERIFY2(reach() <= 1 && reach() > 0.93, qPrintable(QString::number(reach())));
    }
    QCOMPARE(session().undoStack().count(), 0);
    QTest::keyClick(&viewport, Qt::Key_Left);
    const Camera chosen = viewport.camera();
    window_->window.resize(900, 800);
    QCoreApplication::processEvents();
    QVERIFY(viewport.camera() == chosen);
}

/// As smooth as saved pictures are.
void FirstLookTest::edgesAreSmoothAtRest()
{
    open(sampleDataset(16), 0);
    const Viewport& viewport = window_->viewport();
    PictureOptions options;
    options.width = viewport.width();
    options.height = viewport.height();
    options.background = viewport.background();
    options.samplesPerAxis = 4;
    const auto saved = makeCpuBackend()->render(*viewport.scene(), viewport.camera(), options);
    QVERIFY(saved.ok());
    QVERIFY(viewport.picture().convertToFormat(QImage::Format_RGB32) ==
            imageOf(*saved).convertToFormat(QImage::Format_RGB32));
    window_->window.resize(window_->window.size() * 0.9);
    QTest::keyClick(&window_->viewport(), Qt::Key_Left);
    QVERIFY(!viewport.settled());
    QTRY_VERIFY(viewport.settled());
}

/// A scan whose z axis points down is upright after one action.
void FirstLookTest::theHeadIsTurnedUpright()
{
    open(sampleDataset(10), 0);
    const Camera before = window_->viewport().camera();
    trigger("action.up.minusZ");
    const Eigen::Vector3d seen =
        viewMatrix(window_->viewport().camera()).topLeftCorner<3, 3>() * -Eigen::Vector3d::UnitZ();
    QVERIFY2(seen.y() > 0.9 && std::abs(seen.x()) < 1e-9, "z points down in the picture");
    QCOMPARE(session().undoStack().count(), 1);
    trigger("action.undo");
    QVERIFY(window_->viewport().camera() == before);
    trigger("action.flip");
    QVERIFY((viewMatrix(window_->viewport().camera()).topLeftCorner<3, 3>() * -Eigen::Vector3d::UnitY()).y() > 0.9);
}

void FirstLookTest::theOrientationIsKeptInTheSession()
{
    open(sampleDataset(10), 0);
    trigger("action.up.y");
    trigger("action.rollRight");
    trigger("action.trackball");
    QTest::keyClick(&window_->viewport(), Qt::Key_Up);
    const Camera camera = window_->viewport().camera();
    const QString file = window_->folder.filePath("head.tansession");
    QSignalSpy saved(&window_->workbench.opening().sessionFile(), &SessionFile::saved);
    trigger("action.saveSessionAs");
    auto& dialog = window_->find<QFileDialog>("sessionDialog");
    emit dialog.fileSelected(file);
    dialog.reject();
    QTRY_COMPARE(saved.count(), 1);
    WindowFixture other;
    other.window.show();
    other.window.open(file);
    QTRY_VERIFY(other.workbench.session().model() != nullptr);
    QTRY_VERIFY(other.viewport().camera() == camera);
    QVERIFY(other.find<QAction>("action.trackball").isChecked());
    QVERIFY(other.find<QAction>("action.up.y").isChecked());
}

QTEST_MAIN(FirstLookTest)
#include "first_look_test.moc"
