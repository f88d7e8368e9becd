// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/guarded.h"

#include <QTest>

#include <new>
#include <stdexcept>

using namespace tetra;

class GuardedTest : public QObject {
    Q_OBJECT

private slots:
    void whatWorksIsReturned()
    {
        const auto half = [](int number) -> Result<int> {
            if (number % 2 != 0)
                return Error{ErrorKind::WrongUsage, "odd"};
            return number / 2;
        };
        QCOMPARE(*guarded(Message::marked("No memory."), [&] { return half(6); }), 3);
        const Result<int> odd = guarded(Message::marked("No memory."), [&] { return half(5); });
        QVERIFY(!odd && odd.error().kind == ErrorKind::WrongUsage);
        QCOMPARE(odd.error().text(), std::string("odd"));
        QVERIFY(guarded(Message::marked("No memory."), [] { return Status(); }));
    }

    /// As a sentence with places, which can be translated.
    void missingMemoryIsAnError()
    {
        const std::string name = "a.tan";
        const Status status = guarded(
            Message::marked("No memory for '%1' after %2 sites."), []() -> Status { throw std::bad_alloc(); }, name,
            7u);
        QVERIFY(!status && status.error().kind == ErrorKind::OutOfResource);
        QCOMPARE(status.error().text(), std::string("No memory for 'a.tan' after 7 sites."));
        QCOMPARE(status.error().message.sentence(), std::string("No memory for '%1' after %2 sites."));
        QCOMPARE(status.error().message.arguments().size(), std::size_t(2));
    }

    void othersPass()
    {
        QVERIFY_EXCEPTION_THROWN(
            (void)guarded(Message::marked("No memory."), []() -> Status { throw std::logic_error("a mistake"); }),
            std::logic_error);
    }
};

QTEST_APPLESS_MAIN(GuardedTest)
#include "guarded_test.moc"
