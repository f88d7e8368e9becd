// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/checksum.h"
#include "plugins/samples/samples.h"

#include <QTest>

#include <tbb/global_control.h>

#include <cmath>
#include <numbers>
#include <string>

using namespace tetra;

namespace {

Dataset sample(std::string_view name, std::uint32_t size, std::optional<SampleType> type = {})
{
    SampleRequest request;
    request.name = name;
    request.size = size;
    request.type = type;
    Result<Dataset> made = makeSample(request);
    Q_ASSERT(made.ok());
    return *std::move(made);
}

} // namespace

class AnalyticFieldsTest : public QObject {
    Q_OBJECT

private slots:
    /// The same bits on every machine: these numbers may only change with the formulas.
    void neverChanges_data();
    void neverChanges();
    void doesNotDependOnTheThreads();
    void everyKindFillsItsRange();
    void everyTypeHoldsTheSameField();
    void hydrogenFollowsItsFormula();
    void marschnerLobbFollowsItsFormula();
    void c60IsHollowAndHasItsAtoms();
    void noiseIsUniformAndFollowsTheSeed();
    void refuses_data();
    void refuses();
    void reportsAndCancels();
};

void AnalyticFieldsTest::neverChanges_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<SampleType>("type");
    QTest::addColumn<quint64>("hash");
    QTest::newRow("c60") << "c60" << SampleType::UInt8 << quint64(13339681373637291478u);
    QTest::newRow("c60 double") << "c60" << SampleType::Float64 << quint64(10450644404646439459u);
    QTest::newRow("hydrogen") << "hydrogen" << SampleType::Float64 << quint64(17603325631020120991u);
    QTest::newRow("marschner-lobb") << "marschner-lobb" << SampleType::Float64 << quint64(4854087794370289755u);
    QTest::newRow("noise") << "noise" << SampleType::UInt8 << quint64(1034020781644096576u);
}

void AnalyticFieldsTest::neverChanges()
{
    QFETCH(QString, name);
    QFETCH(SampleType, type);
    QFETCH(quint64, hash);
    const std::string kind = name.toStdString();
    const Dataset dataset = sample(kind, 20, type);
    QCOMPARE(quint64(checksum(dataset.values.bytes())), hash);
    QCOMPARE(quint64(dataset.source.hash), hash);
}

void AnalyticFieldsTest::doesNotDependOnTheThreads()
{
    const tbb::global_control oneThread(tbb::global_control::max_allowed_parallelism, 1);
    const std::uint64_t alone = sample("c60", 33).source.hash;
    const tbb::global_control manyThreads(tbb::global_control::max_allowed_parallelism, 8);
    QCOMPARE(quint64(sample("c60", 33).source.hash), quint64(alone));
}

void AnalyticFieldsTest::everyKindFillsItsRange()
{
    QVERIFY(!sampleKinds().empty());
    for (const SampleKind& kind : sampleKinds()) {
        const Dataset dataset = sample(kind.name, 48);
        QCOMPARE(dataset.values.type(), kind.type);
        if (kind.domain != DomainClass::Irregular)
            QCOMPARE(dataset.values.count(), std::uint64_t(48) * 48 * 48);
        QCOMPARE(dataset.lattice.pointCount(), dataset.values.count());
        QCOMPARE(dataset.values.notFiniteCount(), std::uint64_t(0));
        const double full = isInteger(kind.type) ? 255 : 1;
        QVERIFY(dataset.values.range().minimum >= 0 && dataset.values.range().minimum < 0.05 * full);
        QVERIFY(dataset.values.range().maximum <= full && dataset.values.range().maximum > 0.9 * full);
        QVERIFY(!kind.description.empty());
    }
}

void AnalyticFieldsTest::everyTypeHoldsTheSameField()
{
    const Dataset exact = sample("c60", 12, SampleType::Float64);
    for (const auto type : {SampleType::UInt8, SampleType::Int8, SampleType::UInt16, SampleType::Int16,
                            SampleType::UInt32, SampleType::Int32, SampleType::Float32}) {
        const Dataset dataset = sample("c60", 12, type);
        QCOMPARE(dataset.values.type(), type);
        const double largest = visitSampleType(type, []<class T>() {
            return std::is_integral_v<T> ? static_cast<double>(std::numeric_limits<T>::max()) : 1.0;
        });
        const double tolerance = isInteger(type) ? 0.5 : 0x1p-24;
        for (std::uint64_t i = 0; i < exact.values.count(); ++i)
            QVERIFY(std::abs(dataset.values.at(i) - exact.values.at(i) * largest) <= tolerance);
    }
}

void AnalyticFieldsTest::hydrogenFollowsItsFormula()
{
    const Dataset dataset = sample("hydrogen", 21, SampleType::Float64);
    for (std::uint64_t n = 0; n < dataset.values.count(); ++n) {
        const auto [i, j, k] = dataset.lattice.coordinates(n);
        const double x = 2.0 * i - 20;
        const double y = 2.0 * j - 20;
        const double z = 2.0 * k - 20;
        const double r = std::sqrt(x * x + y * y + z * z);
        const double expected = std::pow((3 * z * z - r * r) / 72, 2) * std::exp(4 - 2 * r / 3);
        QVERIFY(std::abs(dataset.values.at(n) - expected) <= 1e-14);
    }
    QCOMPARE(dataset.values.at(dataset.lattice.index(10, 10, 13)), 1.0); // the largest value, 6 Bohr radii up the axis
}

void AnalyticFieldsTest::marschnerLobbFollowsItsFormula()
{
    const Dataset dataset = sample("marschner-lobb", 41, SampleType::Float64);
    constexpr double pi = std::numbers::pi;
    for (std::uint64_t n = 0; n < dataset.values.count(); ++n) {
        const auto [i, j, k] = dataset.lattice.coordinates(n);
        const double r = std::hypot(i / 20.0 - 1, j / 20.0 - 1);
        const double ripple = std::cos(2 * pi * 6 * std::cos(pi * r / 2));
        const double expected = (1 - std::sin(pi * (k / 20.0 - 1) / 2) + 0.25 * (1 + ripple)) / 2.5;
        QVERIFY(std::abs(dataset.values.at(n) - expected) <= 1e-13);
    }
}

void AnalyticFieldsTest::c60IsHollowAndHasItsAtoms()
{
    const std::uint32_t size = 95; // 0.1 Angstrom apart
    const Dataset dataset = sample("c60", size, SampleType::Float64);
    const auto at = [&](int i, int j, int k) {
        return dataset.values.at(dataset.lattice.index(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j),
                                                       static_cast<std::uint32_t>(k)));
    };
    QVERIFY(at(47, 47, 47) < 1e-4);
    int peaks = 0;
    const int last = static_cast<int>(size) - 1;
    for (int k = 1; k < last; ++k)
        for (int j = 1; j < last; ++j)
            for (int i = 1; i < last; ++i) {
                const double value = at(i, j, k);
                bool peak = value > 0.9;
                for (int n = 0; peak && n < 27; ++n)
                    peak = at(i + n % 3 - 1, j + n / 3 % 3 - 1, k + n / 9 - 1) <= value;
                peaks += peak ? 1 : 0;
                // mirror symmetric in each axis
                QVERIFY(std::abs(value - at(last - i, j, k)) < 1e-12 && std::abs(value - at(i, j, last - k)) < 1e-12);
            }
    QCOMPARE(peaks, 60);
}

void AnalyticFieldsTest::noiseIsUniformAndFollowsTheSeed()
{
    const Dataset dataset = sample("noise", 64);
    std::array<int, 256> histogram{};
    for (const std::uint8_t value : dataset.values.as<std::uint8_t>())
        ++histogram[value];
    for (int value = 1; value < 255; ++value) // 1028 expected, six standard deviations: 192
        QVERIFY(std::abs(histogram[static_cast<std::size_t>(value)] - 1028) < 192);
    // the first number of SplitMix64 from 1, as published with the generator
    QCOMPARE(sample("noise", 2, SampleType::Float64).values.at(0), double(0x910a2dec89025cc1u >> 11) * 0x1p-53);
    SampleRequest request{"noise", 8, {}, 2};
    const std::uint64_t second = makeSample(request)->source.hash;
    request.seed = 1;
    const std::uint64_t first = makeSample(request)->source.hash;
    QVERIFY(first != second);
}

void AnalyticFieldsTest::refuses_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<quint32>("size");
    QTest::addColumn<QString>("says");
    QTest::newRow("unknown") << "c70" << 8u << "c60";
    QTest::newRow("one point") << "c60" << 1u << "from 2 to 2048";
    QTest::newRow("no point") << "noise" << 0u << "from 2 to 2048";
    QTest::newRow("huge") << "noise" << 4000000000u << "from 2 to 2048";
}

void AnalyticFieldsTest::refuses()
{
    QFETCH(QString, name);
    QFETCH(quint32, size);
    QFETCH(QString, says);
    const std::string kind = name.toStdString();
    const Result<Dataset> made = makeSample({kind, size, {}, 1});
    QVERIFY(!made.ok());
    QCOMPARE(made.error().kind, ErrorKind::WrongUsage);
    QVERIFY(QString::fromStdString(made.error().text()).contains(says));
}

void AnalyticFieldsTest::reportsAndCancels()
{
    std::stop_source stop;
    double last = 0;
    bool monotonic = true;
    const Progress progress(stop.get_token(), [&](double fraction, const Message&) {
        monotonic = monotonic && fraction >= last;
        last = fraction;
    });
    QVERIFY(makeSample({"noise", 16, {}, 1}, progress).ok());
    QVERIFY(monotonic);
    QCOMPARE(last, 1.0);
    stop.request_stop();
    const Result<Dataset> cancelled = makeSample({"noise", 16, {}, 1}, progress);
    QVERIFY(!cancelled.ok());
    QCOMPARE(cancelled.error().kind, ErrorKind::Cancelled);
}

QTEST_GUILESS_MAIN(AnalyticFieldsTest)
#include "analytic_fields_test.moc"
