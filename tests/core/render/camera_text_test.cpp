// SPDX-License-Identifier: GPL-3.0-or-later
// Cameras as JSON texts.
#include <tan/render.h>

#include <QTest>

#include <random>

using namespace tetra;

namespace {

const Eigen::AlignedBox3d bounds(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(4, 2, 1));

} // namespace

class CameraTextTest : public QObject {
    Q_OBJECT

private slots:
    void comesBackToTheSameBits()
    {
        std::mt19937 random(1);
        std::uniform_real_distribution<double> number(-80, 80);
        for (int round = 0; round < 100; ++round) {
            Camera camera;
            camera.target = {number(random), number(random), 1e-9 * number(random)};
            camera.distance = 1e6 * (number(random) + 81);
            camera.azimuth = number(random);
            camera.elevation = number(random);
            camera.roll = number(random);
            camera.up = static_cast<UpAxis>(round % 6);
            camera.trackball = round % 3 == 0;
            camera.fieldOfView = 90 + number(random);
            camera.perspective = round % 2 == 0;
            const auto back = cameraFromText(cameraToText(camera), bounds);
            QVERIFY(back.ok());
            QCOMPARE(*back, camera);
        }
    }

    void whatIsLeftOpenShowsTheWholeDomain()
    {
        QCOMPARE(*cameraFromText("{}", bounds), fitted(Camera(), bounds));
        Camera wide;
        wide.fieldOfView = 60;
        QCOMPARE(*cameraFromText(R"({"fieldOfView": 60})", bounds), fitted(wide, bounds));
        QCOMPARE(cameraFromText(R"({"distance": 3})", bounds)->distance, 3.0);
    }

    /// Cameras of before there was a roll.
    void olderCamerasAreReadAsTheyWere()
    {
        const auto camera = cameraFromText(
            R"({"azimuth": 1, "elevation": 2, "fieldOfView": 30, "perspective": true, "target": [1, 2, 3],
                               "distance": 4})",
            bounds);
        QVERIFY(camera.ok());
        QCOMPARE(*camera, (Camera{.target = {1, 2, 3}, .distance = 4, .azimuth = 1, .elevation = 2}));
        QCOMPARE(cameraFromText(R"({"up": "-z"})", bounds, 2)->distance,
                 fitted(upright(Camera(), UpAxis::MinusZ), bounds, 2).distance);
    }

    void mistakesAreNamed_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("message");
        QTest::newRow("no JSON") << "{"
                                 << "not a camera";
        QTest::newRow("no object") << "[1]"
                                   << "no JSON object";
        QTest::newRow("unknown key") << R"({"zoom": 1})"
                                     << "\"zoom\" of the camera is not known (line 1";
        QTest::newRow("no number") << R"({"azimuth": "north"})"
                                   << "\"azimuth\" of the camera is not a number";
        QTest::newRow("out of bounds") << R"({"elevation": 91})"
                                       << "from -90 to 90";
        QTest::newRow("no truth") << R"({"perspective": 1})"
                                  << "neither true nor false";
        QTest::newRow("two numbers") << R"({"target": [1, 2]})"
                                     << "list of three numbers";
        const auto row = [](const char* name, const QString& text, const char* message) {
            QTest::newRow(name) << text << QString(message);
        };
        row("empty", "", "not a camera");
        row("binary", QString(QChar(1)) + "NRRD", "not a camera");
        row("cut short", "{\"azimuth\": 3", "not a camera");
        row("no axis", R"({"up": "w"})", "\"up\" of the camera is not one of x, -x, y, -y, z and -z");
        row("an axis as a number", R"({"up": 2})", "\"up\" of the camera is not one of");
        row("no roll", R"({"roll": "left"})", "\"roll\" of the camera is not a number");
        row("no trackball", R"({"trackball": 1})", "neither true nor false");
        row("twice", R"({"azimuth": 3, "azimuth": 4})", "twice");
        row("NaN", R"({"azimuth": NaN})", "not a camera");
        row("larger than any number", R"({"azimuth": 1e999})", "\"azimuth\" of the camera is not a number");
        row("negative distance", R"({"distance": -1})", "\"distance\" of the camera is not a number");
        row("no field of view", R"({"fieldOfView": 0})", "\"fieldOfView\" of the camera is not a number");
        row("null", R"({"target": null})", "list of three numbers");
        row("four numbers", R"({"target": [1, 2, 3, 4]})", "list of three numbers");
        row("a text in the list", R"({"target": [1, 2, "3"]})", "list of three numbers");
        row("too deep", QString(100000, '['), "levels");
        row("a key that controls terminals", "{\"\\u001b[2J\": 1}", "\"\\x1b[2J\" of the camera is not known");
        QTest::newRow("no distance") << R"({"distance": 0})"
                                     << "\"distance\" of the camera is not a number";
    }

    void mistakesAreNamed()
    {
        QFETCH(QString, text);
        QFETCH(QString, message);
        const auto camera = cameraFromText(text.toStdString(), bounds);
        QVERIFY(!camera.ok());
        QVERIFY2(QString::fromStdString(camera.error().text()).contains(message), camera.error().text().c_str());
    }
};

QTEST_APPLESS_MAIN(CameraTextTest)
#include "camera_text_test.moc"
