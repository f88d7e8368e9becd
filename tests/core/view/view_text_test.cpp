// SPDX-License-Identifier: GPL-3.0-or-later
// Views as text: they come back the same, whatever is in them, in the form that Qt writes JSON in, as sessions are; and
// the error says what is wrong with a text.
#include <tan/view.h>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

using namespace tetra;

namespace {

using Random = std::mt19937_64;

/// Of any size, often whole.
double anyNumber(Random& random)
{
    const auto whole = static_cast<double>(random() % 20'000);
    const double exponent = static_cast<double>(random() % 60) - 30;
    switch (random() % 4) {
    case 0: return whole - 10'000;
    case 1: return whole * std::pow(10, std::floor(exponent / 2));
    case 2: return -std::pow(2, exponent) * (1 + whole / 3e5);
    default: return whole / 20'000;
    }
}

Eigen::Vector3d anyVector(Random& random)
{
    return {anyNumber(random), anyNumber(random), anyNumber(random)};
}

float anyChannel(Random& random)
{
    return static_cast<float>(random() % 1001) / 1000;
}

Colour anyColour(Random& random)
{
    return {anyChannel(random), anyChannel(random), anyChannel(random)};
}

TransferFunction anyTransfer(Random& random)
{
    TransferFunction transfer;
    double value = anyNumber(random);
    for (std::uint64_t count = random() % 4; count > 0; --count, value += 1 + std::abs(value))
        transfer.colours.push_back({value, {anyChannel(random), anyChannel(random), anyChannel(random)}, {}});
    for (std::uint64_t count = random() % 4; count > 0; --count, value += 1 + std::abs(value))
        transfer.opacities.push_back({value, anyChannel(random), static_cast<int>(random() % 10)});
    transfer.unitDistance = 1e-3 + std::abs(anyNumber(random));
    return transfer;
}

std::vector<Isovalue> anyIsovalues(Random& random)
{
    std::vector<Isovalue> isovalues;
    for (std::uint64_t count = random() % 4; count > 0; --count)
        isovalues.push_back({anyNumber(random), anyChannel(random), anyChannel(random), anyChannel(random),
                             anyChannel(random), random() % 2 == 0});
    return isovalues;
}

Camera anyCamera(Random& random)
{
    Camera camera;
    camera.target = anyVector(random);
    camera.distance = 1e-6 + std::abs(anyNumber(random));
    camera.azimuth = static_cast<double>(random() % 36'000) / 100;
    camera.elevation = static_cast<double>(random() % 18'000) / 100 - 90;
    camera.roll = static_cast<double>(random() % 3) * 10;
    camera.up = static_cast<UpAxis>(random() % 6);
    camera.perspective = random() % 2 == 0;
    camera.trackball = random() % 2 == 0;
    return camera;
}

QueryState anyQuery(Random& random)
{
    QueryState query;
    query.error = anyNumber(random);
    query.byBudget = random() % 2 == 0;
    query.budget = random() % 1'000'000'000'000;
    query.warping = {static_cast<WarpingLimit>(random() % 3), anyNumber(random)};
    query.focus = {static_cast<FocusState::Shape>(random() % 6),
                   anyVector(random),
                   anyVector(random),
                   anyNumber(random),
                   anyNumber(random),
                   anyNumber(random),
                   anyNumber(random),
                   anyNumber(random)};
    for (std::uint64_t count = random() % 4; count > 0; --count)
        query.focus.others.push_back(random() % 2 == 0 ? MovableRegion(Sphere{anyVector(random), anyNumber(random)})
                                                       : MovableRegion(Box{anyVector(random), anyVector(random)}));
    query.focus.number = static_cast<std::uint32_t>(query.focus.others.size());
    query.range = {true, anyNumber(random), anyNumber(random), 1, 2, 3, anyNumber(random)};
    query.window = {random() % 2 == 0,
                    {{anyVector(random), anyVector(random)}, static_cast<WindowBorder>(random() % 3)}};
    query.values = {random() % 2 == 0, anyNumber(random), anyNumber(random)};
    return query;
}

ParameterValues everySetting(Random& random)
{
    return {{"switch", random() % 2 == 0},
            {"count", static_cast<std::int64_t>(random())},
            {"share", anyNumber(random)},
            {"name", std::string("a \"text\" with ü, \\ and \n two lines")},
            {"colour", anyColour(random)},
            {"direction", anyVector(random)},
            {"own", OwnValue{"example.curve", "{\"x\": [1, 2]}"}},
            {"more surfaces", anyIsovalues(random)},
            {"another", anyTransfer(random)}};
}

ViewValue anyView(Random& random)
{
    ViewValue view;
    view.query = anyQuery(random);
    view.appearance = {"hybrid", anyTransfer(random), everySetting(random)};
    view.isovalues = anyIsovalues(random);
    for (AnnotationPlace& place : view.annotations.places)
        place = {random() % 2 == 0, static_cast<Corner>(random() % 4)};
    if (random() % 2 == 0)
        view.annotations.barEnds = BarEnds{-1 - std::abs(anyNumber(random)), std::abs(anyNumber(random))};
    for (const auto text : {&AnnotationState::title, &AnnotationState::quantity, &AnnotationState::unit})
        if (random() % 2 == 0)
            view.annotations.*text = "\"µ\" " + std::to_string(random() % 100);
    if (random() % 2 == 0)
        view.annotations.numbers = {static_cast<NumberFormat::Style>(1 + random() % 2),
                                    static_cast<int>(random() % (mostDecimals + 1))};
    if (random() % 2 == 0)
        view.annotations.lengths = {static_cast<NumberFormat::Style>(1 + random() % 2),
                                    static_cast<int>(random() % (mostDecimals + 1))};
    view.annotations.textSize = smallestTextSize + static_cast<double>(random() % 300) / 10;
    view.annotations.boldText = random() % 2 == 0;
    view.animation.kind = static_cast<Animation::Kind>(random() % 2);
    view.animation.framesPerSecond = static_cast<double>(10 + random() % 1000) / 10;
    view.animation.turntable = {static_cast<Turntable::Axis>(random() % 2), static_cast<double>(random() % 720),
                                static_cast<int>(1 + random() % 999)};
    for (std::uint64_t count = random() % 4; count > 0; --count)
        view.animation = withKey(view.animation, {anyCamera(random), anyTransfer(random), anyIsovalues(random),
                                                  anyNumber(random), random() % 2 == 0, random() % 1'000'000});
    view.camera = anyCamera(random);
    if (random() % 2 == 0)
        view.background = anyColour(random);
    view.lens = {static_cast<LensState::Shape>(random() % 3),
                 anyNumber(random),
                 anyNumber(random),
                 anyNumber(random),
                 anyNumber(random),
                 anyNumber(random)};
    if (view.isovalues.size() % 2 == 0)
        view.tools = {{"ruler", "1,2,3 4.5,-6,7"}, {"example.own", "a \"text\" with ü and \\"}};
    return view;
}

/// Qt reads whole numbers of 64 bits as such, and writes them in another way than as the doubles that they were.
QJsonValue asDoubles(const QJsonValue& value)
{
    if (value.isDouble() && static_cast<double>(value.toInteger()) == value.toDouble() &&
        static_cast<qint64>(value.toDouble()) == value.toInteger())
        return value.toDouble();
    if (value.isArray()) {
        QJsonArray elements;
        for (const QJsonValue element : value.toArray())
            elements.append(asDoubles(element));
        return elements;
    }
    if (value.isObject()) {
        QJsonObject members = value.toObject();
        for (auto member = members.begin(); member != members.end(); ++member)
            member.value() = asDoubles(member.value());
        return members;
    }
    return value;
}

} // namespace

class ViewTextTest : public QObject {
    Q_OBJECT

private slots:
    void aViewComesBackTheSame()
    {
        Random random(1);
        for (int round = 0; round < 200; ++round) {
            ViewValue view = anyView(random);
            for (int number = round % 3; number > 0; --number)
                view.bookmarks.push_back({"\"ü\" " + std::to_string(number), anyView(random)});
            for (Bookmark& bookmark : view.bookmarks)
                bookmark.view.animation = {};
            const auto again = viewFromText(viewToText(view));
            QVERIFY2(again.ok(), again ? "" : again.error().text().c_str());
            QVERIFY2(*again == view, viewToText(view).c_str());
        }
        const auto usual = viewFromText(viewToText({}));
        QVERIFY(usual.ok() && *usual == ViewValue());
    }

    /// Order, blanks and digits.
    void theTextIsWhatQtWouldWrite()
    {
        Random random(2);
        for (int round = 0; round < 200; ++round) {
            ViewValue view = anyView(random);
            view.appearance.settings.erase("name");                  // Qt has a shorter word for the line feed in it
            view.appearance.settings["count"] = std::int64_t(round); // a large one may be taken for a double
            const QByteArray text = QByteArray::fromStdString(viewToText(view));
            const QJsonValue read = asDoubles(QJsonDocument::fromJson(text).object());
            QCOMPARE(text, QJsonDocument(read.toObject()).toJson());
        }
    }

    void membersHaveTheirPlaces()
    {
        ViewValue view;
        view.query.error = 2.5;
        view.query.focus.shape = FocusState::Shape::Sphere;
        view.query.window.window.border = WindowBorder::Clipped;
        view.appearance.settings["count"] = std::int64_t(9'007'199'254'740'993); // more than a double can tell
        view.annotations[AnnotationKind::Title] = {true, Corner::BottomRight};
        view.background = Colour{0, 0, 0.5f};
        const QJsonObject root = QJsonDocument::fromJson(QByteArray::fromStdString(viewToText(view))).object();
        QCOMPARE(root["mesh"]["error"].toDouble(), 2.5);
        QCOMPARE(root["mesh"]["focus"]["shape"].toString(), QString("sphere"));
        QCOMPARE(root["mesh"]["window"]["border"].toString(), QString("clipped"));
        QCOMPARE(root["look"]["settings"]["count"]["integer"].toInteger(), 9'007'199'254'740'993);
        QCOMPARE(root["annotations"]["title"]["corner"].toString(), QString("bottomRight"));
        QCOMPARE(root["background"].toArray(), (QJsonArray{0, 0, 0.5}));
        QCOMPARE(root.keys(), (QStringList{"animation", "annotations", "background", "camera", "isovalues", "lens",
                                           "look", "mesh"}));
        view.background.reset();
        QVERIFY(viewToText(view).find("background") == std::string::npos);
        view.tools = {{"ruler", "1,2,3"}, {"idle", ""}};
        QCOMPARE(QJsonDocument::fromJson(QByteArray::fromStdString(viewToText(view))).object()["tools"].toObject(),
                 (QJsonObject{{"ruler", "1,2,3"}}));
        view.tools.erase("ruler");
        QVERIFY(viewToText(view).find("tools") == std::string::npos);
    }

    void toolsOfATextReplaceTheUsualOnes()
    {
        ViewValue usual;
        usual.tools = {{"one", "a"}, {"other", "b"}};
        QVERIFY(*viewFromText("{}", usual) == usual);
        QVERIFY(viewFromText(R"({"tools": {"other": "c", "third": ""}})", usual)->tools ==
                (ToolValues{{"other", "c"}}));
        const auto wrong = viewFromText(R"({"tools": {"other": 3}})", usual);
        QVERIFY(!wrong.ok() && wrong.error().text().find("\"tools.other\"") != std::string::npos);
    }

    void bookmarksOfATextReplaceTheUsualOnes()
    {
        ViewValue usual;
        usual.bookmarks = {{"one", {}}};
        QVERIFY(*viewFromText("{}", usual) == usual);
        const auto read =
            viewFromText(R"({"views": [{"name": "a", "mesh": {"error": 3}, "views": [{"name": "b"}]}, {}]})", usual);
        QCOMPARE(read->bookmarks.size(), std::size_t(1)); // what has no name is none, and none has its own
        QCOMPARE(read->bookmarks[0].name, std::string("a"));
        QCOMPARE(read->bookmarks[0].view.query.error, 3.0);
        QVERIFY(read->bookmarks[0].view.bookmarks.empty());
        const auto wrong = viewFromText(R"({"views": [{"name": "a", "mesh": {"error": "b"}}]})");
        QVERIFY(!wrong.ok() && wrong.error().text().find("\"views[0].mesh.error\"") != std::string::npos);
    }

    void whatIsMissingIsAsUsual()
    {
        Random random(3);
        const ViewValue usual = anyView(random);
        const auto read =
            viewFromText(R"({"mesh": {"focus": {"radius": 3, "ofTomorrow": []}}, "ofTomorrow": {}})", usual);
        QVERIFY2(read.ok(), read ? "" : read.error().text().c_str());
        ViewValue expected = usual;
        expected.query.focus.radius = 3;
        QVERIFY(*read == expected);
        QVERIFY(*viewFromText("{}") == ViewValue());
        ViewValue withEnds;
        withEnds.annotations.barEnds = BarEnds{};
        QVERIFY(*viewFromText(R"({"annotations": {}})", withEnds) == ViewValue());
        withEnds.annotations = {.title = "a",
                                .quantity = "b",
                                .unit = "c",
                                .numbers = {NumberFormat::Style::Plain, 1},
                                .lengths = {NumberFormat::Style::Powers, 0},
                                .textSize = 20,
                                .boldText = true};
        QVERIFY(*viewFromText(R"({"annotations": {}})", withEnds) == ViewValue());
        const std::string usualText = viewToText(ViewValue());
        for (const char* name : {"titleText", "quantity", "\"unit\"", "numbers", "lengths", "textSize",
                                 "boldText"}) // earlier programs know none of them
            QVERIFY(usualText.find(name) == std::string::npos);
        const auto many = viewFromText(R"({"annotations": {"numbers": {"style": "powers", "decimals": 1e9}}})");
        QCOMPARE(many->annotations.numbers.decimals, mostDecimals);
        QCOMPARE(viewFromText(R"({"annotations": {"textSize": 1e9}})")->annotations.textSize, largestTextSize);
        QCOMPARE(viewFromText(R"({"annotations": {"textSize": -1}})")->annotations.textSize, smallestTextSize);
        QVERIFY(!viewFromText(R"({"annotations": {"numbers": {"style": "roman"}}})").ok());
    }

    /// A setting may be of a program of tomorrow; numbers that are none are no numbers.
    void whatIsNoSettingIsLeftOut()
    {
        ViewValue view;
        view.appearance.settings = {{"none", std::nan("")}, {"endless", std::numeric_limits<double>::infinity()}};
        auto read = viewFromText(viewToText(view));
        QVERIFY(read.ok());
        QVERIFY(read->appearance.settings.empty());
        read = viewFromText(R"({"look": {"settings": {"a": null, "b": {"tensor": 1}, "c": [1], "d": {"integer": 3.0},
                                                      "e": {"transfer": {"format": "none"}}}}})");
        QVERIFY2(read.ok(), read ? "" : read.error().text().c_str());
        QVERIFY(read->appearance.settings == (ParameterValues{{"d", std::int64_t(3)}}));
    }

    void badTextsAreRefused_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("told");
        const auto row = [](const char* name, const char* text, const char* told) {
            QTest::newRow(name) << QByteArray(text) << QByteArray(told);
        };
        row("nothing", "", "Not valid JSON");
        row("cut", "{\n \"mesh\": {", "line 2, column 11");
        row("a list", "[]", "it must be an object, in braces");
        row("error is a text", R"({"mesh": {"error": "1 %"}})", "\"mesh.error\" must be a number");
        row("two coordinates", R"({"mesh": {"focus": {"centre": [1, 2]}}})",
            "\"mesh.focus.centre\" must be three numbers in brackets");
        row("no coordinate", R"({"mesh": {"focus": {"centre": [1, 2, null]}}})", "\"mesh.focus.centre\"");
        row("shape", R"({"mesh": {"focus": {"shape": "cone"}}})",
            "\"mesh.focus.shape\" must be one of the known names");
        row("isovalue", R"({"isovalues": [{"value": 1}, {"value": null}]})", "\"isovalues[1].value\" must be a number");
        row("transfer", R"({"look": {"transfer": {"points": []}}})", "The transfer function cannot be read");
        row("key", R"({"animation": {"keys": [{"visible": 1}, {"byBudget": 1}]}})",
            "\"animation.keys[1].byBudget\" must be true or false");
        row("camera", R"({"camera": {"azimuth": "north"}})", "azimuth");
        row("camera is a number", R"({"camera": 3})", "camera");
        row("settings", R"({"look": {"settings": []}})", "\"look.settings\" must be an object, in braces");
        row("mode", R"({"look": {"mode": 3}})", "\"look.mode\" must be text in quotes");
        row("background", R"({"background": "red"})", "\"background\" must be three numbers in brackets");
    }
    void badTextsAreRefused()
    {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, told);
        const auto read = viewFromText(text.toStdString());
        QVERIFY(!read);
        QCOMPARE(read.error().kind, ErrorKind::BadInput);
        QVERIFY2(read.error().text().starts_with("The view cannot be read: "), read.error().text().c_str());
        QVERIFY2(QByteArray::fromStdString(read.error().text()).contains(told), read.error().text().c_str());
    }
};

QTEST_GUILESS_MAIN(ViewTextTest)
#include "view_text_test.moc"
