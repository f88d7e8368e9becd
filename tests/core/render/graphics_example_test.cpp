// SPDX-License-Identifier: GPL-3.0-or-later
// The example of docs/developer/tetrahedral-graphics.md is what is compiled here, and draws what it says.
#include <QFile>
#include <QImage>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

namespace {

QString contentOf(const QString& path)
{
    QFile file(QString(TAN_SOURCE_DIR) + "/" + path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

} // namespace

class GraphicsExampleTest : public QObject {
    Q_OBJECT

private slots:
    void isTheOneInTheText()
    {
        const QString source = contentOf("tests/core/render/graphics_example.cpp");
        QVERIFY(source.contains("makeCpuBackend"));
        const QString code = source.mid(source.indexOf("#include"));
        QVERIFY(contentOf("docs/developer/tetrahedral-graphics.md").contains("```cpp\n" + code + "```\n"));
    }

    void drawsABallOfFog()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath("fog.ppm");
        QCOMPARE(QProcess::execute(TAN_GRAPHICS_EXAMPLE, {path}), 0);
        const QImage picture(path);
        QCOMPARE(picture.size(), QSize(320, 240));
        QVERIFY(picture.pixelColor(160, 120).red() > 80);
        QCOMPARE(picture.pixelColor(0, 0), QColor(Qt::black));
    }
};

QTEST_GUILESS_MAIN(GraphicsExampleTest)
#include "graphics_example_test.moc"
