// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/sample_files.h"
#include "ui/opening/import_question.h"
#include "ui/opening/import_texts.h"
#include "ui/panels/import_form.h"
#include "ui/panels/slice_preview.h"
#include "ui/session/message_text.h"

#include <QFile>
#include <QLocale>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <limits>

using namespace tetra;

/// What the import dialog says and remembers, as values.
class ImportTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase()
    {
        QCoreApplication::setOrganizationName("TAn");
        QCoreApplication::setApplicationName("importValues");
        QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates));
        QSettings().clear();
    }

    void sizesAreUnderstood_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<bool>("understood");
        QTest::newRow("x") << "64x32x16" << true;
        QTest::newRow("commas") << "64, 32, 16" << true;
        QTest::newRow("blanks") << "64 32 16" << true;
        QTest::newRow("times") << "64 × 32 × 16" << true;
        QTest::newRow("two") << "64x32" << false;
        QTest::newRow("four") << "64x32x16x8" << false;
        QTest::newRow("flat") << "64x32x1" << false;
        QTest::newRow("huge") << "64x32x4294967296" << false;
        QTest::newRow("nothing") << "" << false;
        QTest::newRow("word") << "axbxc" << false;
    }

    void sizesAreUnderstood()
    {
        QFETCH(QString, text);
        QFETCH(bool, understood);
        const auto samples = storedSamplesOf({{"size", text.toStdString()},
                                              {"type", std::string("int16")},
                                              {"byte-order", std::string("big")},
                                              {"skip", std::int64_t(7)}});
        QCOMPARE(samples.has_value(), understood);
        if (samples) {
            QCOMPARE(samples->size, (std::array<std::uint32_t, 3>{64, 32, 16}));
            QCOMPARE(samples->type, SampleType::Int16);
            QCOMPARE(samples->order, std::endian::big);
            QCOMPARE(samples->skippedBytes, std::uint64_t(7));
        }
    }

    void aSizeFitsOrSaysByHowMuchNot()
    {
        const StoredSamples samples{.size = {32, 32, 32}, .type = SampleType::UInt8};
        QVERIFY(checkRawSize(samples, 32768).fits);
        QCOMPARE(checkRawSize(samples, 32768).text,
                 QString("32 × 32 × 32 × uint8 = 32,768 bytes: exactly the size of the file."));
        QVERIFY(!checkRawSize(samples, 32767).fits);
        QCOMPARE(checkRawSize(samples, 32767).text,
                 QString("32 × 32 × 32 × uint8 = 32,768 bytes; the file has 32,767 (1 missing)."));
        QVERIFY(!checkRawSize(samples, 32769).fits);
        QCOMPARE(checkRawSize(samples, 32769).text,
                 QString("32 × 32 × 32 × uint8 = 32,768 bytes; the file has 32,769 (1 too many)."));
        const StoredSamples behind{.size = {2, 2, 2}, .type = SampleType::Float32, .skippedBytes = 10};
        QVERIFY(checkRawSize(behind, 42).fits);
        const StoredSamples largest{.size = {1 << 20, 1 << 20, 1 << 20}, .type = SampleType::Float64};
        QVERIFY(!checkRawSize(largest, 8).fits);
    }

    void partsAreCounted()
    {
        const Lattice lattice{.size = {10, 20, 30}};
        QCOMPARE(countPart(lattice, {}).text, QString("All 10 × 20 × 30 = 6,000 points."));
        const DatasetPart half{.stride = {2, 2, 2}};
        QCOMPARE(countPart(lattice, half).text, QString("5 × 10 × 15 = 750 of 6,000 points."));
        QVERIFY(!countPart(lattice, {.stride = {10, 1, 1}}).fits);
    }

    void anUnknownFileHasAllFields()
    {
        const auto parameters = parametersOf("plot3d");
        QCOMPARE(importForm(parameters, {}, {}, true).parameters.size(), parameters.size());
        FileContents several{.domain = DomainClass::Curvilinear};
        several.blocks = {"1: 5 x 5 x 5", "2: 6 x 6 x 6"};
        several.arrays = {{.name = "density"}, {.name = "mach"}};
        const ImportForm form = importForm(parameters, several, {}, false);
        QCOMPARE(form.choices.at("grid").size(), std::size_t(3)); // with all of them
        QCOMPARE(form.choices.at("grid")[2].value, ParameterValue(std::int64_t(2)));
        QCOMPARE(form.choices.at("array").size(), std::size_t(3)); // with "automatic"
        several.blocks.clear();
        const ImportForm one = importForm(parameters, several, {}, false);
        QVERIFY(std::ranges::find(one.parameters, "grid", &Parameter::id) == one.parameters.end());
        QVERIFY(!one.looksLike(form) && one.looksLike(one));
    }

    void whatDoesNotFitTheFileIsNotAsked()
    {
        const auto asks = [](const ImportForm& form, const char* id) {
            return std::ranges::find(form.parameters, id, &Parameter::id) != form.parameters.end();
        };
        const auto parameters = parametersOf("plot3d");
        QVERIFY(asks(importForm(parameters, {.domain = DomainClass::Curvilinear}, {}, false), "solution"));
        QVERIFY(!asks(importForm(parameters, {.domain = DomainClass::Irregular}, {}, false), "solution"));
        // Most files tell where they lie, and refuse to be told.
        const ImportForm image = importForm(parametersOf("vtk"), {.domain = DomainClass::RegularLattice}, {}, false);
        QVERIFY(!asks(image, "spacing") && !asks(image, "origin") && !asks(image, "unit"));
        const ImportForm pictures = importForm(
            parametersOf("vtk"), {.domain = DomainClass::RegularLattice, .untold = {"spacing", "unit"}}, {}, false);
        QVERIFY(asks(pictures, "spacing") && !asks(pictures, "origin") && asks(pictures, "unit"));
        // Only NumPy's arrays may be indexed either way; raw files, too, are described by size along x, y and z.
        const auto ofLattices = parametersOf("lattice");
        const auto asksForAxes = [&](const FileContents& contents) {
            return asks(importForm(ofLattices, contents, {}, true), "axes");
        };
        QVERIFY(asksForAxes({.domain = DomainClass::RegularLattice, .untold = {"spacing", "axes"}}));
        QVERIFY(!asksForAxes({.domain = DomainClass::RegularLattice, .untold = {"spacing"}}) && !asksForAxes({}));
    }

    /// D3: a line each, and a guess is called one.
    void whatWouldBeTakenIsTold()
    {
        const std::vector<Taken> taken = {{TakenPart::Array, std::string("heat"), true},
                                          {TakenPart::TimeStep, Message::say("%1 of %2", 2, 5)}};
        const std::vector<Message> leftOut = {Message("It holds 20 volumes.")};
        QCOMPARE(provenanceLines(taken, leftOut),
                 QStringList({"Array: heat (a guess)", "Time step: 2 of 5", "It holds 20 volumes."}));
    }

    void seriesAndChannelsAreChosenByName()
    {
        Parameter series, channel;
        series.id = "series";
        channel.id = "channel";
        series.defaultValue = channel.defaultValue = std::string();
        FileContents pictures{.domain = DomainClass::RegularLattice};
        pictures.channels = {"DAPI", "GFP"};
        const ImportForm form = importForm({series, channel}, pictures, {}, false);
        QCOMPARE(form.parameters.size(), std::size_t(1));
        QCOMPARE(form.choices.at("channel").size(), std::size_t(3));
        QCOMPARE(form.choices.at("channel")[2].value, ParameterValue(std::string("GFP")));
    }

    void theReadersOwnChoiceHasAName()
    {
        FileContents mesh{.domain = DomainClass::Irregular};
        mesh.arrays = {{.name = "density"}, {.name = "pressure"}};
        const ImportForm form = importForm(parametersOf("cells"), mesh, {}, false);
        const auto& choices = form.choices.at("array");
        QCOMPARE(choices.size(), std::size_t(3));
        QCOMPARE(choices[0].value, ParameterValue(std::string()));
        QCOMPARE(choices[0].label, QString("automatic"));
    }

    void aLayoutIsAskedForOnlyWhereTheFileDoesNotTellIt()
    {
        const auto parameters = parametersOf("lattice");
        QVERIFY(needsLayout(parameters, {}));
        const FileContents nrrd{.domain = DomainClass::RegularLattice, .lattice = {}, .points = 8, .arrays = {{}}};
        QVERIFY(!needsLayout(parameters, nrrd));
        QVERIFY(importForm(parameters, nrrd, {}, false).parameters.empty());
        // All but the axes, of NumPy arrays alone.
        QCOMPARE(importForm(parameters, {}, {}, true).parameters.size(), parameters.size() - 1);
    }

    void whatIsMissingIsNotGrey()
    {
        SampleSlice slice{
            .width = 2, .height = 2, .values = {0, 10, std::numeric_limits<float>::quiet_NaN(), 20}, .window = {0, 10}};
        const QImage image = sliceImage(slice);
        QCOMPARE(image.pixel(0, 1), qRgb(0, 0, 0)); // the first row is the lowest
        QCOMPARE(image.pixel(1, 1), qRgb(255, 255, 255));
        QCOMPARE(image.pixel(1, 0), qRgb(255, 255, 255)); // beyond the window
        QVERIFY(qRed(image.pixel(0, 0)) != qBlue(image.pixel(0, 0)));
        slice.window = {5, 5};
        QCOMPARE(sliceImage(slice).pixel(0, 1), qRgb(128, 128, 128));
    }

    void theLastFiftyFilesAreRemembered()
    {
        const ImportOptions options{
            .reader = "lattice",
            .values = {{"size", std::string("4x4x4")}, {"skip", std::int64_t(3)}},
            .part = {.region = Eigen::AlignedBox3d(Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(2, 2, 3)),
                     .stride = {1, 2, 1}}};
        for (int i = 0; i < 51; ++i)
            rememberImport("/nowhere/file" + std::to_string(i) + ".raw", options);
        const ImportOptions last = rememberedImport("/nowhere/file50.raw", *host_);
        QCOMPARE(last.reader, options.reader);
        QVERIFY(last.values == options.values);
        QVERIFY(last.part.region && last.part.region->min() == options.part.region->min());
        QCOMPARE(last.part.stride, options.part.stride);
        QVERIFY(!rememberedImport("/nowhere/file0.raw", *host_).reader);
        QVERIFY(rememberedImport("/nowhere/file1.raw", *host_).reader);
        rememberImport("/nowhere/file1.raw", {});
        QVERIFY(!rememberedImport("/nowhere/file1.raw", *host_).reader);
    }

private:
    std::vector<Parameter> parametersOf(const std::string& reader)
    {
        return host_->reader(reader)->plugin->parameters();
    }

    std::unique_ptr<PluginHost> host_ = hostOfThisBuild();
};

QTEST_MAIN(ImportTest)
#include "import_test.moc"
