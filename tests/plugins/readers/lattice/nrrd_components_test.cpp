// SPDX-License-Identifier: GPL-3.0-or-later
// NRRD of more than one number at a point, of several volumes, and of integers wider than TAn's.
#include "plugins/readers/lattice/lattice_reader.h"
#include "tests/plugins/as_loaded.h"
#include "tests/plugins/readers/lattice/told.h"
#include "tests/plugins/readers/lattice/volume_files.h"

#include <QtTest>

#include <array>
#include <cmath>

using namespace tetra;

namespace {

/// The number of component c of point n in step s, out of which all of them can be told.
double numberOf(int n, int c, int s)
{
    return n + 100 * c + 1000 * s;
}

/// Of 3 x 4 x 5 points, `components` and `steps` with the axes in this order, fastest first: x, y, z, c and t.
QByteArray numbersInOrder(const QByteArray& axes, int components, int steps)
{
    const auto sizeOf = [&](char axis) {
        return axis == 'x' ? 3 : axis == 'y' ? 4 : axis == 'z' ? 5 : axis == 'c' ? components : steps;
    };
    QByteArray bytes;
    for (int number = 0; number < testPoints * components * steps; ++number) {
        int rest = number, x = 0, y = 0, z = 0, c = 0, t = 0;
        for (const char axis : axes) {
            (axis == 'x' ? x : axis == 'y' ? y : axis == 'z' ? z : axis == 'c' ? c : t) = rest % sizeOf(axis);
            rest /= sizeOf(axis);
        }
        const auto value = static_cast<float>(numberOf(x + 3 * (y + 4 * z), c, t));
        bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
    }
    return bytes;
}

constexpr const char* nativeOrder = std::endian::native == std::endian::little ? "little" : "big";

} // namespace

class NrrdComponentsTest : public QObject {
    Q_OBJECT

private slots:
    void componentsAndStepsStandAnywhere_data()
    {
        QTest::addColumn<QByteArray>("order");
        QTest::addColumn<QByteArray>("fields");
        QTest::newRow("vectors") << QByteArray("cxyz")
                                 << QByteArray("sizes: 3 3 4 5\nkinds: vector space space space\n");
        QTest::newRow("colours") << QByteArray("cxyz")
                                 << QByteArray("sizes: 3 3 4 5\nkinds: RGB-color domain domain domain\n");
        QTest::newRow("the last axis") << QByteArray("xyzc")
                                       << QByteArray("sizes: 3 4 5 3\nkinds: domain domain domain 3-vector\n");
        QTest::newRow("between others") << QByteArray("xcyz")
                                        << QByteArray("sizes: 3 3 4 5\nkinds: domain 3-color domain domain\n");
        QTest::newRow("without kinds, outside space")
            << QByteArray("cxyz") << QByteArray("sizes: 3 3 4 5\nspace directions: none (1,0,0) (0,1,0) (0,0,1)\n");
        QTest::newRow("with steps") << QByteArray("cxyzt")
                                    << QByteArray("sizes: 3 3 4 5 2\nkinds: vector space space space time\n");
        QTest::newRow("with a list in front")
            << QByteArray("tcxyz") << QByteArray("sizes: 2 3 3 4 5\nkinds: list vector space space space\n");
    }
    void componentsAndStepsStandAnywhere()
    {
        QFETCH(QByteArray, order);
        QFETCH(QByteArray, fields);
        const int steps = order.contains('t') ? 2 : 1;
        const auto path = write(fields + "dimension: " + QByteArray::number(order.size()) +
                                    "\ntype: float\nendian: " + nativeOrder + "\n",
                                numbersInOrder(order, 3, steps));
        for (int c = 0; c < 3; ++c)
            for (int s = 0; s < steps; ++s) {
                ParameterValues values{{"component", std::to_string(c)}};
                if (steps > 1)
                    values["time"] = std::int64_t(s + 1);
                const auto dataset = asLoaded<LatticeReader>().read(path, values, {});
                QVERIFY2(dataset, dataset ? "" : dataset.error().text().c_str());
                QCOMPARE(dataset->lattice.size, (std::array<std::uint32_t, 3>{3, 4, 5}));
                for (int n = 0; n < testPoints; ++n)
                    QCOMPARE(dataset->values.at(static_cast<std::uint64_t>(n)), numberOf(n, c, s));
                QCOMPARE(takenOf(dataset->source.taken, TakenPart::Component),
                         "component: " + std::to_string(c) + " of 3, counted from 0");
            }
        const auto all = asLoaded<LatticeReader>().read(path, {}, {});
        QVERIFY2(all, all ? "" : all.error().text().c_str());
        for (int n = 0; n < testPoints; ++n)
            QCOMPARE(all->values.at(static_cast<std::uint64_t>(n)),
                     static_cast<double>(static_cast<float>(std::hypot(n, n + 100., n + 200.))));
        QCOMPARE(takenOf(all->source.taken, TakenPart::Component), std::string("component: magnitude of 3 (a guess)"));
        QCOMPARE(takenOf(all->source.taken, TakenPart::TimeStep),
                 std::string(steps > 1 ? "time step: 1 of 2 (a guess)" : ""));
        const auto contents = LatticeReader().probe(path, {}, {});
        QVERIFY(contents && contents->arrays.at(0).components == 3 && contents->taken == all->source.taken);
    }

    void stepsHaveTheirTimes()
    {
        const auto path = write(QByteArray("dimension: 4\nsizes: 3 4 5 2\nkinds: space space space time\nspacings: 1 1 "
                                           "1 0.5\naxis mins: 0 0 0 10\ntype: float\nendian: ") +
                                    nativeOrder + "\n",
                                numbersInOrder("xyzt", 1, 2));
        const auto second = asLoaded<LatticeReader>().read(path, {{"time", std::int64_t(2)}}, {});
        QVERIFY2(second, second ? "" : second.error().text().c_str());
        QCOMPARE(second->values.at(7), numberOf(7, 0, 1));
        QCOMPARE(takenOf(second->source.taken, TakenPart::TimeStep), std::string("time step: 2 of 2, time 10.5"));
        QVERIFY(says(second->source.leftOut, "It holds 2 volumes"));
        QCOMPARE(LatticeReader().probe(path, {}, {})->timeSteps, (std::vector<double>{10, 10.5}));
        const auto third = LatticeReader().read(path, {{"time", std::int64_t(3)}}, {});
        QCOMPARE(third.error().kind, ErrorKind::WrongUsage);
    }

    /// Off the diagonal they have each number once: the root of the sum of squares is nothing.
    void halvesOfMatricesHaveNoMagnitude()
    {
        const auto path = write(QByteArray("dimension: 4\nsizes: 6 3 4 5\nkinds: 3D-symmetric-matrix space space "
                                           "space\ntype: float\nendian: ") +
                                    nativeOrder + "\n",
                                numbersInOrder("cxyz", 6, 1));
        const auto refused = LatticeReader().read(path, {}, {});
        QVERIFY(!refused && refused.error().kind == ErrorKind::WrongUsage);
        QVERIFY(refused.error().text().find("3d-symmetric-matrix") != std::string::npos);
        const auto last = asLoaded<LatticeReader>().read(path, {{"component", std::string("5")}}, {});
        QVERIFY(last && last->values.at(11) == numberOf(11, 5, 0));
    }

    void wideIntegersBecomeWhatHoldsThem_data()
    {
        constexpr std::int64_t large = std::int64_t(1) << 53;
        QTest::addColumn<QByteArray>("type");
        QTest::addColumn<qint64>("least");
        QTest::addColumn<qint64>("most");
        QTest::addColumn<int>("becomes");
        QTest::addColumn<bool>("isExact");
        const auto row = [](const char* type, qint64 least, qint64 most, SampleType becomes, bool isExact = true) {
            QTest::addRow("%s from %lld to %lld", type, least, most)
                << QByteArray(type) << least << most << static_cast<int>(becomes) << isExact;
        };
        row("int64", -7, 1000, SampleType::Int32);
        row("long long", -5, large, SampleType::Float64);
        row("longlong", -large - 1, 3, SampleType::Float64, false);
        row("uint64_t", 0, 4'000'000'000, SampleType::UInt32);
        row("ulonglong", 1, large + 1, SampleType::Float64, false);
    }
    void wideIntegersBecomeWhatHoldsThem()
    {
        QFETCH(QByteArray, type);
        QFETCH(qint64, least);
        QFETCH(qint64, most);
        QFETCH(int, becomes);
        QFETCH(bool, isExact);
        for (const bool isLittle : {true, false}) {
            QByteArray bytes;
            for (const qint64 number : {least, most, qint64(0), qint64(1), qint64(2), qint64(3), qint64(4), qint64(5)})
                for (int byte = 0; byte < 8; ++byte)
                    bytes += static_cast<char>(number >> 8 * (isLittle ? byte : 7 - byte));
            const QByteArray fields =
                "sizes: 2 2 2\ntype: " + type + "\nendian: " + (isLittle ? "little" : "big") + "\n";
            for (const bool isPacked : {false, true}) {
                const auto path = isPacked ? write(fields + "encoding: gzip\n", gzipped(bytes)) : write(fields, bytes);
                const auto dataset = asLoaded<LatticeReader>().read(path, {}, {});
                QVERIFY2(dataset, dataset ? "" : dataset.error().text().c_str());
                QCOMPARE(static_cast<int>(dataset->values.type()), becomes);
                QCOMPARE(dataset->values.at(0), static_cast<double>(least));
                QCOMPARE(dataset->values.at(1), static_cast<double>(most));
                QCOMPARE(dataset->values.at(7), 5.);
                QCOMPARE(says(dataset->remarks, "53 bits"), !isExact);
            }
        }
    }

private:
    std::filesystem::path write(const QByteArray& fields, const QByteArray& samples)
    {
        return folder_.write("volume.nrrd", nrrdHeader(fields) + samples);
    }

    TestFolder folder_;
};

QTEST_GUILESS_MAIN(NrrdComponentsTest)
#include "nrrd_components_test.moc"
