// SPDX-License-Identifier: GPL-3.0-or-later
// A query as the text of a URL and back: what the client writes is what the server reads, and what it says of a text
// that is wrong is said to a client of HTTP.
#include "core/serve/served_query.h"

#include <QtTest>

#include <tuple>

using namespace tetra;

namespace {

auto partsOf(const MeshQuery& query)
{
    const auto livesOf = [](const LifeRange& range) {
        return std::tuple(range.one.error, range.one.warping, range.other.error, range.other.warping,
                          range.births.minimum, range.births.maximum, range.deaths.minimum, range.deaths.maximum);
    };
    const auto cornersOf = [](const Window& window) {
        std::vector<double> corners(window.box.least.begin(), window.box.least.end());
        corners.insert(corners.end(), window.box.largest.begin(), window.box.largest.end());
        return std::pair(corners, window.border);
    };
    std::vector<std::pair<double, double>> values;
    for (const ValueRange& range : query.values)
        values.emplace_back(range.minimum, range.maximum);
    return std::tuple(query.budget, values, query.window ? std::optional(cornersOf(*query.window)) : std::nullopt,
                      query.method, query.range ? std::optional(livesOf(*query.range)) : std::nullopt);
}

/// What a server makes of it.
Result<MeshQuery> read(const std::string& text)
{
    const auto words = QueryWords::fromUrl(text);
    return words ? words->query() : words.error();
}

} // namespace
using namespace tetra;

class ServedQueryTest : public QObject {
    Q_OBJECT

private slots:
    void whatIsWrittenIsRead_data()
    {
        QTest::addColumn<int>("number");
        for (int i = 0; i < int(queries().size()); ++i)
            QTest::newRow(qPrintable(QString::number(i))) << i;
    }
    void whatIsWrittenIsRead()
    {
        QFETCH(int, number);
        const MeshQuery query = queries()[std::size_t(number)];
        for (const bool warps : {false, true}) {
            const auto words = QueryWords::of(query, warps);
            QVERIFY2(words.ok(), words.ok() ? "" : words.error().text().c_str());
            const std::string text = words->toUrl();
            QVERIFY2(text.find_first_of(" +<>\"#") == std::string::npos, text.c_str());
            const auto back = read(text);
            QVERIFY2(back.ok(), back.ok() ? text.c_str() : back.error().text().c_str());
            QVERIFY2(partsOf(*back) == partsOf(query), text.c_str());
            if (!query.range) {
                QVERIFY2(back->error == query.error, text.c_str());
                QVERIFY2(!warps || back->warping == query.warping, text.c_str());
            }
            QCOMPARE(QueryWords::of(*back, warps)->toUrl(), text);
        }
    }

    void whatCannotBeSaidIsTold()
    {
        MeshQuery query;
        query.range = LifeRange{.one = {4, 1}, .other = {1, 3}};
        QVERIFY(!QueryWords::of(query, true).ok());
        QVERIFY(QueryWords::of(query, false).ok());
        std::vector<std::array<double, 2>> knots;
        for (int i = 0; i < 2000; ++i)
            knots.push_back({i / 3.0, i % 7 + 1.0});
        const auto tooLong = QueryWords::of({.error = ValueRamp{knots}}, false);
        QVERIFY(!tooLong.ok() && tooLong.error().text().find("too long") != std::string::npos);
    }

    void whatIsWrongIsSaidInWordsOfTheUrl_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("said");
        const auto row = [](const char* text, const char* said) { QTest::newRow(text) << text << said; };
        row("eror=1", "'eror' is not a query parameter");
        row("error", "'error' needs a value");
        row("=1", "'' is not a query parameter");
        row("error=%", "encoded");
        row("error=1&error=2", "'error' is given twice");
        row("error=x", "'x' does not fit 'error'");
        row("error=101", "'error'");
        row("error=nan", "'error'");
        row("budget=0", "'budget'");
        row("budget=1.5", "'budget'");
        row("border=round&window=0,0,0,1,1,1", "intersecting, contained, clipped");
        row("border=clipped", "specify it with 'window'");
        row("window=1,2", "two opposite corners");
        row("window=0,0,0,1,1,inf", "two opposite corners");
        row("values=2,1", "'values'");
        row("values=1", "'values'");
        row("values=log10(0),1", "'values'");
        row("values=log10(1),log10(0.1)", "the smaller one first");
        row("range=4,1&births=log10(1),2", "'births'");
        row("focus=sphere:1,2,3,4", "'focus' needs 'focus-error'");
        row("focus-error=1", "'focus-error' needs a focus");
        row("focus=sphere:1,2,3,0&focus-error=1", "does not fit 'focus'");
        row("focus=cube:1&focus-error=1", "does not fit 'focus'");
        row("error=1&focus=sphere:1,2,3,4&focus-error=2", "Exchange 'focus-error' and 'error'");
        row("error=4&warping=1&focus=sphere:1,2,3,4&focus-error=2&focus-warping=3",
            "Exchange 'focus-warping' and 'warping'");
        row("error=4&focus=sphere:1,2,3,4&focus-error=2&falloff=-1", "'falloff'");
        row("field=1&error=1", "so 'error' cannot be combined with it");
        row("field=cube(1)", "'field': ");
        row("warping=1&warping-field=2", "so 'warping' cannot be combined with it");
        row("focus=sphere:0,0,0,1&focus-error=1&focus-warping=0&warping-field=2",
            "so 'focus-warping' cannot be combined with it");
        row("warping-field=cube(1)", "'warping-field': ");
        row("range=4,1&error=2", "so 'error' cannot be combined with it");
        row("range=4", "'range'");
        row("range=4,101", "'range'");
        row("range=4,1&window=0,0,0,1,1,1&border=clipped", "'border=clipped' cannot be combined with 'range'");
        row("births=1,2", "specify it with 'range'");
        row("range=4,1&deaths=2,1", "'deaths'");
        row("method=insertion&error=1", "'method' is for meshes whose accuracy varies");
        row("method=magic&field=values(1:1,2:3)", "automatic, closed-set, insertion");
        row("empty=perhaps", "'empty'");
    }
    void whatIsWrongIsSaidInWordsOfTheUrl()
    {
        QFETCH(QString, text);
        QFETCH(QString, said);
        const auto query = read(text.toStdString());
        QVERIFY(!query.ok());
        QVERIFY(query.error().kind == ErrorKind::WrongUsage);
        const QString told = QString::fromStdString(query.error().text());
        QVERIFY2(told.contains(said) && !told.contains("--"), qPrintable(told));
    }

    /// The same words are options where a command line says so.
    void optionsAreNamedAsOptions()
    {
        const auto query = QueryWords({{"field", "1"}, {"error", "1"}}).query("--");
        QVERIFY(!query.ok());
        QVERIFY(query.error().text().find("'--field' sets the error") != std::string::npos);
        QVERIFY(query.error().text().find("'--error' cannot be combined with it") != std::string::npos);
    }

    /// Where values are logarithms, values of the data can be typed.
    void valuesMayBeLogarithms()
    {
        const auto query = read("values=log10(1e-3),log10(100)&values=-4,log10(0.1)");
        QVERIFY2(query.ok(), query.ok() ? "" : query.error().text().c_str());
        QCOMPARE(query->values.size(), std::size_t(2));
        QVERIFY(query->values[0].minimum == -3 && query->values[0].maximum == 2);
        QVERIFY(query->values[1].minimum == -4 && query->values[1].maximum == -1);
    }

    void whatIsLeftOutIsUsual()
    {
        const auto usual = read("");
        QVERIFY(usual.ok() && usual->error == ErrorField(1.0) && usual->warping == ErrorField(1.0));
        const auto best = read("budget=100");
        QVERIFY(best.ok() && best->error == ErrorField(0.0) && best->warping == ErrorField(0.0));
        const auto least = read("budget=100&warping=3");
        QVERIFY(least.ok() && least->error == ErrorField(0.0) && least->warping == ErrorField(3.0));
        const auto none = read("error=none&&warping=1&");
        QVERIFY(none.ok() && none->error == ErrorField(anyError) && none->warping == ErrorField(1.0));
        const auto words = QueryWords::fromUrl("error=1&empty=yes");
        QVERIFY(words.ok() && words->value("empty") == "yes" && words->query().ok());
    }

private:
    static std::vector<MeshQuery> queries()
    {
        std::vector<MeshQuery> all(1);
        all.push_back({.error = 2.5, .warping = 2.5});
        all.push_back({.error = 0.1, .warping = 30.0, .budget = 12'345'678'901});
        all.push_back({.error = 1e-7, .warping = anyWarping});
        MeshQuery part{.error = 3.0, .values = {{-1e9, 1.0 / 3}, {4, 5}}};
        part.window = Window{{{-1, 2e-5, 3}, {4, 5, 6.5}}, WindowBorder::Clipped};
        all.push_back(part);
        part.window->border = WindowBorder::Contained;
        all.push_back(part);
        const ErrorField ball = SpaceRamp{Sphere{{1, 2, 3}, 4.5}, 0.5, 9, 2};
        all.push_back({.error = ball, .warping = anyWarping});
        all.push_back({.error = ball, .warping = ball, .method = VariableMethod::Insertion});
        all.push_back({.error = 2.0, .warping = ball});
        all.push_back({.error = smallerOf(ball, SpaceRamp{Box{{0, 0, 0}, {1, 1, 1}}, 1, 2, 0}), .warping = 7.0});
        MeshQuery lives;
        lives.range = LifeRange{.one = {8, 8}, .other = {2, 2}};
        all.push_back(lives);
        lives.range->births = {2, 3};
        lives.range->deaths = {0, 3.5};
        lives.values = {{1, 2}};
        all.push_back(lives);
        return all;
    }
};

QTEST_GUILESS_MAIN(ServedQueryTest)
#include "served_query_test.moc"
