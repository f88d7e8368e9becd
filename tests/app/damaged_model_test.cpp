// SPDX-License-Identifier: GPL-3.0-or-later
/// Commands on models whose files are damaged in one bit somewhere: what they write is what they write of the undamaged
/// one, or they end with exit code 3, say what to do, and leave nothing.
#include "tests/app/program.h"
#include "tests/app/sample_files.h"
#include "tests/core/history/model_fixture.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include <random>

using namespace tetra;

namespace {

/// What is asked of the model m.tan; OUT stands for a file.
const QList<QStringList> damagedModelCommands = {
    {"info", "m.tan", "--lod", "10,1,0", "--json"},
    {"info", "m.tan", "-o", "OUT.csv"},
    {"extract", "m.tan", "--error", "0", "-o", "OUT.vtu"},
    {"extract", "m.tan", "--error", "20", "--focus", "sphere:5,5,5,3", "--focus-error", "1", "-o", "OUT.vtu"},
    {"extract", "m.tan", "--budget", "900", "-o", "OUT.vtu"},
    {"extract", "m.tan", "--range", "20,1", "-o", "OUT.vtu"},
    {"isosurface", "m.tan", "--error", "2", "--value", "120", "-o", "OUT.vtu"},
    {"render", "m.tan", "--error", "2", "--isovalue", "120", "--size", "40x40", "-o", "OUT.png"},
};

} // namespace

class DamagedModelTest : public QObject {
    Q_OBJECT

private:
    struct Answer {
        Run run;
        QByteArray file; ///< that it wrote; what it printed if it was not told to write one
    };

    QString path(const QString& name) const { return folder_.filePath(name); }

    Answer ask(QStringList words) const
    {
        const bool writes = words.last().startsWith("OUT");
        if (writes)
            words.last().replace("OUT", "out");
        const Run run = runTan(words, folder_.path());
        Answer answer{run, writes ? readFile(path(words.last())) : run.output};
        if (writes && run.exitCode == 0)
            QFile::remove(path(words.last()));
        return answer;
    }

    QTemporaryDir folder_;

private slots:
    void theRightAnswerOrNone_data()
    {
        QTest::addColumn<bool>("isOld");
        QTest::newRow("checksums of chunks") << false;
        QTest::newRow("checksums of sections") << true;
    }
    void theRightAnswerOrNone()
    {
        QFETCH(bool, isOld);
        QVERIFY(writeFile(path("noise.nrrd"), nrrd("uint8", "10 11 12", bytes(10 * 11 * 12))));
        const Run build = runTan({"build", "noise.nrrd", "-o", "m.tan"}, folder_.path());
        QVERIFY2(build.exitCode == 0, build.messages);
        FileParts whole(readBytes(path("m.tan").toStdString()));
        if (isOld)
            whole.removeChunkSums();
        writeBytes(path("m.tan").toStdString(), whole.content);
        QList<QByteArray> expected;
        for (const QStringList& command : damagedModelCommands) {
            const Answer answer = ask(command);
            QVERIFY2(answer.run.exitCode == 0 && !answer.file.isEmpty(), answer.run.messages);
            expected.append(answer.file);
        }
        const QStringList before = QDir(folder_.path()).entryList(QDir::AllEntries | QDir::Hidden);
        std::mt19937 random(isOld ? 2 : 1);
        int right = 0, refused = 0;
        for (std::size_t number = 0; number < whole.sections().size(); ++number) {
            FileParts parts(whole.content);
            const format::Section& section = parts.sections()[number];
            parts.content[section.offset + random() % section.bytes] ^= std::byte(1u << random() % 8);
            writeBytes(path("m.tan").toStdString(), parts.content);
            for (qsizetype i = 0; i < damagedModelCommands.size(); ++i) {
                const auto [run, file] = ask(damagedModelCommands[i]);
                const QByteArray what =
                    damagedModelCommands[i].join(' ').toUtf8() + ", section " + QByteArray::number(section.id);
                if (run.exitCode == 0) {
                    QVERIFY2(file == expected[i], what);
                    ++right;
                    continue;
                }
                QVERIFY2(run.exitCode == 3, what);
                QVERIFY2(run.messages.contains("'m.tan' is damaged") &&
                             run.messages.contains("Copy the file again, or build it again."),
                         run.messages);
                QVERIFY(QDir(folder_.path()).entryList(QDir::AllEntries | QDir::Hidden) == before);
                ++refused;
            }
        }
        QVERIFY(refused > 30);
        QCOMPARE(right == 0, isOld); // of an old file all of every section counts
    }
};

QTEST_GUILESS_MAIN(DamagedModelTest)
#include "damaged_model_test.moc"
