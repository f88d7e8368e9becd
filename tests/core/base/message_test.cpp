// SPDX-License-Identifier: GPL-3.0-or-later
// Messages: what they say in English, and that what they are made of can be taken apart and put together again.
#include <tan/base.h>

#include <QTest>

using namespace tetra;

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
};

QTEST_GUILESS_MAIN(MessageTest)
#include "message_test.moc"
