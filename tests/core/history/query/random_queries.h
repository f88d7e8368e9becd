// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/verify/verify_mesh.h"
#include "tests/core/history/model_fixture.h"
#include "tests/core/history/query/brute_force.h"

#include <tan/query.h>

#include <QtGlobal>

#include <algorithm>
#include <array>
#include <memory>
#include <random>

namespace tetra {

inline double between(std::mt19937& random, double least, double most)
{
    return std::uniform_real_distribution(least, most)(random);
}

inline Eigen::Vector3d placeIn(std::mt19937& random, const Eigen::AlignedBox3d& bounds)
{
    return {between(random, bounds.min().x(), bounds.max().x()), between(random, bounds.min().y(), bounds.max().y()),
            between(random, bounds.min().z(), bounds.max().z())};
}

inline SpaceRamp randomRamp(std::mt19937& random, const Model& model)
{
    const Eigen::AlignedBox3d& bounds = model.description().bounds;
    SpaceRamp ramp;
    const Eigen::Vector3d one = placeIn(random, bounds);
    const Eigen::Vector3d other = placeIn(random, bounds);
    switch (random() % 3) {
    case 0: ramp.region = Box{one.cwiseMin(other), one.cwiseMax(other)}; break;
    case 1: ramp.region = Sphere{one, between(random, 0, 0.4) * bounds.diagonal().norm()}; break;
    default: ramp.region = HalfSpace{(other - one).normalized(), one.dot((other - one).normalized())};
    }
    ramp.inner = between(random, 0, 20);
    ramp.outer = between(random, 20, 90);
    ramp.falloff = random() % 2 == 0 ? 0 : between(random, 0, 1) * bounds.diagonal().norm();
    return ramp;
}

inline ErrorField randomField(std::mt19937& random, const Model& model)
{
    const ValueRange range = model.description().range;
    const ErrorField first = randomRamp(random, model);
    const double isovalue = between(random, range.minimum, range.maximum);
    const ErrorField second = range.extent() > 0 ? ErrorField::nearValues(std::array{isovalue}, between(random, 0, 20),
                                                                          80, between(random, 0.01, 1) * range.extent())
                                                 : ErrorField(7);
    switch (random() % 5) {
    case 0: return second;
    case 1: return smallerOf(first, second);
    case 2: return first * second * ErrorField(0.05);
    case 3: return first + second;
    default: return first;
    }
}

inline MeshQuery randomQuery(std::mt19937& random, const Model& model)
{
    MeshQuery query;
    query.error = randomField(random, model);
    query.warping = query.error;
    query.method = VariableMethod::ClosedSet;
    return query;
}

/// Whether the independent judge proves the mesh; says what it finds.
inline bool isProved(const Model& model, const Dataset& dataset, const MeshQuery& query, const ExtractedMesh& mesh)
{
    const auto verdict = verifyMesh(model, dataset, query, mesh);
    if (!verdict) {
        qWarning("%s", verdict.error().text().c_str());
        return false;
    }
    for (const std::string& failure : verdict->failures)
        qWarning("%s", failure.c_str());
    if (!verdict->ok())
        qWarning("not proved: %s", verdict->failures.empty() ? "by its figures" : "see above");
    return verdict->ok();
}

/// Whether it is the mesh that was found by going through the whole history.
inline bool isMesh(const Model& model, const BruteForce& brute, const ExtractedMesh& mesh,
                   const BruteForce::Answer& expected)
{
    std::vector<std::array<std::uint32_t, 4>> tetrahedra;
    for (const std::uint64_t t : expected.tetrahedra)
        tetrahedra.push_back(brute.corners(t));
    std::vector<std::uint32_t> points;
    for (const std::uint32_t site : mesh.sites) {
        points.push_back(model.points()[site]);
        if (!expected.sites[site]) {
            qWarning("site %u is more than the smallest closed set", site);
            return false;
        }
    }
    return std::ranges::count(expected.sites, true) == static_cast<std::ptrdiff_t>(mesh.sites.size()) &&
           mesh.scale == expected.scale &&
           byPoints(mesh.mesh.tetrahedra, points) == byPoints(tetrahedra, model.points());
}

/// Whether it says what its tetrahedra say of themselves, and of the mesh that each died in: never more than is kept.
inline bool isReachedToldOf(const Model& model, const MeshQuery& query, const ExtractedMesh& mesh,
                            const BruteForce::Answer& expected)
{
    const ModelDescription& about = model.description();
    double error = 0, warping = 0;
    for (const std::uint64_t t : expected.tetrahedra) {
        const std::uint32_t destroyer = model.destroyers()[t];
        const double key = destroyer == Model::never ? model.finalKey() : model.runningKeys()[destroyer];
        error = std::max(error, std::min(model.ownError(t), key));
        if (about.warpingWeight > 0)
            warping = std::max(warping, std::min(model.ownWarping(t), key / about.warpingWeight));
    }
    const Accuracy right{about.range.extent() > 0 ? 100 * error / about.range.extent() : 0,
                         about.warpingWeight > 0 ? 100 * warping / model.diagonal() : 0};
    constexpr double nearly = 1 + 1e-9;
    const bool isRight =
        mesh.reached && mesh.reached->error <= right.error * nearly && right.error <= mesh.reached->error * nearly &&
        mesh.reached->warping <= right.warping * nearly && right.warping <= mesh.reached->warping * nearly;
    const double most = keptPercent(query.error.bounds().maximum, mesh.scale);
    if (!isRight || !(mesh.reached->error <= most * nearly))
        qWarning("reached: error %.17g, right %.17g, at most %.17g; warping %.17g, right %.17g",
                 mesh.reached ? mesh.reached->error : -1, right.error, most, mesh.reached ? mesh.reached->warping : -1,
                 right.warping);
    return isRight && mesh.reached->error <= most * nearly;
}

/// All of it.
inline bool isAnswer(const Model& model, const Dataset& dataset, const BruteForce& brute, const MeshQuery& query,
                     const ExtractedMesh& mesh, const BruteForce::Answer& expected)
{
    return isMesh(model, brute, mesh, expected) && isReachedToldOf(model, query, mesh, expected) &&
           isProved(model, dataset, query, mesh);
}

/// Whether three random fields, one after the other, give their smallest closed sets.
inline bool areFieldsKept(std::mt19937& random, const std::shared_ptr<const Model>& model, const Dataset& dataset)
{
    const BruteForce brute(*model);
    MeshExtractor extractor(model);
    for (int round = 0; round < 3; ++round) {
        const MeshQuery query = randomQuery(random, *model);
        const auto mesh = extractor.extract(query);
        if (!mesh)
            qWarning("%s", mesh.error().text().c_str());
        if (!mesh || !isAnswer(*model, dataset, brute, query, **mesh, brute.smallestClosedSet(query)))
            return false;
    }
    return true;
}

/// Whether a random budget gives the finest closed set of a random field that fits, or is refused where none does.
inline bool isBudgetKept(std::mt19937& random, const std::shared_ptr<const Model>& model, const Dataset& dataset)
{
    const BruteForce brute(*model);
    MeshExtractor extractor(model);
    MeshQuery query = randomQuery(random, *model);
    query.budget = 1 + random() % (model->meshSizes().back() + 10);
    const auto mesh = extractor.extract(query);
    const auto expected = brute.closedSetWithin(query);
    if (!expected)
        return !mesh && mesh.error().kind == ErrorKind::WrongUsage;
    return mesh && (*mesh)->mesh.tetrahedra.size() <= *query.budget &&
           isAnswer(*model, dataset, brute, query, **mesh, *expected);
}

} // namespace tetra
