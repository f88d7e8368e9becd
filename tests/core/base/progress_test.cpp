// SPDX-License-Identifier: GPL-3.0-or-later
// Progress is told in order and in parts, and every request to cancel is heard, however deep the work.
#include "core/base/progress.h"

#include <QTest>

#include <stdexcept>
#include <vector>

using namespace tetra;

class ProgressTest : public QObject {
    Q_OBJECT

private slots:
    void partsOfPartsCoverTheWhole()
    {
        std::vector<double> told;
        const Progress whole({}, [&](double fraction, const Message&) { told.push_back(fraction); });
        const Progress part = whole.part(0.5, 1).part(0, 0.5);
        part.report(0, "Working");
        part.report(1, "Working");
        QCOMPARE(told, (std::vector<double>{0.5, 0.75}));
    }

    void everyRequestIsHeard()
    {
        for (int asking = 0; asking < 3; ++asking) {
            std::stop_source sources[3];
            const Progress progress = Progress(sources[0].get_token(), {})
                                          .alsoCancelledBy(sources[1].get_token())
                                          .alsoCancelledBy(sources[2].get_token());
            const Progress within = progress.part(0, 0.5).withCallback({});
            QVERIFY(!progress.cancelled() && !within.cancelled());
            sources[asking].request_stop();
            QVERIFY(progress.cancelled());
            QVERIFY(within.cancelled());
        }
    }

    /// Pieces of a piece stop when a piece beside that one fails.
    void failuresReachWhatIsWithin()
    {
        FirstFailure outer, inner;
        const Progress within = inner.watching(outer.watching({}));
        QVERIFY(!within.cancelled());
        outer.run([] { return Status(Error{ErrorKind::BadInput, "no good"}); });
        QVERIFY(within.cancelled());
        QVERIFY(!inner.happened());
        QCOMPARE(outer.status().error().text(), std::string("no good"));
        QVERIFY_EXCEPTION_THROWN(inner.run([]() -> Status { throw std::runtime_error("worse"); }), std::runtime_error);
        QVERIFY(inner.happened());
        QVERIFY(inner.status().ok());
    }

    void sharedPiecesAddUp()
    {
        std::vector<double> told;
        const Progress whole({}, [&](double fraction, const Message&) { told.push_back(fraction); });
        SharedProgress shared(whole, 4, "Working");
        const auto first = shared.piece(1), second = shared.piece(3);
        first(0.5, "");
        second(1, "");
        first(1, "");
        QCOMPARE(told, (std::vector<double>{0.125, 0.875, 1}));
    }
};

QTEST_APPLESS_MAIN(ProgressTest)
#include "progress_test.moc"
