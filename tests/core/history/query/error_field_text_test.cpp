// SPDX-License-Identifier: GPL-3.0-or-later
// Error fields to text and back; what cannot be read is an error that names the place.

#include "tests/core/history/query/random_fields.h"
#include "tests/lacks.h"

#include <tan/query.h>

#include <QTest>

#include <clocale>
#include <cstdlib>
#include <limits>

using namespace tetra;

class ErrorFieldTextTest : public QObject {
    Q_OBJECT

private slots:
    void everyFieldComesBack()
    {
        std::mt19937 random(4);
        for (int trial = 0; trial < 3000; ++trial) {
            const ErrorField field = randomField(random, 1 + trial % 6);
            const std::string text = toText(field);
            const auto again = parseErrorField(text);
            QVERIFY2(again.ok(), text.c_str());
            QVERIFY2(*again == field, text.c_str());
            QCOMPARE(toText(*again), text);
        }
    }

    void whatPeopleType_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("means");
        QTest::newRow("number") << "2.5"
                                << "2.5";
        QTest::newRow("blanks") << "  min ( 1e1 ,\n+.5 ) "
                                << "0.5";
        QTest::newRow("any") << "inf"
                             << "inf";
        QTest::newRow("box") << "box(0,0,0,9,9,9;.5,4,2)"
                             << "box(0, 0, 0, 9, 9, 9; 0.5, 4, 2)";
        QTest::newRow("sharp box") << "box(9,0,0,0,9,9;.5,inf)"
                                   << "box(0, 0, 0, 9, 9, 9; 0.5, inf, 0)";
        QTest::newRow("sphere") << "sphere(1,2,-3,4; 1,2,3)"
                                << "sphere(1, 2, -3, 4; 1, 2, 3)";
        QTest::newRow("half-space") << "halfspace(0,0,-2, 8; 1, 2)"
                                    << "halfspace(0, 0, -1, 4; 1, 2, 0)";
        QTest::newRow("camera") << "camera(1,2,3; 0, 10, 500)"
                                << "camera(1, 2, 3; 0, 10, 500)";
        QTest::newRow("a point") << "sphere(1,2,3,0; 0, 10, 500)"
                                 << "camera(1, 2, 3; 0, 10, 500)";
        QTest::newRow("values") << "values(10:2, 0:1)"
                                << "values(0:1, 10:2)";
        QTest::newRow("no values") << "values()"
                                   << "values()";
        QTest::newRow("isovalues") << "isovalues(10, 20; .5, 8, 3)"
                                   << "values(7:8, 10:0.5, 13:8, 17:8, 20:0.5, 23:8)";
        QTest::newRow("logarithms") << "values( log10(1e-5):2, log10( 100 ) :1, 1:3)"
                                    << "values(-5:2, 1:3, 2:1)";
        QTest::newRow("isovalues of logarithms") << "isovalues(log10(1000); .5, 8, 1)"
                                                 << "values(2:8, 3:0.5, 4:8)";
        QTest::newRow("opacity of logarithms") << "opacity(log10(1):0, log10(10):1; 1, 5)"
                                               << "values(0:5, 1:1)";
        QTest::newRow("opacity") << "opacity(0:0, 10:1; 1, 5)"
                                 << "values(0:5, 10:1)";
        QTest::newRow("from the left") << "sum(camera(0,0,0;1,2,3), 1, 2)"
                                       << "sum(camera(0, 0, 0; 1, 2, 3), 1, 2)";
        QTest::newRow("from the right") << "sum(values(0:1), sum(1, values()))"
                                        << "sum(values(0:1), sum(1, values()))";
        QTest::newRow("all four") << "max(product(values(0:1), 2), min(values(), 3))"
                                  << "max(product(values(0:1), 2), min(values(), 3))";
    }
    void whatPeopleType()
    {
        QFETCH(QString, text);
        QFETCH(QString, means);
        const auto field = parseErrorField(text.toStdString());
        QVERIFY2(field.ok(), field.ok() ? "" : field.error().text().c_str());
        QCOMPARE(QString::fromStdString(toText(*field)), means);
    }

    /// What is left out comes from the picture (C3), and is missed where there is none.
    void thePresentViewIsTaken()
    {
        const PresentView present{Eigen::Vector3d(1, 2, 3), {10, 20}, {{0, 0}, {10, 1}}};
        for (const auto& [text, means] : {std::pair{"camera(; 0, 10, 500)", "camera(1, 2, 3; 0, 10, 500)"},
                                          std::pair{"isovalues( ; .5, 8, 3)", "isovalues(10, 20; .5, 8, 3)"},
                                          std::pair{"opacity(;1,5)", "opacity(0:0, 10:1; 1, 5)"}}) {
            const auto field = parseErrorField(text, present);
            QVERIFY2(field.ok(), field.ok() ? "" : field.error().text().c_str());
            QVERIFY(*field == *parseErrorField(means));
            const auto missed = parseErrorField(text);
            QVERIFY(!missed.ok());
            QVERIFY2(missed.error().text().find(", but found ';") != std::string::npos, missed.error().text().c_str());
        }
    }

    void errorsNameThePlace_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("says");
        QTest::newRow("empty") << ""
                               << "character 1: expected a number, or the name of a field, but the text ends";
        QTest::newRow("name") << "min(1, ball(1))"
                              << "character 8: expected a number or one of box";
        QTest::newRow("too few") << "box(1,2,3;"
                                 << "character 10: expected ',', but found ';'";
        QTest::newRow("open") << "sum(1, 2"
                              << "character 9: expected ')', but the text ends";
        QTest::newRow("one operand") << "sum(values())"
                                     << "character 13: expected ','";
        QTest::newRow("more") << "1 2"
                              << "character 3: expected the end of the text";
        QTest::newRow("negative") << "camera(1,2,3; -1, 2)"
                                  << "character 15: expected a number that is not negative";
        QTest::newRow("nan") << "nan"
                             << "one of box";
        QTest::newRow("infinite") << "box(inf"
                                  << "character 5: expected a finite number";
        QTest::newRow("huge") << "1e999"
                              << "fewer than 308 digits";
        QTest::newRow("no normal") << "halfspace(0,0,0,1;1,2)"
                                   << "not all 0";
        QTest::newRow("logarithm of zero") << "values(log10(0):1)"
                                           << "character 14: expected a number above 0, but found '0):1)'";
        QTest::newRow("open logarithm") << "isovalues(log10(1; 1, 2)"
                                        << "character 18: expected ')'";
        QTest::newRow("logarithm of nothing") << "isovalues(log10; 1, 2)"
                                              << "character 16: expected '('";
        QTest::newRow("logarithm for an error") << "values(1:log10(1))"
                                                << "character 10: expected a number";
        QTest::newRow("comma") << "1,5"
                               << "character 2: expected the end";
    }
    void errorsNameThePlace()
    {
        QFETCH(QString, text);
        QFETCH(QString, says);
        const auto field = parseErrorField(text.toStdString());
        QVERIFY(!field.ok());
        QCOMPARE(field.error().kind, ErrorKind::WrongUsage);
        QVERIFY2(QString::fromStdString(field.error().text()).contains(says), field.error().text().c_str());
    }

    void sizesAreLimited()
    {
        const auto nested = [](int depth) {
            std::string text;
            for (int i = 0; i < depth; ++i)
                text += "max(1,";
            text += "values()";
            return text + std::string(std::size_t(depth), ')');
        };
        const auto wide = [](int count) {
            std::string text = "sum(values()";
            for (int i = 1; i < count; ++i)
                text += ",1";
            return text + ')';
        };
        QVERIFY(parseErrorField(nested(99)).ok());
        QVERIFY(!parseErrorField(nested(100)).ok());
        QVERIFY(!parseErrorField(nested(1000000)).ok());
        QVERIFY(!parseErrorField(std::string(1000000, '(')).ok());
        QVERIFY(parseErrorField(wide(999)).ok());
        QVERIFY(!parseErrorField(wide(1000)).ok());
        QVERIFY(!parseErrorField(wide(1000000)).ok());
    }

    /// Whatever is typed: an error, or a field that comes back.
    void mutationsNeverCrash()
    {
        std::mt19937 random(6);
        const std::string signs = "(),;:.-+0123456789einfboxsphrcamlut \n\x80\xff";
        int fields = 0;
        for (int trial = 0; trial < 20000; ++trial) {
            std::string text = toText(randomField(random, 1 + trial % 4));
            for (unsigned changes = 1 + random() % 3; changes > 0 && !text.empty(); --changes) {
                const std::size_t place = random() % text.size();
                switch (random() % 4) {
                case 0: text.erase(place, 1 + random() % 5); break;
                case 1: text.insert(place, 1, signs[random() % signs.size()]); break;
                case 2: text[place] = signs[random() % signs.size()]; break;
                default: text.insert(place, text.substr(random() % text.size(), random() % 20)); break;
                }
            }
            const auto field = parseErrorField(text);
            if (!field) {
                QVERIFY(!field.error().text().empty());
                continue;
            }
            ++fields;
            const auto again = parseErrorField(toText(*field));
            QVERIFY2(again.ok() && *again == *field, text.c_str());
        }
        QVERIFY(fields > 1000);
    }

    void theLocaleDoesNotMatter()
    {
        if (std::setlocale(LC_ALL, "de_DE.UTF-8") == nullptr)
            QSKIP_WITHOUT("locale de_DE.UTF-8");
        const auto field = parseErrorField("sum(values(0.5:1.5), 2.5)");
        QVERIFY(field.ok());
        QCOMPARE(toText(*field), std::string("sum(values(0.5:1.5), 2.5)"));
        std::setlocale(LC_ALL, "C");
    }
};

QTEST_GUILESS_MAIN(ErrorFieldTextTest)
#include "error_field_text_test.moc"
