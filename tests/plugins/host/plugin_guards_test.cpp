// SPDX-License-Identifier: GPL-3.0-or-later
/// What a plugin throws ends at the host, whatever it is and wherever; and what the host does for all readers and
/// writers.
#include "plugins/host/plugin_guards.h"
#include "plugins/host/safe_output.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include <fstream>
#include <stdexcept>

using namespace tetra;

namespace {

namespace fs = std::filesystem;

/// What a plugin may throw.
enum class Thrown { Nothing, Exception, OutOfMemory, TooLong, Anything };

Thrown thrown = Thrown::Nothing;

void throwIt()
{
    switch (thrown) {
    case Thrown::Nothing: return;
    case Thrown::Exception: throw std::runtime_error("no luck");
    case Thrown::OutOfMemory: throw std::bad_alloc();
    case Thrown::TooLong: throw std::length_error("vector");
    case Thrown::Anything: throw 5;
    }
}

template <class Value> Value orThrow(Value value)
{
    throwIt();
    return value;
}

Parameter someParameter()
{
    Parameter parameter;
    parameter.id = "text";
    parameter.defaultValue = std::string();
    parameter.mistake = [](const std::string& text) { return orThrow("wrong: " + text); };
    return parameter;
}

class SomeBuilder : public Builder {
public:
    Acceptance accepts(const Dataset&) const override { return orThrow(Acceptance{1, "yes"}); }
    std::vector<Parameter> parameters() const override { return orThrow(std::vector{someParameter()}); }
    ParameterValues detail(double, DomainClass) const override { return orThrow(ParameterValues{{"text", 1.0}}); }
    BuildAbilities abilities(const Dataset&, const ParameterValues&) const override
    {
        return orThrow(BuildAbilities{true, true, true});
    }
    std::optional<BuildEstimate> estimate(const BuildSize&, const ParameterValues&, unsigned) const override
    {
        return orThrow(std::optional(BuildEstimate{}));
    }
    Result<BuildReport> build(const Dataset&, const ParameterValues&, BuildTarget&, const Progress&) const override
    {
        return orThrow(BuildReport{});
    }
};

Dataset zeros()
{
    return *latticeDataset(Lattice{.size = {2, 2, 2}}, ScalarField::of(std::vector<float>(8, 0)), "zeros");
}

class SomeReader : public Reader {
public:
    std::vector<std::string> nameFilters() const override { return orThrow(std::vector<std::string>{"Some (*.some)"}); }
    double score(const fs::path&, std::span<const std::byte>) const override { return orThrow(1.0); }
    std::vector<Parameter> parameters() const override { return orThrow(std::vector{someParameter()}); }
    Result<Dataset> read(const fs::path&, const ParameterValues&, const Progress&) const override
    {
        throwIt();
        if (error)
            return *error;
        Dataset dataset = zeros();
        dataset.source = {};
        return dataset;
    }
    Result<FileContents> probe(const fs::path&, const ParameterValues&, const Progress&) const override
    {
        throwIt();
        return error ? Result<FileContents>(*error) : FileContents{};
    }

    std::optional<Error> error;
};

class SomeWriter : public Writer {
public:
    std::vector<FileFormat> formats() const override
    {
        return orThrow(std::vector<FileFormat>{{WrittenContent::Surface, "Some", {".some"}}});
    }
    std::vector<Parameter> parameters() const override { return orThrow(std::vector{someParameter()}); }
    Status writeSurface(const SurfaceContent&, OutputFile& file, const ParameterValues&) const override
    {
        const Status written = file.text("half of it");
        throwIt();
        return written;
    }
};

} // namespace

class PluginGuardsTest : public QObject {
    Q_OBJECT

private:
    GuardTarget target()
    {
        return {"some", [this](const Error& error) { told_.push_back(error.text()); }};
    }
    fs::path path(const char* name) const { return fs::path(folder_.path().toStdString()) / name; }

    QTemporaryDir folder_;
    std::vector<std::string> told_;

private slots:
    void init()
    {
        thrown = Thrown::Nothing;
        told_.clear();
    }
    void cleanup() { thrown = Thrown::Nothing; }

    void whatIsNotThrownPasses()
    {
        const SomeBuilder builder;
        const auto guard = guarded(builder, target());
        QCOMPARE(guard->accepts(zeros()).score, 1.0);
        QCOMPARE(guard->parameters().front().mistake("x").text(), std::string("wrong: x"));
        QVERIFY(guard->abilities(zeros(), {}).resumes);
        QVERIFY(guard->estimate({}, {}, 1));
        QCOMPARE(guard->detail(1, DomainClass::Scattered).size(), std::size_t(1));
        QVERIFY(told_.empty());
    }

    void whatIsThrownEnds_data()
    {
        QTest::addColumn<int>("what");
        QTest::addColumn<QString>("word");
        QTest::newRow("an exception") << int(Thrown::Exception) << "no luck";
        QTest::newRow("no memory") << int(Thrown::OutOfMemory) << "memory";
        QTest::newRow("a vector that is too long") << int(Thrown::TooLong) << "memory";
        QTest::newRow("a number") << int(Thrown::Anything) << "without giving a reason";
    }
    void whatIsThrownEnds()
    {
        QFETCH(int, what);
        QFETCH(QString, word);
        const SomeBuilder builder;
        const SomeReader reader;
        const SomeWriter writer;
        const auto builderGuard = guarded(builder, target());
        const auto readerGuard = guarded(reader, target());
        const auto writerGuard = guarded(writer, target());
        const auto parameters = builderGuard->parameters();
        std::ofstream(path("a.some")) << "content";
        thrown = Thrown(what);

        const Acceptance acceptance = builderGuard->accepts(zeros());
        QCOMPARE(acceptance.score, 0.0);
        QVERIFY2(acceptance.reason.text().find(word.toStdString()) != std::string::npos,
                 acceptance.reason.text().c_str());
        const auto read = readerGuard->read(path("a.some"), {}, {});
        QVERIFY2(!read && read.error().text().find(word.toStdString()) != std::string::npos,
                 read.error().text().c_str());
        QVERIFY(!readerGuard->probe(path("a.some"), {}, {}));
        auto file = SafeOutput::create(path("new.some"), Message::marked("Writing"), {});
        QVERIFY(file);
        QVERIFY(!writerGuard->writeSurface({}, **file, {}));
        *file = nullptr;
        QVERIFY(!fs::exists(path("new.some")));
        QVERIFY(told_.empty()); // these give errors themselves

        QVERIFY(parameters.front().mistake("x").empty());
        QVERIFY(builderGuard->parameters().empty());
        QVERIFY(builderGuard->detail(1, DomainClass::Scattered).empty());
        QVERIFY(!builderGuard->abilities(zeros(), {}).resumes);
        QVERIFY(!builderGuard->estimate({}, {}, 1));
        QVERIFY(readerGuard->nameFilters().empty());
        QVERIFY(readerGuard->parameters().empty());
        QCOMPARE(readerGuard->score(path("a.some"), {}), 0.0);
        QVERIFY(writerGuard->formats().empty());
        QVERIFY(writerGuard->parameters().empty());
        QCOMPARE(told_.size(), std::size_t(10));
        for (const std::string& text : told_)
            QVERIFY2(text.find(word.toStdString()) != std::string::npos, text.c_str());
    }

    void memoryThatIsShortNamesTheFile()
    {
        const SomeReader reader;
        const SomeWriter writer;
        auto file = SafeOutput::create(path("large.some"), Message::marked("Writing"), {});
        QVERIFY(file);
        thrown = Thrown::OutOfMemory;
        const auto read = guarded(reader, target())->read("large.some", {}, {});
        QCOMPARE(read.error().kind, ErrorKind::OutOfResource);
        QVERIFY(read.error().text().find("'large.some'") != std::string::npos);
        const Status written = guarded(writer, target())->writeSurface({}, **file, {});
        QCOMPARE(written.error().kind, ErrorKind::OutOfResource);
        QVERIFY(written.error().text().find("large.some'") != std::string::npos);
    }

    void aReadersErrorNamesItsFile()
    {
        SomeReader reader;
        const auto guard = guarded(reader, target());
        const auto textOf = [&](ErrorKind kind, const Message& message, const fs::path& named = {}) {
            reader.error = Error{kind, message, named};
            const auto read = guard->read("a.some", {}, {});
            const auto probed = guard->probe("a.some", {}, {});
            return read.error().text() == probed.error().text() ? read.error().text() : "different";
        };
        QCOMPARE(textOf(ErrorKind::BadInput, "it is empty."), std::string("Cannot read 'a.some': it is empty."));
        QCOMPARE(textOf(ErrorKind::WrongUsage, "it has no array."),
                 std::string("Cannot read 'a.some': it has no array."));
        // Whether a text names a file is not read out of its words.
        QCOMPARE(textOf(ErrorKind::BadInput, "'b.some' is empty.", "b.some"), std::string("'b.some' is empty."));
        QCOMPARE(textOf(ErrorKind::BadInput, "Cannot read 'b.some'."),
                 std::string("Cannot read 'a.some': Cannot read 'b.some'."));
        QCOMPARE(textOf(ErrorKind::Cancelled, "Reading was cancelled."), std::string("Reading was cancelled."));
    }

    void aDatasetHasASource()
    {
        const SomeReader reader;
        const auto read = guarded(reader, target())->read("folder/a.some", {}, {});
        QVERIFY(read);
        QCOMPARE(read->source.name, std::string("a.some"));
        QCOMPARE(read->source.path, fs::path("folder/a.some"));
        QCOMPARE(read->source.hash, zeros().source.hash);
    }

    void severalFilesAppearTogether()
    {
        auto file = SafeOutput::create(path("grid.some"), Message::marked("Writing"), {});
        QVERIFY(file);
        const auto other = (*file)->another(path("grid.other"));
        QVERIFY(other);
        QVERIFY((*file)->text("one"));
        QVERIFY((*other)->text("two"));
        QVERIFY(!fs::exists(path("grid.some")) && !fs::exists(path("grid.other")));
        QVERIFY((*file)->commit());
        QCOMPARE(fs::file_size(path("grid.some")), std::uintmax_t(3));
        QCOMPARE(fs::file_size(path("grid.other")), std::uintmax_t(3));
        auto given = SafeOutput::create(path("half.some"), Message::marked("Writing"), {});
        QVERIFY((*given)->another(path("half.other")));
        *given = nullptr;
        QVERIFY(!fs::exists(path("half.some")) && !fs::exists(path("half.other")));
    }
};

QTEST_APPLESS_MAIN(PluginGuardsTest)
#include "plugin_guards_test.moc"
