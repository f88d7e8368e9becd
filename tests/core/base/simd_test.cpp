// SPDX-License-Identifier: GPL-3.0-or-later
// Kernels do the same by every instruction set, and what they throw arrives.
#include "core/base/simd.h"

#include <QTest>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <new>
#include <numeric>
#include <span>
#include <vector>

using namespace tetra;

namespace {

TETRA_SIMD_INLINE void scale(std::span<const float> from, float factor, std::vector<float>& to)
{
    to.resize(from.size());
    for (std::size_t i = 0; i < from.size(); ++i)
        to[i] = from[i] * factor + 1;
}

TETRA_SIMD_INLINE int plainly(int number)
{
    return number;
}
TETRA_SIMD_INLINE int byEight(int number)
{
    return number + 8;
}
TETRA_SIMD_INLINE int bySixteen(int number)
{
    return number + 16;
}

TETRA_SIMD_INLINE void fail(std::vector<int>& numbers)
{
    numbers.assign(100, 1);
    throw std::bad_alloc();
}

/// As code that calls a kernel and has something to clean up.
void failWithCleaning(std::shared_ptr<int> held)
{
    std::vector<int> numbers;
    dispatch<fail>(numbers);
    QVERIFY2(held == nullptr, "unreachable");
}

} // namespace

class SimdSum {
public:
    void add(std::span<const int> numbers) { dispatch<&SimdSum::addAll>(*this, numbers); }
    int plus(int number) const { return dispatch<&SimdSum::withOne>(*this, number); }

private:
    TETRA_SIMD_INLINE void addAll(std::span<const int> numbers)
    {
        for (const int number : numbers)
            sum_ += number;
    }
    TETRA_SIMD_INLINE int withOne(int number) const { return sum_ + number; }

    int sum_ = 0;
};

class SimdTest : public QObject {
    Q_OBJECT

private slots:
    void everyLevelDoesTheSame()
    {
        std::vector<float> numbers(1003), expected(numbers.size()), found;
        std::iota(numbers.begin(), numbers.end(), 0.1f);
        std::ranges::transform(numbers, expected.begin(), [](float number) { return number * 0.3f + 1; });
        dispatch<scale>(numbers, 0.3f, found);
        QVERIFY(found == expected);
        for (const SimdLevel level : simdLevels()) {
            found.clear();
            dispatch<scale>.at(level, numbers, 0.3f, found);
            QVERIFY(found == expected);
        }
    }

    void ofThreeKernelsTheOneOfTheLevelIsCalled()
    {
        constexpr int added[] = {0, 8, 16};
        constexpr auto any = dispatch<plainly, byEight, bySixteen>;
        for (const SimdLevel level : simdLevels())
            QCOMPARE(any.at(level, 5), 5 + added[static_cast<std::size_t>(level)]);
        QCOMPARE(any(5), 5 + added[static_cast<std::size_t>(simdLevel())]);
    }

    void membersAreKernels()
    {
        SimdSum sum;
        sum.add(std::vector<int>(50, 2));
        QCOMPARE(sum.plus(1), 101);
    }

    void exceptionsPass()
    {
        const auto held = std::make_shared<int>();
        QVERIFY_EXCEPTION_THROWN(failWithCleaning(held), std::bad_alloc);
        QCOMPARE(held.use_count(), 1L);
        std::vector<int> numbers;
        for (const SimdLevel level : simdLevels())
            QVERIFY_EXCEPTION_THROWN(dispatch<fail>.at(level, numbers), std::bad_alloc);
    }

    /// Run again with each of the names.
    void theEnvironmentChooses()
    {
        const QByteArray asked = qgetenv("TAN_INSTRUCTION_SET");
        const SimdLevel most = simdLevels().back();
        if (asked == "x86-64")
            QCOMPARE(simdLevel(), SimdLevel::Plain);
        else if (asked == "x86-64-v3")
            QCOMPARE(simdLevel(), std::min(SimdLevel::Eight, most));
        else
            QCOMPARE(simdLevel(), most);
    }
};

QTEST_GUILESS_MAIN(SimdTest)
#include "simd_test.moc"
