// SPDX-License-Identifier: GPL-3.0-or-later
// Damaged files are read or refused, never anything else: thousands of mutations of valid ones, always the same.
#include "plugins/readers/lattice/lattice_reader.h"
#include "tests/plugins/readers/lattice/volume_files.h"
#include "tests/soak.h"

#include <QtTest>

#include <random>

using namespace tetra;

namespace {

QList<QByteArray> validFiles()
{
    const QByteArray space = "space directions: (0.5,0,0) (0,0.1,0) (0,0,3)\nspace origin: (1,2,-3)\n";
    const QByteArray little = "endian: little\n";
    const QByteArray words = "1 2.5 -3 4e2 5 6 7 8";
    return {
        nrrdHeader("spacings: 1 2 3\naxis mins: 0 0 0\n# note\nkey:=value\n") + testSamples(SampleType::UInt8),
        nrrdHeader(space + little + "type: short\nline skip: 1\nbyte skip: 2\n") + "x\nab" +
            testSamples(SampleType::Int16),
        nrrdHeader(space + little + "type: double\nencoding: gzip\n") + gzipped(testSamples(SampleType::Float64)),
        nrrdHeader("type: float\nencoding: ascii\nsizes: 2 2 2\ncenters: cell cell node\n") + words,
        nrrdHeader("dimension: 4\nsizes: 3 1 4 5\nbyte skip: -1\nkinds: domain vector domain domain\n") +
            testSamples(SampleType::UInt8),
    };
}

/// Words that a damaged or hostile header could hold.
QByteArray evilWord(std::mt19937& random)
{
    static const QList<QByteArray> words = {"-1",
                                            "0",
                                            "1",
                                            "18446744073709551615",
                                            "4294967296",
                                            "1e308",
                                            "nan",
                                            "-inf",
                                            "(",
                                            ")",
                                            "none",
                                            "LIST",
                                            "%d",
                                            "\n",
                                            "\n\n",
                                            ":",
                                            ":=",
                                            "#",
                                            "NRRD0004",
                                            "double",
                                            "gzip",
                                            "ascii",
                                            "99999999999999999999",
                                            QByteArray(1, '\0')};
    return words[static_cast<qsizetype>(random() % static_cast<unsigned>(words.size()))];
}

QByteArray mutated(QByteArray file, std::mt19937& random)
{
    const auto place = [&] { return static_cast<qsizetype>(random() % static_cast<unsigned>(file.size() + 1)); };
    for (unsigned change = 0; change <= random() % 4; ++change)
        switch (random() % 6) {
        case 0: file.truncate(place()); break;
        case 1: file.insert(place(), evilWord(random)); break;
        case 2: file.replace(place(), random() % 8, evilWord(random)); break;
        case 3: file.remove(place(), random() % 8); break;
        case 4: file.insert(place(), file.mid(place(), random() % 64)); break;
        default:
            if (const qsizetype at = place(); at < file.size())
                file[at] = static_cast<char>(random());
        }
    return file;
}

} // namespace

class LatticeMutationsTest : public QObject {
    Q_OBJECT

private slots:
    void validFilesAreRead()
    {
        QVERIFY(!validFiles().empty());
        for (const QByteArray& file : validFiles())
            QVERIFY(readNrrd(file).ok());
    }

    void mutationsAreReadOrRefused()
    {
        std::mt19937 random(seedOf(20240229));
        int read = 0;
        for (int round = 0; round < 6000; ++round)
            for (const QByteArray& file : validFiles()) {
                const Result<Dataset> dataset = readNrrd(mutated(file, random));
                if (!dataset) {
                    QVERIFY(dataset.error().text().size() > 10);
                    continue;
                }
                ++read;
                QCOMPARE(dataset->values.count(), dataset->lattice.pointCount());
                QCOMPARE(dataset->values.notFiniteCount(), std::uint64_t(0));
                QVERIFY((dataset->lattice.spacing.array() > 0).all() || dataset->domain == DomainClass::Irregular);
            }
        QVERIFY(read > 100); // the mutations are not all fatal, so that what lies behind the header is tried, too
    }

private:
    Result<Dataset> readNrrd(const QByteArray& file) const
    {
        const auto dataset = LatticeReader().read(folder_.write("volume.nrrd", file), {}, {});
        return dataset ? withHoles(*dataset) : dataset;
    }

    TestFolder folder_;
};

QTEST_GUILESS_MAIN(LatticeMutationsTest)
#include "lattice_mutations_test.moc"
