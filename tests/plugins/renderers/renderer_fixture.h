// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/core/render/lattice_mesh.h"
#include "tests/core/render/scene_parts.h"
#include "tests/plugins/plugins_of_this_build.h"

#include <QTest>

#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace tetra::testing {

inline const Eigen::AlignedBox3d unitBox(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 1, 1));

/// The distance from the middle of the unit box, on a lattice of so many cells an edge.
inline std::shared_ptr<const TetrahedralMesh> cone(std::uint32_t cells)
{
    return std::make_shared<const TetrahedralMesh>(
        latticeMesh(cells, 1, Split::Six, [](const Eigen::Vector3d& p) { return (p.array() - 0.5).matrix().norm(); }));
}

/// As the program has it: a plugin that was found and loaded by its host.
inline const Renderer& rendererNamed(const std::string& id)
{
    const auto renderer = pluginsOfThisBuild().renderer(id);
    if (!renderer)
        qFatal("%s", renderer.error().text().c_str());
    return *renderer->plugin;
}

inline std::unique_ptr<RendererSession> open(const std::string& id, std::shared_ptr<const TetrahedralMesh> mesh,
                                             std::optional<FocusMesh> focus = {})
{
    return rendererNamed(id).open({std::move(mesh), std::move(focus), unitBox});
}

inline std::shared_ptr<const Scene> prepared(RendererSession& session, const ParameterValues& values)
{
    auto scene = session.prepare({values}, {});
    if (!scene)
        qFatal("%s", scene.error().text().c_str());
    return *scene;
}

/// Checks that the renderer shows the boundary of its mesh as its parameters say, behind `before` other surfaces.
inline void checkBoundary(const std::string& id, std::size_t before)
{
    const auto session = open(id, cone(4));
    const auto boundaryOf = [&](const ParameterValues& values) {
        const auto scene = prepared(*session, values);
        return partsOf(*scene).surfaces.size() == before + 1 ? partsOf(*scene).surfaces.back() : Surface();
    };
    QCOMPARE(partsOf(*prepared(*session, {})).surfaces.size(), before);
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
    QVERIFY(!coloured.mesh->colours.empty() && coloured.lit == false);
    QVERIFY(boundaryOf({{"boundary", std::string("values")}, {"transfer", red}, {"lit", true}}).lit == true);
    QVERIFY(faint.lit.value_or(true));
    for (const Colour& colour : coloured.mesh->colours)
        QVERIFY(colour == (Colour{1, 0, 0}));
    const auto wrong = session->prepare({{{"boundary", std::string("translucent")}, {"boundary-opacity", 0.0}}}, {});
    QVERIFY(!wrong && wrong.error().kind == ErrorKind::WrongUsage);
}

} // namespace tetra::testing
