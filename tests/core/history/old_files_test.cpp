// SPDX-License-Identifier: GPL-3.0-or-later
// Files of the earlier versions of the format open for ever: what is kept in old_files was written by the programs of
// those versions, beside what they said of the levels. That commands take them, tests/app/old_models_test.cpp shows.
#include "core/history/format.h"
#include "tests/core/history/model_fixture.h"
#include "tests/core/history/query/questions.h"

#include <tan/query.h>

#include <QCryptographicHash>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <map>
#include <vector>

using namespace tetra;
using format::SectionId;

namespace {

const std::filesystem::path oldFilesFolder = TAN_SOURCE_DIR "/tests/core/history/old_files";

/// Of all versions, as "1_0/lattice".
std::vector<std::string> oldModels()
{
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(oldFilesFolder))
        if (entry.path().extension() == ".tan")
            names.push_back(relative(entry.path(), oldFilesFolder).replace_extension().string());
    std::ranges::sort(names);
    return names;
}

std::filesystem::path fileOf(const std::string& name, const char* ending)
{
    return oldFilesFolder / (name + ending);
}

QByteArray textOf(const std::filesystem::path& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// A mesh as old_files/meshes.csv has it.
struct RecordedMesh {
    std::uint32_t sites = 0;
    std::size_t tetrahedra = 0;
    QByteArray sha1;
};

std::map<std::string, std::vector<RecordedMesh>> recordedMeshes()
{
    std::map<std::string, std::vector<RecordedMesh>> meshes;
    const QList<QByteArray> lines = textOf(oldFilesFolder / "meshes.csv").split('\n');
    for (const QByteArray& line : lines.mid(1))
        if (const QList<QByteArray> words = line.split(','); words.size() == 4)
            meshes[words[0].toStdString()].push_back({words[1].toUInt(), words[2].toULongLong(), words[3]});
    return meshes;
}

/// Of the sites, each with its point, place and value, and of the tetrahedra by points: see old_files/meshes.py.
QByteArray sha1Of(const Model& model, const TetrahedralMesh& mesh)
{
    QCryptographicHash hash(QCryptographicHash::Sha1);
    const auto add = [&hash](const auto& value) {
        hash.addData(QByteArrayView(reinterpret_cast<const char*>(&value), qsizetype(sizeof value)));
    };
    for (std::size_t site = 0; site < mesh.values.size(); ++site) {
        add(model.points()[site]);
        add(mesh.positions[site].cast<float>().eval()); // in which they were recorded
        add(mesh.values[site]);
    }
    for (const auto& tetrahedron : byPoints(mesh.tetrahedra, model.points()))
        add(tetrahedron);
    return hash.result().toHex();
}

void addRowForEachModel()
{
    QTest::addColumn<QString>("model");
    for (const std::string& name : oldModels())
        QTest::newRow(name.c_str()) << QString::fromStdString(name);
}

} // namespace

class OldFilesTest : public QObject {
    Q_OBJECT

private slots:
    void eachVersionHasItsFiles();
    void levelsAreWhatTheyWere_data() { addRowForEachModel(); }
    void levelsAreWhatTheyWere();
    void meshesAreWhatTheFileSays_data() { addRowForEachModel(); }
    void meshesAreWhatTheFileSays();
    void aChangedFileHasOtherMeshes_data() { addRowForEachModel(); }
    void aChangedFileHasOtherMeshes();
    void everyQuestionIsAnswered_data() { addRowForEachModel(); }
    void everyQuestionIsAnswered();
};

/// A version that another one follows leaves files here.
void OldFilesTest::eachVersionHasItsFiles()
{
    std::map<int, int> filesOfVersion;
    for (const std::string& name : oldModels()) {
        const int minor = FileParts(readBytes(fileOf(name, ".tan"))).header().minorVersion;
        QVERIFY2(name.starts_with("1_" + std::to_string(minor) + "/"), name.c_str());
        ++filesOfVersion[minor];
    }
    for (int minor = 0; minor < format::minorVersion; ++minor)
        QVERIFY2(filesOfVersion[minor] >= 3, qPrintable(QString("version 1.%1").arg(minor)));
    QVERIFY(oldModels().size() >= 12);
    QCOMPARE(recordedMeshes().size(), oldModels().size());
}

void OldFilesTest::levelsAreWhatTheyWere()
{
    QFETCH(QString, model);
    const std::filesystem::path path = fileOf(model.toStdString(), ".tan");
    const auto opened = Model::open(path);
    QVERIFY2(opened.ok(), opened.ok() ? "" : opened.error().text().c_str());
    QByteArray levels = QByteArray::fromStdString(
        levelsAsCsv(**opened, std::vector<Accuracy>{{10, 10}, {4, 4}, {1, 1}, {0.1, 0.1}, {0, 0}}));
    levels.replace(",error_kind\n", "\n").replace(",grid\n", "\n"); // the last column, which came later
    QCOMPARE(levels, textOf(fileOf(model.toStdString(), ".csv")));
    QVERIFY((*opened)->confirm().ok());
    QVERIFY(std::filesystem::file_size(path) < 50'000);
}

void OldFilesTest::meshesAreWhatTheFileSays()
{
    QFETCH(QString, model);
    const ModelPointer opened = *Model::open(fileOf(model.toStdString(), ".tan"));
    const auto recorded = recordedMeshes()[model.toStdString()];
    QVERIFY(recorded.size() >= 3);
    for (const RecordedMesh& expected : recorded) {
        const auto mesh = extractPrefix(*opened, expected.sites);
        QVERIFY2(mesh.ok(), mesh.ok() ? "" : mesh.error().text().c_str());
        QCOMPARE(mesh->values.size(), std::size_t(expected.sites));
        QCOMPARE(mesh->tetrahedra.size(), expected.tetrahedra);
        QCOMPARE(sha1Of(*opened, *mesh), expected.sha1);
    }
}

/// So the sums above prove something.
void OldFilesTest::aChangedFileHasOtherMeshes()
{
    QFETCH(QString, model);
    const QTemporaryDir folder;
    const std::filesystem::path path = folder.filePath("changed.tan").toStdString();
    const RecordedMesh whole = recordedMeshes()[model.toStdString()].back();
    for (const SectionId section : {SectionId::SitePoints, SectionId::SiteValues, SectionId::Destroyers}) {
        FileParts parts(readBytes(fileOf(model.toStdString(), ".tan")));
        if (section == SectionId::Destroyers) { // takes a tetrahedron out of the mesh
            const auto destroyers = parts.elements<std::uint32_t>(section);
            *std::ranges::find_if(destroyers, [&](std::uint32_t site) { return site >= whole.sites; }) =
                whole.sites - 1;
        } else {
            parts.elements<std::byte>(section)[parts.section(section).elementBytes - 1] ^= std::byte(1);
        }
        parts.repairChecksums();
        writeBytes(path, parts.content);
        const auto changed = Model::open(path);
        const auto mesh = changed ? extractPrefix(**changed, whole.sites) : changed.error();
        QVERIFY(!mesh || sha1Of(**changed, *mesh) != whole.sha1);
    }
}

/// But those by insertion, of the files that hold no samples.
void OldFilesTest::everyQuestionIsAnswered()
{
    QFETCH(QString, model);
    const ModelPointer opened = *Model::open(fileOf(model.toStdString(), ".tan"));
    const bool canInsert = opened->description().delaunay && !opened->samples().empty();
    for (const auto& [name, question] : questionsAbout(opened->description())) {
        const auto answer = question(opened);
        const bool answered = canInsert || !name.starts_with("insertion");
        QVERIFY2(answer.ok() == answered, (name + (answer ? "" : ": " + answer.error().text())).c_str());
    }
    QVERIFY(opened->confirm().ok());
}

QTEST_GUILESS_MAIN(OldFilesTest)
#include "old_files_test.moc"
