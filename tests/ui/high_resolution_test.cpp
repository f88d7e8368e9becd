// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/sample_files.h"
#include "ui/viewport/viewport.h"

#include <QApplication>
#include <QTemporaryDir>
#include <QTest>

using namespace tetra;

/// On a screen of two pixels a unit (R26): lines of the picture are as wide as on one of a single pixel.
class HighResolutionTest : public QObject {
    Q_OBJECT
public:
    static void initMain() { qputenv("QT_SCALE_FACTOR", "2"); } // before the application, which reads it
private slots:
    void linesAreAsWideAsElsewhere();
};

void HighResolutionTest::linesAreAsWideAsElsewhere()
{
    constexpr float width = 3;
    auto scene = std::make_shared<Scene>();
    scene->bounds = {Eigen::Vector3d(-1, -1, -1), Eigen::Vector3d(1, 1, 1)};
    scene->drawables.push_back({.id = "line", .shape = LineSet{{{-1, 0, 0}, {1, 0, 0}}, {{0, 1}}, {1, 0, 0}, width}});
    const QTemporaryDir folder;
    const auto host = hostOfThisBuild();
    const auto model = Model::open(buildSampleModel(*host, sampleDataset(8), folder.path().toStdString()));
    QVERIFY(model.ok());
    Session session;
    session.open(*model, {});
    Viewport viewport(session, BackendChoice::Cpu);
    viewport.resize(200, 160);
    static_cast<QWidget&>(viewport).show();
    QCOMPARE(viewport.devicePixelRatioF(), 2.0);
    Camera camera;
    camera.perspective = false;
    camera.azimuth = 0;
    camera.elevation = 0;
    session.setCamera(fitted(camera, scene->bounds));
    session.setBackground(Colour{1, 1, 1});
    viewport.setScene(scene);
    QTRY_VERIFY(viewport.settled());
    const QImage image = viewport.grab().toImage();
    QCOMPARE(image.size(), QSize(400, 320));
    double covered = 0; // of the column through the middle, edges in part
    for (int y = 0; y < image.height(); ++y)
        covered += 1 - image.pixelColor(image.width() / 2, y).blueF();
    QVERIFY2(std::abs(covered - 2 * width) < 0.7, qPrintable(QString::number(covered)));
    QCOMPARE(shapesOf<LineSet>(*viewport.scene()).front()->width, width); // that pictures are made of
}

QTEST_MAIN(HighResolutionTest)
#include "high_resolution_test.moc"
