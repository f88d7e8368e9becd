// SPDX-License-Identifier: GPL-3.0-or-later
// The house keeps its own rules (docs: CONTRIBUTING.md), and the reader of the rules finds each kind of breach.
#include "tests/structure/house_rules.h"

#include <QTemporaryDir>
#include <QtTest>

#include <fstream>

using namespace tetra;
namespace fs = std::filesystem;

namespace {

const std::string licence = "// SPDX-License-Identifier: GPL-3.0-or-later\n";
const std::string header = licence + "#pragma once\n";

void writeFile(const fs::path& path, const std::string& text)
{
    fs::create_directories(path.parent_path());
    std::ofstream(path) << text;
}

/// A small tree in which everything is as it should be, with one header in each room.
void writeGoodTree(const fs::path& root)
{
    for (const char* path : {"core/include/tan/base.h",
                             "core/include/tan/data.h",
                             "core/base/result.h",
                             "core/data/lattice.h",
                             "core/mesh/mesh.h",
                             "core/transfer/function.h",
                             "core/history/model.h",
                             "core/render/scene.h",
                             "core/refine/lattice/star.h",
                             "core/render/cpu/tiles.h",
                             "plugins/api/builder.h",
                             "plugins/host/host.h",
                             "plugins/builders/refinement/builder.h",
                             "plugins/builders/decimation/heap.h",
                             "plugins/readers/lattice/nrrd.h",
                             "plugins/widgets/value_box.h",
                             "ui/opening/opening.h",
                             "ui/workbench/exporting.h",
                             "ui/viewport/canvas.h",
                             "ui/window/window.h",
                             "app/commands.h",
                             "tests/ui/robot.h"})
        writeFile(root / path, header);
}

QStringList breachesIn(const fs::path& root, const Heaps& heaps = {})
{
    QStringList texts;
    for (const auto& breach : houseBreaches(root, heaps))
        texts << QString::fromStdString(breach);
    return texts;
}

} // namespace

class IncludeDirectionTest : public QObject {
    Q_OBJECT

private slots:
    void theRepositoryKeepsItsRules()
    {
        const QStringList breaches = breachesIn(TAN_SOURCE_DIR, heapsOfThisTree());
        QVERIFY2(breaches.isEmpty(), qPrintable("\n" + breaches.join("\n")));
    }

    void allArrowsPointOneWay() { QCOMPARE(arrowsBack(), std::vector<std::string>()); }
    void findsAHeapOfSources()
    {
        const QTemporaryDir folder;
        const fs::path root = folder.path().toStdString();
        for (int i = 0; i < 26; ++i)
            writeFile(root / ("core/base/unit" + std::to_string(i) + ".h"), header);
        writeFile(root / "core/base/unit1.cpp", licence);
        QCOMPARE(breachesIn(root),
                 QStringList("core/base: 26 units, more than 25; divide the folder, or join what is one idea"));
        fs::remove(root / "core/base/unit7.h");
        QCOMPARE(breachesIn(root), QStringList());
        for (int i = 0; i < 26; ++i)
            writeFile(root / ("ui/panels/unit" + std::to_string(i) + ".h"), header);
        QCOMPARE(breachesIn(root),
                 QStringList("ui/panels: 26 units, more than 25; divide the folder, or join what is one idea"));
    }
    void heapsMayOnlyFall()
    {
        const Heaps heaps = {{"tests/fuzz", 27}};
        const QTemporaryDir folder;
        const fs::path root = folder.path().toStdString();
        for (int i = 0; i < 27; ++i)
            writeFile(root / ("tests/fuzz/unit" + std::to_string(i) + ".h"), header);
        QCOMPARE(breachesIn(root, heaps), QStringList());
        writeFile(root / "tests/fuzz/unit27.h", header);
        QCOMPARE(breachesIn(root, heaps),
                 QStringList("tests/fuzz: 28 units, more than 27; divide the folder, or join what is one idea"));
        fs::remove(root / "tests/fuzz/unit27.h");
        fs::remove(root / "tests/fuzz/unit26.h");
        QCOMPARE(breachesIn(root, heaps), QStringList("tests/fuzz: 26 units; let its number among the heaps of "
                                                      "tests/structure/house_rules.cpp fall from 27"));
        fs::remove(root / "tests/fuzz/unit25.h");
        QCOMPARE(breachesIn(root, heaps),
                 QStringList("tests/fuzz: 25 units; let its number among the heaps of "
                             "tests/structure/house_rules.cpp fall from 27, that is, take its line "
                             "away"));
    }

    void acceptsWhatIsAllowed_data();
    void acceptsWhatIsAllowed();
    void findsTheBreach_data();
    void findsTheBreach();

private:
    static QStringList breachesWith(const QString& path, const QByteArray& text)
    {
        const QTemporaryDir folder;
        const fs::path root = folder.path().toStdString();
        writeGoodTree(root);
        writeFile(root / path.toStdString(), text.toStdString());
        return breachesIn(root);
    }
};

void IncludeDirectionTest::acceptsWhatIsAllowed_data()
{
    QTest::addColumn<QString>("path");
    QTest::addColumn<QByteArray>("include");
    QTest::newRow("nothing more") << "core/base/other.h" << QByteArray();
    QTest::newRow("own room") << "core/base/other.h" << QByteArray("#include \"core/base/result.h\"");
    QTest::newRow("a history knows meshes") << "core/history/writer.h" << QByteArray("#include \"core/mesh/mesh.h\"");
    QTest::newRow("data know the face of data") << "core/data/part.h" << QByteArray("#include <tan/data.h>");
    QTest::newRow("an interface knows the face") << "plugins/api/reader.h" << QByteArray("#include <tan/data.h>");
    QTest::newRow("renderers know meshes") << "core/render/order.h" << QByteArray("#include \"core/mesh/mesh.h\"");
    QTest::newRow("EGL in a source of core") << "core/render/context.cpp" << QByteArray("#include <EGL/egl.h>");
    QTest::newRow("plugin uses its own") << "plugins/builders/refinement/builder.cpp"
                                         << QByteArray("#include \"plugins/builders/refinement/builder.h\"");
    QTest::newRow("plugin uses the face and api")
        << "plugins/readers/lattice/reader.cpp"
        << QByteArray("#include <tan/data.h>\n#include \"plugins/api/builder.h\"");
    for (const char* file : {"plugins/editors/curve/panel.cpp", "plugins/widgets/box.cpp", "ui/window/window.cpp"})
        QTest::newRow(file) << file << QByteArray("#include <QString>");
    QTest::newRow("moc's output") << "ui/window/window.cpp" << QByteArray("#include \"window.moc\"");
    QTest::newRow("ui uses the host") << "ui/window/window.cpp" << QByteArray("#include \"plugins/host/host.h\"");
    QTest::newRow("ui uses shared widgets")
        << "ui/window/window.cpp" << QByteArray("#include \"plugins/widgets/value_box.h\"");
    QTest::newRow("editor uses shared widgets")
        << "plugins/editors/curve/panel.cpp" << QByteArray("#include \"plugins/widgets/value_box.h\"");
    QTest::newRow("a panel knows the viewport")
        << "ui/panels/view.cpp" << QByteArray("#include \"ui/viewport/canvas.h\"");
    QTest::newRow("app uses ui") << "app/main.cpp" << QByteArray("#include \"ui/window/window.h\"");
    QTest::newRow("tests use all") << "tests/plugins/heap_test.cpp"
                                   << QByteArray("#include \"plugins/builders/decimation/heap.h\"");
}

void IncludeDirectionTest::acceptsWhatIsAllowed()
{
    QFETCH(QString, path);
    QFETCH(QByteArray, include);
    const QByteArray start = QByteArray::fromStdString(path.endsWith(".h") ? header : licence);
    QCOMPARE(breachesWith(path, start + include + "\n"), QStringList());
}

void IncludeDirectionTest::findsTheBreach_data()
{
    QTest::addColumn<QString>("path");
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("breach");

    const QString data = "core/data/bad.h", render = "core/render/bad.h", lattice = "plugins/readers/lattice/bad.h";
    const auto row = [](const char* name, const QString& path, const char* include, const char* breach) {
        QTest::newRow(name) << path << QByteArray::fromStdString(header) + include + "\n" << path + ": " + breach;
    };
    row("base sees data", "core/base/bad.h", "#include \"core/data/lattice.h\"", "may not include core/data/lattice.h");
    row("data sees refinement", data, "#include \"core/refine/lattice/star.h\"",
        "may not include core/refine/lattice/star.h");
    row("a folder sees one in it", render, "#include \"core/render/cpu/tiles.h\"",
        "may not include core/render/cpu/tiles.h");
    row("mesh sees histories", "core/mesh/bad.h", "#include \"core/history/model.h\"",
        "may not include core/history/model.h");
    row("transfer sees rendering", "core/transfer/bad.h", "# include \"core/render/scene.h\"",
        "may not include core/render/scene.h");
    row("rendering sees data", render, "#include \"core/data/lattice.h\"", "may not include core/data/lattice.h");
    row("rendering sees histories", render, "#include \"core/history/model.h\"",
        "may not include core/history/model.h");
    row("core sees plugins", data, "#include \"plugins/api/builder.h\"", "may not include plugins/api/builder.h");
    row("core sees ui", data, "#include \"ui/window/window.h\"", "may not include ui/window/window.h");
    row("rendering sees the face of data", render, "#include <tan/data.h>", "may not include tan/data.h");
    row("an interface sees the inside", "plugins/api/bad.h", "#include \"core/data/lattice.h\"",
        "may not include core/data/lattice.h");
    row("the face sees the inside", "core/include/tan/data.h", "#include \"core/base/result.h\"",
        "may not include core/base/result.h");
    row("a face that is not there", data, "#include <tan/gone.h>",
        "includes \"tan/gone.h\", which is no file of this repository by its path from the root");
    row("api sees host", "plugins/api/bad.h", "#include \"plugins/host/host.h\"",
        "may not include plugins/host/host.h");
    row("host sees plugin", "plugins/host/bad.h", "#include \"plugins/readers/lattice/nrrd.h\"",
        "may not include plugins/readers/lattice/nrrd.h");
    row("plugin sees host", lattice, "#include \"plugins/host/host.h\"", "may not include plugins/host/host.h");
    row("renderer sees the inside", "plugins/renderers/volume/bad.cpp", "#include \"core/render/scene.h\"",
        "may not include core/render/scene.h");
    row("plugin sees plugin of its kind", "plugins/builders/refinement/bad.h",
        "#include \"plugins/builders/decimation/heap.h\"", "may not include plugins/builders/decimation/heap.h");
    for (const char* kind : {"builders", "renderers", "readers", "writers", "editors"})
        row(kind, QString("plugins/%1/some/bad.h").arg(kind), "#include \"core/data/lattice.h\"",
            "may not include core/data/lattice.h");
    row("widgets see the inside", "plugins/widgets/bad.h", "#include \"core/data/lattice.h\"",
        "may not include core/data/lattice.h");
    row("plugin sees ui", lattice, "#include \"ui/window/window.h\"", "may not include ui/window/window.h");
    row("plugin sees app", lattice, "#include \"app/commands.h\"", "may not include app/commands.h");
    row("editor sees ui", "plugins/editors/curve/bad.h", "#include \"ui/window/window.h\"",
        "may not include ui/window/window.h");
    row("editor sees host", "plugins/editors/curve/bad.h", "#include \"plugins/host/host.h\"",
        "may not include plugins/host/host.h");
    row("reader sees widgets", lattice, "#include \"plugins/widgets/value_box.h\"",
        "may not include plugins/widgets/value_box.h");
    row("widgets see api", "plugins/widgets/bad.h", "#include \"plugins/api/builder.h\"",
        "may not include plugins/api/builder.h");
    row("ui sees plugin", "ui/window/bad.h", "#include \"plugins/readers/lattice/nrrd.h\"",
        "may not include plugins/readers/lattice/nrrd.h");
    row("a session sees the workbench", "ui/session/bad.h", "#include \"ui/workbench/exporting.h\"",
        "may not include ui/workbench/exporting.h");
    row("scenes see what is opened", "ui/scenes/bad.h", "#include \"ui/opening/opening.h\"",
        "may not include ui/opening/opening.h");
    row("what is opened sees the workbench", "ui/opening/bad.h", "#include \"ui/workbench/exporting.h\"",
        "may not include ui/workbench/exporting.h");
    row("widgets see the viewport", "ui/widgets/bad.h", "#include \"ui/viewport/canvas.h\"",
        "may not include ui/viewport/canvas.h");
    row("a heap beside the folders of ui", "ui/bad.h", "",
        "this folder has no rule; give it one in tests/structure/house_rules.cpp");
    row("ui sees app", "ui/window/bad.h", "#include \"app/commands.h\"", "may not include app/commands.h");
    row("program sees tests", "app/bad.h", "#include \"tests/ui/robot.h\"", "may not include tests/ui/robot.h");

    row("Qt in core", data, "#include <QString>", "core is free of Qt, yet it includes QString");
    row("Qt in the command line", "app/command_line/info.cpp", "#include <QFile>",
        "the programs are free of Qt, yet it includes QFile");
    row("Qt by module", data, "#include <QtCore/qglobal.h>", "core is free of Qt, yet it includes QtCore/qglobal.h");
    row("Qt by small name", data, "#include <qglobal.h>", "core is free of Qt, yet it includes qglobal.h");
    const char* const ofPlugins = "plugins but editors are free of Qt, yet it includes QString";
    for (const char* file :
         {"plugins/readers/lattice/bad.h", "plugins/host/bad.h", "plugins/api/bad.h", "plugins/process/bad.h"})
        row(file, file, "#include <QString>", ofPlugins);
    row("GL in a core header", render, "#include <GL/gl.h>",
        "core's headers are free of OpenGL, yet it includes GL/gl.h");
    row("EGL in a core header", render, "#include <EGL/egl.h>",
        "core's headers are free of OpenGL, yet it includes EGL/egl.h");
    row("CGAL in a core header", data, "#include <CGAL/Object.h>",
        "core's headers are free of CGAL, yet it includes CGAL/Object.h");

    row("fonts outside of drawing", data, "#include <hb.h>",
        "texts of pictures are the matter of core/picture/drawing, yet it includes hb.h");

    const char* noFile = "includes \"lattice.h\", which is no file of this repository by its path from the root";
    row("relative include", data, "#include \"lattice.h\"", noFile);
    row("missing header", data, "#include \"core/base/gone.h\"",
        "includes \"core/base/gone.h\", which is no file of this repository by its path from the root");
    row("unknown room", "core/cellar/bad.h", "",
        "this folder has no rule; give it one in tests/structure/house_rules.cpp");

    const char* local = "the system's reason would be in the user's language; take systemErrorText()";
    row("strerror", data, "std::string text = std::strerror(errno);", local);
    row("a category's text", "ui/window/bad.h", "std::string text = std::generic_category().message(errno);", local);
    row("an error code's text", "app/bad.h", "std::string text = problem.message();", local);

    QTest::newRow("a text names what is gone")
        << "docs/developer/guide.md"
        << QByteArray("See `core/base/result.h` and `core/base/gone.cpp`, not /core/gone.h.\n")
        << "docs/developer/guide.md: names core/base/gone.cpp, which is not there";
    QTest::newRow("no licence line") << data << QByteArray("#pragma once\n")
                                     << data + ": the first line is not \"" +
                                            licence.substr(0, licence.size() - 1).c_str() + "\"";
    QTest::newRow("no pragma once") << data << QByteArray::fromStdString(licence)
                                    << data + ": a header without #pragma once";
}

void IncludeDirectionTest::findsTheBreach()
{
    QFETCH(QString, path);
    QFETCH(QByteArray, text);
    QFETCH(QString, breach);
    QCOMPARE(breachesWith(path, text), QStringList(breach));
}

QTEST_GUILESS_MAIN(IncludeDirectionTest)
#include "include_direction_test.moc"
