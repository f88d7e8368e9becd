// SPDX-License-Identifier: GPL-3.0-or-later
/// Layers of samples in files against taking each sample by itself.
#include "core/data/sample_slice.h"

#include <tan/data.h>

#include <QTest>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>

using namespace tetra;

class SampleSliceTest : public QObject {
    Q_OBJECT

private slots:
    void everySampleOfALayerIsWhereItBelongs()
    {
        std::mt19937 random(3);
        for (int round = 0; round < 40; ++round) {
            StoredSamples samples;
            for (auto& size : samples.size)
                size = 2 + random() % 9;
            samples.type = SampleType::UInt16;
            samples.order = round % 2 == 0 ? std::endian::big : std::endian::little;
            samples.skippedBytes = random() % 5;
            const std::size_t count = std::size_t(samples.size[0]) * samples.size[1] * samples.size[2];
            std::vector<std::byte> file(samples.skippedBytes + 2 * count);
            for (std::size_t i = 0; i < count; ++i) { // each sample is its number
                const bool big = samples.order == std::endian::big;
                file[samples.skippedBytes + 2 * i + (big ? 1 : 0)] = std::byte(i & 255);
                file[samples.skippedBytes + 2 * i + (big ? 0 : 1)] = std::byte(i >> 8);
            }
            const std::size_t cut = random() % 3 == 0 ? file.size() / 2 : file.size();
            const int axis = static_cast<int>(random() % 3);
            const std::uint32_t number = random() % samples.size[static_cast<std::size_t>(axis)];
            const auto slice = readSampleSlice(std::span(file).first(cut), samples, axis, number, 100);
            QVERIFY(slice);
            for (std::uint32_t y = 0; y < slice->height; ++y)
                for (std::uint32_t x = 0; x < slice->width; ++x) {
                    std::array<std::uint32_t, 3> at{};
                    at[static_cast<std::size_t>(axis)] = number;
                    at[axis == 0 ? 1 : 0] = x;
                    at[axis == 2 ? 1 : 2] = y;
                    const std::size_t index = (std::size_t(at[2]) * samples.size[1] + at[1]) * samples.size[0] + at[0];
                    const float value = slice->values[y * slice->width + x];
                    if (samples.skippedBytes + 2 * index + 2 <= cut)
                        QCOMPARE(value, static_cast<float>(index));
                    else
                        QVERIFY(std::isnan(value));
                }
        }
    }

    void largeLayersAreThinnedOutFromCornerToCorner()
    {
        const StoredSamples samples{.size = {1000, 700, 2}, .type = SampleType::UInt8};
        std::vector<std::byte> file(std::size_t(1000) * 700 * 2, std::byte(7));
        file[0] = std::byte(1);
        file[999] = std::byte(2);
        file[std::size_t(999) + 1000 * 699] = std::byte(3);
        const auto slice = readSampleSlice(file, samples, 2, 0, 64);
        QVERIFY(slice);
        QCOMPARE(slice->width, 64u);
        QCOMPARE(slice->height, 64u);
        QCOMPARE(slice->values.front(), 1.f);
        QCOMPARE(slice->values[63], 2.f);
        QCOMPARE(slice->values.back(), 3.f);
        QCOMPARE(slice->window.minimum, 7.0); // single samples do not spoil the contrast
        QCOMPARE(slice->window.maximum, 7.0);
    }

    void thereIsNoLayerBeyondTheLast()
    {
        const std::vector<std::byte> file(8);
        QVERIFY(!readSampleSlice(file, {}, 2, 2, 64));
        QVERIFY(!readSampleSlice(file, {}, 3, 0, 64));
        const auto empty = readSampleSlice({}, {}, 0, 0, 64);
        QVERIFY(empty && std::ranges::all_of(empty->values, [](float value) { return std::isnan(value); }));
    }

    void aCancelledSliceIsNone()
    {
        std::stop_source stop;
        stop.request_stop();
        const std::vector<std::byte> file(8);
        QCOMPARE(readSampleSlice(file, {}, 0, 0, 64, Progress(stop.get_token(), {})).error().kind,
                 ErrorKind::Cancelled);
    }
};

QTEST_GUILESS_MAIN(SampleSliceTest)
#include "sample_slice_test.moc"
