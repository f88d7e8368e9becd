// SPDX-License-Identifier: GPL-3.0-or-later
/// Every command takes a model in either form, from this disk or a server (R16, R28, B5): the same meshes, and no more
/// read than they need. What cuts, packs and unpacks keeps to the rules of all commands.
#include "tests/app/program.h"
#include "tests/app/sample_files.h"
#include "tests/core/remote/http_server.h"

#include <tan/open.h>

#include <QDir>
#include <QDirIterator>
#include <QElapsedTimer>
#include <QFile>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>

#include <atomic>

using namespace tetra;

class ModelFormsTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        make({"sample", "c60", "--size", "24", "-o", "c60.nrrd"});
        make({"build", "c60.nrrd", "-o", "c60.tan"});
        make({"build", "c60.nrrd", "--builder", "decimation", "-o", "decimated.tan"});
        make({"sample", "o-grid", "--size", "14", "-o", "grid.xyz"});
        make({"build", "grid.xyz", "--builder", "refinement", "--error-in", "grid", "-o", "grid.tan"});
        make({"sample", "c60", "--size", "40", "-o", "large.nrrd"});
        make({"build", "large.nrrd", "-o", "large.tan"});
    }

    /// The coarse levels as a model of its own: the same meshes down to there, proved against the data.
    void cut_data()
    {
        QTest::addColumn<QString>("model");
        QTest::addColumn<QString>("data");
        QTest::newRow("lattice") << "c60.tan"
                                 << "c60.nrrd";
        QTest::newRow("decimated") << "decimated.tan"
                                   << "c60.nrrd";
        QTest::newRow("grid") << "grid.tan"
                              << "grid.xyz";
    }
    void cut()
    {
        QFETCH(QString, model);
        QFETCH(QString, data);
        const Run run = make({"cut", model, "--error", "5", "-o", "cut.tan", "--json"});
        const Run whole = make({"info", model, "--lod", "20,5", "--json"});
        const Run part = make({"info", "cut.tan", "--lod", "20,5", "--json"});
        QCOMPARE(part.json()["levels"], whole.json()["levels"]);
        QCOMPARE(run.json()["sites"], whole.json()["levels"][1]["sites"]); // to a batch
        QCOMPARE(run.json()["of_sites"], whole.json()["sites"]);
        QCOMPARE(part.json()["sites"], run.json()["sites"]);
        QCOMPARE(run.json()["bytes"].toInteger(), QFile(path("cut.tan")).size());
        const Run verdict = runIn({"verify", "cut.tan", "--against", data, "--lod", "20,5,0"});
        QVERIFY2(verdict.exitCode == 0, verdict.output);
        make({"extract", model, "--error", "5", "-o", "whole.vtu"});
        make({"extract", "cut.tan", "--error", "5", "-o", "part.vtu"});
        QVERIFY(meshIn("part.vtu") == meshIn("whole.vtu"));
        make({"cut", model, "--error", "0", "-o", "all.tan"});
        QVERIFY(model != "c60.tan" || readFile(path("all.tan")) == readFile(path(model)));
    }

    void outputsAreSafe()
    {
        QVERIFY(writeFile(path("notes.txt"), "important"));
        for (const QStringList& words :
             {QStringList{"cut", "c60.tan", "--error", "5"}, QStringList{"pack", "c60.tan"}}) {
            const Run over = runIn(words + QStringList{"-o", "notes.txt"});
            QCOMPARE(over.exitCode, 2);
            QCOMPARE(readFile(path("notes.txt")), QByteArray("important"));
            QCOMPARE(runIn(words + QStringList{"-o", "c60.tan"}).exitCode, 2);
        }
        QCOMPARE(runIn({"cut", "c60.tan", "-o", "x.tan"}).exitCode, 2);
        QCOMPARE(runIn({"cut", "c60.tan", "--error", "5", "--warping", "1", "-o", "x.tan"}).exitCode, 2);
        QCOMPARE(runIn({"cut", "c60.nrrd", "--error", "5", "-o", "x.tan"}).exitCode, 3);
        QCOMPARE(runIn({"unpack", "c60.tan", "-o", "x.tan"}).exitCode, 2);
        QCOMPARE(runIn({"build", "c60.nrrd", "--packed", "--keep", "-o", "x.tan"}).exitCode, 2);
        QVERIFY(!QFile::exists(path("x.tan")));
    }

    /// R16: a packed model in place of the model.
    void packed_data() { cut_data(); }
    void packed()
    {
        QFETCH(QString, model);
        QFETCH(QString, data);
        const qint64 size = QFile(path(model)).size();
        const Run run = make({"pack", model, "-o", "packed.tan", "--json"});
        const QJsonObject packing = run.json()["packed"].toObject();
        QCOMPARE(packing["bytes"].toInteger(), QFile(path("packed.tan")).size());
        QCOMPARE(packing["unpacked_bytes"].toInteger(), size);
        QVERIFY(packing["bytes"].toInteger() < size / 2);

        const Run info = make({"info", "packed.tan", "--lod", "30,0", "--json"});
        QCOMPARE(info.json()["form"].toString(), QString("packed"));
        QCOMPARE(info.json()["unpacked_bytes"].toInteger(), size);
        QVERIFY(info.json()["levels"][0]["bytes"].toInteger() < info.json()["levels"][1]["bytes"].toInteger());
        QVERIFY(!QDir(path("cache")).exists("tan") || QDir(path("cache/tan")).isEmpty()); // nothing was unpacked

        make({"unpack", "packed.tan", "-o", "unpacked.tan"});
        QVERIFY(readFile(path("unpacked.tan")) == readFile(path(model)));
        make({"unpack", "packed.tan", "--error", "30", "-o", "coarse.tan"});
        QVERIFY(QFile(path("coarse.tan")).size() < size);
        QCOMPARE(runIn({"verify", "coarse.tan", "--against", data, "--lod", "40,30"}).exitCode, 0);

        const Run part = make({"extract", "packed.tan", "--error", "30", "-o", "part.vtu", "--json"});
        QVERIFY(part.json()["read_part"].toObject()["bytes"].toInteger() < packing["bytes"].toInteger());
        QVERIFY(part.json()["error"].toDouble() <= 30);
        make({"extract", "packed.tan", "--error", "0", "-o", "all.vtu"});
        make({"extract", model, "--error", "0", "-o", "right.vtu"});
        QVERIFY(meshIn("all.vtu") == meshIn("right.vtu"));
        QCOMPARE(make({"info", "packed.tan", "-o", "levels.csv", "--json"}).json()["bytes"].toInteger(), size);
        const QStringList cached = QDir(path("cache/tan")).entryList(QDir::Files);
        make({"verify", "packed.tan", "--against", data, "--lod", "5"});
        QCOMPARE(QDir(path("cache/tan")).entryList(QDir::Files), cached); // found there again
        QVERIFY(QDir(path("cache")).removeRecursively());
    }

    /// R16, R25: within a budget no more is unpacked than has it, and no accuracy need be given. Where the levels are
    /// those of the model the picture is the same.
    void packedWithinBudget_data() { cut_data(); }
    void packedWithinBudget()
    {
        QFETCH(QString, model);
        make({"pack", model, "-o", "packed.tan"});
        // With axes the box is framed, not the object as far as the part that was read knows it.
        const QStringList drawn = {"render",   model,       "--isovalue", model == "grid.tan" ? "0.5" : "100",
                                   "--budget", "2000",      "--size",     "60x40",
                                   "-o",       "right.png", "--box-axes", "--no-outline",
                                   "--json"};
        QStringList ofPacked = drawn;
        ofPacked.replaceInStrings(model, "packed.tan");
        ofPacked.replaceInStrings("right.png", "packed.png");
        const Run right = make(drawn), packed = make(ofPacked);
        const QJsonObject part = packed.json()["read_part"].toObject();
        QVERIFY2(part["sites"].toInteger() * 2 < part["of_sites"].toInteger(), packed.output);
        QVERIFY(packed.json()["tetrahedra"].toInteger() <= 2000);
        if (model == "c60.tan") // packed in levels of its own
            QVERIFY(packed.json()["tetrahedra"].toInteger() > 1000);
        else
            QVERIFY(readFile(path("packed.png")) == readFile(path("right.png")));
        // All of it where the budget allows that, and then that is what is being done.
        std::atomic<bool> heard = false;
        const auto hear = [&](double, const Message& activity) {
            if (activity.text().starts_with("Unpacking the whole model: "))
                heard = true;
        };
        OpenOptions options;
        options.cacheFolder = path("cache-of-all").toStdString();
        QVERIFY(openModel(path("packed.tan").toStdString(), options, Progress({}, hear)).ok());
        QVERIFY(heard);
        const Run all = make({"extract", "packed.tan", "--budget", "10000000", "-o", "all.vtu", "--json"});
        QVERIFY(!all.json().contains("read_part"));
        make({"extract", model, "--error", "0", "-o", "right.vtu"});
        QVERIFY(meshIn("all.vtu") == meshIn("right.vtu"));
        QVERIFY(QDir(path("cache")).removeRecursively());
    }

    /// Builds, packs, and leaves nothing else.
    void buildsPacked()
    {
        const QStringList before = QDir(folder_.path()).entryList(QDir::AllEntries | QDir::NoDotAndDotDot);
        const Run run = make({"build", "c60.nrrd", "--packed", "-o", "built.tan", "--json"});
        QCOMPARE(run.json()["bytes"].toInteger(), QFile(path("built.tan")).size());
        QCOMPARE(run.json()["packed"].toObject()["bytes"].toInteger(), run.json()["bytes"].toInteger());
        QCOMPARE(QDir(folder_.path()).entryList(QDir::AllEntries | QDir::NoDotAndDotDot).size(), before.size() + 1);
        make({"unpack", "built.tan", "-o", "unpacked.tan"});
        QVERIFY(readFile(path("unpacked.tan")) == readFile(path("c60.tan")));
    }

    /// The front of a packed model does not tell how many cells the data have; that they have none is not said.
    void cellsThatAreNotKnown()
    {
        make({"sample", "part", "--size", "8", "-o", "part.vtu"});
        make({"build", "part.vtu", "--packed", "-o", "part.tan"});
        QVERIFY(!make({"info", "part.tan", "--json"}).json().contains("cells"));
        QVERIFY(!make({"info", "part.tan"}).output.contains("in 0 tetrahedra"));
        QVERIFY(make({"info", "part.vtu", "--json"}).json()["cells"].toInteger() > 0);
    }

    /// R28, B5: of a model on a server no more is fetched than a mesh needs.
    void addresses()
    {
        FaultyHttpServer server(readFile(path("large.tan")).toStdString());
        const QString address = QString::fromStdString(server.address("/large.tan"));
        const qint64 size = QFile(path("large.tan")).size();
        const Run info = make({"info", address, "--lod", "30,0", "--json"});
        QCOMPARE(info.json()["form"].toString(), QString("explicit"));
        QCOMPARE(info.json()["bytes"].toInteger(), size);
        QCOMPARE(info.json()["levels"][1]["bytes"].toInteger(), size);
        QVERIFY(server.requests().size() <= 2);
        QVERIFY(info.json()["levels"][0]["reached"].toDouble() <= 30);

        const Run part = make({"extract", address, "--error", "30", "-o", "part.vtu", "--json"});
        QVERIFY(part.json()["read_part"].toObject()["bytes"].toInteger() < size / 2);
        QCOMPARE(part.json()["read_part"].toObject()["of_bytes"].toInteger(), size);
        make({"extract", "large.tan", "--error", "30", "-o", "whole.vtu"});
        QVERIFY(meshIn("part.vtu") == meshIn("whole.vtu"));
        // It is there the next time.
        server.forget();
        make({"extract", address, "--error", "30", "-o", "part.vtu"});
        QVERIFY(server.requests().size() <= 1);

        make({"isosurface", address, "--error", "30", "--value", "100", "-o", "part.stl"});
        make({"render", address, "--error", "30", "--isovalue", "100:gold", "-o", "part.png"});
        make({"cut", address, "--error", "30", "-o", "part.tan"});
        make({"verify", address, "--against", "large.nrrd", "--lod", "30"});
        const Run all = make({"extract", address, "--error", "0", "-o", "all.vtu", "--json"});
        QVERIFY(!all.json().contains("read_part"));
    }

    /// What a proxy damages on its way is told, and asked for again the next time.
    void damageOnTheWayIsForgotten()
    {
        std::atomic<bool> damages = true;
        FaultyHttpServer server(readFile(path("c60.tan")).toStdString(),
                                [&](const auto& request, std::size_t, FaultyHttpServer::Reply& reply) {
                                    if (damages && request.first.value_or(0) > 0)
                                        reply.body[reply.body.size() / 2] ^= 1;
                                });
        const QString address = QString::fromStdString(server.address("/damaged.tan"));
        const Run run = runIn({"extract", address, "--error", "3", "-o", "x.vtu"});
        QCOMPARE(run.exitCode, 3);
        QVERIFY2(run.messages.contains("is damaged"), run.messages);
        QVERIFY(!QFile::exists(path("x.vtu")));
        damages = false;
        make({"extract", address, "--error", "3", "-o", "x.vtu"});
    }

    /// What a disk damages in the cache is told at most once, and made again.
    void damageInTheCacheIsMended()
    {
        make({"build", "c60.nrrd", "--packed", "-o", "kept.packed.tan"});
        const QStringList words = {"extract", "kept.packed.tan", "--error", "0", "-o", "kept.vtu"};
        make(words);
        const QByteArray right = meshIn("kept.vtu");
        QDirIterator entries(path("cache"), QDir::Files, QDirIterator::Subdirectories);
        while (entries.hasNext()) {
            QFile entry(entries.next());
            QVERIFY(entry.open(QIODevice::ReadWrite));
            for (const qint64 part : {2, 3}) {
                const QByteArray zeros(std::min<qint64>(5000, entry.size() / 4), 0);
                QVERIFY(entry.seek(entry.size() / part) && entry.write(zeros) == zeros.size());
            }
        }
        QVERIFY(QFile::remove(path("kept.vtu")));
        const Run told = runIn(words);
        QVERIFY2(told.exitCode == 0 || (told.exitCode == 3 && !QFile::exists(path("kept.vtu"))), told.messages);
        make(words);
        QVERIFY(meshIn("kept.vtu") == right);
    }

    void whatIsNoModelIsTold()
    {
        FaultyHttpServer server("<html>Please log in</html>",
                                [](const auto& request, std::size_t, FaultyHttpServer::Reply& reply) {
                                    if (request.path == "/gone.tan")
                                        reply.become(404, "nothing here", "text/plain");
                                });
        for (const char* file : {"/login.tan", "/gone.tan"}) {
            const Run run = runIn({"info", QString::fromStdString(server.address(file))});
            QCOMPARE(run.exitCode, 3);
            QVERIFY2(run.messages.count('.') >= 2, run.messages);
        }
        for (const char* place : {"ftp://127.0.0.1/x.tan", "127.0.0.1:9/x.tan"}) {
            const Run none = runIn({"extract", place, "-o", "nothing.vtu"});
            QCOMPARE(none.exitCode, 3);
            QVERIFY2(none.messages.contains("begins with http:// or https://"), none.messages);
        }
        const Run nowhere = runIn({"extract", "http://127.0.0.1:9/x.tan", "-o", "nothing.vtu"});
        QCOMPARE(nowhere.exitCode, 3);
        QVERIFY(!QFile::exists(path("nothing.vtu")));
    }

private:
    QString path(const QString& name) const { return folder_.filePath(name); }
    /// Without the header, which names the model.
    QByteArray meshIn(const QString& file) const
    {
        const QByteArray bytes = readFile(path(file));
        return bytes.mid(std::max<qsizetype>(0, bytes.indexOf("<AppendedData")));
    }
    Run runIn(const QStringList& words) const
    {
        return runTan(words, folder_.path(), {{"XDG_CACHE_HOME", folder_.filePath("cache")}});
    }
    /// The test ends at once if it does not work.
    Run make(const QStringList& words) const
    {
        const Run run = runIn(words);
        if (run.exitCode != 0)
            qFatal("tan %s: %s", qPrintable(words.join(' ')), run.messages.constData());
        return run;
    }

    QTemporaryDir folder_;
};

QTEST_GUILESS_MAIN(ModelFormsTest)
#include "model_forms_test.moc"
