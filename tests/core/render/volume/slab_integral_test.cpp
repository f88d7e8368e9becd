// SPDX-License-Identifier: GPL-3.0-or-later
// The closed form of a slab against its integral (S15).
#include "core/base/simd.h"
#include "core/render/volume/slab_integral.h"

#include <QTest>

#include <cmath>

using namespace tetra;

namespace {

/// The integral of u d(1 - e^-depth(u)), by Simpson's rule.
double weightOf(double depth, double half)
{
    constexpr int steps = 400;
    double sum = 0;
    for (int i = 0; i <= steps; ++i) {
        const double u = double(i) / steps;
        const double before = depth * u - half * u * (1 - u);
        const double rate = depth - half * (1 - 2 * u);
        sum += (i == 0 || i == steps ? 1 : i % 2 == 1 ? 4 : 2) * u * rate * std::exp(-before);
    }
    return sum / (3 * steps);
}

} // namespace

class SlabIntegralTest : public QObject {
    Q_OBJECT

private slots:
    void isTheIntegral()
    {
        for (int i = 0; i <= 40; ++i)
            for (int j = -20; j <= 20; ++j) {
                const float depth = static_cast<float>(i) / 40, half = depth * static_cast<float>(j) / 20;
                SlabLight<Float8> light;
                slabLight(Float8{} + depth, Float8{} + half, light);
                QVERIFY(std::abs(light.opacity[3] + std::expm1(-double(depth))) < 3e-7);
                QVERIFY(std::abs(light.weight[3] - weightOf(depth, half)) < 1.2e-5);
                if (depth > faintDepth)
                    continue;
                faintSlabLight(Float8{} + depth, Float8{} + half, light);
                QVERIFY(std::abs(light.opacity[3] + std::expm1(-double(depth))) < 5e-7);
                QVERIFY(std::abs(light.weight[3] - weightOf(depth, half)) < 4e-6);
            }
    }
};

QTEST_GUILESS_MAIN(SlabIntegralTest)
#include "slab_integral_test.moc"
