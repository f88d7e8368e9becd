// SPDX-License-Identifier: GPL-3.0-or-later
// Files on HTTP servers, read by ranges into a cache (R28, B5), and all that servers, networks and disks do wrong.
#include "core/remote/remote_file.h"

#include "core/remote/fetch.h"
#include "core/remote/piece_store.h"
#include "tests/core/base/small_disk.h"
#include "tests/core/remote/http_server.h"
#include "tests/soak.h"

#include <QTemporaryDir>
#include <QTest>

#include <atomic>
#include <chrono>
#include <csignal>
#include <fstream>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace tetra;
using namespace std::chrono_literals;

namespace {

using Clock = std::chrono::steady_clock;
using Request = FaultyHttpServer::Request;
using Reply = FaultyHttpServer::Reply;

constexpr std::uint64_t kibibyte = 1024, piece = PieceStore::pieceBytes;

std::string someBytes(std::size_t size)
{
    std::mt19937_64 random(1);
    std::string bytes(size, '\0');
    for (char& byte : bytes)
        byte = static_cast<char>(random());
    return bytes;
}

/// 40 pieces and a part of one.
const std::string& content()
{
    static const std::string bytes = someBytes(40 * piece + 1000);
    return bytes;
}

CacheFolder cacheIn(const QTemporaryDir& home, std::uint64_t limit = CacheFolder::defaultLimit)
{
    return CacheFolder::open(std::filesystem::path(home.path().toStdString()) / "tan", limit).value();
}

/// Impatient, so that tests are quick.
RemoteOptions hasty(std::chrono::milliseconds silence = 20s)
{
    return {.silence = silence, .retries = 3, .firstPause = 1ms};
}

Status readInto(const RemoteFile& file, std::uint64_t offset, std::string& to, const Progress& progress = {})
{
    return file.source().read(offset, std::as_writable_bytes(std::span(to)), progress);
}

Status fetchFrom(const RemoteFile& file, std::vector<ByteRange> ranges, const Progress& progress = {})
{
    return file.source().fetch(ranges, progress);
}

/// All of the file, in one fetch; empty with a text of what went wrong.
std::string wholeFile(const Result<RemoteFile>& file, std::string& problem)
{
    problem.clear();
    if (!file) {
        problem = file.error().text();
        return {};
    }
    std::string bytes(file->size(), '\0');
    Status got = fetchFrom(*file, {{0, file->size()}});
    if (got)
        got = readInto(*file, 0, bytes);
    if (!got)
        problem = got.error().text();
    return got ? bytes : std::string();
}

std::string cacheFileOf(const CacheFolder& cache)
{
    std::error_code problem;
    const auto paths = pathsIn(cache.path(), problem);
    return paths.size() == 1 ? paths[0].string() : std::string();
}

/// A fault that a server makes, and what of the sentence must say it; "" allows the right bytes as well.
struct Fault {
    const char* name;
    std::function<void(const Request& request, std::size_t number, std::mt19937_64& random, Reply& reply)> make;
    std::vector<std::string> sentences;
    bool mayWork = false;
};

constexpr const char* page = "<!doctype html><title>Log in</title>";

const std::vector<Fault>& allFaults()
{
    using Random = std::mt19937_64;
    static const std::vector<Fault> all = {
        {"cut at random places",
         [](const Request&, std::size_t, Random& random, Reply& reply) {
             if (random() % 2 == 0)
                 reply.cutAt = random() % (reply.body.size() + 200);
         },
         {"lost again and again"},
         true},
        {"always cut",
         [](const Request&, std::size_t number, Random& random, Reply& reply) {
             if (number > 0)
                 reply.cutAt = random() % 300;
         },
         {"lost again and again"}},
        {"a length that is too large",
         [](const Request&, std::size_t, Random& random, Reply& reply) {
             reply.set("Content-Length", std::to_string(reply.body.size() + 1 + random() % 1000));
             reply.isLast = true;
         },
         {"a different part of the file"}},
        {"fewer bytes than its head says",
         [](const Request&, std::size_t, Random& random, Reply& reply) {
             reply.set("Content-Length", std::to_string(reply.body.size()));
             reply.body.resize(random() % std::min<std::size_t>(reply.body.size(), 10'000));
             reply.isLast = true;
         },
         {"lost again and again"}},
        {"a proxy that cuts, with a head that fits",
         [](const Request&, std::size_t number, Random& random, Reply& reply) {
             if (number == 0)
                 return;
             reply.body.resize(random() % std::min<std::size_t>(reply.body.size(), 10'000) + 1);
             const std::string range = std::get<1>(
                 *std::ranges::find(reply.headers, "Content-Range", [](auto& header) { return header.first; }));
             const std::uint64_t first = std::stoull(range.substr(6));
             reply.set("Content-Range", "bytes " + std::to_string(first) + '-' +
                                            std::to_string(first + reply.body.size() - 1) + '/' +
                                            std::to_string(content().size()));
         },
         {"lost again and again"}},
        {"more bytes than the range has",
         [](const Request&, std::size_t, Random& random, Reply& reply) {
             reply.body += std::string(random() % 5000 + 1, 'x');
             reply.set("Transfer-Encoding", "identity");
             reply.set("Content-Length", std::to_string(reply.body.size()));
         },
         {"a different part of the file"}},
        {"another file, noticed by If-Range",
         [](const Request&, std::size_t number, Random&, Reply& reply) {
             if (number == 0)
                 return;
             reply.status = 200;
             reply.remove("Content-Range");
             reply.set("ETag", "\"second\"");
             reply.body = content();
         },
         {"was changed while it was read"}},
        {"another file, from a server that knows no If-Range",
         [](const Request&, std::size_t number, Random& random, Reply& reply) {
             if (number == 0)
                 return;
             if (random() % 2 == 0)
                 reply.set("ETag", "\"second\"");
             else
                 reply.set("Last-Modified", "Thu, 02 Oct 2025 10:00:00 GMT");
         },
         {"was changed while it was read"}},
        {"another length",
         [](const Request& request, std::size_t number, Random& random, Reply& reply) {
             if (number > 0)
                 reply.set("Content-Range", "bytes " + std::to_string(*request.first) + '-' +
                                                std::to_string(*request.first + reply.body.size() - 1) + '/' +
                                                std::to_string(content().size() + 1 + random() % 1000));
         },
         {"was changed while it was read"}},
        {"a range beyond the end of a file that is shorter now",
         [](const Request&, std::size_t number, Random&, Reply& reply) {
             if (number > 0)
                 reply.become(416, "", "text/plain");
         },
         {"was changed while it was read"}},
        {"200 for 206",
         [](const Request&, std::size_t, Random&, Reply& reply) {
             reply.status = 200;
             reply.remove("Content-Range");
             reply.body = content();
         },
         {"as a whole"}},
        {"200 for 206 after the first request",
         [](const Request&, std::size_t number, Random&, Reply& reply) {
             if (number == 0)
                 return;
             reply.status = 200;
             reply.remove("Content-Range");
             reply.body = content();
         },
         {"as a whole"}},
        {"a drip",
         [](const Request&, std::size_t number, Random&, Reply& reply) {
             if (number > 0)
                 reply.perByte = 10ms;
         },
         {"nothing arrived from the server for"}},
        {"silence",
         [](const Request&, std::size_t, Random&, Reply& reply) { reply.isSilent = true; },
         {"nothing arrived from the server for"}},
        {"garbage in place of HTTP",
         [](const Request&, std::size_t number, Random& random, Reply& reply) {
             if (number == 0 && random() % 2 == 0)
                 return;
             reply.raw = "\x16";
             for (std::size_t byte = random() % 4000 + 100; byte > 0; --byte)
                 *reply.raw += static_cast<char>(random());
         },
         {"not a web server", "lost again and again"}},
        {"a damaged head",
         [](const Request&, std::size_t, Random& random, Reply& reply) {
             auto& header = reply.headers[random() % reply.headers.size()];
             for (char& byte : random() % 2 == 0 ? header.first : header.second)
                 if (random() % 3 == 0)
                     byte = static_cast<char>(33 + random() % 94);
         },
         {"changed", "a different part", "not a web server", "lost again and again", "as a whole", "the length"},
         true},
        {"a head without end",
         [](const Request&, std::size_t, Random& random, Reply& reply) {
             for (int line = 0; line < 40; ++line)
                 reply.headers.emplace_back("X-" + std::to_string(random()), std::string(10'000, 'x'));
         },
         {"not a web server"}},
        {"another range",
         [](const Request& request, std::size_t, Random& random, Reply& reply) {
             const std::uint64_t first = *request.first + 1 + random() % 1000;
             reply.set("Content-Range", "bytes " + std::to_string(first) + '-' +
                                            std::to_string(first + reply.body.size() - 1) + '/' +
                                            std::to_string(content().size() + 2000));
         },
         {"a different part of the file"}},
        {"a range that cannot be read",
         [](const Request&, std::size_t, Random& random, Reply& reply) {
             const std::vector<std::string> ranges = {"", "bytes", "bytes 0-/10", "bytes 9-0/10", "bytes a-b/c"};
             reply.set("Content-Range", ranges[random() % ranges.size()]);
         },
         {"a different part of the file"}},
        {"no length of the whole",
         [](const Request& request, std::size_t, Random&, Reply& reply) {
             reply.set("Content-Range", "bytes " + std::to_string(*request.first) + '-' +
                                            std::to_string(*request.first + reply.body.size() - 1) + "/*");
         },
         {"the length of the file"}},
        {"a page to log in at",
         [](const Request&, std::size_t, Random&, Reply& reply) {
             reply.become(200, page, "text/html; charset=utf-8");
         },
         {"a web page or a list instead of data"}},
        {"a page to log in at, in parts and under a wrong name",
         [](const Request&, std::size_t, Random&, Reply& reply) {
             reply.body.replace(0, std::string(page).size(), page);
         },
         {"a web page or a list instead of data"}},
        {"logged out",
         [](const Request&, std::size_t number, Random&, Reply& reply) {
             if (number > 0)
                 reply.become(200, page, "text/html");
         },
         {"a web page or a list instead of data"}},
        {"a proxy that packs",
         [](const Request&, std::size_t, Random&, Reply& reply) { reply.set("Content-Encoding", "gzip"); },
         {"compresses what it sends (gzip)"}},
        {"redirections without end",
         [](const Request&, std::size_t, Random& random, Reply& reply) {
             reply.become(302, "", "text/plain");
             reply.set("Location", "/" + std::to_string(random()));
         },
         {"redirects from one address to another"}},
        {"a redirection to a file of this machine",
         [](const Request&, std::size_t, Random&, Reply& reply) {
             reply.become(302, "", "text/plain");
             reply.set("Location", "file:///etc/passwd");
         },
         {"not safe to follow"}},
    };
    return all;
}

} // namespace

class RemoteFileTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        for (const char* name : {"http_proxy", "https_proxy", "all_proxy", "HTTP_PROXY", "HTTPS_PROXY", "ALL_PROXY"})
            qunsetenv(name);
        std::signal(SIGXFSZ, SIG_IGN);
    }

    void addresses()
    {
        QVERIFY(isRemoteAddress("https://example.org/x.tan") && isRemoteAddress("HTTP://example.org/x.tan"));
        QVERIFY(!isRemoteAddress("ftp://example.org/x") && !isRemoteAddress("/http://x") &&
                !isRemoteAddress("http:/x"));
        // A slash that is not escaped ends the host for libcurl, so that the password's end would stand in the path.
        QCOMPARE(shownAddress("https://me:1/2secret@example.org/x.tan"), std::string("https://...@example.org/x.tan"));
        QCOMPARE(shownAddress("https://[::1]/a@b.tan"), std::string("https://[::1]/a@b.tan"));
        QCOMPARE(shownAddress("https://me:secret@example.org/a@b.tan?key=secret#x"),
                 std::string("https://example.org/a@b.tan"));
        QCOMPARE(shownAddress("https://example.org/a.tan"), std::string("https://example.org/a.tan"));
        QCOMPARE(shownAddress("http://user:se/cret@127.0.0.1:1/x.tan"), std::string("http://127.0.0.1:1/x.tan"));
        QCOMPARE(shownAddress("http://user:s?cr#t@127.0.0.1:1/x.tan").find("t@"), std::string::npos);
        QCOMPARE(shownAddress("http://user:s@cret@127.0.0.1:1/x.tan?k#f"), std::string("http://127.0.0.1:1/x.tan"));
        QCOMPARE(shownAddress("http://user:se cret@127.0.0.1:1/x.tan").find("cret"), std::string::npos);
        QCOMPARE(shownAddress("http://127.0.0.1:1/\x1b[31m.tan").find('\x1b'), std::string::npos);
        QCOMPARE(addressWithoutUser("http://user:secret@host/x.tan?k"), std::string("http://host/x.tan?k"));
        QCOMPARE(addressWithoutUser("http://user:se/cret@host/x.tan"), std::string());
    }

    void neighboursAreAskedForTogether()
    {
        const std::vector<std::uint64_t> pieces = {0, 1, 6, 12, 40};
        const std::vector<ByteRange> expected = {
            {0, 2 * piece}, {6 * piece, piece}, {12 * piece, piece}, {40 * piece, 1000}};
        QVERIFY(mergedRanges(pieces, piece, 64 * kibibyte, 40 * piece + 1000) == expected);
        const std::vector<std::uint64_t> near = {0, 4, 8};
        QVERIFY(mergedRanges(near, piece, 64 * kibibyte, 9 * piece) == (std::vector<ByteRange>{{0, 9 * piece}}));
    }

    /// B5: 16 KiB first, and nothing twice.
    void theFirstRequest()
    {
        const QTemporaryDir home;
        const FaultyHttpServer server(content());
        QVERIFY(server.isUp());
        const auto file = RemoteFile::open(server.address(), cacheIn(home));
        QVERIFY2(file.ok(), file ? "" : file.error().text().c_str());
        QCOMPARE(file->size(), content().size());
        std::string bytes(100, '\0');
        QVERIFY(readInto(*file, piece - 100, bytes).ok());
        QCOMPARE(bytes, content().substr(piece - 100, 100));
        QCOMPARE(file->counts().requests, 1u);
        QCOMPARE(file->counts().bytes, 16384u);
        QCOMPARE(file->counts().roundTrips, 1u);
        QCOMPARE(server.requests().size(), std::size_t(1));
        QVERIFY(server.requests()[0].first == 0u && server.requests()[0].last == 16383u);
        QVERIFY(server.requests()[0].ifRange.empty());
        QVERIFY(!file->state().empty());
    }

    /// B5: merged over gaps below 64 KiB, at most four at once, each with If-Range.
    void requestsAreFewAndFewAtOnce()
    {
        const QTemporaryDir home;
        FaultyHttpServer server(content(), [](const Request&, std::size_t, Reply& reply) { reply.before = 50ms; });
        const auto file = RemoteFile::open(server.address(), cacheIn(home));
        QVERIFY(file.ok());
        server.forget();
        QVERIFY(fetchFrom(*file, {{2 * piece, 10}, {5 * piece, 10}, {3 * piece + 5, piece}}).ok());
        QCOMPARE(server.requests().size(), std::size_t(1));
        QVERIFY(server.requests()[0].first == 2 * piece && server.requests()[0].last == 6 * piece - 1);
        QCOMPARE(server.requests()[0].ifRange, std::string("\"first\""));
        QCOMPARE(file->counts().roundTrips, 2u);

        server.forget();
        std::vector<ByteRange> far;
        for (std::uint64_t at = 10; at < 40; at += 6)
            far.push_back({at * piece, 1});
        QVERIFY(fetchFrom(*file, far).ok());
        QCOMPARE(server.requests().size(), std::size_t(5));
        QCOMPARE(server.mostAtOnce(), 4);
        QCOMPARE(file->counts().roundTrips, 4u);
        QVERIFY(file->counts().connections <= 4);
        server.forget();
        QVERIFY(fetchFrom(*file, far).ok());
        QVERIFY(fetchFrom(*file, {}).ok());
        QCOMPARE(server.requests().size(), std::size_t(0));
    }

    void rightBytesForManyThreads()
    {
        const QTemporaryDir home;
        const FaultyHttpServer server(content());
        const auto file = RemoteFile::open(server.address(), cacheIn(home));
        QVERIFY(file.ok());
        std::atomic<int> wrong = 0;
        {
            std::vector<std::jthread> threads;
            for (unsigned thread = 0; thread < 8; ++thread)
                threads.emplace_back([&, thread] {
                    std::mt19937 random(thread);
                    for (int turn = 0; turn < 50; ++turn) {
                        const std::size_t offset = random() % content().size();
                        std::string bytes(random() % std::min<std::size_t>(content().size() - offset + 1, 50'000), 0);
                        wrong += !readInto(*file, offset, bytes) || bytes != content().substr(offset, bytes.size());
                    }
                });
        }
        QCOMPARE(wrong.load(), 0);
        QVERIFY(file->counts().bytes <= content().size() + 41 * 64 * kibibyte);
    }

    void nothingBeyondTheEnd()
    {
        const QTemporaryDir home;
        const FaultyHttpServer server(content());
        const auto file = RemoteFile::open(server.address(), cacheIn(home));
        std::string bytes(11, '\0');
        for (const std::uint64_t offset : {content().size() - 10, content().size() + 1, ~std::size_t(0)}) {
            const Status read = readInto(*file, offset, bytes);
            QVERIFY(!read && read.error().text().find("it ends too") != std::string::npos);
            QVERIFY(!fetchFrom(*file, {{offset, 11}}));
        }
    }

    void faults_data()
    {
        QTest::addColumn<int>("index");
        for (int index = 0; const Fault& fault : allFaults())
            QTest::newRow(fault.name) << index++;
    }
    /// 200 of each: no wrong bytes, no hang, a sentence that names the address.
    void faults()
    {
        QFETCH(const int, index);
        const Fault& fault = allFaults()[static_cast<std::size_t>(index)];
        constexpr int atOnce = 10;
        const int attempts = timesOf(40, 200);
        const bool isWait = std::string_view(fault.sentences[0]).starts_with("nothing arrived");
        std::atomic<int> next = 0, right = 0, told = 0;
        std::mutex mutex;
        std::string wrong;
        const auto report = [&](const std::string& text) {
            const std::lock_guard lock(mutex);
            wrong = text;
        };
        const auto begin = Clock::now();
        {
            std::vector<std::jthread> threads;
            for (int thread = 0; thread < atOnce; ++thread)
                threads.emplace_back([&] {
                    const QTemporaryDir home;
                    const CacheFolder cache = cacheIn(home);
                    for (int attempt = next++; attempt < attempts; attempt = next++) {
                        std::mt19937_64 random(seedOf(static_cast<std::uint32_t>(attempt)));
                        std::mutex order;
                        const FaultyHttpServer server(content(),
                                                      [&](const Request& request, std::size_t number, Reply& reply) {
                                                          const std::lock_guard lock(order);
                                                          fault.make(request, number, random, reply);
                                                      });
                        const auto file = RemoteFile::open(server.address(), cache, hasty(isWait ? 100ms : 20s));
                        Status got = file ? Status() : file.error();
                        std::string bytes;
                        for (int read = 0; read < 3 && got; ++read) {
                            const std::size_t offset = random() % content().size();
                            bytes.assign(random() % std::min<std::size_t>(content().size() - offset, 200'000), '\0');
                            if (bytes.empty() || offset + bytes.size() <= piece)
                                bytes.assign(content().size() - offset, '\0');
                            got = readInto(*file, offset, bytes);
                            if (got && bytes != content().substr(offset, bytes.size()))
                                report("wrong bytes");
                        }
                        if (got) {
                            ++right;
                            if (!fault.mayWork)
                                report("it worked");
                            continue;
                        }
                        ++told;
                        const std::string& text = got.error().text();
                        const bool isNamed = text.starts_with("Cannot read '" + server.address() + "': ");
                        const bool isTold = std::ranges::any_of(fault.sentences, [&](const std::string& sentence) {
                            return text.find(sentence) != std::string::npos;
                        });
                        if (!isNamed || !isTold || !text.ends_with('.'))
                            report(text);
                    }
                });
        }
        QCOMPARE(QString::fromStdString(wrong), QString());
        QCOMPARE(right + told, attempts);
        const auto took = std::chrono::duration_cast<std::chrono::milliseconds>(Clock::now() - begin);
        QVERIFY2(took < std::chrono::milliseconds(patiently(60'000)), qPrintable(QString::number(took.count())));
    }

    void refusals_data()
    {
        QTest::addColumn<int>("status");
        QTest::addColumn<QString>("sentence");
        QTest::newRow("401") << 401 << "requires a name and a password";
        QTest::newRow("403") << 403 << "does not allow it (403)";
        QTest::newRow("404") << 404 << "no such file on the server (404)";
        QTest::newRow("407") << 407 << "the proxy requires a name";
        QTest::newRow("410") << 410 << "no such file on the server (410)";
        QTest::newRow("418") << 418 << "answers with status 418";
        QTest::newRow("429") << 429 << "the server is busy (429)";
        QTest::newRow("500") << 500 << "the server failed (500)";
        QTest::newRow("503") << 503 << "the server is busy (503)";
    }
    void refusals()
    {
        QFETCH(const int, status);
        QFETCH(const QString, sentence);
        const QTemporaryDir home;
        const FaultyHttpServer server(
            content(), [&](const Request&, std::size_t, Reply& reply) { reply.become(status, page, "text/html"); });
        const auto file = RemoteFile::open(server.address("/a.tan?key=secret"), cacheIn(home), hasty());
        QVERIFY(!file.ok());
        const QString text = QString::fromStdString(file.error().text());
        QVERIFY2(text.contains(sentence) && text.contains("/a.tan'") && !text.contains("secret"), qPrintable(text));
        const bool isTriedAgain = status == 429 || status >= 500;
        QCOMPARE(server.requests().size(), std::size_t(isTriedAgain ? 3 : 1));
        QCOMPARE(isUnauthorized(file.error()), status == 401);
        // A limit of the server's, and no fault of the file.
        QCOMPARE(file.error().kind, status == 429 || status == 503 ? ErrorKind::OutOfResource : ErrorKind::BadInput);
    }

    /// A server says when to come again.
    void retryAfterIsKept()
    {
        const QTemporaryDir home;
        std::vector<Clock::time_point> times;
        const FaultyHttpServer server(content(), [&](const Request&, std::size_t number, Reply& reply) {
            if (number > 1)
                return;
            times.push_back(Clock::now());
            if (number == 1)
                return;
            reply.become(503, page, "text/html");
            reply.set("Retry-After", "1");
        });
        std::string problem;
        const auto file = RemoteFile::open(server.address(), cacheIn(home), hasty());
        QVERIFY(file);
        QCOMPARE(times.size(), std::size_t(2));
        QVERIFY(times[1] - times[0] >= std::chrono::seconds(1));
    }

    void aFileThatCannotBeSoLongIsRefused()
    {
        const QTemporaryDir home;
        const FaultyHttpServer server(content(), [&](const Request&, std::size_t, Reply& reply) {
            reply.set("Content-Range", "bytes 0-16383/1152921504606846975");
        });
        const auto file = RemoteFile::open(server.address(), cacheIn(home), hasty());
        QVERIFY(!file);
        QCOMPARE(file.error().kind, ErrorKind::BadInput);
        QVERIFY2(file.error().text().find("more than any model has") != std::string::npos, file.error().text().c_str());
    }

    /// Who wants a token has no use for a name and a password.
    void aTokenIsNoPassword()
    {
        for (const char* scheme : {"Bearer", "bearer realm=\"x\"", "Basic realm=\"bearer\"", "Bearers"}) {
            const QTemporaryDir home;
            const FaultyHttpServer server(content(), [&](const Request&, std::size_t, Reply& reply) {
                reply.become(401, "{}", "application/json");
                reply.set("WWW-Authenticate", scheme);
            });
            const auto file = RemoteFile::open(server.address("/a.tan"), cacheIn(home), hasty());
            QVERIFY(!file.ok() && isUnauthorized(file.error()));
            const bool wantsToken = QByteArray(scheme).toLower().startsWith("bearer") && scheme[6] != 's';
            QVERIFY(file.error().wants == (wantsToken ? Credential::Token : Credential::Password));
            QCOMPARE(file.error().file.string(), server.address("/a.tan"));
            QCOMPARE(file.error().text().find("a token") != std::string::npos, wantsToken);
            QCOMPARE(file.error().text().find("a name and a password") == std::string::npos, wantsToken);
        }
    }

    void aServerThatFailsOnce()
    {
        const QTemporaryDir home;
        const FaultyHttpServer server(content(), [](const Request&, std::size_t number, Reply& reply) {
            if (number % 2 == 0)
                reply.become(503, page, "text/html");
        });
        std::string problem;
        const auto file = RemoteFile::open(server.address(), cacheIn(home), hasty());
        QCOMPARE(wholeFile(file, problem), content());
        QCOMPARE(file->counts().breaks, 2u);
    }

    void noServerAndNoAddress()
    {
        const QTemporaryDir home;
        const CacheFolder cache = cacheIn(home);
        std::string nobody;
        {
            const FaultyHttpServer server(content());
            nobody = server.address();
            const auto unsafe = RemoteFile::open(server.address("/a.tan", "https://"), cache, hasty());
            QVERIFY2(unsafe.error().text().find("secure connection") != std::string::npos,
                     unsafe.error().text().c_str());
        }
        const auto none = RemoteFile::open(nobody, cache, hasty());
        QVERIFY2(none.error().text().find("nothing answers") != std::string::npos, none.error().text().c_str());
        QCOMPARE(none.error().kind, ErrorKind::BadInput);
        for (const char* wrong :
             {"model.tan", "file:///etc/passwd", "http://", "http://[x/", "http://a b/", "http://:"}) {
            const auto file = RemoteFile::open(wrong, cache, hasty());
            QVERIFY2(!file && file.error().kind == ErrorKind::WrongUsage &&
                         file.error().text().find("https://HOST/PATH") != std::string::npos,
                     wrong);
        }
    }

    void anEmptyFile()
    {
        const QTemporaryDir home;
        const FaultyHttpServer server("");
        const auto file = RemoteFile::open(server.address(), cacheIn(home), hasty());
        QVERIFY2(!file && file.error().text().find("the file is empty") != std::string::npos, "");
    }

    void aSmallFile()
    {
        const QTemporaryDir home;
        const FaultyHttpServer server("TAN");
        std::string problem;
        QCOMPARE(wholeFile(RemoteFile::open(server.address(), cacheIn(home), hasty()), problem), std::string("TAN"));
    }

    /// The address that a redirection leads to is asked from then on, and the first one again when that has its time.
    void redirectionsAreFollowed()
    {
        const QTemporaryDir home;
        std::atomic<int> key = 0;
        FaultyHttpServer server(content(), [&](const Request& request, std::size_t, Reply& reply) {
            if (request.path == "/model.tan") {
                reply.become(307, "", "text/plain");
                reply.set("Location", "/store?key=" + std::to_string(++key));
            } else if (request.path != "/store?key=" + std::to_string(key)) {
                reply.become(403, "", "text/plain");
            }
        });
        const auto file = RemoteFile::open(server.address(), cacheIn(home), hasty());
        QVERIFY(file.ok());
        QCOMPARE(file->counts().requests, 2u);
        QCOMPARE(file->counts().roundTrips, 2u);
        server.forget();
        QVERIFY(fetchFrom(*file, {{20 * piece, 1}}).ok());
        QCOMPARE(server.requests().size(), std::size_t(1));
        ++key;
        std::string problem;
        QCOMPARE(wholeFile(file, problem), content());
    }

    void nameAndPassword()
    {
        const QTemporaryDir home;
        const FaultyHttpServer server(content(), [](const Request& request, std::size_t, Reply& reply) {
            if (request.authorization.empty())
                reply.become(401, "", "text/plain");
        });
        const CacheFolder cache = cacheIn(home);
        std::string problem;
        const auto file = RemoteFile::open(server.address("/m.tan", "http://me:secret@"), cache, hasty());
        QCOMPARE(wholeFile(file, problem), content());
        std::ifstream kept(cacheFileOf(cache), std::ios::binary);
        const std::string bytes{std::istreambuf_iterator<char>(kept), {}};
        QVERIFY(bytes.find("/m.tan") != std::string::npos && bytes.find("secret") == std::string::npos);
    }

    /// What broke off goes on from there.
    void aBreakCostsLittle()
    {
        const QTemporaryDir home;
        const FaultyHttpServer server(content(), [](const Request&, std::size_t number, Reply& reply) {
            if (number == 1)
                reply.cutAt = 20 * piece + 5000;
        });
        const auto file = RemoteFile::open(server.address(), cacheIn(home), hasty());
        std::string problem;
        QCOMPARE(wholeFile(file, problem), content());
        QCOMPARE(server.requests().size(), std::size_t(3));
        QVERIFY(server.requests()[1].first == piece && server.requests()[2].first == 21 * piece);
        QVERIFY(file->counts().bytes <= content().size() + piece);
        QCOMPARE(file->counts().breaks, 1u);
    }

    void cancelledWithinASecond()
    {
        const QTemporaryDir home;
        const FaultyHttpServer server(
            content(), [](const Request&, std::size_t number, Reply& reply) { reply.isSilent = number > 0; });
        const auto file = RemoteFile::open(server.address(), cacheIn(home));
        QVERIFY(file.ok());
        std::stop_source stop;
        std::vector<std::jthread> readers; // the second waits for the first one's network
        std::atomic<int> cancelled = 0;
        for (int reader = 0; reader < 2; ++reader)
            readers.emplace_back([&] {
                std::string bytes(10, '\0');
                const Status read = readInto(*file, 30 * piece, bytes, Progress(stop.get_token(), {}));
                cancelled += !read && read.error().kind == ErrorKind::Cancelled;
            });
        while (server.requests().size() < 2)
            std::this_thread::sleep_for(1ms);
        const auto begin = Clock::now();
        stop.request_stop();
        readers.clear();
        QCOMPARE(cancelled.load(), 2);
        QVERIFY(Clock::now() - begin < std::chrono::milliseconds(soon(1000)));
    }

    void aLimitOfTheRate()
    {
        const QTemporaryDir home;
        const FaultyHttpServer server(content());
        RemoteOptions options = hasty();
        options.bytesPerSecond = 500'000;
        const auto file = RemoteFile::open(server.address(), cacheIn(home), options);
        const auto begin = Clock::now();
        std::string problem;
        QCOMPARE(wholeFile(file, problem), content());
        const auto took = std::chrono::duration_cast<std::chrono::milliseconds>(Clock::now() - begin);
        QVERIFY2(took > 600ms, qPrintable(QString::number(took.count()))); // 1.3 s by the rate
    }

    /// Progress never decreases, and ends at 1.
    void progressIsReported()
    {
        const QTemporaryDir home;
        const FaultyHttpServer server(content());
        const auto file = RemoteFile::open(server.address(), cacheIn(home));
        double last = 0;
        bool isRising = true;
        const Progress progress({}, [&](double fraction, const Message&) {
            isRising = isRising && fraction >= last;
            last = fraction;
        });
        QVERIFY(fetchFrom(*file, {{0, content().size()}}, progress).ok());
        QVERIFY(isRising && last == 1);
    }

    /// What came is there the next time, and where the file on the server is another one, nothing of it.
    void theCacheOfTheLastTime()
    {
        const QTemporaryDir home;
        const CacheFolder cache = cacheIn(home);
        FaultyHttpServer server(content());
        std::string problem;
        QCOMPARE(wholeFile(RemoteFile::open(server.address(), cache), problem), content());
        const auto again = RemoteFile::open(server.address(), cache);
        QCOMPARE(wholeFile(again, problem), content());
        QCOMPARE(again->counts().requests, 1u);
        const std::string other(content().rbegin(), content().rend());
        server.replace(other, "\"second\"");
        const auto changed = RemoteFile::open(server.address(), cache);
        QCOMPARE(wholeFile(changed, problem), other);
        QVERIFY(changed->state() != again->state());
    }

    /// Bytes that were wrong when they came, which only their reader can know.
    void whatIsForgottenIsFetchedAgain()
    {
        const QTemporaryDir home;
        const CacheFolder cache = cacheIn(home);
        std::atomic<bool> isDamaging = true;
        const FaultyHttpServer server(content(), [&](const Request&, std::size_t, Reply& reply) {
            if (isDamaging)
                reply.body.back() ^= 1;
        });
        const auto file = RemoteFile::open(server.address(), cache);
        std::string problem;
        QVERIFY(wholeFile(file, problem) != content());
        isDamaging = false;
        QVERIFY(wholeFile(RemoteFile::open(server.address(), cache), problem) != content());
        file->forget();
        QCOMPARE(wholeFile(file, problem), content());
        const auto again = RemoteFile::open(server.address(), cache);
        QCOMPARE(wholeFile(again, problem), content());
        QCOMPARE(again->counts().requests, 1u);
    }

    void withoutETagAndDate()
    {
        const QTemporaryDir home;
        const CacheFolder cache = cacheIn(home);
        const FaultyHttpServer server(content(), [](const Request&, std::size_t, Reply& reply) {
            reply.remove("ETag");
            reply.remove("Last-Modified");
        });
        {
            const auto file = RemoteFile::open(server.address(), cache);
            std::string problem;
            QCOMPARE(wholeFile(file, problem), content());
            QVERIFY(file->state().empty());
        }
        QCOMPARE(cache.bytes(), 0u);
    }

    /// Changed within the second in which it is read, it may be changed again and keep its date.
    void aDateOfThisSecondTellsNoChanges()
    {
        const QTemporaryDir home;
        const CacheFolder cache = cacheIn(home);
        for (const bool isPast : {false, true}) {
            const FaultyHttpServer server(content(), [&](const Request&, std::size_t, Reply& reply) {
                reply.remove("ETag");
                reply.set("Date", isPast ? "Wed, 01 Oct 2025 10:00:01 GMT" : FaultyHttpServer::date);
            });
            {
                const auto file = RemoteFile::open(server.address(), cache);
                std::string problem;
                QCOMPARE(wholeFile(file, problem), content());
                QCOMPARE(file->state().empty(), !isPast);
            }
            QCOMPARE(cache.bytes() == 0, !isPast);
        }
    }

    /// What libcurl refuses to be set to has nothing to do with memory.
    void refusedSettingsAreTold()
    {
        const QTemporaryDir home;
        const FaultyHttpServer server(content());
        const QByteArray before = qgetenv("SSL_CERT_FILE");
        qputenv("SSL_CERT_FILE", QByteArray(9'000'000, 'x')); // more than libcurl takes of any text
        const auto file = RemoteFile::open(server.address(), cacheIn(home));
        const auto answer = fetchOnce(server.address(), "", {"text/plain", 1000});
        before.isNull() ? qunsetenv("SSL_CERT_FILE") : qputenv("SSL_CERT_FILE", before);
        QVERIFY(!file.ok() && !answer.ok());
        for (const Error& error : {file.error(), answer.error()}) {
            QCOMPARE(error.kind, ErrorKind::OutOfResource);
            QVERIFY2(error.text().find("does not support what TAn needs (") != std::string::npos, error.text().c_str());
        }
    }

    void aWeakETagGoesByTheDate()
    {
        const QTemporaryDir home;
        const FaultyHttpServer server(
            content(), [](const Request&, std::size_t, Reply& reply) { reply.set("ETag", "W/\"weak\""); });
        std::string problem;
        QCOMPARE(wholeFile(RemoteFile::open(server.address(), cacheIn(home)), problem), content());
        QCOMPARE(server.requests()[1].ifRange, std::string(FaultyHttpServer::date));
    }

    /// A disk that gives other bytes than were written: the pieces are fetched again.
    void damageOnTheDisk()
    {
        const QTemporaryDir home;
        const CacheFolder cache = cacheIn(home);
        const FaultyHttpServer server(content());
        std::string problem;
        QCOMPARE(wholeFile(RemoteFile::open(server.address(), cache), problem), content());
        const std::string path = cacheFileOf(cache);
        std::mt19937 random(3);
        for (int turn = 0; turn < 20; ++turn) {
            const std::size_t size = std::filesystem::file_size(path);
            std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
            const std::size_t at = turn < 5 ? random() % 200 : random() % size; // the head, too
            file.seekg(static_cast<std::streamoff>(at));
            const char byte = static_cast<char>(file.get() ^ (1 << random() % 8));
            file.seekp(static_cast<std::streamoff>(at));
            file.put(byte);
            file.close();
            const auto opened = RemoteFile::open(server.address(), cache);
            QCOMPARE(wholeFile(opened, problem) == content(), true);
            std::string bytes(content().size(), '\0');
            QVERIFY(readInto(*opened, 0, bytes).ok() && bytes == content());
        }
        std::filesystem::resize_file(path, std::filesystem::file_size(path) / 2);
        QCOMPARE(wholeFile(RemoteFile::open(server.address(), cache), problem) == content(), true);
    }

    void twoProcessesAtOnce()
    {
        const QTemporaryDir home;
        const CacheFolder cache = cacheIn(home);
        const FaultyHttpServer server(content());
        std::vector<pid_t> processes;
        for (unsigned process = 0; process < 3; ++process) {
            const pid_t child = ::fork();
            if (child == 0) {
                std::mt19937 random(process);
                const auto file = RemoteFile::open(server.address(), cache);
                bool isRight = file.ok();
                for (int turn = 0; turn < 100 && isRight; ++turn) {
                    const std::size_t offset = random() % (content().size() - 20'000);
                    std::string bytes(20'000, '\0');
                    isRight = readInto(*file, offset, bytes).ok() && bytes == content().substr(offset, bytes.size());
                }
                ::_exit(isRight ? 0 : 1);
            }
            processes.push_back(child);
        }
        for (const pid_t process : processes) {
            int status = 1;
            QCOMPARE(::waitpid(process, &status, 0), process);
            QVERIFY(WIFEXITED(status) && WEXITSTATUS(status) == 0);
        }
        std::string problem;
        QCOMPARE(wholeFile(RemoteFile::open(server.address(), cache), problem), content());
        QVERIFY(!cacheFileOf(cache).empty());
    }

    /// Old files make room for new ones; one that alone is larger than the limit is told.
    void theLimitOfTheCache()
    {
        const QTemporaryDir home;
        const CacheFolder cache = cacheIn(home, 1024 * kibibyte);
        const FaultyHttpServer server(content());
        std::string problem;
        for (const char* path : {"/a", "/b", "/c"})
            QCOMPARE(wholeFile(RemoteFile::open(server.address(path), cache), problem), content());
        QVERIFY(cache.bytes() <= cache.limit());

        const QTemporaryDir small;
        const CacheFolder smallCache = cacheIn(small, 300 * kibibyte);
        const auto file = RemoteFile::open(server.address(), smallCache);
        QVERIFY(wholeFile(file, problem).empty());
        QVERIFY2(problem.find("has no room") != std::string::npos && problem.find("TAN_CACHE_MB") != std::string::npos,
                 problem.c_str());
        QVERIFY(smallCache.bytes() <= smallCache.limit());
        std::string bytes(10, '\0');
        QVERIFY(readInto(*file, 5, bytes).ok() && bytes == content().substr(5, 10));
    }

    void aFullDisk()
    {
        const QTemporaryDir home;
        const CacheFolder cache = cacheIn(home);
        const FaultyHttpServer server(content());
        const auto file = RemoteFile::open(server.address(), cache);
        QVERIFY(file.ok());
        rlimit before{};
        QCOMPARE(::getrlimit(RLIMIT_FSIZE, &before), 0);
        rlimit low = before;
        low.rlim_cur = 10 * piece;
        QCOMPARE(::setrlimit(RLIMIT_FSIZE, &low), 0);
        std::string problem;
        const std::string bytes = wholeFile(file, problem);
        QCOMPARE(::setrlimit(RLIMIT_FSIZE, &before), 0);
        QVERIFY2(bytes.empty() && problem.find("Cannot write '") == 0 && problem.find("ulimit -f") != std::string::npos,
                 problem.c_str());
        QCOMPARE(wholeFile(file, problem), content());

        const SmallDisk disk(400 * kibibyte);
        if (!disk.ok()) // needs the right to mount
            return;
        const auto there = CacheFolder::open(disk.folder() / "tan");
        QVERIFY(there.ok());
        {
            const auto small = RemoteFile::open(server.address("/small"), *there);
            QVERIFY(fetchFrom(*small, {{0, 10 * piece}}).ok());
        }
        // What is not in use makes room on a full disk, too.
        QVERIFY(fetchFrom(*RemoteFile::open(server.address("/other"), *there), {{0, 20 * piece}}).ok());
        QVERIFY(wholeFile(RemoteFile::open(server.address(), *there), problem).empty());
        QVERIFY2(problem.find("No space left on device") != std::string::npos, problem.c_str());
    }
};

QTEST_APPLESS_MAIN(RemoteFileTest)
#include "remote_file_test.moc"
