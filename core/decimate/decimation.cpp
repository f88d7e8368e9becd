// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimate/decimation.h"

#include "core/base/guarded.h"
#include "core/base/progress.h"
#include "core/decimate/collapse_orders.h"
#include "core/decimate/decimated_mesh.h"
#include "core/geometry/hilbert_order.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>
#include <vector>

namespace tetra {

namespace {

/// A copy of a mesh in which what lies near in space lies near in memory: points along a Hilbert curve, tetrahedra by
/// their first point. Looking at a star then waits for memory a third as long.
class RenumberedMesh {
public:
    /// May throw std::bad_alloc.
    explicit RenumberedMesh(const DecimationMesh& mesh);

    /// Refers to this.
    DecimationMesh view() const { return {positions_, physical_, values_, weights_, tetrahedra_, box_, leftHanded_}; }
    /// For each point its number in the mesh that was copied.
    const std::vector<std::uint32_t>& originals() const noexcept { return originals_; }

private:
    std::vector<std::uint32_t> originals_;
    std::vector<Eigen::Vector3d> positions_;
    std::vector<Eigen::Vector3d> physical_;
    std::vector<double> values_;
    std::vector<float> weights_;
    std::vector<std::array<std::uint32_t, 4>> tetrahedra_;
    bool box_;
    bool leftHanded_;
};

Error cannotDecimate(const Message& text)
{
    return {ErrorKind::BadInput, Message::say("The mesh cannot be decimated: %1", text)};
}

Status checkSizes(const DecimationMesh& mesh)
{
    const std::size_t points = mesh.positions.size();
    if (points >= 0xffffffff || mesh.tetrahedra.size() >= std::size_t(1) << 30)
        return Error{
            ErrorKind::OutOfResource,
            Message::say(
                "Meshes of more than 4294967294 points or 1073741823 tetrahedra cannot be decimated. Take a part.")};
    if (mesh.tetrahedra.empty())
        return cannotDecimate(Message::say("it has no tetrahedra."));
    if (mesh.values.size() != points || (!mesh.physical.empty() && mesh.physical.size() != points) ||
        (!mesh.weights.empty() && mesh.weights.size() != points))
        return cannotDecimate(
            Message::say("it does not have one value, weight and position for each of its %1 points.", points));
    return {};
}

Status checkNumbers(const DecimationMesh& mesh)
{
    const auto finite = [](const Eigen::Vector3d& position) { return position.allFinite(); };
    for (const auto& positions : {mesh.positions, mesh.physical})
        if (const auto bad = std::ranges::find_if_not(positions, finite); bad != positions.end())
            return cannotDecimate(Message::say("point %1 has no finite position.", bad - positions.begin()));
    if (const auto bad = std::ranges::find_if_not(mesh.values, [](double value) { return std::isfinite(value); });
        bad != mesh.values.end())
        return cannotDecimate(Message::say("point %1 has no finite value.", bad - mesh.values.begin()));
    if (!std::ranges::all_of(mesh.weights, [](float weight) { return weight > 0 && weight <= 1; }))
        return cannotDecimate(Message::say("weights must be above 0 and at most 1."));
    std::vector<bool> used(mesh.positions.size(), false);
    for (const auto& tetrahedron : mesh.tetrahedra)
        for (const std::uint32_t vertex : tetrahedron) {
            if (vertex >= used.size())
                return cannotDecimate(Message::say("a tetrahedron has vertex %1, which does not exist.", vertex));
            used[vertex] = true;
        }
    if (const auto alone = std::ranges::find(used, false); alone != used.end())
        return cannotDecimate(Message::say("point %1 is in no tetrahedron. Leave it out.", alone - used.begin()));
    return {};
}

Status checkDecimationOptions(const DecimationMesh& mesh, const DecimationOptions& options)
{
    const bool warps = !mesh.box || !mesh.physical.empty();
    if (!(options.warpingWeight >= 0) || !std::isfinite(options.warpingWeight) || (warps && options.warpingWeight == 0))
        return Error{ErrorKind::WrongUsage, Message::say("The weight of the warping must be a positive number.")};
    if (!(options.stopKey >= 0))
        return Error{ErrorKind::WrongUsage, Message::say("The error at which to stop must not be negative.")};
    return {};
}

Status collapseInOrder(DecimatedMesh& mesh, const DecimationOptions& options, const Progress& progress)
{
    switch (options.order) {
    case DecimationOrder::PaperEstimates:
        return decimateByEstimates(mesh, options.warpingWeight, options.stopKey, progress, options.state);
    case DecimationOrder::IndependentRounds: return decimateInRounds(mesh, options.stopKey, progress, options.state);
    case DecimationOrder::ExactError: break;
    }
    return decimateByExactError(mesh, options.stopKey, progress, options.state);
}

/// What is reported and asked on the way, between collapses: also for a look at the mesh.
Progress withPreviews(const Progress& progress, const DecimationOptions& options,
                      std::function<Status(HistorySink& history)> hand)
{
    using Clock = std::chrono::steady_clock;
    static constexpr std::chrono::milliseconds shortest(500);
    static constexpr int timesTheirTime = 5; // so that looks take a sixth of the time
    return progress.withCallback([progress, preview = options.preview, hand = std::move(hand),
                                  next = Clock::now()](double fraction, const Message& activity) mutable {
        progress.report(fraction, activity);
        const auto begin = Clock::now();
        if (begin < next)
            return;
        preview(hand);
        const auto end = Clock::now();
        next = end + std::max<Clock::duration>(shortest, timesTheirTime * (end - begin));
    });
}

Result<DecimationResult> decimateSound(const DecimationMesh& mesh, const DecimationOptions& options, HistorySink& sink,
                                       const Progress& progress)
{
    const RenumberedMesh renumbered(mesh);
    DecimatedMesh decimated(renumbered.view(), options);
    const CollapseLog& log = decimated.log();
    const HistoryTraits traits{.warpingWeight = decimated.warps() ? options.warpingWeight : 0, .delaunay = false};
    const auto handMesh = [&](HistorySink& history) {
        const Status begun = history.begin(traits);
        return begun ? log.handCoarsest(renumbered.originals(), decimated.coarsest(), decimated.key(), history) : begun;
    };
    const Progress collapsing = progress.part(0, .9);
    const auto isKept = [&options] { return options.keepWhenCancelled != nullptr && *options.keepWhenCancelled; };
    const Status collapsed =
        collapseInOrder(decimated, options, options.preview ? withPreviews(collapsing, options, handMesh) : collapsing);
    if (!collapsed && !(collapsed.error().kind == ErrorKind::Cancelled && isKept()))
        return collapsed.error();
    if (Status status = sink.begin(traits); !status)
        return status.error();
    const std::vector<CollapseLog::Coarsest> coarsest = decimated.coarsest();
    const Progress writing = untilGivenUp(progress.part(.9, 1), isKept);
    if (Status status = log.replay(renumbered.originals(), coarsest, 0, sink, writing); !status)
        return status.error();
    const auto pointCount = static_cast<std::uint32_t>(mesh.positions.size());
    return DecimationResult{pointCount, pointCount - log.collapseCount(), log.tetrahedronCount() + coarsest.size(),
                            decimated.evaluations(), !collapsed.ok()};
}

} // namespace

Result<DecimationResult> decimate(const DecimationMesh& mesh, const DecimationOptions& options, HistorySink& sink,
                                  const Progress& progress)
{
    for (const Status& status : {checkSizes(mesh), checkDecimationOptions(mesh, options)})
        if (!status)
            return status.error();
    const auto decimateChecked = [&]() -> Result<DecimationResult> {
        if (Status status = checkNumbers(mesh); !status)
            return status.error();
        return decimateSound(mesh, options, sink, progress);
    };
    return guarded(
        Message::marked(
            "Not enough memory to decimate this mesh. Close other programs, use a machine with more memory, or "
            "take a part of the data."),
        decimateChecked);
}

std::uint64_t decimationBytes(std::uint64_t points, std::uint64_t tetrahedra)
{
    // Measured on lattices, grids and irregular meshes: two thirds of it are the log, some 18 tetrahedra a point.
    constexpr std::uint64_t bytesPerPoint = 800, bytesPerTetrahedron = 110;
    return points * bytesPerPoint + tetrahedra * bytesPerTetrahedron;
}

namespace {

using Tetrahedra = std::vector<std::array<std::uint32_t, 4>>;

std::vector<std::uint32_t> alongCurve(std::span<const Eigen::Vector3d> positions)
{
    // By floats: the order of a model's vertices, and so its bytes, are the same whether a place has more digits.
    std::vector<Eigen::Vector3d> places;
    places.reserve(positions.size());
    for (const Eigen::Vector3d& position : positions)
        places.emplace_back(position.cast<float>().cast<double>());
    Buffer<KeyedIndex> keys = spatialKeys(places);
    radixSort(keys, spatialKeyBits);
    std::vector<std::uint32_t> order;
    order.reserve(keys.size());
    for (const KeyedIndex& key : keys)
        order.push_back(key.index);
    return order;
}

/// With other numbers, by the smallest of them.
Tetrahedra renumbered(std::span<const std::array<std::uint32_t, 4>> tetrahedra, std::span<const std::uint32_t> numbers)
{
    const auto firstOf = [numbers](const std::array<std::uint32_t, 4>& t) {
        return std::min({numbers[t[0]], numbers[t[1]], numbers[t[2]], numbers[t[3]]});
    };
    std::vector<std::uint32_t> places(numbers.size() + 1, 0);
    for (const auto& tetrahedron : tetrahedra)
        ++places[firstOf(tetrahedron) + 1];
    for (std::size_t i = 1; i < places.size(); ++i)
        places[i] += places[i - 1];
    Tetrahedra result(tetrahedra.size());
    for (const auto& tetrahedron : tetrahedra) {
        auto& to = result[places[firstOf(tetrahedron)]++];
        for (std::size_t i = 0; i < 4; ++i)
            to[i] = numbers[tetrahedron[i]];
    }
    return result;
}

template <class Number>
std::vector<Number> reordered(std::span<const Number> numbers, std::span<const std::uint32_t> order)
{
    std::vector<Number> result;
    if (numbers.empty())
        return result;
    result.reserve(order.size());
    for (const std::uint32_t index : order)
        result.push_back(numbers[index]);
    return result;
}

RenumberedMesh::RenumberedMesh(const DecimationMesh& mesh)
    : originals_(alongCurve(mesh.positions)), positions_(reordered(mesh.positions, originals_)),
      physical_(reordered(mesh.physical, originals_)), values_(reordered(mesh.values, originals_)),
      weights_(reordered(mesh.weights, originals_)), box_(mesh.box), leftHanded_(mesh.leftHanded)
{
    std::vector<std::uint32_t> numbers(originals_.size());
    for (std::uint32_t number = 0; number < originals_.size(); ++number)
        numbers[originals_[number]] = number;
    tetrahedra_ = renumbered(mesh.tetrahedra, numbers);
}

} // namespace

} // namespace tetra
