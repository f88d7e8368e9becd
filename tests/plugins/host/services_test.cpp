// SPDX-License-Identifier: GPL-3.0-or-later
/// Opening, saving and building through the plugins of this program.
#include "core/build/model_build.h"
#include "plugins/host/dataset_opening.h"
#include "plugins/host/file_saving.h"
#include "plugins/host/input_file.h"
#include "plugins/host/model_building.h"
#include "plugins/host/output_check.h"
#include "plugins/host/plugin_call.h"
#include "plugins/samples/samples.h"
#include "tests/core/base/small_disk.h"

#include <tan/model.h>

#include <QTemporaryDir>
#include <QTest>

#include <array>
#include <fstream>
#include <stdexcept>

using namespace tetra;

namespace {

namespace fs = std::filesystem;

Dataset smallSample()
{
    return *makeSample({.name = "noise", .size = 8, .type = std::nullopt, .seed = 1});
}

} // namespace

class ServicesTest : public QObject {
    Q_OBJECT

private:
    fs::path path(const char* name) const { return fs::path(folder_.path().toStdString()) / name; }

    QTemporaryDir folder_;
    std::unique_ptr<PluginHost> host_;

private slots:
    void initTestCase() { host_ = PluginHost::standard(); }

    void whatWasSavedIsOpened()
    {
        const Dataset sample = smallSample();
        const auto saved = saveDataset(*host_, sample, path("noise.nrrd"));
        QVERIFY2(saved, saved ? "" : saved.error().text().c_str());
        const auto opened = openDataset(*host_, path("noise.nrrd"));
        QVERIFY2(opened, opened ? "" : opened.error().text().c_str());
        QCOMPARE(opened->lattice.size, sample.lattice.size);
        QVERIFY(std::ranges::equal(opened->values.bytes(), sample.values.bytes()));
        QCOMPARE(chooseReader(*host_, path("noise.nrrd"))->id, std::string("lattice"));
    }

    /// Whoever reads files of that name, and whoever is asked for; a name that alone says what it is may be empty.
    void emptyFilesAreToldAsThat()
    {
        for (const char* name : {"a.nrrd", "a.raw", "a.csv", "a.vtu", "a.inp", "a.q", "a.vti", "a.mha", "a.tif",
                                 "a.case", "a.nothing", "noending"}) {
            std::ofstream(path(name)) << "";
            for (const ImportOptions& options : {ImportOptions{}, ImportOptions{.reader = std::string("points")}}) {
                const auto dataset = openDataset(*host_, path(name), options);
                QVERIFY(!dataset.ok());
                QVERIFY2(dataset.error().text().ends_with("is empty. The copy may be incomplete: copy the file again."),
                         dataset.error().text().c_str());
                QVERIFY(!probeDataset(*host_, path(name), options).ok());
            }
        }
        std::ofstream(path("case.foam")) << "";
        const auto noCase = openDataset(*host_, path("case.foam"));
        QVERIFY(!noCase.ok());
        QVERIFY2(noCase.error().text().find("is empty") == std::string::npos, noCase.error().text().c_str());
    }

    /// The files of an OpenFOAM case, and its folder, lead to what opens it.
    void partsOfAnOpenFoamCaseAreKnown()
    {
        namespace fs = std::filesystem;
        fs::create_directories(path("pitz/system"));
        fs::create_directories(path("pitz/1000"));
        const std::string head =
            "/* C++ */\nFoamFile\n{\n    version 2.0;\n    format ascii;\n    class volScalarField;\n"
            "    object p;\n}\n";
        std::ofstream(path("pitz/1000/p")) << head << "dimensions [0 2 -2 0 0 0 0];\n";
        std::ofstream(path("pitz/system/controlDict")) << head;
        for (const char* name : {"pitz", "pitz/1000/p"}) {
            const auto opened = openDataset(*host_, path(name));
            QVERIFY(!opened);
            QVERIFY2(opened.error().text().find("'system/controlDict' in it") != std::string::npos,
                     opened.error().text().c_str());
        }
        const auto folder = openDataset(*host_, path("pitz/1000"));
        QVERIFY(!folder);
        QVERIFY2(folder.error().text().find("is a folder. Choose a file") != std::string::npos,
                 folder.error().text().c_str());
    }

    void noReaderSaysThatTheFormatIsUnknown()
    {
        std::ofstream(path("letter.txt")) << "Dear reader";
        const auto opened = openDataset(*host_, path("letter.txt"));
        QVERIFY(!opened);
        QCOMPARE(opened.error().kind, ErrorKind::BadInput);
        QVERIFY2(opened.error().text().find("has an unknown format") != std::string::npos,
                 opened.error().text().c_str());
        QVERIFY(!readableFiles(*host_).empty());
    }

    void noWriterSaysWhatCanBeWritten()
    {
        const auto saved = saveDataset(*host_, smallSample(), path("noise.unknown"));
        QVERIFY(!saved);
        QVERIFY2(saved.error().text().find("nrrd") != std::string::npos, saved.error().text().c_str());
    }

    void aHostWithoutPluginsSaysSo()
    {
        PluginHost empty(PluginHostOptions{.folders = {}});
        QVERIFY(openDataset(empty, path("noise.nrrd")).error().text().find("No reader is installed") !=
                std::string::npos);
        QVERIFY(!chooseBuilder(empty, smallSample()));
        QVERIFY(saveDataset(empty, smallSample(), path("a.nrrd")).error().text().find("No writer") !=
                std::string::npos);
    }

    void unknownParametersAreRefused()
    {
        const auto opened = openDataset(*host_, path("noise.nrrd"), {.values = {{"colour", 1.0}}});
        QVERIFY(!opened);
        QCOMPARE(opened.error().kind, ErrorKind::WrongUsage);
        const auto built = buildModel(*host_, smallSample(), std::nullopt, {{"colour", 1.0}}, path("no.tan"));
        QVERIFY(!built);
        QCOMPARE(built.error().kind, ErrorKind::WrongUsage);
        QVERIFY(!fs::exists(path("no.tan")));
    }

    void buildsAndKeepsTheProvenance()
    {
        const auto built = buildModel(*host_, smallSample(), "refinement", {{"error", 2.0}}, path("noise.tan"));
        QVERIFY2(built, built ? "" : built.error().text().c_str());
        QCOMPARE(built->builder, std::string("refinement"));
        QCOMPARE(built->fileBytes, std::uint64_t(fs::file_size(path("noise.tan"))));
        QVERIFY(built->peakBytes > 0);
        const auto model = Model::open(path("noise.tan"));
        QVERIFY(model);
        QCOMPARE((*model)->siteCount(), built->report.sites);
        QCOMPARE((*model)->tetrahedronCount(), built->report.tetrahedra);
        QCOMPARE((*model)->description().builder, std::string("refinement"));
        const auto& parameters = (*model)->description().parameters;
        QVERIFY(std::ranges::count(parameters, std::pair<std::string, std::string>("error", "2")) == 1);
    }

    void choosesTheBuilderItself()
    {
        const auto chosen = chooseBuilder(*host_, smallSample());
        QVERIFY(chosen);
        QCOMPARE(chosen->id, std::string("refinement"));
        const auto unknown = chooseBuilder(*host_, smallSample(), "magic");
        QVERIFY(!unknown);
        QVERIFY(unknown.error().text().find("refinement") != std::string::npos);
    }

    void aCancelledBuildLeavesNothing()
    {
        std::stop_source stop;
        stop.request_stop();
        const auto built =
            buildModel(*host_, smallSample(), std::nullopt, {}, path("cancelled.tan"), Progress(stop.get_token(), {}));
        QVERIFY(!built);
        QCOMPARE(built.error().kind, ErrorKind::Cancelled);
        QVERIFY(!fs::exists(path("cancelled.tan")));
    }

    void outputsNeverReplaceTheirInputs()
    {
        std::ofstream(path("input.raw")) << "samples";
        fs::create_symlink("input.raw", path("link.raw"));
        fs::create_hard_link(path("input.raw"), path("hard.raw"));
        const std::array inputs = {path("input.raw")};
        for (const char* name : {"input.raw", "link.raw", "hard.raw", "./input.raw"})
            QVERIFY2(!checkOutput(path(name), inputs), name);
        QVERIFY(checkOutput(path("other.raw"), inputs));
        QVERIFY(!checkModelOutput(path("input.raw")));
        QVERIFY(checkModelOutput(path("new.tan")));

        Dataset dataset = smallSample();
        dataset.source.path = path("input.raw");
        QCOMPARE(buildModel(*host_, dataset, std::nullopt, {}, path("link.raw")).error().kind, ErrorKind::WrongUsage);
        QCOMPARE(fs::file_size(path("input.raw")), std::uintmax_t(7));
    }

    void modelsReplaceOnlyModels()
    {
        std::ofstream(path("notes.tan")) << "my notes";
        std::ofstream(path("begun.tan")) << "TAN";
        std::ofstream(path("empty.tan"));
        fs::create_symlink("notes.tan", path("linked.tan"));
        for (const char* name : {"notes.tan", "begun.tan", "linked.tan"}) {
            const auto built = buildModel(*host_, smallSample(), std::nullopt, {}, path(name));
            QVERIFY2(!built, name);
            QCOMPARE(built.error().kind, ErrorKind::WrongUsage);
            QVERIFY2(built.error().text().find("is not a TAn model") != std::string::npos,
                     built.error().text().c_str());
        }
        QCOMPARE(fs::file_size(path("notes.tan")), std::uintmax_t(8));
        QVERIFY(buildModel(*host_, smallSample(), std::nullopt, {}, path("empty.tan")));
        fs::resize_file(path("empty.tan"), 100); // damaged, and one of ours all the same
        QVERIFY(buildModel(*host_, smallSample(), std::nullopt, {}, path("empty.tan")));
    }

    void aModelBehindALinkIsBuiltOnItsDisk()
    {
        const SmallDisk disk(std::size_t(16) << 20);
        if (!disk.ok())
            QSKIP("skipped: a small disk needs the right to mount");
        fs::create_symlink(disk.folder() / "there.tan", path("here.tan"));
        const auto built = buildModel(*host_, smallSample(), std::nullopt, {}, path("here.tan"));
        QVERIFY2(built, built ? "" : built.error().text().c_str());
        QVERIFY(fs::is_symlink(path("here.tan")));
        QVERIFY(Model::open(disk.folder() / "there.tan"));
        QCOMPARE(std::distance(fs::directory_iterator(disk.folder()), {}), std::ptrdiff_t(1));
    }

    void modelsAreRecognised()
    {
        QVERIFY(buildModel(*host_, smallSample(), std::nullopt, {}, path("real.tan")));
        fs::copy_file(path("real.tan"), path("renamed"));
        QVERIFY(isModelFile(path("renamed")));
        QVERIFY(isModelFile("nowhere.tan"));
        QVERIFY(!isModelFile(path("noise.nrrd")));
        QVERIFY(!isModelFile("nowhere"));
        QVERIFY(checkModelOutput(path("renamed")));
        QVERIFY(openDataset(*host_, path("real.tan")).error().text().find("is a TAn model") != std::string::npos);
    }

    void whatAPluginThrowsIsAnError()
    {
        const Status thrown = callPlugin("bad", []() -> Status { throw std::runtime_error("no luck"); });
        QVERIFY(!thrown);
        QVERIFY(thrown.error().text().find("no luck") != std::string::npos);
        const Status full = callPlugin("bad", []() -> Status { throw std::bad_alloc(); });
        QCOMPARE(full.error().kind, ErrorKind::OutOfResource);
    }

    /// As std::thread and TBB throw them: the machine's limit is not a mistake of the plugin.
    void limitsOfTheMachineAreNotBlamedOnThePlugin()
    {
        for (const std::errc limit : {std::errc::resource_unavailable_try_again, std::errc::not_enough_memory}) {
            const Status failed =
                callPlugin("good", [&]() -> Status { throw std::system_error(std::make_error_code(limit)); });
            QCOMPARE(failed.error().kind, ErrorKind::OutOfResource);
            QVERIFY(failed.error().text().find("fault of the plugin") == std::string::npos);
        }
        const Status ofTbb = callPlugin("good", []() -> Status {
            throw std::runtime_error("pthread_create has failed: Resource temporarily unavailable");
        });
        QCOMPARE(ofTbb.error().kind, ErrorKind::OutOfResource);
        QVERIFY2(ofTbb.error().text().find("any more threads") != std::string::npos, ofTbb.error().text().c_str());
        const Status other = callPlugin(
            "bad", []() -> Status { throw std::system_error(std::make_error_code(std::errc::bad_address)); });
        QCOMPARE(other.error().kind, ErrorKind::BadInput);
    }
};

QTEST_GUILESS_MAIN(ServicesTest)
#include "services_test.moc"
