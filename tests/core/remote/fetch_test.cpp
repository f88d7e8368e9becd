// SPDX-License-Identifier: GPL-3.0-or-later
// One question to a server: what it may send, and how long it may take.
#include "core/remote/fetch.h"

#include "core/remote/transfer_error.h"
#include "tests/core/remote/http_server.h"

#include <QTest>

#include <chrono>
#include <string>
#include <thread>
#include <vector>

using namespace tetra;
using namespace std::chrono_literals;

namespace {

using Request = FaultyHttpServer::Request;
using Reply = FaultyHttpServer::Reply;
using Clock = std::chrono::steady_clock;

constexpr const char* wanted = "application/vnd.tan.mesh";

FetchLimits limits(std::uint64_t mostBytes = 1 << 20)
{
    FetchLimits some{wanted, mostBytes};
    some.thinking = some.silence = 20s;
    return some;
}

} // namespace

class FetchTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        for (const char* name : {"http_proxy", "all_proxy", "HTTP_PROXY", "ALL_PROXY"})
            qunsetenv(name);
    }

    void theWholeIsTaken()
    {
        const std::string body(300'000, 'm');
        const FaultyHttpServer server(
            "", [&](const Request&, std::size_t, Reply& reply) { reply.become(200, body, wanted); });
        const auto answer = fetchOnce(server.address(), "", limits());
        QVERIFY(answer);
        QCOMPARE(answer->status, 200);
        QCOMPARE(answer->contentType, std::string(wanted));
        QCOMPARE(answer->content.size(), body.size());
    }

    /// Of a page, a list or a refusal, which may have no end, the beginning is enough.
    void ofAnythingElseTheBeginningIsTaken_data()
    {
        QTest::addColumn<int>("status");
        QTest::addColumn<QByteArray>("type");
        QTest::newRow("a page") << 200 << QByteArray("text/html");
        QTest::newRow("no type") << 200 << QByteArray("");
        QTest::newRow("a refusal") << 404 << QByteArray("application/json");
        QTest::newRow("a refusal of the type") << 500 << QByteArray(wanted);
    }
    void ofAnythingElseTheBeginningIsTaken()
    {
        QFETCH(int, status);
        QFETCH(QByteArray, type);
        const FaultyHttpServer server("", [&](const Request&, std::size_t, Reply& reply) {
            reply.become(status, std::string(8 << 20, 'x'), type.toStdString());
            reply.set("Content-Length", "1000000000000"); // more than comes
        });
        const auto answer = fetchOnce(server.address(), "", limits(std::uint64_t(1) << 40));
        QVERIFY2(answer, answer ? "" : answer.error().text().c_str());
        QCOMPARE(answer->status, status);
        QCOMPARE(answer->content.size(), std::size_t(64 << 10));
    }

    void tooMuchIsRefused_data()
    {
        QTest::addColumn<QByteArray>("announced");
        QTest::newRow("as much as announced") << QByteArray("2000000");
        QTest::newRow("announced, and not sent") << QByteArray("1000000000000000");
        QTest::newRow("not announced") << QByteArray();
        QTest::newRow("no number that there is") << QByteArray("100000000000000000000000");
    }
    void tooMuchIsRefused()
    {
        QFETCH(QByteArray, announced);
        const FaultyHttpServer server("", [&](const Request&, std::size_t, Reply& reply) {
            const std::string length = announced.isEmpty() ? "" : "Content-Length: " + announced.toStdString() + "\r\n";
            reply.raw = "HTTP/1.1 200 OK\r\nContent-Type: " + std::string(wanted) + "\r\n" + length + "\r\n" +
                        std::string(2'000'000, 'm');
        });
        const auto answer = fetchOnce(server.address(), "", limits());
        QVERIFY(!answer);
        QCOMPARE(answer.error().kind, ErrorKind::OutOfResource);
        QVERIFY2(answer.error().text().find("sends more than 2 MB") != std::string::npos,
                 answer.error().text().c_str());
    }

    /// Each wait by itself would last for ever.
    void silenceEnds()
    {
        const auto refusal = [](const FaultyHttpServer::Change& change, FetchLimits given) {
            const FaultyHttpServer server("", change);
            const auto answer = fetchOnce(server.address(), "", given);
            return answer ? std::string("an answer") : answer.error().text();
        };
        FetchLimits brief = limits(), dripping = limits();
        brief.thinking = 100ms;
        dripping.silence = 100ms;
        std::string silent, dripped;
        {
            const std::jthread first([&] {
                silent = refusal([](const Request&, std::size_t, Reply& reply) { reply.isSilent = true; }, brief);
            });
            const std::jthread second([&] {
                dripped = refusal(
                    [](const Request&, std::size_t, Reply& reply) {
                        reply.become(200, std::string(100'000, 'm'), wanted);
                        reply.perByte = 10ms;
                    },
                    dripping);
            });
        }
        QVERIFY2(silent.find("does not answer: nothing arrived for 0.1 seconds") != std::string::npos, silent.c_str());
        QVERIFY2(dripped.find("does not answer: nothing arrived for 0.1 seconds") != std::string::npos,
                 dripped.c_str());
    }

    void whoThinksForLongIsWaitedFor()
    {
        const FaultyHttpServer server("", [&](const Request&, std::size_t, Reply& reply) {
            reply.become(200, "mesh", wanted);
            reply.before = 300ms;
        });
        FetchLimits given = limits();
        given.silence = 1ms; // that counts once something has come
        const auto answer = fetchOnce(server.address(), "", given);
        QVERIFY2(answer, answer ? "" : answer.error().text().c_str());
        QCOMPARE(answer->content.size(), std::size_t(4));
    }

    void aBusyServerIsAskedAgain_data()
    {
        QTest::addColumn<int>("status");
        QTest::newRow("503") << 503;
        QTest::newRow("429") << 429;
    }
    void aBusyServerIsAskedAgain()
    {
        QFETCH(int, status);
        const FaultyHttpServer server("", [&](const Request&, std::size_t number, Reply& reply) {
            reply.become(number < 2 ? status : 200, number < 2 ? "{\"error\": \"busy\"}" : "mesh",
                         number < 2 ? "application/json" : wanted);
            reply.set("Retry-After", "0");
        });
        const auto answer = fetchOnce(server.address(), "", limits());
        QVERIFY(answer);
        QCOMPARE(answer->status, 200);
        QCOMPARE(server.requests().size(), std::size_t(3));
    }

    void aServerThatStaysBusySaysSo()
    {
        const FaultyHttpServer server("", [&](const Request&, std::size_t, Reply& reply) {
            reply.become(503, "{\"error\": \"busy\"}", "application/json");
            reply.set("Retry-After", "0");
        });
        const auto answer = fetchOnce(server.address(), "", limits());
        QVERIFY(answer);
        QCOMPARE(answer->status, 503);
        QCOMPARE(server.requests().size(), std::size_t(1 + limits().retries));
    }

    void waitingForItsTurnIsCancelled()
    {
        const FaultyHttpServer server("", [&](const Request&, std::size_t, Reply& reply) {
            reply.become(503, "", "application/json");
            reply.set("Retry-After", "3600");
        });
        std::stop_source source;
        const Progress progress(source.get_token(), [&](double, const Message& activity) {
            if (activity.text() == "Waiting for the server" && !server.requests().empty())
                source.request_stop();
        });
        const auto answer = fetchOnce(server.address(), "", limits(), progress);
        QVERIFY(!answer);
        QCOMPARE(answer.error().kind, ErrorKind::Cancelled);
    }

    /// Every error of libcurl has a sentence, the same for files and for questions.
    void errorsAreToldInOneWay()
    {
        for (int code = CURLE_OK + 1; code < CURL_LAST; ++code)
            if (code != CURLE_OUT_OF_MEMORY) {
                const Refusal refusal = refusedTransfer(static_cast<CURLcode>(code), "\x1b[31m", 0);
                QVERIFY(refusal.reason.text().ends_with('.'));
                QVERIFY(refusal.reason.text().find('\x1b') == std::string::npos);
            }
        for (int code = CURLE_OK + 1; code < CURL_LAST; ++code)
            if (code != CURLE_OUT_OF_MEMORY)
                QCOMPARE(refusedSettings(static_cast<CURLcode>(code)).kind, ErrorKind::OutOfResource);
        const auto endless = fetchOnce("http://127.0.0.1:1/" + std::string(1 << 20, 'x'), "", limits());
        QVERIFY(!endless && endless.error().kind == ErrorKind::WrongUsage && endless.error().text().size() < 20'000);
        const auto nowhere = fetchOnce("http://127.0.0.1:1/x.tan", "", limits());
        QVERIFY(!nowhere);
        QCOMPARE(nowhere.error().text(), std::string("'http://127.0.0.1:1/x.tan' does not answer: nothing answers at "
                                                     "that host and port. Check the address and the network."));
    }
};

QTEST_GUILESS_MAIN(FetchTest)
#include "fetch_test.moc"
