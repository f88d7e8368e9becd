// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/host/dependency_order.h"

#include <QTest>

#include <algorithm>

using namespace tetra;

namespace {

std::size_t place(const DependencyOrder& order, std::size_t index)
{
    return static_cast<std::size_t>(std::ranges::find(order.order, index) - order.order.begin());
}

} // namespace

class DependencyOrderTest : public QObject {
    Q_OBJECT

private slots:
    void whatIsNeededComesFirst()
    {
        const auto order = dependencyOrder({{"a", {"b", "c"}}, {"b", {"c"}}, {"c", {}}, {"d", {"a"}}, {"e", {}}});
        QCOMPARE(order.order.size(), std::size_t(5));
        QVERIFY(place(order, 2) < place(order, 1));
        QVERIFY(place(order, 1) < place(order, 0));
        QVERIFY(place(order, 0) < place(order, 3));
        QVERIFY(std::ranges::all_of(order.errors, &Message::empty));
    }

    void aMissingNeedIsNamedThroughTheChain()
    {
        const auto order = dependencyOrder({{"a", {"b"}}, {"b", {"nowhere"}}, {"c", {}}});
        QCOMPARE(order.order, std::vector<std::size_t>{2});
        QVERIFY(QByteArray::fromStdString(order.errors[1].text()).contains("\"nowhere\""));
        QVERIFY(QByteArray::fromStdString(order.errors[0].text()).contains("\"b\""));
        QVERIFY(QByteArray::fromStdString(order.errors[0].text()).contains("\"nowhere\""));
    }

    void circlesAreToldInFullAndSpareTheRest()
    {
        const auto order = dependencyOrder({{"a", {"b"}}, {"b", {"c"}}, {"c", {"a"}}, {"d", {"a"}}, {"e", {}}});
        QCOMPARE(order.order, std::vector<std::size_t>{4});
        for (const std::size_t index : {0, 1, 2})
            QVERIFY(QByteArray::fromStdString(order.errors[index].text()).contains("\"a\" > \"b\" > \"c\" > \"a\""));
        QVERIFY(QByteArray::fromStdString(order.errors[3].text()).contains("circle"));
    }

    void whatNeedsItselfIsACircle()
    {
        const auto order = dependencyOrder({{"a", {"a"}}});
        QVERIFY(order.order.empty());
        QVERIFY(QByteArray::fromStdString(order.errors[0].text()).contains("\"a\" > \"a\""));
    }

    void nothingGivesNothing() { QVERIFY(dependencyOrder({}).order.empty()); }
};

QTEST_APPLESS_MAIN(DependencyOrderTest)
#include "dependency_order_test.moc"
