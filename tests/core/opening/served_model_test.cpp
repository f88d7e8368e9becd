// SPDX-License-Identifier: GPL-3.0-or-later
// What a server says of its model: numbers that no model has are refused with a sentence that says which.
#include "core/opening/served_model.h"

#include "core/packed/packed_mesh.h"
#include "tests/core/remote/http_server.h"

#include <tan/query.h>

#include <QTest>

#include <limits>
#include <string>

using namespace tetra;

namespace {

using Request = FaultyHttpServer::Request;
using Reply = FaultyHttpServer::Reply;

constexpr const char* soundSizes =
    R"({"sites":100,"tetrahedra":900,"bytes":5000,"warps":false,"tag":"t","meshes":[[8,6,50,0],[100,400,0,0]]})";

Result<std::shared_ptr<const ServedModel>> modelThatSays(const std::string& sizes)
{
    const FaultyHttpServer server(
        "", [&](const Request&, std::size_t, Reply& reply) { reply.become(200, sizes, "application/json"); });
    return ServedModel::ask(server.address(), "", {});
}

/// The facts beside a mesh of one tetrahedron.
std::string factsOf(const std::string& figures, const std::string& method = "closed-set")
{
    return R"({"tag":"t","overlaps":false,"mesh":{"method":")" + method + "\"," + figures + "}}";
}

std::string packedMesh(const std::string& facts, const std::vector<float>& births, const std::vector<float>& deaths)
{
    TetrahedralMesh mesh;
    for (const Eigen::Vector3d& place :
         {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(0, 0, 1)}) {
        mesh.positions.push_back(place);
        mesh.values.push_back(1);
    }
    mesh.tetrahedra.push_back({0, 1, 2, 3});
    const auto bytes = packMesh(mesh, births, deaths, facts);
    return bytes ? std::string(reinterpret_cast<const char*>(bytes->data()), bytes->size()) : std::string();
}

/// What extracting gives of a server that answers with such a mesh.
Result<std::shared_ptr<const ExtractedMesh>>
meshThatSays(const std::string& facts, const std::vector<float>& births = {}, const std::vector<float>& deaths = {})
{
    const std::string mesh = packedMesh(facts, births, deaths);
    const FaultyHttpServer server("", [&](const Request& request, std::size_t, Reply& reply) {
        if (request.path.find("empty=yes") == std::string::npos)
            reply.become(200, soundSizes, "application/json");
        else
            reply.become(200, mesh, "application/vnd.tan.mesh");
    });
    const auto model = ServedModel::ask(server.address(), "", {});
    if (!model)
        return model.error();
    return (*model)->extract({}, {});
}

bool isRefused(const Error& error, const std::string& why)
{
    const bool said = error.text().find("of its model is impossible: " + why + ". Tell ") != std::string::npos;
    if (!said)
        qWarning("%s", error.text().c_str());
    return said && error.kind == ErrorKind::BadInput && !error.file.empty();
}

} // namespace

class ServedModelTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        for (const char* name : {"http_proxy", "all_proxy", "HTTP_PROXY", "ALL_PROXY"})
            qunsetenv(name);
    }

    void impossibleSizes_data()
    {
        QTest::addColumn<QByteArray>("from");
        QTest::addColumn<QByteArray>("to");
        QTest::addColumn<QByteArray>("why");
        const auto row = [](const char* name, const char* from, const char* to, const char* why) {
            QTest::newRow(name) << QByteArray(from) << QByteArray(to) << QByteArray(why);
        };
        row("sites", R"("sites":100)", R"("sites":4294967295)", "it has 4294967295 sites");
        row("few sites", R"("sites":100)", R"("sites":3)", "it has 3 sites");
        row("tetrahedra", ":900", ":18446744073709551615", "it has 18446744073709551615 tetrahedra");
        row("no tetrahedra", ":900", ":0", "it has 0 tetrahedra");
        row("bytes", ":5000", ":18446744073709551615", "it has 18446744073709551615 bytes");
        row("mesh of too many sites", "[100,400", "[101,400", "a mesh has 101 of its 100 sites");
        row("mesh of too many tetrahedra", "[100,400", "[100,901", "a mesh has 901 of its 900 tetrahedra");
        row("mesh of none", "[8,6", "[8,0", "a mesh has 0 of its 900 tetrahedra");
        row("error", "[8,6,50,0]", "[8,6,-1,0]", "a mesh has the error -1 % and the warping 0 %");
        row("order", "[8,6,50,0],[100", "[100,6,50,0],[8", "a mesh with 100 sites comes before one with 8");
    }
    void impossibleSizes()
    {
        QFETCH(QByteArray, from);
        QFETCH(QByteArray, to);
        QFETCH(QByteArray, why);
        QVERIFY(modelThatSays(soundSizes).ok());
        const auto model = modelThatSays(QByteArray(soundSizes).replace(from, to).toStdString());
        QVERIFY(!model.ok());
        QVERIFY(isRefused(model.error(), why.toStdString()));
    }

    void impossibleOffers()
    {
        const auto offerOf = [](const std::string& about) {
            const FaultyHttpServer server(
                "", [&](const Request&, std::size_t, Reply& reply) { reply.become(200, about, "application/json"); });
            return askServer(server.address(), "");
        };
        const auto sound = offerOf(R"({"form":"packed","bytes":5000,"unpacked_bytes":90000,"sites":100})");
        QVERIFY(sound.ok() && sound->findsMeshes && sound->sites == 100);
        const auto large =
            offerOf(R"({"form":"packed","bytes":5000,"unpacked_bytes":18446744073709551615,"sites":100})");
        QVERIFY(!large.ok() && isRefused(large.error(), "it has 18446744073709551615 bytes"));
        const auto empty = offerOf(R"({"form":"packed","bytes":5000,"unpacked_bytes":90000,"sites":0})");
        QVERIFY(!empty.ok() && isRefused(empty.error(), "it has 0 sites"));
    }

    void impossibleMeshes()
    {
        const char* const sound =
            R"("whole_sites":4,"whole_tetrahedra":1,"kept_sites":4,"kept_tetrahedra":1,"scale":1)";
        const auto mesh = meshThatSays(factsOf(sound));
        QVERIFY2(mesh.ok(), mesh ? "" : mesh.error().text().c_str());
        const auto refused = [&](const char* from, const char* to, const char* why) {
            const auto wrong = meshThatSays(factsOf(QByteArray(sound).replace(from, to).toStdString()));
            return !wrong.ok() && isRefused(wrong.error(), why);
        };
        QVERIFY(refused("whole_sites\":4", "whole_sites\":101", "a mesh has 4 of 101 sites, and the model 100"));
        QVERIFY(refused("kept_sites\":4", "kept_sites\":5", "a mesh has 5 of 4 sites, and the model 100"));
        QVERIFY(refused("whole_tetrahedra\":1", "whole_tetrahedra\":901",
                        "a mesh has 1 of 901 tetrahedra, and the model 900"));
        QVERIFY(refused("scale\":1", "scale\":0.5", "a mesh keeps 0.5 times the error"));
        const float none = std::numeric_limits<float>::quiet_NaN(), always = std::numeric_limits<float>::infinity();
        QVERIFY(meshThatSays(factsOf(sound), {always}, {0}).ok());
        const auto lives = meshThatSays(factsOf(sound), {always}, {none});
        QVERIFY(!lives.ok() &&
                isRefused(lives.error(), "a tetrahedron exists at errors that are not numbers of at least 0"));
    }
};

QTEST_GUILESS_MAIN(ServedModelTest)
#include "served_model_test.moc"
