// SPDX-License-Identifier: GPL-3.0-or-later
/// `tan render` of volumes and hybrids: what its options do to the picture, and every wrong use.
#include "tests/app/program.h"
#include "tests/app/sample_files.h"
#include "tests/lacks.h"
#include "tests/plugins/writers/vtk_reader.h"

#include <QFile>
#include <QImage>
#include <QJsonArray>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>

using namespace tetra;

namespace {

/// Red from 100 on, of this opacity in a length of one; else nothing.
QByteArray redFrom100(const char* opacity)
{
    return QByteArray(R"({"format": "tan-transfer-function", "version": 1, "unitDistance": 1, "points": [)"
                      R"({"value": 100, "colour": [1, 0, 0], "opacity": 0}, )"
                      R"({"value": 100, "colour": [1, 0, 0], "opacity": )") +
           opacity + "}]}";
}

int difference(const QColor& a, const QColor& b)
{
    return std::max({std::abs(a.red() - b.red()), std::abs(a.green() - b.green()), std::abs(a.blue() - b.blue()),
                     std::abs(a.alpha() - b.alpha())});
}

int largestDifference(const QImage& one, const QImage& other)
{
    int largest = one.size() == other.size() ? 0 : 255;
    for (int y = 0; largest < 255 && y < one.height(); ++y)
        for (int x = 0; x < one.width(); ++x)
            largest = std::max(largest, difference(one.pixelColor(x, y), other.pixelColor(x, y)));
    return largest;
}

/// Pixels that differ by more than rounding could do.
int pixelsThatDiffer(const QImage& one, const QImage& other)
{
    int count = 0;
    for (int y = 0; y < one.height(); ++y)
        for (int x = 0; x < one.width(); ++x)
            count += difference(one.pixelColor(x, y), other.pixelColor(x, y)) > 2 ? 1 : 0;
    return count;
}

/// Pixels of columns [begin, end) that are not the white background.
int coloured(const QImage& image, int begin, int end)
{
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = begin; x < end; ++x)
            count += image.pixelColor(x, y) != QColor(Qt::white) ? 1 : 0;
    return count;
}

int coloured(const QImage& image)
{
    return coloured(image, 0, image.width());
}

} // namespace

class RenderTest : public QObject {
    Q_OBJECT

private:
    Run tan(const QStringList& words) const { return runTan(words, folder_.path()); }
    QString path(const QString& name) const { return folder_.filePath(name); }
    /// A picture of 60 x 60 from the front, and its figures. Volumes are not lit, so that they are before white, too.
    std::pair<QImage, QJsonObject> drawn(const QStringList& options, const QString& mode = "volume") const
    {
        const bool isVolume = mode == "volume" || mode == "hybrid";
        const Run run = tan(QStringList{"render", "c60.tan", "--mode", mode, "--camera", "front", "--size", "60x60",
                                        "-o", "picture.png", "--json"} +
                            (isVolume ? QStringList{"--no-shaded"} : QStringList()) + options);
        if (run.exitCode != 0)
            qWarning("%s", run.messages.constData());
        return run.exitCode == 0 ? std::pair(QImage(path("picture.png")), run.json())
                                 : std::pair(QImage(), QJsonObject());
    }
    qint64 tetrahedra(const QStringList& options) const { return drawn(options).second["tetrahedra"].toInteger(-1); }

    QTemporaryDir folder_;

private slots:
    void initTestCase()
    {
        QCOMPARE(tan({"sample", "c60", "--size", "16", "-o", "c60.nrrd"}).exitCode, 0);
        QCOMPARE(tan({"build", "c60.nrrd", "-o", "c60.tan"}).exitCode, 0);
        QVERIFY(writeFile(path("opaque.json"), redFrom100("1")));
        QVERIFY(writeFile(path("cloud.json"), redFrom100("0.1")));
        QVERIFY(writeFile(path("nothing.json"), redFrom100("0")));
        QVERIFY(writeFile(path("slip.json"), redFrom100("0.5,")));
        QVERIFY(writeFile(path("steep.json"), redFrom100("1.5")));
    }

    /// With what helps: options with which nothing is told any more.
    void whatMayBeErrorAloneIsTold()
    {
        const QJsonArray range = tan({"info", "c60.nrrd", "--json"}).json()["range"].toArray();
        const double least = range[0].toDouble(), largest = range[1].toDouble();
        const QString isovalue = QString::number(least + 0.01 * (largest - least));
        const auto run = [&](const QStringList& accuracy) {
            return tan(QStringList{"render", "c60.tan", "--isovalue", isovalue, "--size", "20x20", "-o", "picture.png",
                                   "--json"} +
                       accuracy);
        };
        const Run told = run({"--error", "4"});
        QCOMPARE(told.exitCode, 0);
        QVERIFY2(told.messages.contains("is within the displayed error"), told.messages.constData());
        QCOMPARE(told.json()["remarks"].toArray().size(), 1);
        const QString remark = told.json()["remarks"][0].toString();
        for (const char* option : {"--error", "--field"}) {
            const QString quote = QString(option) == "--field" ? "\"" : "";
            const QRegularExpression words(QString(option) + " " + quote + "([^\"']+)" + quote + "'");
            const QRegularExpressionMatch found = words.match(remark);
            QVERIFY2(found.hasMatch(), qPrintable(remark));
            const Run cured = run({option, found.captured(1)});
            QCOMPARE(cured.exitCode, 0);
            QVERIFY2(cured.messages.isEmpty(), cured.messages.constData());
            QVERIFY(cured.json()["remarks"].toArray().isEmpty());
        }
    }

    /// The same with any error: a function to begin with shows nothing of the background that its error has made.
    void aVolumeToBeginWithNeedsNoRemark()
    {
        for (const char* error : {"0", "1", "4", "15"})
            QVERIFY2(drawn({"--error", error}).second["remarks"].toArray().isEmpty(), error);
        QVERIFY(drawn({"--budget", "2000"}).second["remarks"].toArray().isEmpty());
    }

    void aVolumeIsDrawn()
    {
        const auto [image, figures] = drawn({"--error", "2"});
        QVERIFY2(coloured(image) > 300, QByteArray::number(coloured(image)));
        QCOMPARE(figures["mode"].toString(), QString("volume"));
        QCOMPARE(figures["width"].toInt(), 60);
        QCOMPARE(figures["height"].toInt(), 60);
        QCOMPARE(figures["triangles"].toInt(-1), 0);
        QCOMPARE(figures["error"].toDouble(), 2.0);
        QVERIFY(figures["tetrahedra"].toInt() > 0);
        QVERIFY(figures["cells_drawn"].toInt() > 0);
        for (const char* key : {"extraction_seconds", "scene_seconds", "picture_seconds", "order_seconds",
                                "set_up_seconds", "fill_seconds", "fragments"})
            QVERIFY2(figures[key].toDouble() > 0, key);
        for (const char* key : {"cut_cells", "broken_cycles"})
            QCOMPARE(figures[key].toInt(-1), 0); // a Delaunay mesh has no cycles
        const auto sum = [&figures](std::initializer_list<const char*> keys) {
            double seconds = 0;
            for (const char* key : keys)
                seconds += figures[key].toDouble();
            return seconds;
        };
        QVERIFY(sum({"extraction_seconds", "scene_seconds", "picture_seconds"}) <= figures["seconds"].toDouble());
        QVERIFY(sum({"order_seconds", "set_up_seconds", "fill_seconds"}) <= figures["picture_seconds"].toDouble());
    }

    void theTransferFunctionIsTheFiles()
    {
        const QStringList bare = {"--no-outline", "--transfer"};
        const QImage opaque = drawn(bare + QStringList{"opaque.json"}).first;
        QVERIFY(coloured(opaque) > 300);
        int red = 0;
        for (int y = 0; y < 60; ++y)
            for (int x = 0; x < 60; ++x)
                red += opaque.pixelColor(x, y) == QColor(255, 0, 0) ? 1 : 0;
        QVERIFY2(red > 200, QByteArray::number(red));
        QCOMPARE(coloured(drawn(bare + QStringList{"nothing.json"}).first), 0);
        const QImage cloud = drawn(bare + QStringList{"cloud.json", "--background", "transparent"}).first;
        QVERIFY(cloud.pixelColor(0, 0).alpha() == 0);
        const int middle = cloud.pixelColor(30, 15).alpha();
        QVERIFY(middle > 0 && middle < 255);
    }

    /// What stands from 0 to 1 in ParaView's file is the same picture as what stands over the range of the data.
    void aPresetFrom0To1IsStretchedOverTheData()
    {
        const QJsonArray range = tan({"info", "c60.tan", "--json"}).json()["range"].toArray();
        const double least = range[0].toDouble(), largest = range[1].toDouble();
        QVERIFY2(largest > least + 2, QByteArray::number(largest));
        const auto preset = [&](const char* name, double first, double last) {
            const auto at = [&](double share) { return QByteArray::number(first + share * (last - first), 'g', 17); };
            return writeFile(path(name), "[{\"Name\": \"p\", \"RGBPoints\": [" + at(0) + ", 0, 0, 1, " + at(1) +
                                             ", 1, 0, 0], \"Points\": [" + at(0) + ", 0, 0.5, 0, " + at(0.5) +
                                             ", 0.1, 0.5, 0, " + at(1) + ", 0.8, 0.5, 0]}]");
        };
        QVERIFY(preset("unit.json", 0, 1) && preset("range.json", least, largest));
        const QStringList bare = {"--no-outline", "--background", "transparent", "--transfer"};
        const QImage unit = drawn(bare + QStringList{"unit.json"}).first;
        const QImage stretched = drawn(bare + QStringList{"range.json"}).first;
        QVERIFY2(largestDifference(unit, stretched) <= 1, QByteArray::number(largestDifference(unit, stretched)));
        const auto told = [&](const char* name) {
            return QString(drawn(bare + QStringList{name}).second["remarks"].toArray().first().toString());
        };
        QVERIFY2(told("unit.json").contains("'unit.json' covers 0 to 1, and is stretched"),
                 qPrintable(told("unit.json")));
        QVERIFY(told("range.json").isEmpty());
        int opaque = 0, seenThrough = 0; // nearly all is behind the last point of a function that is not stretched
        for (int y = 0; y < unit.height(); ++y)
            for (int x = 0; x < unit.width(); ++x) {
                const int alpha = unit.pixelColor(x, y).alpha();
                (alpha == 255 ? opaque : seenThrough) += alpha > 0 ? 1 : 0;
            }
        QVERIFY2(seenThrough > 2 * opaque, QByteArray::number(seenThrough) + " and " + QByteArray::number(opaque));
    }

    /// The opacities are those without a function, the colours the file's.
    void aPresetOfColoursKeepsTheOpacities()
    {
        QVERIFY(writeFile(path("colours.json"), R"([{"Name": "green", "RGBPoints": [0, 0, 1, 0, 1, 0, 1, 0]}])"));
        const QStringList bare = {"--no-outline", "--background", "transparent"};
        const QImage usual = drawn(bare).first, green = drawn(bare + QStringList{"--transfer", "colours.json"}).first;
        QCOMPARE(green.size(), usual.size());
        int opaque = 0;
        for (int y = 0; y < usual.height(); ++y)
            for (int x = 0; x < usual.width(); ++x) {
                const QColor colour = green.pixelColor(x, y);
                QCOMPARE(colour.alpha(), usual.pixelColor(x, y).alpha());
                opaque += colour.alpha() > 40 ? 1 : 0;
                QVERIFY(colour.alpha() <= 40 || (colour.red() < 10 && colour.blue() < 10 && colour.green() > 245));
            }
        QVERIFY2(opaque > 20, QByteArray::number(opaque));
    }

    /// A volume of which nothing is seen leaves the surface as it is alone, but at a few pixels of its edges, where
    /// samples lie at other places of the pixel; a cloud changes it.
    void aHybridIsBoth()
    {
        const QStringList options = {"--isovalue", "120:silver", "--no-outline"};
        const auto [surface, alone] = drawn(options, "isosurface");
        const auto [hybrid, both] = drawn(options + QStringList{"--transfer", "nothing.json"}, "hybrid");
        QVERIFY(coloured(surface) > 300);
        QVERIFY2(pixelsThatDiffer(surface, hybrid) < 36, QByteArray::number(pixelsThatDiffer(surface, hybrid)));
        QCOMPARE(both["triangles"].toInt(), alone["triangles"].toInt());
        const QImage cloudy = drawn(options + QStringList{"--transfer", "cloud.json"}, "hybrid").first;
        QVERIFY(pixelsThatDiffer(surface, cloudy) > 200);
        const QImage withCell =
            drawn(options + QStringList{"--transfer", "cloud.json", "--order", "with-cell"}, "hybrid").first;
        QVERIFY(pixelsThatDiffer(surface, withCell) > 200);
    }

    void clipPlanesCutAllModes_data()
    {
        QTest::addColumn<QString>("mode");
        for (const char* mode : {"volume", "isosurface", "hybrid"})
            QTest::newRow(mode) << QString(mode);
    }
    void clipPlanesCutAllModes()
    {
        QFETCH(QString, mode);
        QStringList options = {"--no-outline"};
        if (mode != "volume")
            options << "--isovalue"
                    << "120";
        const QImage whole = drawn(options, mode).first;
        QVERIFY(coloured(whole, 0, 25) > 100 && coloured(whole, 35, 60) > 100);
        // From the front x goes to the right; the data lie from 0 to 15.
        const QImage right = drawn(options + QStringList{"--clip", "1,0,0,7.5"}, mode).first;
        QCOMPARE(coloured(right, 0, 25), 0);
        QVERIFY(coloured(right, 35, 60) > 100);
        const QImage none = drawn(options + QStringList{"--clip", "1,0,0,9", "--clip", "-1,0,0,-6"}, mode).first;
        QCOMPARE(coloured(none), 0);
    }

    /// Each in its corner, and nothing else is touched; what has no value of its own is not there.
    void annotationsAreWrittenOver()
    {
        const auto picture = [this](const QStringList& options, const char* mode) {
            const Run run = tan(QStringList{"render", "c60.tan", "--mode", mode, "--size", "400x320", "--no-outline",
                                            "-o", "annotated.png"} +
                                options);
            return run.exitCode == 0 ? QImage(path("annotated.png")) : QImage();
        };
        const auto corner = [](const QImage& image, int number) {
            return image.copy(number % 2 * 300, number / 2 * 240, 100, 80); // top left, top right, bottom left ...
        };
        const QImage bare = picture({}, "volume");
        QCOMPARE(bare.size(), QSize(400, 320));
        const std::array<QStringList, 4> options{QStringList{"--title", "Sixty atoms"}, QStringList{"--colour-bar"},
                                                 QStringList{"--axes"}, QStringList{"--scale-bar"}};
        for (int wanted = 0; wanted < 4; ++wanted) {
            const QImage image = picture(options[static_cast<std::size_t>(wanted)], "volume");
            for (int other = 0; other < 4; ++other) {
                const int changed = pixelsThatDiffer(corner(image, other), corner(bare, other));
                QVERIFY2(other == wanted ? changed > 100 : changed == 0, QByteArray::number(10 * wanted + other));
            }
            QCOMPARE(pixelsThatDiffer(image.copy(150, 100, 100, 120), bare.copy(150, 100, 100, 120)), 0);
        }
        const QImage surface = picture({"--colour-bar", "--isovalue", "120.5:silver"}, "isosurface");
        QVERIFY(pixelsThatDiffer(corner(surface, 1), corner(picture({"--isovalue", "120.5:silver"}, "isosurface"), 1)) >
                100);
        QCOMPARE(tan({"render", "c60.tan", "--title", "-o", "annotated.png"}).exitCode, 2);
    }

    /// What 'tan extract' takes, the picture shows.
    void queriesChooseTheMesh()
    {
        const qint64 coarse = tetrahedra({"--error", "8"});
        const qint64 fine = tetrahedra({"--error", "0.5"});
        QVERIFY(coarse > 0 && coarse < fine);
        const qint64 focus = tetrahedra({"--error", "8", "--focus", "sphere:8,8,8,3", "--focus-error", "0.5"});
        QVERIFY(focus > coarse && focus < fine);
        const auto budget = drawn({"--budget", "3000"}).second;
        QVERIFY(budget["tetrahedra"].toInt() <= 3000 && budget["scale"].toDouble() > 1);
        const auto window = drawn({"--window", "0,0,0,15,15,7", "--error", "0.5", "--border", "clipped"}).second;
        QVERIFY(window["tetrahedra"].toInteger() < fine);
        QCOMPARE(window["whole_tetrahedra"].toInteger(), fine);
        QVERIFY(tetrahedra({"--values", "100,200", "--error", "0.5"}) < fine);
    }

    /// C5: the blend of two meshes shows surfaces, too, and has several regions.
    void theFocusHasSurfacesAndSeveralRegions()
    {
        const QStringList one{"--error", "8",         "--focus", "sphere:8,8,8,3", "--focus-error",
                              "0.5",     "--falloff", "2",       "--no-outline"};
        const auto [cloud, ofCloud] = drawn(one, "focus");
        const auto [clouds, ofTwo] = drawn(one + QStringList{"--focus", "box:1,1,1,4,4,14"}, "focus");
        QVERIFY(ofTwo["focus_tetrahedra"].toInteger() > ofCloud["focus_tetrahedra"].toInteger());
        QVERIFY(pixelsThatDiffer(cloud, clouds) > 20);
        QCOMPARE(ofCloud["triangles"].toInt(-1), 0);
        const QStringList surfaces = one + QStringList{"--isovalue", "120.5:silver", "--shows"};
        const auto [alone, ofAlone] = drawn(surfaces + QStringList{"surfaces"}, "focus");
        const auto [both, ofBoth] = drawn(surfaces + QStringList{"both"}, "focus");
        QVERIFY(ofAlone["triangles"].toInt() > 0 && ofAlone["cells_drawn"].toInt(-1) == 0);
        QCOMPARE(ofBoth["triangles"].toInt(), ofAlone["triangles"].toInt());
        QVERIFY(ofBoth["cells_drawn"].toInt() > 0 && coloured(alone) > 100);
        QVERIFY(pixelsThatDiffer(alone, both) > 100 && pixelsThatDiffer(cloud, both) > 100);
        const Run useless = tan(QStringList{"render", "c60.tan", "--mode", "focus", "-o", "picture.png"} + one +
                                QStringList{"--isovalue", "120.5"});
        QCOMPARE(useless.exitCode, 2);
    }

    /// C5: in the lens the picture is that which is so many times as large, of a finer mesh if that is asked for.
    void theLensEnlarges()
    {
        const QStringList usual{"--error", "8", "--no-outline", "--samples", "1"};
        const auto [plain, ofPlain] = drawn(usual);
        QCOMPARE(tan(QStringList{"render", "c60.tan", "--mode", "volume", "--no-shaded", "--camera", "front", "--size",
                                 "180x180", "-o", "large.png"} +
                     usual)
                     .exitCode,
                 0);
        const QImage large(path("large.png"));
        const auto [magnified, ofMagnified] = drawn(usual + QStringList{"--lens", "square:0.5,0.45,0.25,3,100"});
        const auto [fine, ofFine] = drawn(usual + QStringList{"--lens", "square:0.5,0.45,0.25,3,0.5"});
        QCOMPARE(ofMagnified["lens_tetrahedra"].toInteger(), ofMagnified["tetrahedra"].toInteger());
        QVERIFY(ofFine["lens_tetrahedra"].toInteger() > ofFine["tetrahedra"].toInteger());
        int finer = 0, larger = 0;
        for (int y = 0; y < 60; ++y)
            for (int x = 0; x < 60; ++x) {
                const int right = x - 30, down = y - 27; // from the middle
                if (std::max(std::abs(right), std::abs(down)) > 18) {
                    QCOMPARE(magnified.pixelColor(x, y), plain.pixelColor(x, y));
                    QCOMPARE(fine.pixelColor(x, y), plain.pixelColor(x, y));
                }
                if (std::abs(right) > 11 || down < -11 || down >= -5)
                    continue; // but for the rim and the number
                QCOMPARE(magnified.pixelColor(x, y), large.pixelColor(90 + right, 81 + down));
                larger += magnified.pixelColor(x, y) != plain.pixelColor(x, y) ? 1 : 0;
                finer += fine.pixelColor(x, y) != magnified.pixelColor(x, y) ? 1 : 0;
            }
        QVERIFY2(larger > 10 && finer > 10, qPrintable(QString("%1 %2").arg(larger).arg(finer)));
        QVERIFY(pixelsThatDiffer(drawn(usual + QStringList{"--lens", "0.5,0.45,0.25,3,0.5"}).first, fine) > 4);
    }

    void depthsAreAGreyPicture()
    {
        const auto [image, figures] = drawn({"--transfer", "opaque.json", "--no-outline", "--depth", "depth.png"});
        const QImage depth(path("depth.png"));
        QCOMPARE(depth.format(), QImage::Format_Grayscale16);
        QCOMPARE(depth.size(), image.size());
        const double nearest = figures["nearest"].toDouble(), farthest = figures["farthest"].toDouble();
        QVERIFY(nearest > 0 && nearest < farthest && farthest < nearest + 26);
        QCOMPARE(depth.text("nearest").toDouble(), nearest);
        QCOMPARE(depth.text("farthest").toDouble(), farthest);
        int least = 65535, largest = 0;
        for (int y = 0; y < 60; ++y)
            for (int x = 0; x < 60; ++x) {
                const int grey = reinterpret_cast<const quint16*>(depth.constScanLine(y))[x];
                if (image.pixelColor(x, y) == QColor(Qt::white))
                    QCOMPARE(grey, 65535);
                if (image.pixelColor(x, y) == QColor(255, 0, 0))
                    QVERIFY(grey < 65535);
                if (grey < 65535) {
                    least = std::min(least, grey);
                    largest = std::max(largest, grey);
                }
            }
        QCOMPARE(least, 0);
        QCOMPARE(largest, 65534);
    }

    void nothingSeenHasNoDepth()
    {
        const auto figures = drawn({"--transfer", "nothing.json", "--no-outline", "--depth", "depth.png"}).second;
        QCOMPARE(figures["nearest"].toDouble(-1), 0.0);
        QCOMPARE(figures["farthest"].toDouble(-1), 0.0);
        const QImage depth(path("depth.png"));
        QCOMPARE(reinterpret_cast<const quint16*>(depth.constScanLine(30))[30], quint16(65535));
    }

    void samplesAndThreads()
    {
        const QImage coarse = drawn({"--samples", "1"}).first;
        const QImage fine = drawn({"--samples", "4"}).first;
        QVERIFY(largestDifference(coarse, fine) > 0);
        QCOMPARE(drawn({"--samples", "1", "--threads", "1"}).first, coarse);
    }

    /// Volumes are lit and stand before a dark ground, unless it is said otherwise; what is usual can be said, too.
    void volumesAreLit()
    {
        const auto picture = [this](const QStringList& options) {
            const Run run = tan(QStringList{"render", "c60.tan", "--size", "60x60", "-o", "picture.png"} + options);
            return run.exitCode == 0 ? QImage(path("picture.png")) : QImage();
        };
        const auto corner = [](const QImage& image) { return image.pixelColor(1, 1); };
        for (const char* mode : {"volume", "hybrid"}) {
            const QStringList words{"--mode", mode};
            const QImage usual = picture(words), unlit = picture(words + QStringList{"--no-shaded"});
            const QImage onWhite = picture(words + QStringList{"--background", "white"});
            QVERIFY2(corner(usual).lightness() < 50, mode);
            QVERIFY2(corner(unlit) == QColor(Qt::white) && corner(onWhite) == QColor(Qt::white), mode);
            QVERIFY2(largestDifference(onWhite, unlit) > 5, mode);
            QVERIFY2(picture(words + QStringList{"--shaded"}) == usual, mode);
        }
        QCOMPARE(corner(picture({})), QColor(Qt::white));
        for (const QStringList& order : {QStringList{"--shaded", "--no-shaded"}, {"--no-shaded", "--shaded"}}) {
            const Run run = tan(QStringList{"render", "c60.tan", "--mode", "volume", "-o", "picture.png"} + order);
            QCOMPARE(run.exitCode, 2);
            QVERIFY2(run.messages.contains("'--shaded' and '--no-shaded' contradict each other"), run.messages);
        }
        QCOMPARE(tan({"render", "c60.tan", "--shaded", "-o", "picture.png"}).exitCode, 2); // of no isosurface
        QCOMPARE(tan({"render", "c60.tan", "--mode", "volume", "--shaded=on", "-o", "picture.png"}).exitCode, 2);
    }

    void theBoundaryIsDrawn()
    {
        const QStringList plain{"--transfer", "nothing.json", "--no-outline"};
        QCOMPARE(coloured(drawn(plain).first), 0);
        const auto [faint, figures] = drawn(plain + QStringList{"--boundary", "translucent"});
        QVERIFY(coloured(faint) > 1000);
        QVERIFY(figures["triangles"].toInteger() > 100);
        const QImage solid = drawn(plain + QStringList{"--boundary", "translucent", "--boundary-opacity", "1"}).first;
        QVERIFY(solid.pixelColor(30, 30).red() < faint.pixelColor(30, 30).red());
        const QStringList red{"--transfer", "cloud.json", "--no-outline", "--boundary", "values"};
        for (const char* mode : {"volume", "isosurface", "hybrid"}) {
            const QColor seen = drawn(red, mode).first.pixelColor(30, 30);
            QVERIFY2(seen.red() > 200 && seen.green() < 60, mode);
        }
        const auto triangles = [&](const QStringList& options) {
            const Run run =
                tan(QStringList{"render", "c60.tan", "--size", "60x60", "-o", "picture.png", "--json"} + red + options);
            return run.json()["triangles"].toInteger(-1);
        };
        QVERIFY(triangles({}) > 0 && triangles({}) < triangles({"--mode", "isosurface"}));
        QVERIFY(triangles({}) < triangles({"--isovalue", "60"}));
        const QStringList lit = red + QStringList{"--lit"};
        QVERIFY(drawn(lit).first != drawn(lit + QStringList{"--boundary-far-side"}).first);
    }

    /// The colour of a value is that of the map, straight on and at an angle; light is a choice.
    void coloursOfValuesAreNotLit()
    {
        QVERIFY(writeFile(path("half.json"), R"([{"RGBPoints": [-1e6, 0.5, 0.25, 0.75, 1e6, 0.5, 0.25, 0.75]}])"));
        const QStringList values{"--transfer", "half.json", "--no-outline", "--boundary", "values"};
        for (const char* camera : {"front", "iso"}) {
            const auto middle = [&](const QStringList& options) {
                const Run run =
                    tan(QStringList{"render", "c60.tan", "--camera", camera, "--size", "60x60", "-o", "picture.png"} +
                        values + options);
                return run.exitCode == 0 ? QImage(path("picture.png")).pixelColor(30, 30) : QColor();
            };
            QVERIFY2(difference(middle({}), QColor(128, 64, 191)) <= 1, camera);
            const QColor lit = middle({"--lit"});
            if (std::string_view(camera) == "front") // 0.965 of the colour, and a highlight of 0.014
                QVERIFY2(difference(lit, QColor(127, 65, 188)) <= 1, camera);
            else
                QVERIFY2(difference(lit, QColor(128, 64, 191)) > 10, camera);
        }
    }

    /// Ends of the bar change the bar alone.
    void theBarsEndsCanBeFixed()
    {
        const auto picture = [this](const QStringList& options) {
            const Run run = tan(QStringList{"render", "c60.tan", "--mode", "volume", "--size", "400x320", "-o",
                                            "annotated.png", "--colour-bar"} +
                                options);
            return run.exitCode == 0 ? QImage(path("annotated.png")) : QImage();
        };
        const QImage usual = picture({}), fixed = picture({"--bar-range", "-50:1000"});
        QCOMPARE(fixed.size(), usual.size());
        QVERIFY(pixelsThatDiffer(usual.copy(260, 0, 140, 220), fixed.copy(260, 0, 140, 220)) > 100);
        QCOMPARE(pixelsThatDiffer(usual.copy(0, 0, 260, 320), fixed.copy(0, 0, 260, 320)), 0);
    }

    /// Each of them changes the bar, or the corner of the title, and nothing else.
    void textsOfTheBarCanBeChosen()
    {
        const auto picture = [this](const QStringList& options) {
            const Run run = tan(QStringList{"render", "c60.tan", "--mode", "volume", "--size", "400x320", "-o",
                                            "annotated.png", "--colour-bar"} +
                                options);
            return run.exitCode == 0 ? QImage(path("annotated.png")) : QImage();
        };
        const QImage usual = picture({});
        QCOMPARE(picture({"--bar-numbers", "auto"}), usual);
        QCOMPARE(picture({"--title", ""}), usual);
        QList<QImage> others{picture({"--bar-quantity", "Density"}), picture({"--bar-unit", "HU"}),
                             picture({"--bar-numbers", "plain:3"}), picture({"--bar-numbers", "powers:1"}),
                             picture({"--title", "Own"})};
        for (qsizetype i = 0; i < others.size(); ++i) {
            const QImage& other = others[i];
            QCOMPARE(other.size(), usual.size());
            QVERIFY(pixelsThatDiffer(usual, other) > 20);
            QCOMPARE(pixelsThatDiffer(usual.copy(100, 40, 140, 280), other.copy(100, 40, 140, 280)), 0);
            QCOMPARE(others.count(other), 1);
        }
    }

    /// What is drawn, as 'tan isosurface' writes it.
    void surfacesAreWrittenToo()
    {
        const auto [image, figures] =
            drawn({"--isovalue", "120:gold", "--error", "1", "--surfaces", "both.vtp"}, "isosurface");
        QVERIFY(!image.isNull());
        QCOMPARE(figures["surfaces_file"].toString(), QString("both.vtp"));
        QVERIFY(figures["triangles"].toInteger() > 100);
        const VtkReader read(path("both.vtp"));
        if (read.isMissing())
            QSKIP_WITHOUT("python3-vtk9");
        QVERIFY2(read.ok(), read.messages());
        QCOMPARE(read.told()["cells"].toInteger(), figures["triangles"].toInteger());
        const std::vector<float> values = read.array<float>("point.isovalue");
        QVERIFY(!values.empty() && std::ranges::all_of(values, [](float value) { return value == 120; }));
        QCOMPARE(tan({"isosurface", "c60.tan", "--error", "1", "--value", "120", "-o", "alone.vtp"}).exitCode, 0);
        const VtkReader alone(path("alone.vtp"));
        std::vector<double> points = read.places(), others = alone.places();
        QVERIFY(points.size() > 300);
        std::ranges::sort(points);
        std::ranges::sort(others);
        QCOMPARE(points, others);
    }

    /// Fields take the camera, the isovalues and the opacities from the picture (C3).
    void fieldsDependOnThePicture()
    {
        QVERIFY(writeFile(path("view.json"),
                          R"({"azimuth": 0, "elevation": 0, "target": [7.5, 7.5, 7.5], "distance": 40})"));
        QVERIFY(writeFile(path("ramp.json"),
                          R"({"format": "tan-transfer-function", "version": 2, "colours": [],
                              "opacities": [{"value": 50, "opacity": 0}, {"value": 150, "opacity": 0.5}]})"));
        const auto tetrahedra = [&](const QString& mode, const QString& field) {
            QStringList options{"render", "c60.tan", "--mode",      mode,     "--camera", "view.json", "--size",
                                "9x9",    "-o",      "picture.png", "--json", "--field",  field};
            options += mode == "volume" ? QStringList{"--transfer", "ramp.json"} : QStringList{"--isovalue", "120"};
            return tan(options).json()["tetrahedra"].toInteger(-1);
        };
        for (const auto& [mode, present, written] :
             {std::tuple{"isosurface", "camera(; 0.5, 8, 45)", "camera(7.5, -32.5, 7.5; 0.5, 8, 45)"},
              std::tuple{"isosurface", "isovalues(; 0.5, 8, 20)", "isovalues(120; 0.5, 8, 20)"},
              std::tuple{"volume", "opacity(; 0.5, 8)", "opacity(50:0, 150:1; 0.5, 8)"}}) {
            const qint64 size = tetrahedra(mode, present);
            QCOMPARE(size, tetrahedra(mode, written));
            QVERIFY(size > tetrahedra(mode, "8") && size < tetrahedra(mode, "0.5"));
        }
        const Run missed = tan({"extract", "c60.tan", "--field", "camera(; 1, 2, 3)", "-o", "x.vtu"});
        QCOMPARE(missed.exitCode, 2);
        QVERIFY2(missed.messages.contains("the camera's position"), missed.messages);
    }

    /// Surfaces of a range are drawn over each other; a volume is drawn of one mesh only (C2).
    void rangesAreDrawnAsSurfaces()
    {
        const auto [all, figures] = drawn({"--range", "8,1", "--isovalue", "120:gold:0.2"}, "isosurface");
        const auto [one, fewer] = drawn({"--error", "1", "--isovalue", "120:gold:0.2"}, "isosurface");
        QVERIFY(figures["triangles"].toInteger() > fewer["triangles"].toInteger());
        QVERIFY(all != one);
        const QStringList cloud{"--transfer", "cloud.json"}; // the one to begin with depends on the error
        const QStringList alive{"--range", "8,1", "--births", "2,inf", "--deaths", "0,2"};
        QCOMPARE(drawn(alive + cloud, "volume").first, drawn(QStringList{"--error", "2"} + cloud, "volume").first);
        for (const QStringList& options : {QStringList{"--mode", "volume"}, QStringList{"--boundary", "translucent"}}) {
            const Run run =
                tan(QStringList{"render", "c60.tan", "--range", "8,1", "--size", "60x60", "-o", "x.png"} + options);
            QCOMPARE(run.exitCode, 2);
            QVERIFY2(run.messages.contains("over each other") || run.messages.contains("overlap"), run.messages);
        }
    }

    /// Planes show themselves, and are drawn as those of the mode; their surfaces are a file with values.
    void slicesAreAModeOfTheirOwn()
    {
        const QStringList planes{"--slice", "z=7.5", "--slice", "1,1,0,15"};
        const auto render = [&](const QStringList& options) {
            return tan(QStringList{"render", "c60.tan", "--size", "60x60", "-o", "picture.png", "--json"} + options);
        };
        const Run implied = render(planes + QStringList{"--surfaces", "slices.vtp", "--colour-bar"});
        QVERIFY2(implied.exitCode == 0, implied.messages.constData());
        QCOMPARE(implied.json()["mode"].toString(), QString("slice"));
        QVERIFY(implied.json()["triangles"].toInt() > 100);
        const QImage picture(path("picture.png"));
        QVERIFY(coloured(picture) > 300);
        QVERIFY(QFile::remove(path("picture.png"))); // else that of the first run could be taken for the second's
        const Run named = render(planes + QStringList{"--mode", "slice", "--colour-bar"});
        QVERIFY2(named.exitCode == 0, named.messages.constData());
        QCOMPARE(QImage(path("picture.png")), picture);
        const VtkReader file(path("slices.vtp"));
        if (file.isMissing())
            QSKIP_WITHOUT("python3-vtk9");
        QVERIFY2(file.ok(), file.messages());
        QCOMPARE(file.told()["cells"].toInteger(), implied.json()["triangles"].toInteger());
        const Run isosurface = render({});
        QCOMPARE(isosurface.json()["mode"].toString(), QString("isosurface"));
        // As the panel has them at first, one across each axis; and one of them.
        QCOMPARE(render({"--mode", "slice", "--no-outline"}).exitCode, 0);
        const QImage three(path("picture.png"));
        QCOMPARE(render({"--slice", "x=7.5", "--slice", "y=7.5", "--slice", "z=7.5", "--no-outline"}).exitCode, 0);
        QCOMPARE(QImage(path("picture.png")), three);
        QCOMPARE(render({"--mode", "slice", "--slice-axis", "z", "--no-outline"}).exitCode, 0);
        QVERIFY(QImage(path("picture.png")) != three);
    }

    void anEmptySessionIsNoPicture()
    {
        QFile empty(path("empty.tansession"));
        QVERIFY(empty.open(QIODevice::WriteOnly));
        empty.close();
        const Run run = tan({"render", "empty.tansession", "-o", "x.png"});
        QCOMPARE(run.exitCode, 3);
        QVERIFY2(run.messages.contains("empty.tansession") && !run.messages.contains("picture"), run.messages);
    }

    /// Of a mode that draws neither by a transfer function nor isosurfaces.
    void aColourBarNeedsColoursThatMeanSomething()
    {
        const QStringList words{"render", "c60.tan", "--mode", "example.band", "-o", "band.png"};
        const QMap<QString, QString> plugins{{"TAN_PLUGIN_PATH", TAN_BAND_RENDERER}};
        const Run refused = runTan(words + QStringList{"--colour-bar"}, folder_.path(), plugins);
        QCOMPARE(refused.exitCode, 2);
        QVERIFY2(refused.messages.contains("'example.band' draws nothing that '--colour-bar' could explain"),
                 refused.messages);
        QVERIFY(!QFile::exists(path("band.png")));
        const Run axes = runTan(words + QStringList{"--axes"}, folder_.path(), plugins);
        QVERIFY2(axes.exitCode == 0, axes.messages);
    }

    void wrongUseIsRefused_data()
    {
        QTest::addColumn<QStringList>("options");
        QTest::addColumn<int>("exitCode");
        QTest::addColumn<QByteArray>("message");
        const auto row = [](const char* name, const QStringList& options, int exitCode, const char* message) {
            QTest::newRow(name) << options << exitCode << QByteArray(message);
        };
        row("isovalue of a volume", {"--isovalue", "9"}, 2, "'volume' has no option '--isovalue'");
        row("order of a volume", {"--order", "exact"}, 2, "'--order'");
        row("unknown order", {"--mode", "hybrid", "--order", "random"}, 2, "exact, with-cell");
        row("not a clip plane", {"--clip", "1,2,3"}, 2, "'1,2,3' is not a clip plane");
        row("no normal", {"--clip", "1,0,0,0", "--clip", "0,0,0,1"}, 2, "'0,0,0,1'");
        row("not a plane", {"--mode", "slice", "--slice", "w=3"}, 2, "'w=3' is not a plane");
        row("a plane beside the data", {"--mode", "slice", "--slice", "z=3", "--slice", "z=99"}, 2, "misses the data");
        row("a slice of a volume", {"--slice", "z=3"}, 2, "'volume' has no option '--slice'");
        row("a plane in place of those by its axis", {"--mode", "slice", "--slice", "z=3", "--slice-axis", "x"}, 2,
            "'--slice-axis' applies only without '--slice'");
        row("the place of a plane that is given", {"--mode", "slice", "--slice", "z=3", "--slice-place", "40"}, 2,
            "'--slice-place' applies only without '--slice'");
        row("a slice beside everything", {"--mode", "slice", "--slice-place", "101"}, 2, "'--slice-place'");
        row("an unknown projection", {"--mode", "projection", "--projection", "mean"}, 2, "maximum, minimum");
        row("unknown boundary", {"--boundary", "thick"}, 2, "off, translucent, values");
        row("boundary of no opacity", {"--boundary-opacity", "0"}, 2, "0.01");
        row("opacity without a boundary", {"--boundary-opacity", "0.5"}, 2, "'--boundary-opacity' applies only if");
        row("far side without a boundary", {"--boundary-far-side"}, 2, "'--boundary-far-side' applies only if");
        row("light without values", {"--lit"}, 2, "'--lit' applies only if");
        row("light on one colour", {"--boundary", "translucent", "--lit"}, 2, "'--lit' applies only if");
        row("ends without a bar", {"--bar-range", "1:2"}, 2, "'--colour-bar'");
        row("a bar from more to less", {"--colour-bar", "--bar-range", "2:1"}, 2, "does not fit '--bar-range'");
        row("a bar of one end", {"--colour-bar", "--bar-range", "2"}, 2, "does not fit '--bar-range'");
        row("a bar of words", {"--colour-bar", "--bar-range", "low:high"}, 2, "does not fit '--bar-range'");
        row("a quantity without a bar", {"--bar-quantity", "Density"}, 2, "it needs '--colour-bar'");
        row("a unit without a bar", {"--bar-unit", "HU"}, 2, "it needs '--colour-bar'");
        row("numbers without a bar", {"--bar-numbers", "plain:1"}, 2, "it needs '--colour-bar'");
        row("lengths without one", {"--length-numbers", "plain:1", "--colour-bar"}, 2, "'--box-axes'");
        row("lengths of no format", {"--box-axes", "--length-numbers", "short"}, 2, "does not fit '--length-numbers'");
        row("text of no size", {"--axes", "--text-size", "5"}, 2, "'--text-size'");
        row("text too large", {"--axes", "--text-size", "49"}, 2, "'--text-size'");
        row("size of no text", {"--text-size", "20"}, 2, "it needs one");
        row("bold nothing", {"--bold-text"}, 2, "it needs one");
        for (const char* numbers : {"plain", "plain:", "plain:13", "plain:-1", "powers:x", "short:1", ""})
            QTest::addRow("numbers as '%s'", numbers) << QStringList{"--colour-bar", "--bar-numbers", numbers} << 2
                                                      << QByteArray("does not fit '--bar-numbers'");
        row("missing function", {"--transfer", "gone.json"}, 3, "'gone.json'");
        row("no JSON", {"--transfer", "c60.nrrd"}, 3, "c60.nrrd': ");
        row("slip in a function", {"--transfer", "slip.json"}, 3, "slip.json': ");
        row("place of a slip", {"--transfer", "slip.json"}, 3, "line 1, column 183");
        row("opacity above 1", {"--transfer", "steep.json"}, 3, "Opacity 2");
        row("place of the opacities", {"--transfer", "steep.json"}, 3, "line 1, column 80");
        row("no samples", {"--samples", "0"}, 2, "'--samples'");
        row("many samples", {"--samples", "5"}, 2, "'--samples'");
        row("no threads", {"--threads", "0"}, 2, "'--threads'");
        row("too large", {"--size", "32768x10"}, 2, "32767");
        row("depth in another format", {"--depth", "depth.tif"}, 2, ".png");
        row("depth over the picture", {"--depth", "./x.png"}, 2, "same file");
        row("depth over the picture, from the root", {"--depth", path("x.png")}, 2, "same file");
        row("surfaces of a volume", {"--surfaces", "x.ply"}, 2, "'--surfaces' has nothing to write");
        row("surfaces in another format", {"--surfaces", "x.png2"}, 2, "'--surfaces'");
        row("surfaces over the depth", {"--surfaces", "./d.png", "--depth", "d.png"}, 2, "same file");
        row("surfaces over the model", {"--surfaces", "c60.tan"}, 2, "c60.tan");
        row("a lens of three numbers", {"--lens", "0.5,0.5,0.2"}, 2, "does not fit '--lens'");
        row("a lens of six", {"--lens", "0.5,0.5,0.2,3,1,1"}, 2, "does not fit '--lens'");
        row("a lens beside the picture", {"--lens", "1.5,0.5,0.2,3"}, 2, "does not fit '--lens'");
        row("a lens that is no number", {"--lens", "0.5,0.5,0.2,big"}, 2, "does not fit '--lens'");
        row("a lens that makes smaller", {"--lens", "0.5,0.5,0.2,0.5"}, 2, "does not fit '--lens'");
        row("focus without error", {"--focus", "sphere:1,2,3,4"}, 2, "--focus-error");
        row("window beside the data", {"--window", "90,90,90,91,91,91"}, 2, "No tetrahedron");
    }
    void wrongUseIsRefused()
    {
        QFETCH(QStringList, options);
        QFETCH(int, exitCode);
        QFETCH(QByteArray, message);
        QStringList words = {"render", "c60.tan", "-o", "x.png", "--size", "8x8"};
        if (options.contains("--size"))
            words = words.mid(0, 4);
        if (!options.contains("--mode"))
            words << "--mode"
                  << "volume";
        const Run run = tan(words + options);
        QCOMPARE(run.exitCode, exitCode);
        QVERIFY2(run.messages.contains(message), run.messages);
        QVERIFY(!QFile::exists(path("x.png")));
        QVERIFY(!QFile::exists(path("x.ply")));
    }
};

QTEST_GUILESS_MAIN(RenderTest)
#include "render_test.moc"
