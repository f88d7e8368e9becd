// SPDX-License-Identifier: GPL-3.0-or-later
/// Values over many powers of ten: the logarithms of a dataset's values, and what has none.
#include "core/data/value_scale.h"

#include <QTest>

#include <array>
#include <cmath>
#include <random>

using namespace tetra;

namespace {

Dataset rowOf(std::vector<double> values)
{
    Lattice lattice;
    lattice.size = {static_cast<std::uint32_t>(values.size() / 4), 2, 2};
    return *latticeDataset(lattice, ScalarField::of(std::move(values)), "row");
}

} // namespace

class ValueScaleTest : public QObject {
    Q_OBJECT

private slots:
    void logarithmsAreRight()
    {
        std::mt19937_64 random(20261129);
        std::uniform_real_distribution<double> exponents(-307, 308), near(0.5, 2);
        for (int i = 0; i < 20'000; ++i)
            for (const double x : {std::pow(10.0, exponents(random)), near(random)}) {
                const double expected = std::log10(x), found = portableLogarithm(x);
                QVERIFY2(std::abs(found - expected) <= 1e-15 * std::abs(expected) + 1e-300,
                         qPrintable(QString("%1: %2, not %3").arg(x).arg(found, 0, 'g', 17).arg(expected, 0, 'g', 17)));
            }
        QCOMPARE(portableLogarithm(1), 0.0);
        QVERIFY(std::abs(portableLogarithm(5e-324) - std::log10(5e-324)) < 1e-12);
    }

    void textComesBack()
    {
        for (const char* text : {"log", "log:1e-06", "log:0.5"})
            QCOMPARE(QString::fromStdString(scaleText(*parseScale(text))), QString(text));
        for (const char* text : {"", "linear"})
            QVERIFY(*parseScale(text) == ValueScale() && scaleText(*parseScale(text)).empty());
        for (const char* text : {"logarithmic", "log:", "log:0", "log:-1", "log:nan", "log:inf", "log:1x", "Log"}) {
            const auto wrong = parseScale(text);
            QVERIFY2(!wrong && wrong.error().kind == ErrorKind::WrongUsage, text);
        }
    }

    void valuesBecomeLogarithms()
    {
        const Dataset dataset = rowOf({1e-8, 1e-4, 1, 10, 1000, 5, 2, 3});
        const auto found = scaled(dataset, {.logarithmic = true});
        QVERIFY2(found.ok(), found ? "" : found.error().text().c_str());
        const auto logarithms = found->values.as<float>();
        for (std::size_t i = 0; i < logarithms.size(); ++i)
            QCOMPARE(logarithms[i], static_cast<float>(std::log10(dataset.values.at(i))));
        QCOMPARE(found->source.valueName, std::string("log10(value)"));
        QVERIFY(found->source.hash != dataset.source.hash && found->source.leftOut.empty());
        QCOMPARE(found->source.hash, contentHash(found->values, nullptr));
        const auto same = scaled(dataset, {});
        QVERIFY(same && same->source.hash == dataset.source.hash && same->values.type() == SampleType::Float64);
    }

    /// Zeros are counted, and the way out is named; what is smaller than that is told.
    void zerosAreToldOrTakenAsTheSmallest()
    {
        const Dataset dataset = rowOf({0, 1e-4, -2, 10, 1000, 5, 2, 3e-5});
        const auto refused = scaled(dataset, {.logarithmic = true});
        QVERIFY(!refused && refused.error().kind == ErrorKind::WrongUsage);
        const QString why = QString::fromStdString(refused.error().text());
        QVERIFY2(why.contains("2 of 8 values") && why.contains("log:3e-05"), qPrintable(why));
        const auto taken = scaled(dataset, {.logarithmic = true, .from = 5e-5});
        QVERIFY(taken.ok());
        QCOMPARE(taken->values.range().minimum, static_cast<double>(static_cast<float>(std::log10(5e-5))));
        QCOMPARE(taken->source.leftOut.size(), std::size_t(1));
        const QString told = QString::fromStdString(taken->source.leftOut[0].text());
        QVERIFY2(told.contains("3 of 8 values") && told.contains("5e-05"), qPrintable(told));
        QVERIFY(!scaled(dataset, {.logarithmic = true, .from = 1000}).ok());
        QVERIFY(!scaled(rowOf({0, 0, 0, 0, 0, 0, 0, -1}), {.logarithmic = true}).ok());
    }

    void integersHaveLogarithms()
    {
        Lattice lattice;
        lattice.size = {2, 2, 2};
        const auto dataset =
            latticeDataset(lattice, ScalarField::of(std::vector<std::uint8_t>{1, 2, 10, 100, 255, 7, 3, 4}), "bytes");
        const auto found = scaled(*dataset, {.logarithmic = true});
        QCOMPARE(found->values.type(), SampleType::Float32);
        QCOMPARE(found->values.as<float>()[3], 2.0F);
    }

    void namesComeBack()
    {
        QCOMPARE(logarithmName("nut"), std::string("log10(nut)"));
        for (const char* name : {"nut", "log10(x)", "a (b)"})
            QCOMPARE(nameOfLogarithms(logarithmName(name)), std::string(name));
        QCOMPARE(nameOfLogarithms("nut"), std::string("nut"));
    }

    void valuesOfTheDataCanBeTyped()
    {
        QCOMPARE(parseFieldValue("-4.5"), std::optional(-4.5));
        QVERIFY(std::abs(*parseFieldValue("log10(3e-5)") - std::log10(3e-5)) < 1e-14);
        for (const char* text : {"", "log10(0)", "log10(-1)", "log10()", "log10(1", "log(1)", "nan", "inf"})
            QVERIFY2(!parseFieldValue(text), text);
    }

    void errorsAreFactors()
    {
        QVERIFY(std::abs(factorOf(1, {-8, 2}) - std::pow(10.0, 0.1)) < 1e-12);
        const std::array<float, 3> logarithms{-2, 0, 3};
        const Buffer<float> values = valuesOfLogarithms(logarithms);
        QCOMPARE(values[0], 0.01F);
        QCOMPARE(values[1], 1.0F);
        QCOMPARE(values[2], 1000.0F);
        QVERIFY(holdsLogarithms(std::vector<std::pair<std::string, std::string>>{{"import.scale", "log:1e-06"}}));
        QVERIFY(!holdsLogarithms(std::vector<std::pair<std::string, std::string>>{{"import.stride", "2"}}));
    }
};

QTEST_GUILESS_MAIN(ValueScaleTest)
#include "value_scale_test.moc"
