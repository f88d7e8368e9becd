// SPDX-License-Identifier: GPL-3.0-or-later
// Messages: what they say in English, and that what they are made of can be taken apart and put together again.
#include <tan/base.h>

#include <QTest>

using namespace tetra;

// What would be shown as a number and is none, and a question that has two answers, are not compiled.
static_assert(std::constructible_from<Message, int> && std::constructible_from<Message, std::uint8_t>);
static_assert(!std::constructible_from<Message, bool> && !std::constructible_from<Message, char>);
static_assert(!std::constructible_from<Message, char8_t> && !std::constructible_from<Message, wchar_t>);
static_assert(std::constructible_from<bool, Result<int>> && std::constructible_from<bool, Status>);
static_assert(!std::constructible_from<bool, Result<bool>>);

class MessageTest : public QObject {
    Q_OBJECT
private slots:
    void textsStayWhatTheyAre()
    {
        QCOMPARE(Message("100 %").text(), std::string("100 %"));
        QCOMPARE(Message(std::string("a%1b")).text(), std::string("a%1b"));
        QCOMPARE(Message(std::uint64_t(18446744073709551615u)).text(), std::string("18446744073709551615"));
        QCOMPARE(Message(-3).text(), std::string("-3"));
        QVERIFY(Message("a name").sentence().empty());
        QVERIFY(Message().text().empty());
    }

    void placesAreFilled()
    {
        const Message message = Message::say("%2 of %1 are at 5 %, the rest (%1) is not.", 7, "some");
        QCOMPARE(message.text(), std::string("some of 7 are at 5 %, the rest (7) is not."));
        QCOMPARE(message.sentence(), std::string("%2 of %1 are at 5 %, the rest (%1) is not."));
        QCOMPARE(message.arguments().size(), std::size_t(2));
        QCOMPARE(Message::say("Nothing to fill.").text(), std::string("Nothing to fill."));
    }

    /// What stands in a place is not looked at again.
    void argumentsAreNoSentences()
    {
        QCOMPARE(Message::say("'%1' and '%2'", "%2", "%1").text(), std::string("'%2' and '%1'"));
    }

    void placesWithoutArgumentsStay()
    {
        QCOMPARE(Message::say("%1 and %2%", "one").text(), std::string("one and %2%"));
        QCOMPARE(Message::say("%", "one").text(), std::string("%"));
        QCOMPARE(Message::say("%0 %a %%1", "one").text(), std::string("%0 %a %one"));
    }

    void messagesStandInMessages()
    {
        const Message inner = Message::say("it has %1 bytes", 12);
        const Error error{ErrorKind::BadInput, Message::say("Cannot read '%1': %2.", "a.raw", inner)};
        QCOMPARE(error.text(), std::string("Cannot read 'a.raw': it has 12 bytes."));
        QCOMPARE(error.message.arguments()[1].sentence(), std::string("it has %1 bytes"));
        const Message again = Message::of(error.message.sentence(), error.message.arguments());
        QCOMPARE(again.text(), error.text());
    }

    /// Whoever passes an error on asks its fields and not its words.
    void errorsNameWhatTheySpeakOf()
    {
        const Error error{ErrorKind::BadInput, Message::say("'%1' is empty.", "a.raw"), "a.raw"};
        QCOMPARE(error.file, std::filesystem::path("a.raw"));
        QVERIFY(cancelledError("Reading").file.empty());
        QVERIFY(error.wants == Credential::None);
    }
};

QTEST_GUILESS_MAIN(MessageTest)
#include "message_test.moc"
