// SPDX-License-Identifier: GPL-3.0-or-later
// Models by URL (R28, B5): nginx, or the tests' own server where there is none, behind a proxy that delays. What it
// takes to the first picture of the whole domain and to meshes of so many tetrahedra: requests, bytes, round trips and
// seconds, each with an empty cache.

#include "plugins/samples/samples.h"
#include "tests/bench/bench_report.h"
#include "tests/bench/delaying_proxy.h"
#include "tests/core/remote/http_server.h"

#include <tan/build.h>
#include <tan/open.h>
#include <tan/packed.h>

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTextStream>

#include <cstdio>
#include <memory>
#include <thread>

namespace tetra {
namespace {

/// A port that nobody listens at.
std::uint16_t freePort()
{
    return LoopbackListener([](int) {}).port();
}

/// nginx with the files of one folder, ended with this.
class Nginx {
public:
    explicit Nginx(const QString& folder) : port_(freePort())
    {
        const QString program = QStandardPaths::findExecutable("nginx", {"/usr/sbin", "/usr/bin", "/usr/local/sbin"});
        if (program.isEmpty() || !home_.isValid())
            return;
        QString places;
        for (const char* kind : {"client_body", "proxy", "fastcgi", "uwsgi", "scgi"})
            places += QString("%1_temp_path %2; ").arg(kind, home_.filePath(kind));
        QFile settings(home_.filePath("nginx.conf"));
        if (!settings.open(QIODevice::WriteOnly))
            return;
        settings.write(QString("daemon off; master_process off; pid %1; error_log %2; events {}\n"
                               "http { access_log off; %3 server { listen 127.0.0.1:%4; root %5; } }\n")
                           .arg(home_.filePath("pid"), home_.filePath("errors"), places)
                           .arg(port_)
                           .arg(folder)
                           .toUtf8());
        settings.close();
        process_.start(program, {"-e", home_.filePath("errors"), "-c", settings.fileName()});
        for (int look = 0; look < 100 && process_.state() != QProcess::NotRunning && !isUp_; ++look) {
            process_.waitForFinished(20);
            const int probe = ::socket(AF_INET, SOCK_STREAM, 0);
            const sockaddr_in address = loopback(port_);
            isUp_ = ::connect(probe, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
            ::close(probe);
        }
    }
    ~Nginx()
    {
        process_.terminate();
        process_.waitForFinished();
    }

    bool isUp() const { return isUp_; }
    std::uint16_t port() const { return port_; }

private:
    QTemporaryDir home_;
    QProcess process_;
    std::uint16_t port_;
    bool isUp_ = false;
};

/// What is waited for.
struct Milestone {
    QString name;
    std::uint64_t tetrahedra = 0; ///< 0: the first mesh that is shown
};

struct Reached {
    double seconds = 0;
    std::uint64_t tetrahedra = 0;
    std::uint64_t readBytes = 0;
};

/// Models of a sample in both forms, made in the folder.
Result<QStringList> sampleModels(const QString& folder, std::uint32_t size)
{
    const auto dataset = makeSample({"c60", size, SampleType::UInt8});
    if (!dataset)
        return dataset.error();
    const QStringList models = {folder + "/c60.tan", folder + "/c60.packed.tan"};
    if (const auto built = buildModel(*dataset, models[0].toStdString()); !built)
        return built.error();
    const auto model = Model::open(models[0].toStdString());
    if (!model)
        return model.error();
    const auto packed = packModel(**model, models[1].toStdString());
    return packed ? Result<QStringList>(models) : packed.error();
}

Result<Reached> reach(const std::string& address, const Milestone& milestone)
{
    const QTemporaryDir cache;
    std::stop_source stop;
    Reached reached;
    bool isReached = false;
    const auto start = std::chrono::steady_clock::now();
    const auto look = [&](const FoundModel& found) {
        const std::uint64_t tetrahedra = meshSizeAt(*found.model, {.error = 0, .warping = 0}).tetrahedra;
        if (isReached || tetrahedra < milestone.tetrahedra)
            return;
        isReached = true;
        reached.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        reached.tetrahedra = tetrahedra;
        reached.readBytes = found.readBytes;
        stop.request_stop();
    };
    OpenOptions options;
    options.cacheFolder = cache.path().toStdString();
    options.grown = look;
    if (milestone.tetrahedra > 0) { // a site makes some six tetrahedra
        const auto facts = modelFacts(address);
        if (!facts)
            return facts.error();
        const auto isLarge = [&](const LevelInFile& level) { return level.sites * 6 >= milestone.tetrahedra; };
        const auto level = std::ranges::find_if(facts->levels, isLarge);
        if (level != facts->levels.end())
            options.accuracy = Accuracy{.error = level->error, .warping = level->warping};
    }
    const auto found = openModel(address, options, Progress(stop.get_token(), {}));
    if (!found && !isReached)
        return found.error();
    if (found && !isReached) {
        reached.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        reached.tetrahedra = meshSizeAt(*found->model, {.error = 0, .warping = 0}).tetrahedra;
        reached.readBytes = found->readBytes;
    }
    return reached;
}

/// Prints the addresses of files behind the proxy and, when the input has ended, what passed.
void serveUntilInputEnds(const DelayingProxy& proxy, const QStringList& files)
{
    for (const QString& file : files)
        std::printf("%s\n", proxy.address(QFileInfo(file).fileName().toStdString()).c_str());
    std::fflush(stdout);
    QTextStream(stdin).readAll();
    const DelayingProxy::Counts counts = proxy.counts();
    std::printf("%llu connections, %llu requests, %llu round trips, %llu bytes\n",
                static_cast<unsigned long long>(counts.connections), static_cast<unsigned long long>(counts.requests),
                static_cast<unsigned long long>(counts.roundTrips), static_cast<unsigned long long>(counts.bytes));
}

} // namespace
} // namespace tetra

int main(int argc, char** argv)
{
    using namespace tetra;
    const QCoreApplication application(argc, argv);
    QCommandLineParser parser;
    parser.addHelpOption();
    parser.addPositionalArgument("MODEL", "Models of either form, in one folder; without any C60 in both.",
                                 "[MODEL...]");
    parser.addOption({"size", "Points along an edge of C60.", "N", "64"});
    parser.addOption({"json", "Print one JSON object."});
    parser.addOption({"delay", "Milliseconds each way.", "N", "50"});
    parser.addOption({"tetrahedra", "Sizes of meshes that are waited for.", "N,N,...", "100000,1000000"});
    parser.addOption({"serve", "Print the addresses and serve until the input ends."});
    parser.addOption(
        {"port", "Only delay the way to a server of this machine, such as 'tan serve'; like --serve.", "N"});
    parser.process(application);
    const std::chrono::milliseconds delay(parser.value("delay").toInt());
    if (parser.isSet("port")) {
        serveUntilInputEnds(DelayingProxy(parser.value("port").toUShort(), delay), parser.positionalArguments());
        return 0;
    }
    const QTemporaryDir home;
    QStringList models = parser.positionalArguments();
    if (models.isEmpty()) {
        const auto made = sampleModels(home.path(), parser.value("size").toUInt());
        if (!made) {
            std::fprintf(stderr, "%s\n", made.error().text().c_str());
            return 4;
        }
        models = *made;
    }
    const QString folder = QFileInfo(models[0]).absolutePath();
    const Nginx nginx(folder);
    std::unique_ptr<FaultyHttpServer> own;
    if (!nginx.isUp()) {
        std::fprintf(stderr, "There is no nginx: the first model is served by the tests' own server.\n");
        QFile file(models[0]);
        if (!file.open(QIODevice::ReadOnly)) {
            std::fprintf(stderr, "Cannot read '%s'.\n", qPrintable(models[0]));
            return 3;
        }
        own = std::make_unique<FaultyHttpServer>(file.readAll().toStdString());
    }
    DelayingProxy proxy(own ? own->port() : nginx.port(), delay);
    if (parser.isSet("serve")) {
        serveUntilInputEnds(proxy, models);
        return 0;
    }
    std::vector<Milestone> milestones = {{"first picture", 0}};
    for (const QString& size : parser.value("tetrahedra").split(',', Qt::SkipEmptyParts))
        milestones.push_back({size + " tetrahedra", size.toULongLong()});
    std::vector<BenchCase> cases;
    for (const QString& model : own ? models.first(1) : models)
        for (const Milestone& milestone : milestones) {
            const QString name = QFileInfo(model).fileName();
            proxy.reset();
            const auto reached = reach(proxy.address(name.toStdString()), milestone);
            if (!reached) {
                std::fprintf(stderr, "%s\n", reached.error().text().c_str());
                return 4;
            }
            const DelayingProxy::Counts counts = proxy.counts();
            BenchCase one;
            one.name = QString("%1: %2, %3 ms each way").arg(name, milestone.name).arg(delay.count());
            one.seconds = reached->seconds;
            one.more = {{"tetrahedra", qint64(reached->tetrahedra)}, {"bytes_of_file", qint64(reached->readBytes)},
                        {"requests", qint64(counts.requests)},       {"round_trips", qint64(counts.roundTrips)},
                        {"connections", qint64(counts.connections)}, {"bytes", qint64(counts.bytes)},
                        {"file_bytes", QFileInfo(model).size()}};
            cases.push_back(one);
        }
    printReport("remote", cases, parser.isSet("json"));
    return 0;
}
