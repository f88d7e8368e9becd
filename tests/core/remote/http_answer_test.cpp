// SPDX-License-Identifier: GPL-3.0-or-later
// What of HTTP answers is read here (R28, B5).
#include "core/remote/http_answer.h"

#include <QTest>

using namespace tetra;

namespace {

std::optional<ContentRange> part(std::uint64_t first, std::uint64_t last, std::optional<std::uint64_t> total)
{
    return ContentRange{first, last, total};
}

HttpAnswer answerOf(std::string_view head)
{
    HttpAnswer answer;
    while (!head.empty()) {
        const std::size_t end = std::min(head.find('\n'), head.size() - 1) + 1;
        takeHeaderLine(answer, head.substr(0, end));
        head.remove_prefix(end);
    }
    return answer;
}

bool isPage(std::string_view type, std::string_view start)
{
    HttpAnswer answer;
    answer.contentType = type;
    return isWebPage(answer, std::as_bytes(std::span(start)));
}

} // namespace

class HttpAnswerTest : public QObject {
    Q_OBJECT

private slots:
    void contentRanges()
    {
        QVERIFY(parseContentRange("bytes 0-16383/1400000") == part(0, 16383, 1400000));
        QVERIFY(parseContentRange(" Bytes 5-5/6 ") == part(5, 5, 6));
        QVERIFY(parseContentRange("bytes 0-9/*") == part(0, 9, {}));
        QVERIFY(parseContentRange("bytes */7") == (ContentRange{{}, {}, 7}));
        for (const char* wrong :
             {"", "bytes", "bytes ", "bytes */*", "bytes 0-9", "bytes 9-0/20", "bytes 0-20/20", "bytes -9/20",
              "bytes 0-/20", "bytes +0-9/20", "bytes 0-9/-20", "items 0-9/20", "bytes 0-9/20/30", "bytes 0x1-9/20",
              "bytes 0-99999999999999999999/999999999999999999999", "bytes 0-9,20-29/40"})
            QVERIFY2(!parseContentRange(wrong), wrong);
    }

    void headsOfAnswers()
    {
        const HttpAnswer answer = answerOf("HTTP/1.1 302 Found\r\nETag: \"of the page\"\r\nLocation: /other\r\n\r\n"
                                           "HTTP/2 206 \r\ncontent-RANGE: bytes 0-9/20\r\nContent-Length: 10\r\n"
                                           "Content-Type: Application/Octet-Stream; charset=x\r\n"
                                           "ETag: W/\"weak\"\r\nLast-Modified: Wed, 01 Oct 2025 10:00:00 GMT\r\n\r\n");
        QCOMPARE(answer.status, 206);
        QVERIFY(answer.contentRange == part(0, 9, 20));
        QVERIFY(answer.contentLength == 10u);
        QCOMPARE(answer.contentType, std::string("application/octet-stream"));
        QCOMPARE(answer.entityTag, std::string("W/\"weak\""));
        QCOMPARE(answer.validator(), std::string_view("Wed, 01 Oct 2025 10:00:00 GMT"));
        QCOMPARE(answerOf("HTTP/1.1 200 OK\nETag: \"strong\"\n").validator(), std::string_view("\"strong\""));
        QCOMPARE(answerOf("HTTP/1.1 200 OK\n").validator(), std::string_view());
        QVERIFY(answer.isWhole && !answerOf("HTTP/1.1 200 OK\r\nETag: \"cut").isWhole);
        QVERIFY(answerOf("HTTP/1.1 206 x\n\nETag: \"behind\"\n").entityTag.empty());
    }

    /// A file that was changed within the second of the answer may be changed again and keep its date.
    void aDateTellsChangesWhenItIsPast()
    {
        const auto tells = [](const std::string& changed, const std::string& answered, const char* tag = "") {
            std::string head = "HTTP/1.1 206 x\n";
            head += *tag != '\0' ? std::string("ETag: ") + tag + "\n" : "";
            head += changed.empty() ? "" : "Last-Modified: " + changed + "\n";
            head += answered.empty() ? "" : "Date: " + answered + "\n";
            return answerOf(head).tellsChanges();
        };
        const std::string second = "Wed, 01 Oct 2025 10:00:00 GMT";
        QVERIFY(!tells(second, second));
        QVERIFY(tells(second, "Wed, 01 Oct 2025 10:00:01 GMT"));
        QVERIFY(tells(second, "Thu, 01 Jan 2026 00:00:00 GMT"));
        QVERIFY(!tells("Thu, 01 Jan 2026 00:00:00 GMT", second)); // its clock is wrong
        QVERIFY(tells("Mon, 29 Feb 2024 23:59:59 GMT", "Fri, 01 Mar 2024 00:00:00 GMT"));
        QVERIFY(tells(second, second, "\"strong\""));
        QVERIFY(!tells(second, second, "W/\"weak\""));
        QVERIFY(tells(second, "")); // a server without a clock
        QVERIFY(!tells("yesterday", "yesterday"));
        QVERIFY(!tells("", second));
    }

    void whatIsWrongInAHeadIsLeftOut()
    {
        QVERIFY(!answerOf("HTTP/1.1 206 x\nContent-Range: bytes 0-9/20\nContent-Range: bytes 5-9/20\n").contentRange);
        QVERIFY(!answerOf("HTTP/1.1 206 x\nContent-Length: 1e9\n").contentLength);
        QVERIFY(answerOf("HTTP/1.1 206 x\nETag: \"" + std::string(2000, 'a') + "\"\n").entityTag.empty());
        QVERIFY(answerOf("HTTP/1.1 206 x\nETag: \"a\x01\"\n").entityTag.empty());
        for (const char* line : {"HTTP/1.1", "HTTP/1.1 ", "HTTP/1.1 99 x", "HTTP/1.1 1000", "HTTP/1.1 +200 x"})
            QCOMPARE(answerOf(line).status, 0);
    }

    void pagesInPlaceOfData()
    {
        QVERIFY(isPage("text/html", "TAN"));
        QVERIFY(isPage("application/json", "{\"models\": []}"));
        QVERIFY(isPage("application/xml", "<ListBucketResult>"));
        QVERIFY(isPage("application/octet-stream", "\n\n<!DOCTYPE html><title>Log in</title>"));
        QVERIFY(isPage("", "<HTML lang=de>"));
        QVERIFY(!isPage("application/octet-stream", "TAN <html>"));
        QVERIFY(!isPage("", ""));
    }
};

QTEST_APPLESS_MAIN(HttpAnswerTest)
#include "http_answer_test.moc"
