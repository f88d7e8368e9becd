// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever a renderer of somebody else does, the program gets a scene or an error.
#include "plugins/api/scene_parameters.h"
#include "plugins/host/plugin_guards.h"

#include <QTest>

#include <functional>
#include <new>
#include <stdexcept>

using namespace tetra;

namespace {

using Prepare = std::function<Result<std::shared_ptr<const Scene>>(const RendererView&)>;

Parameter named(const std::string& id, ParameterValue value)
{
    Parameter parameter;
    parameter.id = id;
    parameter.defaultValue = std::move(value);
    return parameter;
}

/// A renderer with two transfer functions, and with a prepare() of the test's own.
class StrangeRenderer : public Renderer {
public:
    explicit StrangeRenderer(Prepare prepare) : prepare_(std::move(prepare)) {}

    std::vector<Parameter> parameters(const FieldExtent& field) const override
    {
        Parameter colour = named("colour", std::string("red"));
        colour.choices = {"red", "green"};
        return {transferParameter(field), named("second-transfer", sequentialTransferFunction(5, 6, 1)), colour,
                named("count", std::int64_t{3})};
    }
    std::unique_ptr<RendererSession> open(const RendererMeshes&) const override
    {
        class Session : public RendererSession {
        public:
            explicit Session(Prepare prepare) : prepare_(std::move(prepare)) {}
            Result<std::shared_ptr<const Scene>> prepare(const RendererView& view, const Progress&) override
            {
                return prepare_(view);
            }

        private:
            Prepare prepare_;
        };
        return std::make_unique<Session>(prepare_);
    }

private:
    Prepare prepare_;
};

std::shared_ptr<const TetrahedralMesh> oneCell()
{
    auto mesh = std::make_shared<TetrahedralMesh>();
    mesh->positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    mesh->values = {2, 3, 4, 8};
    mesh->tetrahedra = {{0, 1, 2, 3}};
    return mesh;
}

Result<std::shared_ptr<const Scene>> sceneOf(const Prepare& prepare, const RendererView& view = {})
{
    const StrangeRenderer strange(prepare);
    return guarded(strange, {"strange", [](const Error&) {}})->open({.mesh = oneCell()})->prepare(view, {});
}

Result<std::shared_ptr<const Scene>> sceneWith(const std::vector<std::string>& ids)
{
    Scene scene;
    for (const std::string& id : ids)
        scene.drawables.push_back({.id = id, .shape = LineSet{}});
    return std::make_shared<const Scene>(scene);
}

} // namespace

class RendererGuardTest : public QObject {
    Q_OBJECT

private slots:
    void whatIsThrownIsAnError()
    {
        const auto broken = sceneOf(
            [](const RendererView&) -> Result<std::shared_ptr<const Scene>> { throw std::runtime_error("oh"); });
        QVERIFY(!broken && broken.error().text().find("'strange' failed: oh") != std::string::npos);
        const auto silent = sceneOf([](const RendererView&) -> Result<std::shared_ptr<const Scene>> { throw 3; });
        QVERIFY(!silent && silent.error().text().find("'strange'") != std::string::npos);
        const auto large =
            sceneOf([](const RendererView&) -> Result<std::shared_ptr<const Scene>> { throw std::bad_alloc(); });
        QVERIFY(!large && large.error().kind == ErrorKind::OutOfResource);
    }

    void whatIsNoSceneIsAnError()
    {
        const auto none = sceneOf([](const RendererView&) { return Result<std::shared_ptr<const Scene>>(nullptr); });
        QVERIFY(!none && none.error().text().find("there is none") != std::string::npos);
        const auto nameless = sceneOf([](const RendererView&) { return sceneWith({"a", ""}); });
        QVERIFY(!nameless && nameless.error().text().find("has no name") != std::string::npos);
        const auto twins = sceneOf([](const RendererView&) { return sceneWith({"a", "b", "a"}); });
        QVERIFY(!twins && twins.error().text().find("called 'a'") != std::string::npos);
        QVERIFY(sceneOf([](const RendererView&) { return sceneWith({"a", "b"}); }).ok());
    }

    /// For errors of the back ends, which know no plugins.
    void scenesSayWhoseTheyAre()
    {
        const auto scene = sceneOf([](const RendererView&) { return sceneWith({"a"}); });
        QVERIFY(scene.ok());
        QCOMPARE((*scene)->maker, std::string("strange"));
    }

    /// Each parameter has a value of its type; those of one type keep apart.
    void valuesAreWhole()
    {
        RendererView seen;
        const auto keep = [&](const RendererView& view) {
            seen = view;
            return sceneWith({});
        };
        QVERIFY(sceneOf(keep).ok());
        QCOMPARE(seen.values.size(), std::size_t(4));
        QCOMPARE(seen.value<TransferFunction>("transfer").opacities.front().value, 2.0); // for the mesh
        QCOMPARE(seen.value<TransferFunction>("transfer").opacities.back().value, 8.0);
        QCOMPARE(seen.value<TransferFunction>("second-transfer").opacities.front().value, 5.0);
        QCOMPARE(seen.value<std::int64_t>("count"), std::int64_t{3});

        const TransferFunction mine = sequentialTransferFunction(-1, 1, 2);
        QVERIFY(sceneOf(keep, {.values = {{"second-transfer", mine}, {"count", 0.5}, {"colour", std::string("green")}},
                               .camera = {.azimuth = 77},
                               .width = 640,
                               .height = 480})
                    .ok());
        QVERIFY(seen.value<TransferFunction>("second-transfer") == mine);
        QVERIFY(seen.value<TransferFunction>("transfer") != mine);
        QCOMPARE(seen.value<std::int64_t>("count"), std::int64_t{3}); // half is no count
        QCOMPARE(seen.value<std::string>("colour"), std::string("green"));
        QVERIFY(seen.camera.azimuth == 77 && seen.width == 640 && seen.height == 480);
        const auto blue = sceneOf(keep, {.values = {{"colour", std::string("blue")}}});
        QVERIFY(!blue && blue.error().kind == ErrorKind::WrongUsage);
        QCOMPARE(blue.error().text(), std::string("'blue' is not a choice for 'colour'. Available: red, green."));
    }

    void parametersAndNeedsMayThrow()
    {
        class Thrower : public Renderer {
        public:
            std::vector<Parameter> parameters(const FieldExtent&) const override { throw std::runtime_error("no"); }
            RendererNeeds needs() const override { throw std::runtime_error("no"); }
            std::unique_ptr<RendererSession> open(const RendererMeshes&) const override { return nullptr; }
        };
        const Thrower thrower;
        int told = 0;
        const auto renderer =
            guarded(thrower, {"thrower", [&](const Error& error) {
                                  ++told;
                                  QVERIFY(error.text().find("'thrower' failed: no") != std::string::npos);
                              }});
        QVERIFY(renderer->parameters({}).empty());
        QCOMPARE(told, 1);
        QVERIFY(!renderer->needs().view && !renderer->needs().focusMesh);
        QCOMPARE(told, 3);
        QVERIFY(!renderer->open({.mesh = oneCell()})->prepare({}, {}).ok());
        QCOMPARE(told, 3); // that is the error's business
    }
};

QTEST_GUILESS_MAIN(RendererGuardTest)
#include "renderer_guard_test.moc"
