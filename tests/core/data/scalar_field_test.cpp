// SPDX-License-Identifier: GPL-3.0-or-later
// Scalar fields, their sample types and the lattice under them: what every reader and builder relies on.
#include <tan/data.h>

#include <QTest>

#include <algorithm>
#include <limits>
#include <stop_token>
#include <string_view>
#include <vector>

using namespace tetra;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

template <class T> ScalarField fieldOf(SampleType type, const std::vector<T>& values)
{
    const auto samples = std::make_shared<std::vector<T>>(values);
    return {type, values.size(), {samples, reinterpret_cast<const std::byte*>(samples->data())}};
}

} // namespace

class ScalarFieldTest : public QObject {
    Q_OBJECT

private slots:
    void holdsTheLimitsOfEveryType_data();
    void holdsTheLimitsOfEveryType();
    void leavesOutWhatIsNotFinite_data();
    void leavesOutWhatIsNotFinite();
    void largeFieldsAreTheSameInParts();
    void copiesShareTheSamples();
    void emptyFieldHasNoExtent();
    void latticeNumbersItsPoints();
    void latticeBounds();
    void absurdBuffersAreRefused();
    void scanningTellsHowFarItIsAndStops();
};

void ScalarFieldTest::holdsTheLimitsOfEveryType_data()
{
    QTest::addColumn<SampleType>("type");
    QTest::addColumn<QString>("name");
    QTest::newRow("uint8") << SampleType::UInt8 << "uint8";
    QTest::newRow("int8") << SampleType::Int8 << "int8";
    QTest::newRow("uint16") << SampleType::UInt16 << "uint16";
    QTest::newRow("int16") << SampleType::Int16 << "int16";
    QTest::newRow("uint32") << SampleType::UInt32 << "uint32";
    QTest::newRow("int32") << SampleType::Int32 << "int32";
    QTest::newRow("float") << SampleType::Float32 << "float";
    QTest::newRow("double") << SampleType::Float64 << "double";
}

void ScalarFieldTest::holdsTheLimitsOfEveryType()
{
    QFETCH(SampleType, type);
    QFETCH(QString, name);
    QCOMPARE(QString::fromStdString(std::string(sampleTypeName(type))), name);
    visitSampleType(type, [&]<class T>() {
        QCOMPARE(sampleSize(type), sizeof(T));
        QCOMPARE(isInteger(type), std::is_integral_v<T>);
        using Limits = std::numeric_limits<T>;
        const ScalarField field = fieldOf<T>(type, {T(3), Limits::lowest(), T(7), Limits::max(), T(5)});
        QCOMPARE(field.type(), type);
        QCOMPARE(field.count(), std::uint64_t(5));
        QCOMPARE(field.bytes().size(), 5 * sizeof(T));
        QCOMPARE(field.range().minimum, static_cast<double>(Limits::lowest()));
        QCOMPARE(field.range().maximum, static_cast<double>(Limits::max()));
        QCOMPARE(field.notFiniteCount(), std::uint64_t(0));
        QCOMPARE(field.at(2), 7.0);
        QCOMPARE(field.at(3), static_cast<double>(Limits::max()));
        QCOMPARE(field.as<T>()[4], T(5));
    });
}

void ScalarFieldTest::leavesOutWhatIsNotFinite_data()
{
    QTest::addColumn<QList<double>>("values");
    QTest::addColumn<int>("notFinite");
    QTest::addColumn<double>("minimum");
    QTest::addColumn<double>("maximum");
    QTest::newRow("all finite") << QList<double>{2, -1, 4} << 0 << -1.0 << 4.0;
    QTest::newRow("constant") << QList<double>{2, 2} << 0 << 2.0 << 2.0;
    QTest::newRow("not a number first") << QList<double>{notANumber, -1, 4} << 1 << -1.0 << 4.0;
    QTest::newRow("not a number last") << QList<double>{-1, 4, notANumber} << 1 << -1.0 << 4.0;
    QTest::newRow("infinities") << QList<double>{infinity, -1, -infinity, 4, notANumber} << 3 << -1.0 << 4.0;
    QTest::newRow("nothing else") << QList<double>{notANumber, infinity} << 2 << 0.0 << 0.0;
}

void ScalarFieldTest::leavesOutWhatIsNotFinite()
{
    QFETCH(QList<double>, values);
    QFETCH(int, notFinite);
    QFETCH(double, minimum);
    QFETCH(double, maximum);
    const ScalarField doubles = fieldOf<double>(SampleType::Float64, {values.begin(), values.end()});
    const ScalarField floats = fieldOf<float>(SampleType::Float32, {values.begin(), values.end()});
    for (const ScalarField& field : {doubles, floats}) {
        QCOMPARE(field.notFiniteCount(), static_cast<std::uint64_t>(notFinite));
        QCOMPARE(field.range().minimum, minimum);
        QCOMPARE(field.range().maximum, maximum);
    }
}

void ScalarFieldTest::largeFieldsAreTheSameInParts()
{
    std::vector<float> values(1'000'003, 1.0f);
    values[123'456] = -8;
    values[999'999] = 9;
    for (std::size_t i = 0; i < values.size(); i += 1000)
        values[i] = std::numeric_limits<float>::quiet_NaN();
    const ScalarField field = fieldOf(SampleType::Float32, values);
    QCOMPARE(field.range().minimum, -8.0);
    QCOMPARE(field.range().maximum, 9.0);
    QCOMPARE(field.notFiniteCount(), std::uint64_t(1001));
}

void ScalarFieldTest::copiesShareTheSamples()
{
    ScalarField copy;
    {
        const ScalarField field = fieldOf<std::uint8_t>(SampleType::UInt8, {1, 2, 3});
        copy = field;
        QCOMPARE(copy.bytes().data(), field.bytes().data());
    }
    QCOMPARE(copy.at(2), 3.0); // the samples outlive the first field
}

void ScalarFieldTest::emptyFieldHasNoExtent()
{
    QCOMPARE(ScalarField().count(), std::uint64_t(0));
    QCOMPARE(ScalarField().range().extent(), 0.0);
    QVERIFY(ScalarField(SampleType::Float32, 0, nullptr).bytes().empty());
}

void ScalarFieldTest::latticeNumbersItsPoints()
{
    const Lattice lattice{{3, 4, 5}, {1, 1, 1}, {0, 0, 0}};
    QCOMPARE(lattice.pointCount(), std::uint64_t(60));
    QCOMPARE(lattice.cellCount(), std::uint64_t(24));
    std::uint64_t expected = 0;
    for (std::uint32_t k = 0; k < 5; ++k)
        for (std::uint32_t j = 0; j < 4; ++j)
            for (std::uint32_t i = 0; i < 3; ++i, ++expected) {
                QCOMPARE(lattice.index(i, j, k), expected);
                QVERIFY((lattice.coordinates(expected) == std::array<std::uint32_t, 3>{i, j, k}));
            }
    const Lattice large{{4096, 4096, 4096}, {1, 1, 1}, {0, 0, 0}};
    QCOMPARE(large.index(4095, 4095, 4095), large.pointCount() - 1);
}

void ScalarFieldTest::latticeBounds()
{
    const Lattice lattice{{3, 4, 5}, {0.5, 2, 1}, {-1, 10, 0}};
    QCOMPARE(lattice.position(1, 2, 3), Eigen::Vector3d(-0.5, 14, 3));
    QCOMPARE(lattice.bounds().min(), Eigen::Vector3d(-1, 10, 0));
    QCOMPARE(lattice.bounds().max(), Eigen::Vector3d(0, 16, 4));
}

void ScalarFieldTest::absurdBuffersAreRefused()
{
    for (const std::uint64_t count : {std::uint64_t(1) << 45, ~std::uint64_t(0), ~std::uint64_t(0) / 8 + 2}) {
        const auto samples = allocateSamples(SampleType::Float64, count);
        QVERIFY(!samples.ok());
        QCOMPARE(samples.error().kind, ErrorKind::OutOfResource);
    }
    const auto samples = allocateSamples(SampleType::Float64, 1000);
    QVERIFY(samples.ok());
    std::ranges::fill_n(samples->get(), 8000, std::byte(1));
}

void ScalarFieldTest::scanningTellsHowFarItIsAndStops()
{
    constexpr std::uint64_t count = (std::uint64_t(1) << 24) + 3; // several pieces
    const auto samples = allocateSamples(SampleType::UInt8, count);
    QVERIFY(samples.ok());
    std::ranges::fill_n(samples->get(), count, std::byte(7));
    samples->get()[0] = std::byte(2);
    samples->get()[count - 1] = std::byte(200);
    std::vector<double> fractions;
    const Progress telling({}, [&](double fraction, const Message&) { fractions.push_back(fraction); });
    const auto whole = ScalarField::scanned(SampleType::UInt8, count, *samples, telling);
    QVERIFY(whole.ok());
    QCOMPARE(whole->range().minimum, 2.0);
    QCOMPARE(whole->range().maximum, 200.0);
    QVERIFY(fractions.size() > 1 && std::ranges::is_sorted(fractions));
    QCOMPARE(fractions.back(), 1.0);

    std::stop_source stop;
    const Progress stopping(stop.get_token(), [&](double, const Message&) { stop.request_stop(); });
    const auto stopped = ScalarField::scanned(SampleType::UInt8, count, *samples, stopping);
    QVERIFY(!stopped.ok());
    QCOMPARE(stopped.error().kind, ErrorKind::Cancelled);
}

QTEST_GUILESS_MAIN(ScalarFieldTest)
#include "scalar_field_test.moc"
