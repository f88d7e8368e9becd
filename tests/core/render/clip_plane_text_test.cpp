// SPDX-License-Identifier: GPL-3.0-or-later
// Clip planes as text, and back to the same bits.
#include <tan/render.h>

#include <QTest>

#include <cmath>
#include <random>

using namespace tetra;

class ClipPlaneTextTest : public QObject {
    Q_OBJECT

private slots:
    void textsAreReadBack()
    {
        std::mt19937 random(7);
        std::normal_distribution<double> number(0, 1e3);
        for (std::size_t count = 0; count < 20; ++count) {
            std::vector<ClipPlane> planes(count);
            for (ClipPlane& plane : planes)
                plane = {{number(random), number(random), number(random)}, number(random)};
            const auto read = parseClipPlanes(clipPlanesText(planes));
            QVERIFY(read.ok());
            QCOMPARE(read->size(), count);
            for (std::size_t i = 0; i < count; ++i) {
                QCOMPARE((*read)[i].normal, planes[i].normal);
                QCOMPARE((*read)[i].offset, planes[i].offset);
            }
        }
    }

    void blanksAndEmptyEntriesAreNoPlanes()
    {
        QCOMPARE(parseClipPlanes("")->size(), std::size_t(0));
        QCOMPARE(parseClipPlanes(" ; ")->size(), std::size_t(0));
        const auto planes = parseClipPlanes("1, 0 ,0 ,-2.5 ;; 0,-1,0,1e2;");
        QVERIFY(planes.ok());
        QCOMPARE(planes->size(), std::size_t(2));
        QCOMPARE((*planes)[0].offset, -2.5);
        QCOMPARE((*planes)[1].normal, Eigen::Vector3d(0, -1, 0));
    }

    /// Whatever the length of the normal: squares and floats of it are numbers, and the plane is where it was.
    void normalsOfAnySize()
    {
        for (const char* text : {"1e-200,0,0,1e-201", "1e-300,0,0,1e-301", "1e-320,0,0,1e-321", "1e-50,0,0,1e-51",
                                 "1e50,0,0,1e49", "1e200,0,0,1e199", "1e308,0,0,1e307"}) {
            const auto planes = parseClipPlanes(text);
            QVERIFY2(planes.ok() && planes->size() == 1, text);
            const Eigen::Vector3f normal = planes->front().normal.cast<float>();
            QVERIFY2(normal.squaredNorm() > 0 && std::isfinite(normal.squaredNorm()), text);
            QVERIFY2(std::abs(planes->front().offset / planes->front().normal.x() - 0.1) < 1e-3, text);
            const auto again = parseClipPlanes(clipPlanesText(*planes));
            QCOMPARE(again->front().normal, planes->front().normal);
            QCOMPARE(again->front().offset, planes->front().offset);
        }
        QVERIFY(!parseClipPlanes("1e-200,0,0,1e200").ok()); // infinitely far
        const auto usual = parseClipPlanes("1e-9,0,2e9,3"); // as it is
        QCOMPARE(usual->front().normal, Eigen::Vector3d(1e-9, 0, 2e9));
        QCOMPARE(usual->front().offset, 3.0);
    }

    void mistakesNameThePlane_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("named");
        for (const char* wrong : {"1,0,0", "1,0,0,0,0", "1,0,0,5,", "0,0,0,1", "a,0,0,1", "1,0,0,nan", "inf,0,0,1",
                                  "1 0 0 1", "1,,0,1", "x"})
            QTest::addRow("%s", wrong) << QString("1,0,0,0;%1").arg(wrong) << QString("'%1'").arg(wrong);
    }
    void mistakesNameThePlane()
    {
        QFETCH(QString, text);
        QFETCH(QString, named);
        const auto planes = parseClipPlanes(text.toStdString());
        QVERIFY(!planes.ok());
        QCOMPARE(planes.error().kind, ErrorKind::WrongUsage);
        QVERIFY2(planes.error().text().find(named.toStdString()) != std::string::npos, planes.error().text().c_str());
    }
};

QTEST_GUILESS_MAIN(ClipPlaneTextTest)
#include "clip_plane_text_test.moc"
