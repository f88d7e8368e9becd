// SPDX-License-Identifier: GPL-3.0-or-later
// What a check says does not depend on which thread found what first.
#include "core/verify/findings.h"

#include <QTest>

#include <algorithm>

using namespace tetra;

class FindingsTest : public QObject {
    Q_OBJECT

private slots:
    void theOrderOfFindingDoesNotShow()
    {
        std::vector<std::pair<std::uint64_t, std::string>> found = {{9, "a"}, {7, "c"}, {7, "a"}, {7, "b"}, {3, "z"}};
        std::ranges::sort(found);
        do {
            Findings findings;
            for (const auto& [place, text] : found)
                findings.add(place, [&] { return text; });
            QCOMPARE(findings.count(), std::uint64_t(5));
            std::vector<std::string> failures;
            findings.moveTo(failures);
            QCOMPARE(failures, (std::vector<std::string>{"z", "a", "b", "... and 2 more of this kind."}));
        } while (std::ranges::next_permutation(found).found);
    }
};

QTEST_APPLESS_MAIN(FindingsTest)
#include "findings_test.moc"
