// SPDX-License-Identifier: GPL-3.0-or-later
// The library exports its face, and of its inside what is on a list: what TAn's own programs call, and plugins do not.
#include <QDirIterator>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QtTest>

namespace {

QString contentOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

/// The classes and functions that the headers below `folder` mark, without their namespace.
QStringList marked(const QString& folder, const QString& mark)
{
    static const QRegularExpression declaration(
        R"(\b(?:class|struct|enum class) %1 (\w+)|(?<!#define )%1 [^;{}()]*?(operator[^\s(]+|\w+)\()");
    const QRegularExpression pattern(declaration.pattern().arg(mark));
    QSet<QString> names;
    for (QDirIterator files(folder, {"*.h"}, QDir::Files, QDirIterator::Subdirectories); files.hasNext();) {
        static const QRegularExpression macros("^#define .*$", QRegularExpression::MultilineOption);
        const QString text = contentOf(files.next()).remove(macros); // of the mark itself, for one
        for (auto found = pattern.globalMatch(text); found.hasNext();) {
            const auto match = found.next();
            names.insert(match.captured(1).isEmpty() ? match.captured(2) : match.captured(1));
        }
    }
    QStringList sorted = names.values();
    sorted.sort();
    return sorted;
}

const QString source = TAN_SOURCE_DIR;

} // namespace

class ExportedSymbolsTest : public QObject {
    Q_OBJECT

private slots:
    void whatIsInsideIsListed()
    {
        QStringList listed = contentOf(source + "/tests/face/inner_symbols.txt").split('\n', Qt::SkipEmptyParts);
        listed.removeIf([](const QString& line) { return line.startsWith('#'); });
        QVERIFY(!listed.isEmpty());
        QCOMPARE(marked(source + "/core", "TAN_INTERNAL").join('\n'), listed.join('\n'));
    }

    void nothingElseIsExported_data()
    {
        QTest::addColumn<QString>("library");
        QTest::addColumn<int>("least");
        QTest::newRow("core") << QString(TAN_CORE_LIBRARY) << 200;
        QTest::newRow("picture") << QString(TAN_PICTURE_LIBRARY) << 12;
    }
    void nothingElseIsExported()
    {
        QFETCH(QString, library);
        QFETCH(int, least);
        QProcess list;
        list.start(TAN_NM, {"-DC", "--defined-only", library});
        QVERIFY(list.waitForFinished());
        const QStringList known =
            marked(source + "/core/include", "TAN_API") + marked(source + "/core", "TAN_INTERNAL");
        QVERIFY(known.size() > 100);
        static const QRegularExpression symbol(
            R"(^[0-9a-f]+ [A-Z] (?:(?:typeinfo|typeinfo name|vtable|VTT|guard variable) for )?tetra::(operator[^\s(]+|\w+))");
        QSet<QString> strangers;
        int exported = 0;
        for (const QString& line : QString::fromUtf8(list.readAllStandardOutput()).split('\n'))
            if (const auto match = symbol.match(line); match.hasMatch()) {
                ++exported;
                if (!known.contains(match.captured(1)))
                    strangers.insert(line.mid(19));
            }
        QVERIFY(exported > least);
        QVERIFY2(strangers.isEmpty(), qPrintable("\n" + QStringList(strangers.values()).join('\n')));
    }
};

QTEST_GUILESS_MAIN(ExportedSymbolsTest)
#include "exported_symbols_test.moc"
