// SPDX-License-Identifier: GPL-3.0-or-later
// A server that gives files, ranges of them and meshes that it finds, to those who may have them and to nobody else
// (R28, C16; the paper's 5.1).
#include "app/command_line/arguments.h"
#include "app/command_line/query_options.h"
#include "app/command_line/server_mesh.h"
#include "core/opening/served_model.h"
#include "core/packed/packed_mesh.h"
#include "core/serve/http_server.h"
#include "core/serve/model_server.h"
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

#include <array>
#include <atomic>
#include <csignal>
#include <deque>
#include <future>
#include <mutex>
#include <thread>

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

using namespace tetra;

namespace {

using std::chrono::milliseconds;

/// A client's end of a connection.
class Client {
public:
    /// `from`: its own address, any of 127.0.0.0/8.
    explicit Client(int port, const char* from = "127.0.0.1") : socket_(::socket(AF_INET, SOCK_STREAM, 0))
    {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        ::inet_pton(AF_INET, from, &address.sin_addr);
        ::bind(socket_, reinterpret_cast<sockaddr*>(&address), sizeof address);
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
    /// Waits until something has come; false if nothing does.
    bool isAnswered() const
    {
        pollfd place{.fd = socket_, .events = POLLIN, .revents = 0};
        return ::poll(&place, 1, patiently(5000)) > 0;
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

/// How many connections to a port of this machine their server has not ended.
int connectionsTo(int port)
{
    const QByteArray local = "0100007F:" + QByteArray::number(port, 16).toUpper().rightJustified(4, '0');
    int count = 0;
    for (const QByteArray& line : readFile("/proc/net/tcp").split('\n')) {
        const QByteArrayList fields = line.simplified().split(' ');
        count += fields.size() > 3 && fields[1] == local && fields[3] == "01" ? 1 : 0; // TCP_ESTABLISHED
    }
    return count;
}

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

/// The mesh that the query of a URL asks for.
Result<ServerMesh> meshOf(const LocalServer& server, const std::string& model, const std::string& query,
                          const std::string& token = {})
{
    return meshAtServer(server.address(model), *QueryWords::fromUrl(query), token);
}

/// Requests that are held until they are let go.
class Gate {
public:
    /// For LocalServer: each request waits.
    LocalServer::Before before()
    {
        return [this](const ServedRequest&) {
            ++waiting_;
            opened_.wait();
        };
    }
    bool isWaitedForBy(int count) const
    {
        return waitFor([&] { return waiting_ == count; });
    }
    void open()
    {
        if (!isOpen_)
            open_.set_value();
        isOpen_ = true;
    }

private:
    std::promise<void> open_;
    std::shared_future<void> opened_ = open_.get_future().share();
    std::atomic<int> waiting_ = 0;
    bool isOpen_ = false;
};

/// A running `tan serve`, and what it says.
class ServeProgram {
public:
    ServeProgram(const QString& place, const QStringList& options = {}, std::function<void()> inChild = {})
    {
        process.setWorkingDirectory(place);
        if (inChild)
            process.setChildProcessModifier(std::move(inChild));
        process.start(tanProgram(), QStringList{"serve", "models", "--port", "0"} + options);
        process.setReadChannel(QProcess::StandardError);
    }
    ~ServeProgram()
    {
        if (process.state() != QProcess::NotRunning)
            process.kill();
        process.waitForFinished(patiently(20'000));
    }
    ServeProgram(const ServeProgram&) = delete;
    ServeProgram& operator=(const ServeProgram&) = delete;

    /// 0 if it does not serve.
    int port()
    {
        while (process.state() != QProcess::NotRunning && !process.canReadLine())
            process.waitForReadyRead(1000);
        return portIn(process.readLine());
    }
    /// Waits until so many more requests stand in its log.
    bool waitForRequests(int count)
    {
        while (count > 0) {
            while (process.state() != QProcess::NotRunning && !process.canReadLine())
                if (!process.waitForReadyRead(patiently(5000)))
                    return false;
            if (!process.canReadLine())
                return false;
            count -= process.readLine().contains("\"GET ") ? 1 : 0;
        }
        return true;
    }
    static int portIn(const QByteArray& line)
    {
        return line.startsWith("Serving") ? line.mid(line.lastIndexOf(':') + 1).split('/')[0].toInt() : 0;
    }
    void signal(int number) { ::kill(static_cast<pid_t>(process.processId()), number); }

    QProcess process;
};

} // namespace

class ServeTest : public QObject {
    Q_OBJECT

private:
    QTemporaryDir place_;
    QString folder_ = place_.filePath("models");
    QByteArray lattice_; ///< the bytes of a model

    bool build(const QString& sample, const QString& size, const QString& dataset, const QString& model)
    {
        const QStringList options = sample == "bent-duct" ? QStringList{"--error-in", "grid"} : QStringList();
        return runTan({"sample", sample, "--size", size, "-o", dataset}, place_.path()).exitCode == 0 &&
               runTan(QStringList{"build", dataset, "-o", model} + options, place_.path()).exitCode == 0;
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
            return server.answer({.method = HttpMethod::Get, .target = target, .header = noHeader, .gone = {}}).status;
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

        // The same bytes in the same place, and the time of modification set back: only the system's time tells.
        const QByteArray part = readFile(folder_ + "/part.tan");
        struct stat before {};
        const QByteArray place = QFile::encodeName(folder_ + "/part.tan");
        QCOMPARE(::stat(place.constData(), &before), 0);
        const auto isAnother = [&] {
            const std::array times = {before.st_atim, before.st_mtim};
            return ::utimensat(AT_FDCWD, place.constData(), times.data(), 0) == 0 &&
                   ask(server.port, "/part.tan", {}, "HEAD").header("ETag") != tag;
        };
        QTRY_VERIFY(isAnother());
        const QByteArray touched = ask(server.port, "/part.tan", {}, "HEAD").header("ETag");
        QFile::remove(folder_ + "/part.tan");
        QVERIFY(writeFile(folder_ + "/part.tan", lattice_));
        QVERIFY(ask(server.port, "/part.tan", {}, "HEAD").header("ETag") != touched);
        QCOMPARE(ask(server.port, "/part.tan", range + "If-Range: " + tag + "\r\n").status, 200);
        const auto other = meshOf(server, "part.tan", "error=5");
        const auto lattice = meshOf(server, "lattice.tan", "error=5");
        QVERIFY(other.ok() && lattice.ok());
        QVERIFY(inAnyOrder(other->content.mesh, {}, {}) == inAnyOrder(lattice->content.mesh, {}, {}));
        QVERIFY(writeFile(folder_ + "/part.tan", part));
        QVERIFY(meshOf(server, "part.tan", "error=5").ok());
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
        const auto there = meshAtServer(server.address(model.toStdString()), queryWords(arguments), "");
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
        QVERIFY2(refusal({.error = 5}).find("does not answer") != std::string::npos, refusal({.error = 5}).c_str());
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
        QVERIFY2(empty.messages.contains("No tetrahedron is in that crop box"), empty.messages);
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
        QJsonObject figures[2], shape[2];
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
            // Sums over the triangles, which come in another order.
            QJsonArray shapes = figures[isThere].take("surfaces").toArray();
            QCOMPARE(shapes.size(), 1);
            shape[isThere] = shapes[0].toObject();
            const Run picture = runTan(QStringList{"render"} + model + ofMesh +
                                           QStringList{"--isovalue", "120", "--lens", "0.5,0.5,0.2,3,0.3", "--size",
                                                       "200x150", "-o", name + ".png"},
                                       place_.path());
            QVERIFY2(picture.exitCode == 0, picture.messages);
            pictures[isThere] = QImage(place_.filePath(name + ".png"));
        }
        QCOMPARE(figures[1], figures[0]);
        for (const char* const sum : {"area", "volume"}) {
            const double local = shape[0].take(sum).toDouble(), remote = shape[1].take(sum).toDouble();
            QVERIFY2(local > 1000 && std::abs(remote - local) < 1e-12 * local, sum);
        }
        QCOMPARE(shape[1], shape[0]);
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
        QVERIFY2(refused.messages.contains("a token"), refused.messages);
        QVERIFY2(refused.messages.contains("--token-file"), refused.messages);
        for (const QStringList& wrong : {QStringList{"models/lattice.tan", "--at-server"},
                                         QStringList{"models/lattice.tan", "--token-file", "token"}})
            QCOMPARE(
                runTan(QStringList{"isosurface"} + wrong + QStringList{"--value", "120", "-o", "no.ply"}, place_.path())
                    .exitCode,
                2);
        QVERIFY(!QFile::exists(place_.filePath("no.ply")));
    }

    /// Which surface it shows follows from a coarse mesh. Without that there is no picture, rather than another one.
    void noPictureIsGuessed()
    {
        ModelServer models(*ServedFolder::open(folder_.toStdString()), {}, {});
        HttpServer server({},
                          {.takesLong = ModelServer::takesLong,
                           .answer =
                               [&](const ServedRequest& request) {
                                   return request.target.find("budget=") == std::string::npos
                                              ? models.answer(request)
                                              : textAnswer(500, "application/json", "{\"error\": \"Out of order.\"}");
                               }},
                          [](const HttpRecord&) {});
        const auto port = server.bind("127.0.0.1", 0);
        QVERIFY(port.ok());
        const std::jthread thread([&](const std::stop_token& stop) { (void)server.run(Progress(stop, {})); });
        const QString address = "http://127.0.0.1:" + QString::number(*port) + "/lattice.tan";
        const Run run = runTan(
            {"render", address, "--at-server", "--error", "8", "--size", "64x48", "-o", "guessed.png"}, place_.path());
        QCOMPARE(run.exitCode, 3);
        QVERIFY2(run.messages.contains("Out of order."), run.messages);
        QVERIFY(!QFile::exists(place_.filePath("guessed.png")));
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
            QVERIFY2(without.exitCode != 0 && without.messages.contains("a token") &&
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
                                  "error=nan",
                                  "warping-field=1",
                                  "empty=maybe"}) {
            const Answer answer = ask(server.port, "/lattice.tan?" + QByteArray(query));
            QVERIFY2(answer.status == 400, query);
            const QString said = QJsonDocument::fromJson(answer.body)["error"].toString();
            QVERIFY2(!said.isEmpty() && !said.contains("--") && !said.contains(place_.path()), answer.body);
        }
    }

    /// What is no model, or cannot be unpacked here, is told as that, and never where it lies.
    void whatIsWrongWithAFileIsTold()
    {
        QVERIFY(writeFile(folder_ + "/no-model.tan", QByteArray(50'000, 'x')));
        {
            const LocalServer server(folder_);
            for (const char* query : {"error=1", "about", "sizes"}) {
                const Answer answer = ask(server.port, "/no-model.tan?" + QByteArray(query));
                QVERIFY2(answer.status == 422 && answer.body.contains("'no-model.tan' cannot be opened as a model"),
                         answer.body);
            }
        }
        QVERIFY(QFile::remove(folder_ + "/no-model.tan"));

        ServeProgram server(place_.path(), {}, [] {
            ::setenv("XDG_CACHE_HOME", "full-cache", 1); // relative, so that it lies nowhere; then HOME counts
            ::setenv("HOME", "/tmp", 1);
            const rlimit small{10'000, 10'000}; // as a full disk
            ::setrlimit(RLIMIT_FSIZE, &small);
        });
        const int port = server.port();
        QVERIFY(port > 0);
        for (const char* query : {"error=0", "sizes"}) {
            const Answer answer = ask(port, "/within/packed.tan?" + QByteArray(query));
            QVERIFY2(answer.status == 507 && answer.body.contains("cache folder"), answer.body);
            QVERIFY2(!answer.body.contains(place_.path().toUtf8()), answer.body);
        }
        QCOMPARE(ask(port, "/within/packed.tan", "Range: bytes=0-9\r\n").status, 206);
    }

    /// Pages of an origin may read answers if it was named, also refusals; a browser asks before it sends a token.
    void pagesOfNamedOriginsMayRead()
    {
        const QByteArray known = "Origin: https://viewer.example\r\n", other = "Origin: https://evil.example\r\n";
        const QByteArray right = "Authorization: Bearer 0123456789abcdef-token\r\n";
        const QByteArray preflight = "Access-Control-Request-Method: GET\r\nAccess-Control-Request-Headers: "
                                     "authorization,range\r\n";
        const QByteArray allowed = "Access-Control-Allow-Origin";
        const LocalServer server(folder_, "0123456789abcdef-token", {}, {}, [](const ServedRequest&) {}, 0,
                                 {"http://localhost:3000", "https://viewer.example"});
        const Answer may = ask(server.port, "/lattice.tan", known + preflight, "OPTIONS");
        QCOMPARE(may.status, 204);
        QCOMPARE(may.header(allowed), "https://viewer.example");
        QVERIFY(may.header("Access-Control-Allow-Headers").toLower().contains("authorization"));
        QVERIFY(may.header("Access-Control-Allow-Headers").toLower().contains("range"));
        QVERIFY(may.header("Access-Control-Allow-Methods").contains("GET"));
        QCOMPARE(ask(server.port, "/lattice.tan", other + preflight, "OPTIONS").status, 405);
        QCOMPARE(ask(server.port, "/lattice.tan", preflight, "OPTIONS").status, 405);

        const Answer part = ask(server.port, "/lattice.tan", known + right + "Range: bytes=0-9\r\n");
        QCOMPARE(part.status, 206);
        QCOMPARE(part.header(allowed), "https://viewer.example");
        for (const char* name : {"Content-Range", "ETag", "Retry-After"})
            QVERIFY2(part.header("Access-Control-Expose-Headers").contains(name), part.head);
        QCOMPARE(part.header("Vary"), "Origin");
        QCOMPARE(ask(server.port, "/lattice.tan", known).header(allowed), "https://viewer.example"); // 401
        QCOMPARE(ask(server.port, "/lattice.tan", other + right).header(allowed), QByteArray());
        QCOMPARE(ask(server.port, "/lattice.tan", right).header(allowed), QByteArray());

        const LocalServer forNone(folder_);
        QCOMPARE(ask(forNone.port, "/lattice.tan", known).header(allowed), QByteArray());
        QCOMPARE(ask(forNone.port, "/lattice.tan", known + preflight, "OPTIONS").status, 405);
    }

    /// A mesh of nothing is no answer: documented, also where the server is another one.
    void anEmptyMeshIsRefused()
    {
        const auto empty = packMesh({}, {}, {}, "{}");
        QVERIFY(empty.ok());
        const std::string bytes(reinterpret_cast<const char*>(empty->data()), empty->size());
        HttpServer server(
            {},
            {.takesLong = [](const ServedRequest&) { return false; },
             .answer = [&](const ServedRequest&) { return textAnswer(200, std::string(packedMeshType), bytes); }},
            [](const HttpRecord&) {});
        const auto port = server.bind("127.0.0.1", 0);
        QVERIFY(port.ok());
        const std::jthread thread([&](const std::stop_token& stop) { (void)server.run(Progress(stop, {})); });
        const QString address = "http://127.0.0.1:" + QString::number(*port) + "/x.tan";
        const Run run = runTan({"extract", address, "--at-server", "-o", "empty.vtu"}, place_.path());
        QCOMPARE(run.exitCode, 3);
        QVERIFY2(run.messages.contains("without tetrahedra"), run.messages);
        QVERIFY(!QFile::exists(place_.filePath("empty.vtu")));
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
                 << "GET /lattice.tan\r\n\r\n"
                 << "GET /lattice.tan HTTP/1.1 x\r\n" + host + "\r\n"
                 << "GET /lattice.tan HTTP/2.0\r\n" + host + "\r\n"
                 << "GET /lattice.tan HTTP/1.9\r\n" + host + "\r\n"
                 << "PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n"
                 << "GET /lattice.tan#x HTTP/1.1\r\n" + host + "\r\n"
                 << "GET /latt\x01ice.tan HTTP/1.1\r\n" + host + "\r\n"
                 << "GET /latt\xc3\xa4.tan HTTP/1.1\r\n" + host + "\r\n"
                 << get + "\r\n"
                 << get + "Host:\r\n\r\n"
                 << get + "Host: \r\n\r\n"
                 << get + host + host + "\r\n"
                 << get + "Host : localhost\r\n\r\n"
                 << get + host + " folded: x\r\n\r\n"
                 << get + host + "no colon\r\n\r\n"
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

    /// Heads that libmicrohttpd reads although the standard knows better: what comes of them is an honest answer.
    void generousReadingGivesNothingAway()
    {
        const LocalServer server(folder_);
        const QByteArray get = "GET /lattice.tan HTTP/1.1\r\n", end = "Host: localhost\r\nConnection: close\r\n\r\n";
        for (const QByteArray& head :
             {"GET  /lattice.tan HTTP/1.1\r\n" + end, get + "X: a\nRange: bytes=0-1\r\n" + end, get + ": x\r\n" + end,
              QByteArray("GET /lattice.tan\0/../../secret.tan HTTP/1.1\r\n", 45) + end,
              get + QByteArray("X: a\0b\r\n", 8) + end, "\r\n" + get + end}) {
            const Client client(server.port);
            client.send(head);
            const Answer answer = answerIn(client.rest());
            QVERIFY2(answer.status == 200 || answer.status == 206 || answer.status == 400, head);
            QVERIFY(!answer.body.contains("SECRET"));
        }
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
        QVERIFY(meshOf(server, "lattice.tan", "error=5", token).ok());
        QVERIFY(!meshOf(server, "lattice.tan", "error=5", "0123456789abcdef-tokex").ok());
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
            folder_, {}, {.headTime = milliseconds(400), .idleTime = milliseconds(700), .sendTime = milliseconds(400)});
        const Client silent(server.port), half(server.port), dripping(server.port), deaf(server.port);
        half.send("GET / HTTP/1.1\r\nHost: loc");
        deaf.send("GET /large.tan HTTP/1.1\r\nHost: localhost\r\n\r\n");
        while (dripping.send("G")) // until it is ended
            QTest::qSleep(20);
        QVERIFY(server.waitForRecords(3));
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
        Gate gate;
        const LocalServer server(folder_, {}, {.connections = 3, .connectionsOfAddress = 3}, {}, gate.before());
        const auto atTheEnd = qScopeGuard([&gate] { gate.open(); }); // the server waits for its answers
        const Client one(server.port), two(server.port), three(server.port);
        for (const Client* client : {&one, &two, &three})
            client->send("GET /?x HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n");
        QVERIFY(gate.isWaitedForBy(3)); // an answer is worked on for each
        const Answer refused = ask(server.port, "/");
        QCOMPARE(refused.status, 503);
        QVERIFY(refused.header("Retry-After").toInt() > 0);
        gate.open();
        QCOMPARE(answerIn(three.rest()).status, 200);
    }

    /// Work for a client that has gone ends.
    void nobodyWaitsForAMesh()
    {
        std::atomic<bool> hasCome = false;
        const LocalServer server(folder_, {}, {}, {.waiting = milliseconds(600'000), .meshes = 0},
                                 [&](const ServedRequest&) { hasCome = true; });
        {
            const Client client(server.port);
            client.send("GET /lattice.tan?error=1 HTTP/1.1\r\nHost: localhost\r\n\r\n");
            QVERIFY(waitFor([&] { return hasCome.load(); }));
            QCOMPARE(server.records().size(), std::size_t(0));
        }
        QVERIFY(server.waitForRecords(1));
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
                QVERIFY(isKept || waitFor([&] { return connectionsTo(server.port) == 0; }));
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
        const LocalServer server(folder_, {}, {.connections = 2, .connectionsOfAddress = 2});
        const QByteArray get = "GET /lattice.tan HTTP/1.1\r\nHost: localhost\r\nRange: bytes=0-9\r\n";
        const Client first(server.port), second(server.port);
        first.send(get + "\r\n");
        QVERIFY(server.waitForRecords(1));
        second.send(get + "\r\n");
        QVERIFY(server.waitForRecords(2));
        QCOMPARE(ask(server.port, "/").status, 200);
        QCOMPARE(answerIn(first.rest()).status, 206); // and then its end
        second.send(get + "Connection: close\r\n\r\n");
        QCOMPARE(second.rest().count("HTTP/1.1 206"), 2);
    }

    /// Nor does who says nothing, or half of what is to be said, however often it comes again.
    void muteConnectionsShutNobodyOut()
    {
        constexpr int places = 8;
        const LocalServer server(folder_, {}, {.connections = places, .connectionsOfAddress = places});
        for (const QByteArray& said : {QByteArray(), QByteArray("GET /lattice.tan HTTP/1.1\r\nHost: loc")}) {
            std::deque<Client> others;
            for (int round = 0; round < 40; ++round) {
                if (others.size() >= 40)
                    others.pop_front();
                others.emplace_back(server.port).send(said);
                const Answer answer = ask(server.port, "/lattice.tan", "Range: bytes=0-9\r\n");
                QVERIFY2(answer.status == 206, answer.head);
            }
        }
    }

    /// One address does not take all places, even if all of its requests are being answered.
    void oneAddressLeavesPlacesToOthers()
    {
        Gate gate;
        const LocalServer server(folder_, {}, {.connections = 4, .connectionsOfAddress = 2}, {},
                                 [wait = gate.before()](const ServedRequest& request) {
                                     if (request.target.find('?') != std::string::npos)
                                         wait(request);
                                 });
        const auto atTheEnd = qScopeGuard([&gate] { gate.open(); });
        const Client one(server.port), two(server.port);
        for (const Client* client : {&one, &two})
            client->send("GET /?x HTTP/1.1\r\nHost: localhost\r\n\r\n");
        QVERIFY(gate.isWaitedForBy(2));
        QCOMPARE(ask(server.port, "/lattice.tan").status, 503);
        const Client neighbour(server.port, "127.0.0.2");
        neighbour.send("GET /lattice.tan HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n");
        QCOMPARE(answerIn(neighbour.rest()).status, 200);
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

    /// Whatever goes on.
    void theProgramStopsCleanly_data()
    {
        QTest::addColumn<int>("signal");
        QTest::newRow("Ctrl+C") << SIGINT;
        QTest::newRow("kill") << SIGTERM;
    }
    void theProgramStopsCleanly()
    {
        QFETCH(int, signal);
        ServeProgram server(place_.path(), {"--json"});
        const int port = server.port();
        QVERIFY(port > 0);
        QCOMPARE(ask(port, "/lattice.tan?error=5").status, 200);
        const Client idle(port), asking(port), reading(port), kept(port);
        kept.send("GET / HTTP/1.1\r\nHost: localhost\r\n\r\n");
        asking.send("GET / HT");
        reading.send("GET /lattice.tan HTTP/1.1\r\nHost: localhost\r\n\r\n");
        QVERIFY(kept.isAnswered() && reading.isAnswered()); // the others came before them
        server.signal(signal);
        QVERIFY(server.process.waitForFinished(patiently(20'000)));
        const Run run = collect(server.process);
        QCOMPARE(run.exitCode, 0);
        QVERIFY(run.json()["requests"].toInt() >= 2);
        QVERIFY2(run.messages.contains("\"GET /lattice.tan?error=5\" 200"), run.messages);
        QVERIFY2(run.messages.contains("Every user of this machine can read"), run.messages);
    }

    /// Requests are answered and Ctrl+C ends the program also where both of its streams go into a pipe that nobody
    /// reads.
    void aLogThatNobodyReadsStopsNothing()
    {
        std::array<int, 2> pipe{};
        QCOMPARE(::pipe2(pipe.data(), O_CLOEXEC), 0);
        QVERIFY(::fcntl(pipe[1], F_SETPIPE_SZ, 4096) > 0);
        ServeProgram server(place_.path(), {}, [to = pipe[1]] {
            ::dup2(to, STDOUT_FILENO);
            ::dup2(to, STDERR_FILENO);
        });
        QByteArray line;
        for (char c = 0; c != '\n' && ::read(pipe[0], &c, 1) == 1;)
            line += c;
        const int port = ServeProgram::portIn(line);
        QVERIFY2(port > 0, line);
        for (int i = 0; i < 200; ++i)
            QCOMPARE(ask(port, "/lattice.tan", "Range: bytes=0-9\r\n").status, 206);
        server.signal(SIGINT);
        QVERIFY(server.process.waitForFinished(patiently(20'000)));
        QCOMPARE(server.process.exitCode(), 0);
        ::close(pipe[0]);
        ::close(pipe[1]);
    }

    /// What a client sends reaches the log printable only.
    void theLogIsPrintable()
    {
        const LocalServer server(folder_);
        const QByteArray bidi = "\xe2\x80\xae", host = " HTTP/1.1\r\nHost: localhost\r\n\r\n";
        for (const QByteArray& target : {"/a" + bidi + "b", QByteArray("/\x1b[31mx"), QByteArray("/\xc2\x9bx")}) {
            const Client client(server.port);
            client.send("GET " + target + host);
            QCOMPARE(answerIn(client.rest()).status, 400);
        }
        QVERIFY(server.waitForRecords(3));
        for (const HttpRecord& record : server.records())
            QVERIFY2(std::ranges::all_of(record.request, [](char c) { return c >= ' ' && c < 0x7f; }),
                     record.request.c_str());
    }

    /// Memory that meshes took goes back, whichever threads found them. (tests/bench/serve_load.py: at random, for
    /// hours.)
    void theProgramsMemoryIsSteady()
    {
        ServeProgram server(place_.path());
        const int port = server.port();
        QVERIFY(port > 0);
        // Each has a connection of its own, and so another thread of the server.
        const auto areAnswered = [&](int meshes) {
            int answered = 0;
            for (int i = 0; i < meshes; ++i)
                answered += ask(port, "/lattice.tan?error=" + QByteArray::number(i % 2)).status == 200 ? 1 : 0;
            return answered == meshes && server.waitForRequests(meshes); // it logs what is over
        };
        const auto kept = [&server] {
            const QByteArray pages = readFile("/proc/" + QString::number(server.process.processId()) + "/smaps_rollup");
            const qsizetype at = pages.indexOf("Anonymous:");
            return at < 0 ? -1.0 : pages.mid(at + 10).trimmed().split(' ')[0].toDouble() / 1024;
        };
        QVERIFY(areAnswered(4));
        const double first = kept();
        QVERIFY(first > 0);
        QVERIFY(areAnswered(40));
        constexpr double mostOfAThread = 0.1;
        double later = kept();
        const bool isSteady = waitFor([&] { return (later = kept()) > 0 && later < first + 36 * mostOfAThread; });
        QVERIFY2(isSteady, qPrintable(QString("%1 MB, then %2").arg(first).arg(later)));
        server.signal(SIGTERM);
        QVERIFY(server.process.waitForFinished(patiently(20'000)));
    }

    /// Where the system gives fewer threads than there may be connections, it serves with those, or says why not.
    void fewThreadsAreEnough()
    {
        int served = 0;
        for (const rlim_t megabytes : {200, 300, 400}) {
            ServeProgram server(place_.path(), {}, [megabytes] {
                const rlimit limit{megabytes << 20, megabytes << 20};
                ::setrlimit(RLIMIT_AS, &limit);
            });
            if (const int port = server.port(); port > 0) {
                served += ask(port, "/lattice.tan", "Range: bytes=0-9\r\n").status == 206 ? 1 : 0;
                server.signal(SIGTERM);
            }
            QVERIFY(server.process.waitForFinished(patiently(20'000)) ||
                    server.process.state() == QProcess::NotRunning);
            QCOMPARE(server.process.exitStatus(), QProcess::NormalExit);
            const int code = server.process.exitCode();
            QVERIFY2(code == 0 || code == 4 || code == 127, server.process.readAllStandardError());
        }
        QVERIFY(served > 0);
    }

    void wrongUseIsRefused()
    {
        QVERIFY(writeFile(place_.filePath("short"), "tooshort\n"));
        QVERIFY(writeFile(place_.filePath("long"), QByteArray(20'000, 'x') + "\n"));
        QVERIFY(writeFile(place_.filePath("control"), "0123456789abcdef\x01token\n"));
        QVERIFY(writeFile(place_.filePath("token"), "0123456789abcdef-token\n"));
        for (const QStringList& options :
             {QStringList{"models", "--token-file", "long"}, QStringList{"models", "--token-file", "control"},
              QStringList{"models", "--allow-origin", "*"}, QStringList{"models", "--allow-origin", "viewer.example"},
              QStringList{"models", "--allow-origin", "https://viewer.example/"},
              QStringList{"models", "--address", "0.0.0.0"}, QStringList{"models", "--address", "127.evil.example"},
              QStringList{"models", "--token-file", "short"}, QStringList{"models", "--token-file", "nothing"},
              QStringList{"models", "--port", "70000"}, QStringList{"models", "--limit", "0"},
              QStringList{"models", "--address", "192.0.2.1", "--token-file", "token"}}) {
            const Run run = runTan(QStringList{"serve"} + options, place_.path());
            QVERIFY2(run.exitCode == 2, qPrintable(options.join(' ') + "\n" + run.messages));
        }
        QCOMPARE(runTan({"serve", "nothing"}, place_.path()).exitCode, 3);
        QVERIFY(writeFile(place_.filePath("windows"), "0123456789abcdef-token\r\n")); // a line as Windows ends it
        QCOMPARE(tokenIn(place_.filePath("windows").toStdString()).value(), "0123456789abcdef-token");
        const LocalServer taken(folder_);
        const Run run = runTan({"serve", "models", "--port", QString::number(taken.port)}, place_.path());
        QCOMPARE(run.exitCode, 2);
        QVERIFY2(run.messages.contains("Address already in use"), run.messages);
    }
};

QTEST_GUILESS_MAIN(ServeTest)
#include "serve_test.moc"
