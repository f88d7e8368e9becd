// SPDX-License-Identifier: GPL-3.0-or-later
// Gaussian cubes: every value in its place, whatever the axes, units and numbers of values.
#include "tests/plugins/readers/lattice/format_files.h"

#include <QtTest>

using namespace tetra;

namespace {

/// What a cube has besides its numbers.
struct CubeStyle {
    int atoms = 2;
    bool inAngstrom = false;
    QByteArray behindAtoms{}; ///< at the end of the third line
    QByteArray orbitals{};    ///< the line behind the atoms
    QByteArray lineEnd = "\n";
};

QByteArray cubeHeader(const WorldVolume& world, const CubeStyle& style)
{
    QByteArray text = " a molecule" + style.lineEnd + "density" + style.lineEnd;
    text += "  " + QByteArray::number(style.orbitals.isEmpty() ? style.atoms : -style.atoms) + " " +
            threeNumbers(world.origin) + style.behindAtoms + style.lineEnd;
    for (int axis = 0; axis < 3; ++axis)
        text += (style.inAngstrom ? "-" : " ") + QByteArray::number(world.size[static_cast<std::size_t>(axis)]) + " " +
                threeNumbers(world.steps.col(axis)) + style.lineEnd;
    for (int atom = 0; atom < style.atoms; ++atom)
        text += "    6    6.000000    0.100000    0.200000   -0.300000" + style.lineEnd;
    return text + style.orbitals;
}

Eigen::Matrix3d obliqueSteps()
{
    Eigen::Matrix3d steps;
    steps << 0.4, 0.1, 0, 0, 0.5, -0.2, 0.05, 0, 0.6;
    return steps;
}

} // namespace

class CubeReaderTest : public QObject {
    Q_OBJECT

private slots:
    void liesWhereItSays_data()
    {
        QTest::addColumn<Eigen::Matrix3d>("steps");
        int number = 0;
        for (const Eigen::Matrix3d& permutation : signedPermutations())
            QTest::addRow("permutation %d", number++)
                << Eigen::Matrix3d(permutation * Eigen::Vector3d(0.4, 0.3, 0.7).asDiagonal());
        QTest::newRow("oblique") << obliqueSteps();
    }
    void liesWhereItSays()
    {
        QFETCH(Eigen::Matrix3d, steps);
        const WorldVolume world{{4, 5, 6}, steps, {-1, 2.5, 0.25}, 1};
        const auto dataset = read(cubeHeader(world, {}) + world.lastFastest(textNumber));
        QVERIFY2(dataset, text_);
        QVERIFY((dataset->lattice.size == world.size));
        QVERIFY(distanceFromWorld(*dataset, 1) < 1e-12);
        QVERIFY((dataset->position(0) - world.origin).norm() == 0);
        QCOMPARE(dataset->lengthUnit, std::string("bohr"));
        QCOMPARE(sentences(dataset->source.leftOut), QByteArray("It names 2 atoms, which are not shown.\n"));
        QVERIFY(dataset->source.taken.empty() && dataset->source.valueName.empty() && dataset->remarks.empty());
    }

    void otherStyles()
    {
        const WorldVolume world{{3, 4, 5}, obliqueSteps(), {1, 2, 3}, 1};
        const auto windows = read(cubeHeader(world, {.atoms = 1, .lineEnd = "\r\n"}) +
                                  world.lastFastest([](double value) { return textNumber(value) + "\r\n"; }));
        QVERIFY2(windows, text_);
        QVERIFY(distanceFromWorld(*windows, 1) < 1e-12);
        QCOMPARE(sentences(windows->source.leftOut), QByteArray("It names 1 atom, which is not shown.\n"));
        const auto angstrom = read(cubeHeader(world, {.atoms = 0, .inAngstrom = true}) + world.lastFastest(textNumber));
        QVERIFY2(angstrom, text_);
        QVERIFY(distanceFromWorld(*angstrom, 1) < 1e-12);
        QCOMPARE(angstrom->lengthUnit, std::string("angstrom"));
        QVERIFY(angstrom->source.leftOut.empty());
        const auto fortran = read(cubeHeader(world, {}) +
                                  world.lastFastest([](double value) { return textNumber(value).replace('e', 'D'); }));
        QVERIFY2(fortran, text_);
        QVERIFY(distanceFromWorld(*fortran, 1) < 1e-12);
    }

    void exponentsOfThreeDigits()
    {
        WorldVolume world;
        world.size = {2, 2, 2};
        const auto dataset = read(cubeHeader(world, {}) + "0.5-101 -0.25+102 1.E-400 -2.5d-99 +3 4.0E+00 .5 -0.1D-330");
        QVERIFY2(dataset, text_);
        // The last index runs fastest in the file, the first one in the dataset.
        const std::array<double, 8> numbers{0.5e-101, 3, 0, .5, -0.25e102, 4, -2.5e-99, 0};
        for (std::uint64_t n = 0; n < numbers.size(); ++n)
            QCOMPARE(dataset->values.at(n), numbers[n]);
    }

    void oneOfSeveralOrbitals()
    {
        const WorldVolume world{{3, 4, 5}, obliqueSteps(), {1, 2, 3}, 1};
        const auto both = [](double value) { return textNumber(100 - value) + textNumber(value); };
        const QByteArray orbitals = cubeHeader(world, {.orbitals = "   2   21\n   22\n"}) + world.lastFastest(both);
        for (const char* const name : {"orbital 22", "2"}) {
            const auto second = read(orbitals, {{"array", std::string(name)}});
            QVERIFY2(second, text_);
            QVERIFY(distanceFromWorld(*second, 1) < 1e-12);
            QCOMPARE(second->source.valueName, std::string("orbital 22"));
            QCOMPARE(takenWords(second->source.taken), QByteArray("array: orbital 22, number 2 of 2\n"));
        }
        const auto first = read(orbitals);
        QVERIFY2(first, text_);
        QVERIFY(std::abs(first->values.at(0) - (100 - world.at(0, 0, 0))) < 1e-12);
        QCOMPARE(takenWords(first->source.taken), QByteArray("array: orbital 21, number 1 of 2 (a guess)\n"));
        QVERIFY(sentences(first->source.leftOut).contains("2 values at each point"));
        const auto contents = asLoaded<LatticeReader>().probe(folder_.write("volume.cube", orbitals), {}, {});
        QVERIFY(contents.ok() && contents->arrays.size() == 2 && contents->arrays[1].name == "orbital 22");
        QCOMPARE(refusal(orbitals, {"'orbital 23'", "orbital 21, orbital 22"}, {{"array", std::string("orbital 23")}}),
                 QByteArray());
        const auto one = read(cubeHeader(world, {.orbitals = " 1 7\n"}) + world.lastFastest(textNumber));
        QVERIFY2(one, text_);
        QVERIFY(distanceFromWorld(*one, 1) < 1e-12);
        QVERIFY(one->source.taken.empty());
        QCOMPARE(one->source.valueName, std::string("orbital 7"));
        const auto values = read(cubeHeader(world, {.behindAtoms = " 2"}) + world.lastFastest(both),
                                 {{"array", std::string("value 2")}});
        QVERIFY2(values, text_);
        QVERIFY(distanceFromWorld(*values, 1) < 1e-12);
    }

    void refuses_data()
    {
        QTest::addColumn<QByteArray>("file");
        QTest::addColumn<QList<QByteArray>>("words");
        WorldVolume world;
        world.size = {2, 2, 2};
        const QByteArray numbers = "1 2 3 4 5 6 7 8\n";
        const QByteArray header = cubeHeader(world, {});
        const auto row = [](const char* name, const QByteArray& file, const QList<QByteArray>& words) {
            QTest::newRow(name) << file << words;
        };
        const auto lines = [](const QByteArray& atoms, const QByteArray& axes) {
            return "a\nb\n" + atoms + "\n" + axes + "1 2 3 4 5 6 7 8\n";
        };
        const QByteArray axes = "2 1 0 0\n2 0 1 0\n2 0 0 1\n";
        row("no cube", "nothing of the kind", {"ends in its header", "line 1"});
        row("colours", "TITLE \"film\"\nLUT_3D_SIZE 2\n0 0 0\n", {"table of colours"});
        row("titles alone", "a\nb\n", {"ends in its header", "line 2"});
        row("no number of atoms", lines("many 0 0 0", axes), {"line 3", "number of atoms"});
        row("no first point", lines("0 0 0", axes), {"line 3", "first point"});
        row("no axis", lines("0 0 0 0", "2 1 0 0\n2 0 1\n2 0 0 1\n"), {"line 5", "step"});
        row("atoms that are not there", lines("9000000000000000000 0 0 0", axes), {"ends in its header", "line 7"});
        row("the least number of atoms", lines("-9223372036854775808 0 0 0", axes), {"ends in its header", "line 7"});
        row("atoms to the end", lines("3 0 0 0", axes + "1 1 0 0 0\n").left(46), {"ends in its header"});
        row("no atom", lines("1 0 0 0", axes + "1 1 0 0\n"), {"line 7", "atom"});
        row("no orbitals", "a\nb\n-1 0 0 0\n" + axes + "1 1 0 0 0\n0\n" + numbers, {"orbitals"});
        row("endless orbitals", "a\nb\n-1 0 0 0\n" + axes + "1 1 0 0 0\n18446744073709551615 1\n" + numbers,
            {"orbitals"});
        row("too few orbitals", "a\nb\n-1 0 0 0\n" + axes + "1 1 0 0 0\n3 1 2 x\n" + numbers, {"3 orbitals"});
        row("values that are no number", lines("0 0 0 0 x", axes), {"line 3", "'x'"});
        row("no values", lines("0 0 0 0 0", axes), {"line 3", "'0'"});
        row("endless values", lines("0 0 0 0 5000000000000000000", axes), {"line 3"});
        row("more values than orbitals can be", lines("0 0 0 0 10001", axes) + QByteArray("1 ").repeated(6000),
            {"10001 values at each point"});
        row("more values than text", lines("0 0 0 0 9", axes), {"72 numbers", "16 bytes of text", "cut short"});
        row("signs that differ", lines("0 0 0 0", "2 1 0 0\n-2 0 1 0\n2 0 0 1\n"), {"negative along some axes"});
        row("one point", lines("0 0 0 0", "1 1 0 0\n2 0 1 0\n2 0 0 1\n"), {"1 x 2 x 2", "at least 2"});
        row("no points", lines("0 0 0 0", "0 1 0 0\n2 0 1 0\n2 0 0 1\n"), {"at least 2"});
        row("endless points", lines("0 0 0 0", "1000000000000000000 1 0 0\n2 0 1 0\n2 0 0 1\n"),
            {"1000000000000000000"});
        row("more points than text", lines("0 0 0 0", "2000 1 0 0\n2000 0 1 0\n2000 0 0 1\n"), {"cut short"});
        row("steps in a plane", lines("0 0 0 0", "2 1 0 0\n2 0 1 0\n2 1 1 0\n"), {"plane"});
        row("no step", lines("0 0 0 0", "2 0 0 0\n2 0 1 0\n2 0 0 1\n"), {"."});
        row("an origin that is none", lines("0 nan 0 0", axes), {"finite"});
        row("stars", header + "1 2 3 4 5 6 7 *******\n", {"number 8", "'*******'"});
        row("too few numbers", header + "1.000000000 2 3 4 5 6 7\n", {"only 7 numbers", "8"});
        row("too many numbers", header + "1 2 3 4 5 6 7 8 9\n", {"more than the 8 numbers"});
        row("bytes", header + QByteArray("1 2 3 4 5 6 7 \x01\x02\x00\xff\n", 19), {"number 8"});
    }
    void refuses()
    {
        QFETCH(QByteArray, file);
        QFETCH(QList<QByteArray>, words);
        QCOMPARE(refusal(file, words), QByteArray());
    }

    void refusesAnotherPlace()
    {
        const WorldVolume world;
        const QByteArray file = cubeHeader(world, {}) + world.lastFastest(textNumber);
        QCOMPARE(refusal(file, {"states its spacing itself"}, {{"spacing", std::string("1x1x1")}}), QByteArray());
        QCOMPARE(refusal(file, {"states its unit itself"}, {{"unit", std::string("nm")}}), QByteArray());
        QCOMPARE(refusal(file, {"one number for each sample"}, {{"component", std::string("1")}}), QByteArray());
    }

    void cutFilesAreRefused()
    {
        WorldVolume world;
        world.size = {2, 2, 2};
        const QByteArray file = cubeHeader(world, {}) + "1 2 3 4 5 6 7 8";
        for (qsizetype bytes = 1; bytes < file.size(); ++bytes)
            QCOMPARE(refusal(file.left(bytes), {"volume.cube"}), QByteArray());
    }

    void valuesThatAreNotFiniteAreHoles()
    {
        WorldVolume world;
        world.size = {2, 2, 3};
        const auto dataset = read(cubeHeader(world, {}) + "1 2 3 4 5 6 7 8 9 10 11 nan");
        QVERIFY2(dataset, text_);
        QCOMPARE(dataset->values.notFiniteCount(), std::uint64_t(1));
    }

private:
    std::optional<Dataset> read(const QByteArray& file, const ParameterValues& values = {})
    {
        return readFormat(folder_.write("volume.cube", file), text_, values);
    }
    QByteArray refusal(const QByteArray& file, const QList<QByteArray>& words, const ParameterValues& values = {})
    {
        return refusalFault(folder_.write("volume.cube", file), words, values);
    }

    TestFolder folder_;
    QByteArray text_;
};

QTEST_GUILESS_MAIN(CubeReaderTest)
#include "cube_reader_test.moc"
