// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/renderer.h"
#include "tests/core/render/lattice_mesh.h"

#include <QJsonObject>
#include <QPluginLoader>
#include <QTest>

namespace tetra::testing {

inline const Eigen::AlignedBox3d unitBox(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 1, 1));

/// The distance from the middle of the unit box, on a lattice of so many cells an edge.
inline std::shared_ptr<const TetrahedralMesh> cone(std::uint32_t cells)
{
    return std::make_shared<const TetrahedralMesh>(
        latticeMesh(cells, 1, Split::Six, [](const Eigen::Vector3d& p) { return (p.array() - 0.5).matrix().norm(); }));
}

inline std::shared_ptr<const Scene> prepared(RendererSession& session, const ParameterValues& values)
{
    auto scene = session.prepare(values, {}, {});
    if (!scene)
        qFatal("%s", scene.error().text().c_str());
    return *scene;
}

/// Checks that the renderer shows the boundary of its mesh as its parameters say, behind `before` other surfaces.
inline void checkBoundary(const Renderer& renderer, std::size_t before)
{
    const auto session = renderer.open(cone(4), unitBox);
    const auto boundaryOf = [&](const ParameterValues& values) {
        const auto scene = prepared(*session, values);
        return scene->surfaces.size() == before + 1 ? scene->surfaces.back() : Surface();
    };
    QCOMPARE(prepared(*session, {})->surfaces.size(), before);
    const Surface faint = boundaryOf({{"boundary", std::string("translucent")}, {"boundary-opacity", 0.4}});
    QVERIFY(faint.mesh);
    QCOMPARE(faint.mesh->triangles.size(), std::size_t(6 * 4 * 4 * 2));
    QVERIFY(faint.opacity == 0.4f && !faint.backFacesOnly && faint.mesh->colours.empty());
    const TransferFunction red = transferFunctionFromPoints({{0, {1, 0, 0}, 0.5f}, {1, {1, 0, 0}, 0.5f}}, 1);
    const Surface coloured = boundaryOf({{"boundary", std::string("values")},
                                         {"boundary-far-side", true},
                                         {"transfer", red},
                                         {"boundary-opacity", 0.4}});
    QVERIFY(coloured.mesh && coloured.opacity == 1 && coloured.backFacesOnly);
    QVERIFY(!coloured.mesh->colours.empty());
    for (const Colour& colour : coloured.mesh->colours)
        QVERIFY(colour == (Colour{1, 0, 0}));
    const auto wrong = session->prepare({{"boundary", std::string("translucent")}, {"boundary-opacity", 0.0}}, {}, {});
    QVERIFY(!wrong && wrong.error().kind == ErrorKind::WrongUsage);
}

/// Checks that the file is a plugin that says that it is the renderer of this name, and loads.
inline void checkRendererPlugin(const QString& file, const QString& id)
{
    QPluginLoader loader(file);
    const QJsonObject metadata = loader.metaData().value("MetaData").toObject();
    QCOMPARE(metadata.value("id").toString(), id);
    QCOMPARE(metadata.value("kind").toString(), "renderer");
    QVERIFY2(loader.instance() != nullptr, qPrintable(loader.errorString()));
    QVERIFY(qobject_cast<Renderer*>(loader.instance()) != nullptr);
}

} // namespace tetra::testing
