// SPDX-License-Identifier: GPL-3.0-or-later
// A server that gives files, ranges of them and meshes that it finds, to those who may have them and to nobody else
// (R28, C16; the paper's 5.1).
#include "app/command_line/arguments.h"
#include "app/command_line/query_options.h"
#include "app/server/http_server.h"
#include "app/server/model_server.h"
#include "app/server/server_mesh.h"
#include "core/opening/served_model.h"
#include "tests/app/local_server.h"
#include "tests/app/program.h"
#include "tests/app/sample_files.h"
#include "tests/core/packed/any_order.h"
#include "tests/soak.h"

#include <tan/open.h>
#include <tan/query.h>

#include <QDir>
#include <QElapsedTimer>
#include <QImage>
#include <QJsonArray>
#include <QSet>
#include <QTemporaryDir>
#include <QTest>

#include <atomic>
#include <csignal>
#include <mutex>
#include <thread>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

namespace tetra {
namespace {

using std::chrono::milliseconds;

/// A client's end of a connection.
class Client {
public:
    explicit Client(int port) : socket_(::socket(AF_INET, SOCK_STREAM, 0))
    {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_port = htons(static_cast<std::uint16_t>(port));
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        ::connect(socket_, reinterpret_cast<sockaddr*>(&address), sizeof address);
    }
    ~Client() { ::close(socket_); }
    Client(const Client&) = delete;
    Client& operator=(const Client&) = delete;

    bool send(const QByteArray& bytes) const
    {
        return ::send(socket_, bytes.data(), static_cast<std::size_t>(bytes.size()), MSG_NOSIGNAL) == bytes.size();
    }
    /// What comes until the server ends the connection; "timeout" if it does not.
    QByteArray rest(int patience = 60'000) const
    {
        QByteArray received;
        for (;;) {
            pollfd place{.fd = socket_, .events = POLLIN, .revents = 0};
            if (::poll(&place, 1, patience) <= 0)
                return "timeout";
            std::array<char, 65536> piece{};
            const ssize_t count = ::recv(socket_, piece.data(), piece.size(), 0);
            if (count <= 0)
                return received;
            received.append(piece.data(), static_cast<qsizetype>(count));
        }
    }

private:
    int socket_;
};

struct Answer {
    int status = 0; ///< 0: none
    QByteArray head, body;

    QByteArray header(const QByteArray& name) const
    {
        for (const QByteArray& line : head.split('\n'))
            if (line.toLower().startsWith(name.toLower() + ":"))
                return line.mid(name.size() + 1).trimmed();
        return {};
    }
};

Answer answerIn(const QByteArray& received)
{
    const qsizetype end = received.indexOf("\r\n\r\n");
    Answer answer;
    answer.head = received.left(end);
    answer.body = end < 0 ? QByteArray() : received.mid(end + 4);
    answer.status = received.startsWith("HTTP/1.1 ") ? received.mid(9, 3).toInt() : 0;
    return answer;
}

/// One request on a connection of its own.
Answer ask(int port, const QByteArray& target, const QByteArray& headers = {}, const QByteArray& method = "GET")
{
    const Client client(port);
    client.send(method + " " + target + " HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n" + headers + "\r\n");
    return answerIn(client.rest());
}

/// Takes all descriptors that this process may have, but for `left`, until it goes.
class FewDescriptors {
public:
    explicit FewDescriptors(int left)
    {
        ::getrlimit(RLIMIT_NOFILE, &before_);
        rlimit few = before_;
        few.rlim_cur = 100;
        ::setrlimit(RLIMIT_NOFILE, &few);
        for (int next = ::dup(STDERR_FILENO); next >= 0; next = ::dup(STDERR_FILENO))
            taken_.push_back(next);
        for (; left > 0; --left)
            give();
    }
    ~FewDescriptors()
    {
        while (!taken_.empty())
            give();
        ::setrlimit(RLIMIT_NOFILE, &before_);
    }
    FewDescriptors(const FewDescriptors&) = delete;
    FewDescriptors& operator=(const FewDescriptors&) = delete;

private:
    void give()
    {
        ::close(taken_.back());
        taken_.pop_back();
    }

    rlimit before_{};
    std::vector<int> taken_;
};

/// Of each question for a model's sizes or meshes, in the order in which they were answered, the connection.
QStringList connectionsThatAsked(const LocalServer& server)
{
    QStringList peers;
    for (const HttpRecord& record : server.records())
        if (record.request.find('?') != std::string::npos)
            peers << QString::fromStdString(record.peer);
    return peers;
}

Arguments argumentsOf(const QStringList& words)
{
    Syntax syntax;
    syntax.options = queryOptions();
    std::vector<std::string> texts;
    for (const QString& word : words)
        texts.push_back(word.toStdString());
    const auto arguments = parseArguments(syntax, texts);
    return arguments ? *arguments : Arguments();
}

} // namespace

class ServeTest : public QObject {
    Q_OBJECT

private:
    QTemporaryDir place_;
    QString folder_ = place_.filePath("models");
    QByteArray lattice_; ///< the bytes of a model

    bool build(const QString& sample, const QString& size, const QString& dataset, const QString& model)
    {
        return runTan({"sample", sample, "--size", size, "-o", dataset}, place_.path()).exitCode == 0 &&
               runTan({"build", dataset, "-o", model}, place_.path()).exitCode == 0;
    }

    OpenOptions cached() const { return {.cacheFolder = place_.filePath("cache").toStdString()}; }

private slots:
    void initTestCase()
    {
        QVERIFY(QDir(place_.path()).mkpath("models/within"));
        QVERIFY(build("c60", "20", "c60.nrrd", "models/lattice.tan"));
        QVERIFY(build("bent-duct", "9", "duct.xyz", "models/within/grid.tan"));
        QVERIFY(build("part", "6", "part.vtu", "models/part.tan"));
        QCOMPARE(runTan({"pack", "models/lattice.tan", "-o", "models/within/packed.tan"}, place_.path()).exitCode, 0);
        lattice_ = readFile(folder_ + "/lattice.tan");
        QVERIFY(lattice_.size() > 100'000);
        // What is not to be had.
        QVERIFY(writeFile(place_.filePath("secret.tan"), "SECRET"));
        QVERIFY(writeFile(folder_ + "/notes.txt", "SECRET"));
        QVERIFY(writeFile(folder_ + "/.hidden.tan", "SECRET"));
        QVERIFY(QFile::link("../secret.tan", folder_ + "/link.tan"));
        QVERIFY(QFile::link(place_.path(), folder_ + "/out"));
        QVERIFY(QDir(folder_).mkdir("folder.tan"));
        QCOMPARE(::mkfifo((folder_ + "/pipe.tan").toLocal8Bit().constData(), 0600), 0);
    }

    void modelsAreListed()
    {
        const LocalServer server(folder_);
        const Answer answer = ask(server.port, "/");
        QCOMPARE(answer.status, 200);
        QStringList files;
        for (const QJsonValue model : QJsonDocument::fromJson(answer.body)["models"].toArray()) {
            files << model["file"].toString();
            QCOMPARE(model["bytes"].toInteger(), QFileInfo(folder_ + "/" + files.back()).size());
            QVERIFY(model["sites"].toInteger() > 4 && model["tetrahedra"].toInteger() > 4);
            QCOMPARE(ask(server.port, model["url"].toString().toUtf8()).header("ETag"),
                     model["tag"].toString().toUtf8());
        }
        QCOMPARE(files, QStringList({"lattice.tan", "part.tan", "within/grid.tan", "within/packed.tan"}));
    }

    /// A server that has no descriptors left does not say that it has no models.
    void lackOfDescriptorsIsTold()
    {
        ModelServer server(*ServedFolder::open(folder_.toStdString()), {}, {});
        const auto noHeader = [](std::string_view) { return std::optional<std::string>(); };
        const auto statusOf = [&](const std::string& target) {
            return server.answer({.isHead = false, .target = target, .header = noHeader, .gone = {}}).status;
        };
        const auto statuses = [&] {
            return std::array{statusOf("/"), statusOf("/lattice.tan"), statusOf("/none.tan")};
        };
        QCOMPARE(statuses(), (std::array{200, 200, 404}));
        {
            const FewDescriptors none(0);
            QCOMPARE(statuses(), (std::array{503, 503, 503}));
        }
        {
            const FewDescriptors one(1); // enough: folders are looked into one after the other
            QCOMPARE(statuses(), (std::array{200, 200, 404}));
        }
    }

    void rangesAreTheFilesBytes_data()
    {
        QTest::addColumn<QByteArray>("range");
        QTest::addColumn<int>("status");
        QTest::addColumn<qint64>("first");
        QTest::addColumn<qint64>("count");
        const qint64 size = QFileInfo(folder_ + "/lattice.tan").size();
        QTest::newRow("the first byte") << QByteArray("bytes=0-0") << 206 << qint64(0) << qint64(1);
        QTest::newRow("a header") << QByteArray("bytes=0-16383") << 206 << qint64(0) << qint64(16384);
        QTest::newRow("in the middle") << QByteArray("bytes=1000-99999") << 206 << qint64(1000) << qint64(99000);
        QTest::newRow("to the end") << QByteArray("bytes=70000-") << 206 << qint64(70000) << size - 70000;
        QTest::newRow("beyond the end") << QByteArray("bytes=70000-999999999999") << 206 << qint64(70000)
                                        << size - 70000;
        QTest::newRow("the last ones") << QByteArray("bytes=-70001") << 206 << size - 70001 << qint64(70001);
        QTest::newRow("more than there are") << QByteArray("bytes=-999999999999") << 206 << qint64(0) << size;
        QTest::newRow("the last byte") << "bytes=" + QByteArray::number(size - 1) + "-" << 206 << size - 1 << qint64(1);
        QTest::newRow("behind the end") << "bytes=" + QByteArray::number(size) + "-" << 416 << qint64(0) << qint64(0);
        QTest::newRow("far behind") << QByteArray("bytes=99999999999999999999-") << 416 << qint64(0) << qint64(0);
        QTest::newRow("none of the last") << QByteArray("bytes=-0") << 416 << qint64(0) << qint64(0);
        for (const char* other : {"bytes=5-4", "bytes=", "bytes=-", "bytes=a-b", "bytes=0-1,5-6", "lines=0-1", "0-1",
                                  "bytes=0x1-2", "bytes=+1-2", "bytes=1--2", "bytes=1-2;"})
            QTest::addRow("not understood: %s", other) << QByteArray(other) << 200 << qint64(0) << size;
    }
    void rangesAreTheFilesBytes()
    {
        QFETCH(QByteArray, range);
        QFETCH(int, status);
        QFETCH(qint64, first);
        QFETCH(qint64, count);
        const LocalServer server(folder_);
        const QByteArray size = QByteArray::number(lattice_.size());
        const Answer answer = ask(server.port, "/lattice.tan", "Range: " + range + "\r\n");
        QCOMPARE(answer.status, status);
        QCOMPARE(answer.header("Content-Length").toLongLong(), answer.body.size());
        if (status == 416) {
            QCOMPARE(answer.header("Content-Range"), "bytes */" + size);
            return;
        }
        QVERIFY(answer.body == lattice_.mid(first, count));
        QCOMPARE(answer.header("Accept-Ranges"), "bytes");
        if (status == 206)
            QCOMPARE(answer.header("Content-Range"),
                     "bytes " + QByteArray::number(first) + "-" + QByteArray::number(first + count - 1) + "/" + size);
        const Answer head = ask(server.port, "/lattice.tan", "Range: " + range + "\r\n", "HEAD");
        QCOMPARE(head.status, status);
        QCOMPARE(head.header("Content-Length"), QByteArray::number(count));
        QVERIFY(head.body.isEmpty());
    }

    /// If-Range and If-None-Match by the file's tag, which another state of the file does not have.
    void aChangedFileIsAnother()
    {
        const LocalServer server(folder_);
        const QByteArray tag = ask(server.port, "/part.tan", {}, "HEAD").header("ETag");
        QVERIFY(tag.startsWith('"') && tag.endsWith('"'));
        const QByteArray range = "Range: bytes=0-9\r\n";
        QCOMPARE(ask(server.port, "/part.tan", range + "If-Range: " + tag + "\r\n").status, 206);
        QCOMPARE(ask(server.port, "/part.tan", range + "If-Range: \"other\"\r\n").status, 200);
        QCOMPARE(ask(server.port, "/part.tan", range + "If-Range: Thu, 26 Nov 2026 00:00:00 GMT\r\n").status, 200);
        const Answer known = ask(server.port, "/part.tan", "If-None-Match: " + tag + "\r\n");
        QCOMPARE(known.status, 304);
        QVERIFY(known.body.isEmpty());
        const Answer mesh = ask(server.port, "/part.tan?error=5");
        QCOMPARE(mesh.status, 200);
        QCOMPARE(ask(server.port, "/part.tan?error=5", "If-None-Match: " + mesh.header("ETag") + "\r\n").status, 304);
        QCOMPARE(ask(server.port, "/part.tan?error=6", "If-None-Match: " + mesh.header("ETag") + "\r\n").status, 200);

        const QByteArray part = readFile(folder_ + "/part.tan");
        QFile::remove(folder_ + "/part.tan");
        QVERIFY(writeFile(folder_ + "/part.tan", lattice_));
        QVERIFY(ask(server.port, "/part.tan", {}, "HEAD").header("ETag") != tag);
        QCOMPARE(ask(server.port, "/part.tan", range + "If-Range: " + tag + "\r\n").status, 200);
        const auto other = meshAtServer(server.address("part.tan?error=5"), "");
        const auto lattice = meshAtServer(server.address("lattice.tan?error=5"), "");
        QVERIFY(other.ok() && lattice.ok());
        QVERIFY(inAnyOrder(other->content.mesh, {}, {}) == inAnyOrder(lattice->content.mesh, {}, {}));
        QVERIFY(writeFile(folder_ + "/part.tan", part));
        QVERIFY(meshAtServer(server.address("part.tan?error=5"), "").ok());
    }

    void meshesAreThoseOfTheCommandLine_data()
    {
        QTest::addColumn<QString>("model");
        QTest::addColumn<QStringList>("options");
        const QStringList lattice[] = {
            {"--error=1"},
            {"--error=none", "--budget=20000"},
            {"--budget=2000"},
            {"--error=8", "--focus=sphere:5,5,5,4", "--focus-error=0.5"},
            {"--error=8", "--focus=box:0,0,0,6,6,6", "--focus-error=0.5", "--falloff=5", "--method=closed-set"},
            {"--field=min(sphere(9,9,9, 5; 0.5, 9, 2), isovalues(100; 2, 9, 20))"},
            {"--error=2", "--window=1.5,2,3,9,10.25,11"},
            {"--error=2", "--window=1.5,2,3,9,10.25,11", "--border=contained"},
            {"--error=2", "--window=1.5,2,3,9,10.25,11", "--border=clipped", "--values=50,250"},
            {"--error=3", "--values=100,120", "--values=180,200"},
            {"--range=8,2"},
            {"--range=8,2", "--births=2,inf", "--deaths=0,3", "--window=0,0,0,9,9,9"}};
        for (const QStringList& options : lattice)
            QTest::newRow(qPrintable("lattice " + options.join(' '))) << "lattice.tan" << options;
        QTest::newRow("of a packed model") << "within/packed.tan" << QStringList{"--error=1"};
        for (const QStringList& options :
             {QStringList{"--error=2", "--warping=1"}, QStringList{"--error=none", "--warping=1"},
              QStringList{"--error=1"},
              QStringList{"--error=5", "--focus=sphere:0,0,0,1", "--focus-error=1", "--focus-warping=1"}})
            for (const char* model : {"within/grid.tan", "part.tan"})
                QTest::newRow(qPrintable(model + QString(" ") + options.join(' '))) << QString(model) << options;
    }
    void meshesAreThoseOfTheCommandLine()
    {
        QFETCH(QString, model);
        QFETCH(QStringList, options);
        const LocalServer server(folder_);
        const Arguments arguments = argumentsOf(options);
        QVERIFY(!arguments.options.empty());
        const auto query = queryOf(arguments);
        QVERIFY2(query.ok(), query.ok() ? "" : query.error().text().c_str());
        const QString explicitModel = model == "within/packed.tan" ? "lattice.tan" : model;
        const auto opened = Model::open((folder_ + "/" + explicitModel).toStdString());
        QVERIFY(opened.ok());
        const auto here = MeshExtractor(*opened).extract(*query);
        QVERIFY2(here.ok(), here.ok() ? "" : here.error().text().c_str());
        const auto there = meshAtServer(meshAddress(server.address(model.toStdString()), arguments), "");
        QVERIFY2(there.ok(), there.ok() ? "" : there.error().text().c_str());
        QVERIFY(!there->content.mesh.tetrahedra.empty());
        const auto expected = inAnyOrder((*here)->mesh, (*here)->birthErrors, (*here)->deathErrors);
        QVERIFY(expected == inAnyOrder(there->content.mesh, there->content.birthErrors, there->content.deathErrors));

        // By a model that is left there, with all that is told of the mesh.
        const auto left = openModel(placeOf(server.address(model.toStdString()), true), cached());
        QVERIFY2(left.ok(), left.ok() ? "" : left.error().text().c_str());
        const auto asked = MeshExtractor(left->model).extract(*query);
        QVERIFY2(asked.ok(), asked.ok() ? "" : asked.error().text().c_str());
        QVERIFY(expected == inAnyOrder((*asked)->mesh, (*asked)->birthErrors, (*asked)->deathErrors));
        QCOMPARE((*asked)->wholeSites, (*here)->wholeSites);
        QCOMPARE((*asked)->wholeTetrahedra, (*here)->wholeTetrahedra);
        QCOMPARE((*asked)->keptSites, (*here)->keptSites);
        QCOMPARE((*asked)->keptTetrahedra, (*here)->keptTetrahedra);
        QCOMPARE((*asked)->scale, (*here)->scale);
        QCOMPARE((*asked)->method, (*here)->method);
        QCOMPARE((*asked)->overlaps, (*here)->overlaps);
        QCOMPARE((*asked)->sites.size(), (*asked)->mesh.positions.size());
    }

    /// R28: without the model it is known what it is of, and how large the mesh of an error is; to a few percent.
    void aModelLeftAtTheServerIsKnown()
    {
        const LocalServer server(folder_);
        for (const char* name : {"lattice.tan", "within/packed.tan", "within/grid.tan", "part.tan"}) {
            const std::string place = placeOf(server.address(name), true);
            QVERIFY(isLeftAtServer(place) && isAddress(place) && !isLeftAtServer(server.address(name)));
            QCOMPARE(placeOf(place, false), server.address(name));
            const auto left = openModel(place, cached());
            QVERIFY2(left.ok(), left.ok() ? "" : left.error().text().c_str());
            const Model& far = *left->model;
            const QString file =
                folder_ + (name == std::string("within/packed.tan") ? "/lattice.tan" : "/" + QString(name));
            const auto here = Model::open(file.toStdString());
            QVERIFY(here.ok());
            QCOMPARE(far.path().string(), place);
            QCOMPARE(far.description().sourceName, (*here)->description().sourceName);
            QCOMPARE(far.diagonal(), (*here)->diagonal());
            QCOMPARE(wholeSites(far), (*here)->siteCount());
            QCOMPARE(wholeBytes(far), std::uint64_t(QFileInfo(folder_ + "/" + name).size()));
            QVERIFY(left->isWhole);
            const Accuracy finest{.error = 0, .warping = 0};
            QCOMPARE(meshSizeAt(far, finest).tetrahedra, meshSizeAt(**here, finest).tetrahedra);
            QCOMPARE(meshSizeAt(far, {.error = anyError}).sites, meshSizeAt(**here, {.error = anyError}).sites);
            for (double error = 50; error > 0.01; error *= 0.77) {
                const MeshSize one = meshSizeAt(far, {error, error}), other = meshSizeAt(**here, {error, error});
                QVERIFY(one.error <= error && one.warping <= error);
                QVERIFY2(one.sites >= other.sites && double(one.sites) <= 1.1 * double(other.sites) + 8,
                         qPrintable(QString("%1 %2: %3 %4").arg(name).arg(error).arg(one.sites).arg(other.sites)));
                const auto within = meshSizeWithin(far, {}, other.tetrahedra);
                QVERIFY(within.ok() && within->tetrahedra <= other.tetrahedra &&
                        double(within->tetrahedra) > 0.85 * double(other.tetrahedra) - 30);
            }
            QVERIFY(!meshSizeWithin(far, {}, 1).ok());
            QCOMPARE(meshSizeOf(far, wholeSites(far)).sites, meshSizeAt(far, finest).sites);
            // An empty part is a mesh, and no refusal.
            MeshQuery nothing;
            nothing.values = {{1e9, 2e9}};
            const auto empty = MeshExtractor(left->model).extract(nothing);
            QVERIFY2(empty.ok() && (*empty)->mesh.tetrahedra.empty(), empty.ok() ? "" : empty.error().text().c_str());
        }
    }

    /// R28: whoever left the model there is told what is wrong, in a sentence each.
    void whatAServerDoesNotGiveIsTold()
    {
        const std::string token = "0123456789abcdef-token";
        std::optional<LocalServer> server(std::in_place, folder_, token);
        const std::string place = placeOf(server->address("part.tan"), true);
        OpenOptions options = cached();
        for (const char* wrong : {"", "0123456789abcdef-tokex"}) {
            options.token = wrong;
            const auto refused = openModel(place, options);
            QVERIFY(!refused.ok() && wantsToken(refused.error()));
            QVERIFY(askServer(place, wrong)->wantsToken);
        }
        options.token = token;
        const auto offer = askServer(place, token);
        QVERIFY(offer.ok() && offer->findsMeshes && !offer->wantsToken && offer->sites > 4);
        QVERIFY(askServer(server->address("within/packed.tan"), token)->form == ModelForm::Packed);
        QVERIFY(!askServer(server->address("nothing.tan"), token).ok());
        QVERIFY(!openModel(server->address("part.tan"), cached()).ok());
        QVERIFY(openModel(server->address("part.tan"), options).ok()); // fetched, with the token
        const auto left = openModel(place, options);
        QVERIFY2(left.ok(), left.ok() ? "" : left.error().text().c_str());
        MeshExtractor extractor(left->model);
        QVERIFY(extractor.extract({.error = 5}).ok());
        const auto refusal = [&](const MeshQuery& query, const Progress& progress = {}) {
            const auto mesh = extractor.extract(query, progress);
            return mesh ? std::string() : mesh.error().text();
        };
        std::vector<std::array<double, 2>> knots;
        for (int i = 0; i < 2000; ++i)
            knots.push_back({i / 3.0, i % 7 + 1.0});
        QVERIFY(refusal({.error = ValueRamp{knots}}).find("too long") != std::string::npos);
        std::stop_source stopped;
        stopped.request_stop();
        QVERIFY(extractor.extract({.error = 5}, Progress(stopped.get_token(), {})).error().kind ==
                ErrorKind::Cancelled);

        const QByteArray part = readFile(folder_ + "/part.tan");
        QFile::remove(folder_ + "/part.tan");
        QVERIFY(writeFile(folder_ + "/part.tan", part)); // another file, though of the same bytes
        QVERIFY2(refusal({.error = 5}).find("changed on its server") != std::string::npos,
                 refusal({.error = 5}).c_str());
        server.reset();
        QVERIFY2(refusal({.error = 5}).find("gives no answer") != std::string::npos, refusal({.error = 5}).c_str());
        QVERIFY(!askServer(place, token).ok());
        const LocalServer strict(folder_, {}, {}, {.tetrahedra = 10});
        const auto small = openModel(placeOf(strict.address("part.tan"), true), cached());
        QVERIFY(small.ok());
        const auto large = MeshExtractor(small->model).extract({.error = 0});
        QVERIFY(!large.ok() && large.error().text().find("more than 10 tetrahedra") != std::string::npos);
    }

    /// The same files and figures, but for the order; by the program.
    void theProgramAsksAServer()
    {
        const LocalServer server(folder_);
        const QString address = QString::fromStdString(server.address("lattice.tan"));
        const QStringList options = {"--error", "2", "--window", "1,2,3,9,10,11", "--border", "clipped", "--json"};
        const Run here =
            runTan(QStringList{"extract", "models/lattice.tan", "-o", "here.vtu"} + options, place_.path());
        const Run there =
            runTan(QStringList{"extract", address, "--at-server", "-o", "there.vtu"} + options, place_.path());
        QCOMPARE(here.exitCode, 0);
        QVERIFY2(there.exitCode == 0, there.messages);
        QJsonObject one = here.json(), other = there.json();
        for (QJsonObject* figures : {&one, &other})
            for (const char* name : {"seconds", "file"})
                figures->remove(name);
        QCOMPARE(other, one);
        QCOMPARE(readFile(place_.filePath("there.vtu")).size(), readFile(place_.filePath("here.vtu")).size());
        const Run empty =
            runTan({"extract", address, "--at-server", "--window", "90,90,90,91,91,91", "-o", "no.vtu"}, place_.path());
        QCOMPARE(empty.exitCode, 2);
        QVERIFY2(empty.messages.contains("No tetrahedron is in that window"), empty.messages);
        QCOMPARE(runTan({"extract", address + "x", "--at-server", "-o", "no.vtu"}, place_.path()).exitCode, 3);
        QCOMPARE(runTan({"extract", "models/lattice.tan", "--at-server", "-o", "no.vtu"}, place_.path()).exitCode, 2);
        QVERIFY(!QFile::exists(place_.filePath("no.vtu")));
    }

    /// Surfaces and pictures of the mesh that a server finds: those of the model.
    void surfacesAndPicturesAreMadeOfIt()
    {
        const std::string token = "0123456789abcdef-token";
        QVERIFY(writeFile(place_.filePath("token"), QByteArray::fromStdString(token) + "\n"));
        const LocalServer server(folder_, token);
        const QString address = QString::fromStdString(server.address("lattice.tan"));
        const QStringList there{address, "--at-server", "--token-file", "token"};
        const QStringList ofMesh{"--error", "2", "--focus", "sphere:9,9,9,4", "--focus-error", "0.5"};
        QJsonObject figures[2];
        QImage pictures[2];
        for (const bool isThere : {false, true}) {
            const QStringList model = isThere ? there : QStringList{"models/lattice.tan"};
            const QString name = isThere ? "there" : "here";
            const Run surface = runTan(QStringList{"isosurface"} + model + ofMesh +
                                           QStringList{"--value", "120", "-o", name + ".ply", "--json"},
                                       place_.path());
            QVERIFY2(surface.exitCode == 0, surface.messages);
            figures[isThere] = surface.json();
            figures[isThere].remove("seconds");
            figures[isThere].remove("file");
            const Run picture = runTan(QStringList{"render"} + model + ofMesh +
                                           QStringList{"--isovalue", "120", "--lens", "0.5,0.5,0.2,3,0.3", "--size",
                                                       "200x150", "-o", name + ".png"},
                                       place_.path());
            QVERIFY2(picture.exitCode == 0, picture.messages);
            pictures[isThere] = QImage(place_.filePath(name + ".png"));
        }
        QCOMPARE(figures[1], figures[0]);
        QVERIFY(figures[0]["triangles"].toInt() > 100);
        QCOMPARE(pictures[1].size(), QSize(200, 150));
        int differing = 0;
        for (int y = 0; y < 150; ++y)
            for (int x = 0; x < 200; ++x)
                differing += std::abs(qGray(pictures[0].pixel(x, y)) - qGray(pictures[1].pixel(x, y))) > 2 ? 1 : 0;
        QVERIFY2(differing < 20, qPrintable(QString::number(differing)));
        const Run refused =
            runTan({"isosurface", address, "--at-server", "--value", "120", "-o", "no.ply"}, place_.path());
        QCOMPARE(refused.exitCode, 2);
        QVERIFY2(refused.messages.contains("only those who have its token"), refused.messages);
        QVERIFY2(refused.messages.contains("--token-file"), refused.messages);
        for (const QStringList& wrong : {QStringList{"models/lattice.tan", "--at-server"},
                                         QStringList{"models/lattice.tan", "--token-file", "token"}})
            QCOMPARE(
                runTan(QStringList{"isosurface"} + wrong + QStringList{"--value", "120", "-o", "no.ply"}, place_.path())
                    .exitCode,
                2);
        QVERIFY(!QFile::exists(place_.filePath("no.ply")));
    }

    /// R28: every command that reads a model takes the token of its server.
    void eachCommandTakesAToken()
    {
        const QByteArray token = "0123456789abcdef-token";
        QVERIFY(writeFile(place_.filePath("token"), token + "\n"));
        const LocalServer server(folder_, token.toStdString());
        const QString address = QString::fromStdString(server.address("within/packed.tan"));
        const QList<QStringList> commands{{"info", address},
                                          {"info", address, "-o", "levels.csv"},
                                          {"cut", address, "--error", "5", "-o", "cut.tan"},
                                          {"unpack", address, "-o", "unpacked.tan"},
                                          {"pack", address, "-o", "again.tan"},
                                          {"extract", address, "--error", "5", "-o", "mesh.vtu"},
                                          {"extract", address, "--budget", "500", "-o", "mesh.vtu"},
                                          {"extract", address, "--error", "5", "-o", "mesh.vtu", "--at-server"},
                                          {"render", address, "--error", "5", "--size", "40x30", "-o", "token.png"}};
        for (const QStringList& command : commands) {
            const Run without = runTan(command, place_.path());
            QVERIFY2(without.exitCode != 0 && without.messages.contains("only those who have its token") &&
                         without.messages.contains("--token-file"),
                     without.messages);
            const Run with = runTan(command + QStringList{"--token-file", "token"}, place_.path());
            QVERIFY2(with.exitCode == 0, with.messages);
        }
        const Run idle = runTan({"info", "models/lattice.tan", "--token-file", "token"}, place_.path());
        QVERIFY2(idle.exitCode == 2 && idle.messages.contains("models on a server"), idle.messages);
    }

    /// Names of hosts have no capitals that count.
    void thisMachineMayBeWrittenInCapitals()
    {
        const LocalServer server(folder_);
        const Client client(server.port);
        client.send("GET /lattice.tan HTTP/1.1\r\nHost: LocalHost:8080\r\nConnection: close\r\n\r\n");
        QCOMPARE(answerIn(client.rest()).status, 200);
    }

    void badQueriesAreRefused()
    {
        const LocalServer server(folder_);
        for (const char* query : {"eror=1",
                                  "error=x",
                                  "error=1&error=2",
                                  "error=-1",
                                  "budget=0",
                                  "field=box(",
                                  "error=%",
                                  "error=1%00",
                                  "window=1,2",
                                  "output=/tmp/x",
                                  "o=x",
                                  "warping=1",
                                  "help",
                                  "json=1",
                                  "range=4,1&error=2",
                                  "values=2,1",
                                  "border=clipped",
                                  "=",
                                  "&&=&",
                                  "error=nan"}) {
            const Answer answer = ask(server.port, "/lattice.tan?" + QByteArray(query));
            QVERIFY2(answer.status == 400, query);
            QVERIFY2(!QJsonDocument::fromJson(answer.body)["error"].toString().isEmpty(), answer.body);
        }
    }

    /// Fifty ways to what is not to be had, and heads that are none.
    void attacksAreRefused()
    {
        const LocalServer server(folder_);
        QList<QByteArray> requests;
        for (const QByteArray& path : QList<QByteArray>{"/../secret.tan",
                                                        "/..%2fsecret.tan",
                                                        "/%2e%2e/secret.tan",
                                                        "/%2e%2e%2fsecret.tan",
                                                        "/%252e%252e/secret.tan",
                                                        "/..%252fsecret.tan",
                                                        "/.%2e/secret.tan",
                                                        "/within/../../secret.tan",
                                                        "/within/..%2f..%2fsecret.tan",
                                                        "/..\\secret.tan",
                                                        "/..%5csecret.tan",
                                                        "/%2e%2e%5csecret.tan",
                                                        "//secret.tan",
                                                        "///etc/passwd",
                                                        "/etc/passwd",
                                                        "/%2fetc%2fpasswd",
                                                        place_.filePath("secret.tan").toUtf8(),
                                                        "/" + place_.filePath("secret.tan").toUtf8(),
                                                        "/link.tan",
                                                        "/out/secret.tan",
                                                        "/.hidden.tan",
                                                        "/%2ehidden.tan",
                                                        "/notes.txt",
                                                        "/notes.txt%00.tan",
                                                        "/lattice.tan%00",
                                                        "/lattice.tan%00.txt",
                                                        "/lattice.tan/",
                                                        "/lattice.tan/.",
                                                        "/within/../lattice.tan",
                                                        "/./lattice.tan",
                                                        "/lattice.tan%0d%0aX:%20y",
                                                        "/folder.tan",
                                                        "/folder.tan/",
                                                        "/pipe.tan",
                                                        "/proc/self/environ",
                                                        "/%c0%ae%c0%ae/secret.tan",
                                                        "/%uff0e%uff0e/secret.tan",
                                                        "/....//secret.tan",
                                                        "/..;/secret.tan",
                                                        "/%",
                                                        "/%2",
                                                        "/%zz.tan",
                                                        "/%00",
                                                        "/lattice.TAN",
                                                        "/lattice.tan.",
                                                        "/lattice.tan%20",
                                                        "/~/secret.tan",
                                                        "/out/../secret.tan",
                                                        "/models/lattice.tan",
                                                        "/link.tan?error=1",
                                                        "/..%2fsecret.tan?error=1",
                                                        "/" + QByteArray(4000, 'a') + ".tan",
                                                        "/" + QByteArray("a/").repeated(2000) + "x.tan"})
            requests << "GET " + path + " HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n";
        const QByteArray get = "GET /lattice.tan HTTP/1.1\r\n", host = "Host: localhost\r\n";
        requests << "GET http://localhost/lattice.tan HTTP/1.1\r\n" + host + "\r\n"
                 << "GET * HTTP/1.1\r\n" + host + "\r\n"
                 << "GET lattice.tan HTTP/1.1\r\n" + host + "\r\n"
                 << "GET  /lattice.tan HTTP/1.1\r\n" + host + "\r\n"
                 << "GET /lattice.tan\r\n\r\n"
                 << "GET /lattice.tan HTTP/1.1 x\r\n" + host + "\r\n"
                 << "GET /lattice.tan HTTP/2.0\r\n" + host + "\r\n"
                 << "GET /lattice.tan HTTP/1.9\r\n" + host + "\r\n"
                 << "PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n"
                 << "GET /lattice.tan#x HTTP/1.1\r\n" + host + "\r\n"
                 << "GET /latt\x01ice.tan HTTP/1.1\r\n" + host + "\r\n"
                 << QByteArray("GET /lattice.tan\0 HTTP/1.1\r\nHost: localhost\r\n\r\n", 49)
                 << "GET /latt\xc3\xa4.tan HTTP/1.1\r\n" + host + "\r\n"
                 << "\r\n\r\n"
                 << get + "\r\n"
                 << get + host + host + "\r\n"
                 << get + "Host : localhost\r\n\r\n"
                 << get + host + " folded: x\r\n\r\n"
                 << get + host + "no colon\r\n\r\n"
                 << get + host + "X: a\nRange: bytes=0-1\r\n\r\n"
                 << get + host + QByteArray("X: a\0b\r\n\r\n", 11) << get + host + ": x\r\n\r\n"
                 << get + host + "Range: bytes=0-1\r\nRange: bytes=5-6\r\n\r\n"
                 << get + host + "Transfer-Encoding: chunked\r\n\r\n5\r\nGET /\r\n0\r\n\r\n"
                 << get + host + "Content-Length: 5\r\n\r\nGET /" << get + host + "Content-Length: -1\r\n\r\n"
                 << get + host + "Content-Length: 0\r\nContent-Length: 5\r\n\r\n"
                 << get + "Host: evil.example\r\nConnection: close\r\n\r\n"
                 << get + "Host: localhost.evil.example\r\nConnection: close\r\n\r\n"
                 << get + "Host: 127.0.0.1.evil.example:80\r\nConnection: close\r\n\r\n";
        for (const char* method : {"POST", "PUT", "DELETE", "OPTIONS", "TRACE", "CONNECT", "PATCH", "get", "BREW"})
            requests << method + QByteArray(" /lattice.tan HTTP/1.1\r\n") + host + "\r\n";
        QVERIFY(requests.size() >= 50);
        for (const QByteArray& request : requests) {
            const Client client(server.port);
            client.send(request);
            const QByteArray received = client.rest();
            const Answer answer = answerIn(received);
            QVERIFY2(answer.status >= 400 && answer.status <= 505 && answer.status != 500,
                     request.left(100) + " -> " + received.left(100));
            QVERIFY2(!received.contains("SECRET") && !received.contains("TAN\r\n\x1a"), request.left(100));
        }
        QCOMPARE(ask(server.port, "/lattice.tan").status, 200);
    }

    void onlyWhoHasTheTokenIsAnswered()
    {
        const std::string token = "0123456789abcdef-token";
        const LocalServer server(folder_, token);
        for (const char* given :
             {"", "Authorization: Bearer 0123456789abcdef-tokex\r\n", "Authorization: Bearer \r\n",
              "Authorization: Bearer 0123456789abcdef\r\n", "Authorization: Basic 0123456789abcdef-token\r\n",
              "Authorization: Bearer 0123456789abcdef-token0123456789abcdef-token\r\n",
              "Authorization: 0123456789abcdef-token\r\n"})
            for (const char* target : {"/", "/lattice.tan", "/lattice.tan?error=1", "/nothing"}) {
                const Answer answer = ask(server.port, target, given);
                QVERIFY2(answer.status == 401 && answer.header("WWW-Authenticate") == "Bearer", given);
            }
        QCOMPARE(ask(server.port, "/lattice.tan?error=1&token=0123456789abcdef-token").status, 401);
        const QByteArray right = "Authorization: Bearer 0123456789abcdef-token\r\n";
        QCOMPARE(ask(server.port, "/", right).status, 200);
        QVERIFY(meshAtServer(server.address("lattice.tan?error=5"), token).ok());
        QVERIFY(!meshAtServer(server.address("lattice.tan?error=5"), "0123456789abcdef-tokex").ok());
        for (const HttpRecord& record : server.records())
            QVERIFY(record.request.find("0123456789abcdef-tokex") == std::string::npos &&
                    record.note.find(token) == std::string::npos && record.peer.find(token) == std::string::npos);
    }

    void tooMuchIsRefused()
    {
        const LocalServer server(folder_);
        const QByteArray start = "GET / HTTP/1.1\r\nHost: localhost\r\n";
        const auto statusOf = [&](const QByteArray& request) {
            const Client client(server.port);
            client.send(request);
            return answerIn(client.rest()).status;
        };
        QCOMPARE(statusOf(start + "X: " + QByteArray(20'000, 'x') + "\r\n\r\n"), 431);
        QCOMPARE(statusOf(start + "X: " + QByteArray(200'000, 'x')), 431);
        QCOMPARE(statusOf("GET /" + QByteArray(10'000, 'x') + " HTTP/1.1\r\nHost: localhost\r\n\r\n"), 414);
        QByteArray many = start;
        for (int i = 0; i < 100; ++i)
            many += "X" + QByteArray::number(i) + ": x\r\n";
        QCOMPARE(statusOf(many + "\r\n"), 431);
        QCOMPARE(statusOf(start + "Content-Length: 100000000\r\n\r\n"), 413);

        const LocalServer small(folder_, {}, {}, {.tetrahedra = 1000});
        QCOMPARE(ask(small.port, "/lattice.tan?error=0").status, 413);
        QCOMPARE(ask(small.port, "/lattice.tan?range=9,0").status, 413);
        QCOMPARE(ask(small.port, "/lattice.tan?budget=2000").status, 413);
        QCOMPARE(ask(small.port, "/lattice.tan?error=9&focus=sphere:9,9,9,9&focus-error=0").status, 413);
        QCOMPARE(ask(small.port, "/lattice.tan?budget=1000").status, 200);
        const LocalServer hasty(folder_, {}, {}, {.time = milliseconds(0)});
        QCOMPARE(ask(hasty.port, "/lattice.tan?error=0").status, 504);
        const LocalServer busy(folder_, {}, {}, {.waiting = milliseconds(200), .meshes = 0});
        const Answer later = ask(busy.port, "/lattice.tan?error=0");
        QCOMPARE(later.status, 503);
        QVERIFY(later.header("Retry-After").toInt() > 0);
    }

    /// Who dawdles, at asking or at reading, does not keep the server.
    void slowClientsAreLeft()
    {
        QFile large(folder_ + "/large.tan");
        QVERIFY(large.open(QIODevice::WriteOnly) && large.resize(64 << 20));
        large.close();
        const LocalServer server(
            folder_, {},
            {.headTime = milliseconds(1200), .idleTime = milliseconds(2000), .sendTime = milliseconds(1200)});
        QElapsedTimer time;
        time.start();
        const Client silent(server.port), half(server.port), dripping(server.port), deaf(server.port);
        half.send("GET / HTTP/1.1\r\nHost: loc");
        deaf.send("GET /large.tan HTTP/1.1\r\nHost: localhost\r\n\r\n");
        while (time.elapsed() < 4500 && dripping.send("G"))
            QTest::qSleep(50);
        QVERIFY(server.waitForRecords(3));
        QVERIFY2(time.elapsed() < soon(5000), qPrintable(QString::number(time.elapsed())));
        QCOMPARE(answerIn(half.rest()).status, 408);
        QCOMPARE(silent.rest(), QByteArray()); // it never asked
        int unfinished = 0, late = 0;
        for (const HttpRecord& record : server.records()) {
            unfinished += record.note == "unfinished" ? 1 : 0;
            late += record.status == 408 ? 1 : 0;
        }
        QCOMPARE(unfinished, 1);
        QCOMPARE(late, 2);
        QVERIFY(QFile::remove(folder_ + "/large.tan"));
    }

    void moreConnectionsThanThereMayBeAreToldSo()
    {
        const LocalServer server(folder_, {}, {.connections = 3});
        const Client one(server.port), two(server.port), three(server.port);
        QVERIFY(waitFor([&] { return ask(server.port, "/").status == 503; }));
        QVERIFY(ask(server.port, "/").header("Retry-After").toInt() > 0);
    }

    /// Work for a client that has gone ends.
    void nobodyWaitsForAMesh()
    {
        const LocalServer server(folder_, {}, {}, {.waiting = milliseconds(600'000), .meshes = 0});
        QElapsedTimer time;
        time.start();
        {
            const Client client(server.port);
            client.send("GET /lattice.tan?error=1 HTTP/1.1\r\nHost: localhost\r\n\r\n");
            QTest::qSleep(200);
            QCOMPARE(server.records().size(), std::size_t(0));
        }
        QVERIFY(server.waitForRecords(1));
        QVERIFY2(time.elapsed() < soon(5000), qPrintable(QString::number(time.elapsed())));
    }

    /// Several requests on one connection, some sent before the last was answered.
    void connectionsStayOpen()
    {
        const LocalServer server(folder_);
        const Client client(server.port);
        const QByteArray get = "GET /lattice.tan HTTP/1.1\r\nHost: localhost\r\nRange: bytes=0-9\r\n";
        client.send(get + "\r\n" + get + "\r\n" + get + "Connection: close\r\n\r\n");
        const QByteArray received = client.rest();
        QCOMPARE(received.count("HTTP/1.1 206"), 3);
        QCOMPARE(received.count(lattice_.left(10)), 3);
    }

    /// R28: all that is asked of a model that stays at its server goes over one connection, until the server ends it;
    /// then over the next one.
    void questionsShareAConnection()
    {
        for (const bool isKept : {true, false}) {
            const LocalServer server(folder_, {}, {.keptTime = milliseconds(isKept ? 60'000 : 1)});
            const auto left = openModel(placeOf(server.address("lattice.tan"), true), cached());
            QVERIFY2(left.ok(), left.ok() ? "" : left.error().text().c_str());
            MeshExtractor extractor(left->model);
            for (const double error : {1.0, 0.5, 0.0}) {
                QTest::qSleep(isKept ? 0 : 50);
                const auto mesh = extractor.extract({.error = error});
                QVERIFY2(mesh.ok(), mesh.ok() ? "" : mesh.error().text().c_str());
            }
            QVERIFY(waitFor([&] { return connectionsThatAsked(server).size() == 4; }));
            const QStringList asked = connectionsThatAsked(server);
            QCOMPARE(QSet<QString>(asked.begin(), asked.end()).size(), isKept ? 1 : 4);
        }
    }

    /// Who asks now and then does not keep others out: the one that has been idle for longest gives way.
    void idleConnectionsGiveWay()
    {
        const LocalServer server(folder_, {}, {.connections = 2});
        const QByteArray get = "GET /lattice.tan HTTP/1.1\r\nHost: localhost\r\nRange: bytes=0-9\r\n";
        const Client first(server.port), second(server.port);
        first.send(get + "\r\n");
        QVERIFY(server.waitForRecords(1));
        second.send(get + "\r\n");
        QVERIFY(server.waitForRecords(2));
        QVERIFY(waitFor([&] { return ask(server.port, "/").status == 200; }));
        QCOMPARE(answerIn(first.rest()).status, 206); // and then its end
        second.send(get + "Connection: close\r\n\r\n");
        QCOMPARE(second.rest().count("HTTP/1.1 206"), 2);
        // Who has begun to ask is not idle.
        const Client half(server.port), other(server.port);
        half.send(get);
        other.send("GET");
        QVERIFY(waitFor([&] { return ask(server.port, "/").status == 503; }));
        half.send("Connection: close\r\n\r\n");
        QCOMPARE(answerIn(half.rest()).status, 206);
    }

    /// 16 at once, as in the benchmark (tests/bench/serve_load.py: 10,000 requests): each gets what is its own.
    void manyAtOnce()
    {
        const LocalServer server(folder_);
        const QByteArray mesh = ask(server.port, "/lattice.tan?error=5").body, list = ask(server.port, "/").body;
        QVERIFY(mesh.size() > 100);
        std::atomic<int> wrong = 0;
        {
            std::vector<std::jthread> clients;
            for (int client = 0; client < 16; ++client)
                clients.emplace_back([&, client] {
                    for (int i = 0; i < 25; ++i) {
                        const int first = (client * 25 + i) * 100;
                        const Answer answer = i % 3 == 0   ? ask(server.port, "/lattice.tan?error=5")
                                              : i % 3 == 1 ? ask(server.port, "/lattice.tan",
                                                                 "Range: bytes=" + QByteArray::number(first) + "-" +
                                                                     QByteArray::number(first + 999) + "\r\n")
                                                           : ask(server.port, "/");
                        const QByteArray& expected = i % 3 == 0 ? mesh : i % 3 == 1 ? lattice_.mid(first, 1000) : list;
                        wrong += answer.body == expected ? 0 : 1;
                    }
                });
        }
        QCOMPARE(wrong.load(), 0);
        QVERIFY(server.waitForRecords(402));
    }

    /// Within a second, whatever goes on.
    void theProgramStopsCleanly_data()
    {
        QTest::addColumn<int>("signal");
        QTest::newRow("Ctrl+C") << SIGINT;
        QTest::newRow("kill") << SIGTERM;
    }
    void theProgramStopsCleanly()
    {
        QFETCH(int, signal);
        QProcess process;
        process.setWorkingDirectory(place_.path());
        process.start(tanProgram(), {"serve", "models", "--port", "0", "--json"});
        process.setReadChannel(QProcess::StandardError);
        while (!process.canReadLine())
            QVERIFY(process.waitForReadyRead(60'000));
        const QByteArray line = process.readLine();
        const int port = line.mid(line.lastIndexOf(':') + 1).split('/')[0].toInt();
        QVERIFY2(port > 0, line);
        QCOMPARE(ask(port, "/lattice.tan?error=5").status, 200);
        const Client idle(port), asking(port), reading(port), kept(port);
        kept.send("GET / HTTP/1.1\r\nHost: localhost\r\n\r\n");
        asking.send("GET / HT");
        reading.send("GET /lattice.tan HTTP/1.1\r\nHost: localhost\r\n\r\n");
        QTest::qSleep(100);
        QElapsedTimer time;
        time.start();
        ::kill(static_cast<pid_t>(process.processId()), signal);
        QVERIFY(process.waitForFinished(60'000));
        QVERIFY2(time.elapsed() < soon(3000), qPrintable(QString::number(time.elapsed())));
        const Run run = collect(process);
        QCOMPARE(run.exitCode, 0);
        QVERIFY(run.json()["requests"].toInt() >= 2);
        QVERIFY2(run.messages.contains("\"GET /lattice.tan?error=5\" 200"), run.messages);
    }

    /// Memory that meshes took goes back, whichever threads found them. (tests/bench/serve_load.py: at random, for
    /// hours.)
    void theProgramsMemoryIsSteady()
    {
        QProcess process;
        process.setWorkingDirectory(place_.path());
        process.start(tanProgram(), {"serve", "models", "--port", "0"});
        process.setReadChannel(QProcess::StandardError);
        while (!process.canReadLine())
            QVERIFY(process.waitForReadyRead(60'000));
        const QByteArray line = process.readLine();
        const int port = line.mid(line.lastIndexOf(':') + 1).split('/')[0].toInt();
        // Each has a connection of its own, and so another thread of the server.
        const auto keptAfter = [&](int meshes) {
            for (int i = 0; i < meshes; ++i)
                if (ask(port, "/lattice.tan?error=" + QByteArray::number(i % 2)).status != 200)
                    return -1.0;
            QTest::qSleep(100); // the last one is put away
            const QByteArray pages = readFile("/proc/" + QString::number(process.processId()) + "/smaps_rollup");
            const qsizetype at = pages.indexOf("Anonymous:");
            return at < 0 ? -1.0 : pages.mid(at + 10).trimmed().split(' ')[0].toDouble() / 1024;
        };
        const double first = keptAfter(4), later = keptAfter(40);
        ::kill(static_cast<pid_t>(process.processId()), SIGTERM);
        QVERIFY(process.waitForFinished(60'000));
        QVERIFY(first > 0);
        constexpr double mostOfAThread = 0.1;
        QVERIFY2(later > 0 && later < first + 36 * mostOfAThread,
                 qPrintable(QString("%1 MB, then %2").arg(first).arg(later)));
    }

    /// Where the system gives fewer threads than there may be connections, it serves with those, or says why not.
    void fewThreadsAreEnough()
    {
        int served = 0;
        for (const rlim_t megabytes : {200, 300, 400}) {
            QProcess process;
            process.setWorkingDirectory(place_.path());
            process.setChildProcessModifier([megabytes] {
                const rlimit limit{megabytes << 20, megabytes << 20};
                ::setrlimit(RLIMIT_AS, &limit);
            });
            process.start(tanProgram(), {"serve", "models", "--port", "0"});
            process.setReadChannel(QProcess::StandardError);
            while (process.state() != QProcess::NotRunning && !process.canReadLine())
                process.waitForReadyRead(1000);
            const QByteArray line = process.readLine();
            if (process.state() != QProcess::NotRunning && line.startsWith("Serving")) {
                QTest::qSleep(100);
                const Answer answer = ask(line.mid(line.lastIndexOf(':') + 1).split('/')[0].toInt(), "/lattice.tan",
                                          "Range: bytes=0-9\r\n");
                served += answer.status == 206 ? 1 : 0;
                ::kill(static_cast<pid_t>(process.processId()), SIGTERM);
            }
            QVERIFY(process.waitForFinished(60'000));
            QCOMPARE(process.exitStatus(), QProcess::NormalExit);
            QVERIFY2(process.exitCode() == 0 || process.exitCode() == 4 || process.exitCode() == 127,
                     line + process.readAllStandardError());
        }
        QVERIFY(served > 0);
    }

    void wrongUseIsRefused()
    {
        QVERIFY(writeFile(place_.filePath("short"), "tooshort\n"));
        QVERIFY(writeFile(place_.filePath("token"), "0123456789abcdef-token\n"));
        for (const QStringList& options :
             {QStringList{"models", "--address", "0.0.0.0"}, QStringList{"models", "--address", "127.evil.example"},
              QStringList{"models", "--token-file", "short"}, QStringList{"models", "--token-file", "nothing"},
              QStringList{"models", "--port", "70000"}, QStringList{"models", "--limit", "0"},
              QStringList{"models", "--address", "192.0.2.1", "--token-file", "token"}}) {
            const Run run = runTan(QStringList{"serve"} + options, place_.path());
            QVERIFY2(run.exitCode == 2, qPrintable(options.join(' ') + "\n" + run.messages));
        }
        QCOMPARE(runTan({"serve", "nothing"}, place_.path()).exitCode, 3);
        const LocalServer taken(folder_);
        const Run run = runTan({"serve", "models", "--port", QString::number(taken.port)}, place_.path());
        QCOMPARE(run.exitCode, 2);
        QVERIFY2(run.messages.contains("Address already in use"), run.messages);
    }
};

} // namespace tetra

QTEST_GUILESS_MAIN(tetra::ServeTest)
#include "serve_test.moc"
