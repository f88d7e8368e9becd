// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever a tool of somebody else does, the program gets an answer that it can use, and tells what went wrong.
#include "plugins/host/plugin_guards.h"

#include <QTest>

#include <functional>
#include <limits>
#include <stdexcept>

using namespace tetra;

namespace {

/// Does the same whatever it is asked.
class StrangeTool : public Tool {
public:
    explicit StrangeTool(std::function<ToolAnswer()> answer) : answer_(std::move(answer)) {}

    ToolLook look() const override { return answer_(), ToolLook{.shortcut = "K"}; }
    ToolNeeds needs() const override { return answer_(), ToolNeeds{true}; }
    ToolDrawing drawing(const ToolSurroundings&) const override { return answer_(), drawn; }
    ToolAnswer clicked(const ToolSurroundings&, const ToolPointer&) const override { return answer_(); }
    ToolAnswer moved(const ToolSurroundings&, const HandleMove&) const override { return answer_(); }
    ToolAnswer pressed(const ToolSurroundings&, const ToolKey&) const override { return answer_(); }
    std::vector<Parameter> parameters(const ToolSurroundings&) const override
    {
        answer_();
        Parameter parameter;
        parameter.mistake = [this](const std::string& text) { return answer_(), Message(text); };
        return {parameter};
    }
    ToolAnswer parameterSet(const ToolSurroundings&, const std::string&, const ParameterValue&) const override
    {
        return answer_();
    }
    std::vector<ToolReading> readings(const ToolSurroundings&) const override
    {
        return answer_(), std::vector{reading};
    }
    std::vector<ToolCommand> commands(const ToolSurroundings&) const override
    {
        return answer_(), std::vector<ToolCommand>(2);
    }
    ToolAnswer commanded(const ToolSurroundings&, const std::string&) const override { return answer_(); }

    ToolDrawing drawn{};
    ToolReading reading{};

private:
    std::function<ToolAnswer()> answer_;
};

} // namespace

class ToolGuardTest : public QObject {
    Q_OBJECT

private:
    std::unique_ptr<const Tool> guard(const Tool& tool)
    {
        return guarded(tool, {"strange", [this](const Error& error) { told_.push_back(error.text()); }});
    }
    /// The texts of all answers that it gives.
    static int textsOf(const Tool& tool, const ToolSurroundings& surroundings)
    {
        int texts = 0;
        for (const ToolAnswer& answer :
             {tool.clicked(surroundings, {}), tool.moved(surroundings, {}), tool.pressed(surroundings, {}),
              tool.parameterSet(surroundings, "id", 1.0), tool.commanded(surroundings, "id")})
            texts += answer.value ? 1 : 0;
        return texts;
    }

    ViewValue view_;
    ModelDescription model_;
    std::string value_;
    std::vector<Parameter> parameters_;
    ToolSurroundings surroundings_{.view = view_, .model = model_, .value = value_, .parameters = parameters_};
    std::vector<std::string> told_;

private slots:
    void init() { told_.clear(); }

    void whatIsGoodPasses()
    {
        StrangeTool tool([] { return ToolAnswer{.value = "kept, ü"}; });
        tool.drawn.handles = {{.id = "a"}, {.id = "b"}};
        const auto guarded = guard(tool);
        QCOMPARE(textsOf(*guarded, surroundings_), 5);
        QCOMPARE(guarded->look().shortcut, std::string("K"));
        QVERIFY(guarded->needs().pointer);
        QCOMPARE(guarded->drawing(surroundings_).handles.size(), std::size_t(2));
        QCOMPARE(guarded->parameters(surroundings_).front().mistake("x").text(), std::string("x"));
        QCOMPARE(guarded->readings(surroundings_).size(), std::size_t(1));
        QCOMPARE(guarded->commands(surroundings_).size(), std::size_t(2));
        QVERIFY(told_.empty());
    }

    void whatIsThrownIsToldAndChangesNothing()
    {
        const StrangeTool tool([]() -> ToolAnswer { throw std::runtime_error("no luck"); });
        const auto guarded = guard(tool);
        QCOMPARE(textsOf(*guarded, surroundings_), 0);
        QCOMPARE(told_.size(), std::size_t(5));
        QCOMPARE(told_.front(),
                 std::string("The plugin 'strange' failed: no luck. This is a fault of the plugin; tell its author."));
        QVERIFY(!guarded->pressed(surroundings_, {"Escape"}).taken); // others get the key
        told_.pop_back();
        QVERIFY(guarded->look().shortcut.empty());
        QVERIFY(!guarded->needs().pointer);
        QVERIFY(guarded->drawing(surroundings_).handles.empty());
        QVERIFY(guarded->parameters(surroundings_).empty());
        QVERIFY(guarded->readings(surroundings_).empty());
        QVERIFY(guarded->commands(surroundings_).empty());
        QCOMPARE(told_.size(), std::size_t(11));
    }

    /// A session could not have it, or would be too large with it.
    void whatCannotBeKeptIsNot_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<bool>("isKept");
        QTest::newRow("no UTF-8") << QByteArray("\xff\xfe") << false;
        QTest::newRow("a zero") << QByteArray("a\0b", 3) << false;
        QTest::newRow("too long") << QByteArray(qsizetype(mostToolBytes) + 1, 'a') << false;
        QTest::newRow("as long as may be") << QByteArray(qsizetype(mostToolBytes), 'a') << true;
    }
    void whatCannotBeKeptIsNot()
    {
        QFETCH(QByteArray, text);
        QFETCH(bool, isKept);
        const StrangeTool tool([&] {
            ToolAnswer answer{.value = text.toStdString(), .view = ViewValue()};
            answer.view->tools["other"] = text.toStdString();
            return answer;
        });
        const ToolAnswer answer = guard(tool)->clicked(surroundings_, {});
        QCOMPARE(answer.value.has_value(), isKept);
        QCOMPARE(answer.view->tools.contains("other"), isKept);
        QCOMPARE(told_.empty(), isKept);
    }

    void whatCannotBePaintedIsLeftOut()
    {
        StrangeTool tool([] { return ToolAnswer(); });
        const Eigen::Vector3d nowhere(0, std::numeric_limits<double>::quiet_NaN(), 0), here(1, 2, 3);
        tool.drawn.lines = {{.points = {here, here}}, {.points = {here}}, {.points = {here, nowhere, here}}};
        for (const double size : {0.0, -1.0, 1e6, std::numeric_limits<double>::quiet_NaN()}) {
            tool.drawn.lines.push_back({.points = {here, here}, .width = size});
            tool.drawn.points.push_back({.place = here, .radius = size});
        }
        tool.drawn.points.insert(tool.drawn.points.end(), {{.place = nowhere}, {.place = here}});
        tool.drawn.texts = {{here, "text"}, {nowhere, "text"}, {here, ""}};
        tool.drawn.handles = {{.id = "a"}, {.id = "a", .place = here}, {.id = ""}, {.id = "b", .place = nowhere}};
        const ToolDrawing drawing = guard(tool)->drawing(surroundings_);
        QCOMPARE(drawing.lines.size(), std::size_t(1));
        QCOMPARE(drawing.points.size(), std::size_t(1));
        QCOMPARE(drawing.texts.size(), std::size_t(1));
        QCOMPARE(drawing.handles.size(), std::size_t(1));
        QVERIFY(drawing.handles.front().place.isZero());
    }
};

QTEST_GUILESS_MAIN(ToolGuardTest)
#include "tool_guard_test.moc"
