// SPDX-License-Identifier: GPL-3.0-or-later
// Files of HDF5 can say that their values lie in another one. The libraries of NetCDF, CGNS and VTK would open that
// without a word, or give zeros for it; here such a file is refused.
#include "tests/lacks.h"
#include "tests/plugins/readers/vtk/vtk_test_files.h"

#include <QDir>
#include <QProcess>
#include <QTest>

using namespace tetra;

class LinkedFilesTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QProcess python;
        python.start("/usr/bin/python3", {TAN_SOURCE_DIR "/tests/plugins/readers/vtk/make_linked_files.py",
                                          QString::fromStdString(folder_.path().string())});
        const bool isOver = python.waitForFinished(120'000);
        QVERIFY2(isOver || python.error() == QProcess::FailedToStart, "the files are not written in two minutes");
        if (!isOver || python.exitCode() == 77)
            QSKIP_WITHOUT("python3-h5py");
        QVERIFY2(python.exitCode() == 0, python.readAllStandardError().constData());
    }

    void valuesOfOtherFilesAreNotRead_data()
    {
        QTest::addColumn<QString>("opened");
        QTest::addColumn<bool>("isGood");
        const QDir dir(QString::fromStdString(folder_.path().string()));
        for (const QString& name : dir.entryList({"*.*"}, QDir::Dirs | QDir::NoDotAndDotDot)) {
            const QStringList inside = QDir(dir.filePath(name)).entryList(QDir::Files);
            QCOMPARE(inside.size(), 1);
            QTest::newRow(qPrintable(name)) << name + '/' + inside.front() << name.endsWith(".good");
        }
    }
    void valuesOfOtherFilesAreNotRead()
    {
        QFETCH(QString, opened);
        QFETCH(bool, isGood);
        const std::filesystem::path path = folder_.path() / opened.toStdString();
        const auto dataset = readerOf(path).read(path, {}, {});
        const std::string told = dataset ? "it is read" : dataset.error().text();
        QVERIFY2(dataset.ok() == isGood, told.c_str());
        if (isGood)
            QCOMPARE(dataset->values.range().maximum, 26.);
        else
            QVERIFY2(told.find(path.filename().string()) != std::string::npos, told.c_str());
    }

    void eachOfThemIsTried()
    {
        const QDir dir(QString::fromStdString(folder_.path().string()));
        QCOMPARE(dir.entryList({"*.*"}, QDir::Dirs | QDir::NoDotAndDotDot).size(), 3 * 5);
    }

private:
    VtkFolder folder_;
};

QTEST_GUILESS_MAIN(LinkedFilesTest)
#include "linked_files_test.moc"
