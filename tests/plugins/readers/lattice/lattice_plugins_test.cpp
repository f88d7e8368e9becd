// SPDX-License-Identifier: GPL-3.0-or-later
// The reader and the writer as the program gets them: found, loaded and chosen by the host.
#include "plugins/host/dataset_opening.h"
#include "plugins/host/file_saving.h"
#include "plugins/samples/samples.h"
#include "tests/plugins/readers/lattice/volume_files.h"

#include <QtTest>

#include <algorithm>

using namespace tetra;

class LatticePluginsTest : public QObject {
    Q_OBJECT

private slots:
    void areLoaded()
    {
        for (const PluginStatus& plugin : host_.plugins())
            QVERIFY2(plugin.error.empty(), plugin.error.text().c_str());
        const auto has = [](const auto& plugins, const char* id) {
            return std::ranges::any_of(plugins, [&](const auto& provided) { return provided.id == id; });
        };
        QVERIFY(has(host_.readers(), "lattice"));
        QVERIFY(has(host_.writers(), "nrrd-writer"));
    }

    void saveAndOpen()
    {
        const TestFolder folder;
        const Result<Dataset> made = makeSample({"c60", 16, {}, 1});
        QVERIFY(made.ok());
        const auto path = folder.path() / "c60.nrrd";
        const auto saved = saveDataset(host_, *made, path, {{"encoding", std::string("gzip")}}, {});
        QVERIFY2(saved.ok(), saved.ok() ? "" : saved.error().text().c_str());
        const Result<Dataset> opened = openDataset(host_, path, {}, {});
        QVERIFY2(opened.ok(), opened.ok() ? "" : opened.error().text().c_str());
        QVERIFY(std::ranges::equal(opened->values.bytes(), made->values.bytes()));
    }

    void rawNeedsItsDescription()
    {
        const TestFolder folder;
        const auto path = folder.write("volume.raw", testSamples(SampleType::UInt8));
        const Result<Dataset> undescribed = openDataset(host_, path, {}, {});
        QVERIFY(!undescribed.ok());
        QCOMPARE(undescribed.error().kind, ErrorKind::WrongUsage);
        const Result<Dataset> opened = openDataset(host_, path, {.values = {{"size", std::string("3x4x5")}}}, {});
        QVERIFY2(opened.ok(), opened.ok() ? "" : opened.error().text().c_str());
        QVERIFY(holdsTestSamples(opened->values));
    }

private:
    PluginHost host_{{.folders = {TAN_BINARY_DIR "/lib/tan/plugins"}}};
};

QTEST_GUILESS_MAIN(LatticePluginsTest)
#include "lattice_plugins_test.moc"
