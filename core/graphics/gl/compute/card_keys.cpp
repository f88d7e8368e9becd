// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/gl/compute/card_keys.h"

#include <array>
#include <bit>

namespace tetra {
namespace {

constexpr std::string_view orderingTetrahedra = "Ordering the tetrahedra";
/// Rounds that are asked for at once: whether they changed anything is known only when the card has done them.
constexpr unsigned roundsAtOnce = 8;
/// Of a Delaunay mesh of points in a box most circumspheres have their centres in it; keys beyond four times what these
/// have are not told apart at first.
constexpr double keyMargin = 4;

/// A double as the sum of three floats.
void setEye(const GlProgram& program, const Eigen::Vector3d& eye)
{
    const Eigen::Vector3f high = eye.cast<float>();
    const Eigen::Vector3d rest = eye - high.cast<double>();
    const Eigen::Vector3f middle = rest.cast<float>();
    program.set("eyeHigh", high);
    program.set("eyeMiddle", middle);
    program.set("eyeLow", Eigen::Vector3f((rest - middle.cast<double>()).cast<float>()));
}

double largestKey(const EyePoint& eye, const Eigen::AlignedBox3d& bounds)
{
    const double size = bounds.diagonal().norm();
    return keyMargin * (eye.perspective ? ((eye.place - bounds.center()).norm() + size) * size : size);
}

} // namespace

void CardKeys::begin(const ComputeContext& context, const GlProgram& program, const CardMesh& mesh, const EyePoint& eye,
                     const Eigen::AlignedBox3d& bounds)
{
    facing_.reserve(context, mesh.cellCount * sizeof(unsigned));
    keys_.reserve(context, mesh.cellCount * sizeof(unsigned));
    program.use();
    program.set("count", static_cast<unsigned>(mesh.cellCount));
    program.set("perspective", eye.perspective ? 1 : 0);
    program.set("middle", Eigen::Vector3f(bounds.center().cast<float>()));
    program.set("keyScale", static_cast<float>(1 / largestKey(eye, bounds)));
    setEye(program, eye.place);
    bindStorage(context, {&mesh.vertices, &mesh.corners, &facing_, &keys_});
    runFor(context, mesh.cellCount);
}

/// Some rounds; true if the last one found nothing more to change.
bool CardKeys::relax(const ComputeContext& context, const GlProgram& program, const CardMesh& mesh)
{
    std::array<unsigned, roundsAtOnce> changes{};
    changes_.fill(context, std::as_bytes(std::span(changes)));
    program.use();
    program.set("count", static_cast<unsigned>(mesh.cellCount));
    bindStorage(context, {&mesh.neighbours, &facing_, &keys_, &changes_});
    for (unsigned round = 0; round < roundsAtOnce; ++round) {
        program.set("thisRound", round);
        runFor(context, mesh.cellCount);
    }
    changes_.read(context, 0, std::as_writable_bytes(std::span(changes)));
    rounds_ += roundsAtOnce;
    return changes.back() == 0;
}

Result<bool> CardKeys::make(const ComputeContext& context, const ComputePrograms& programs, const CardMesh& mesh,
                            const EyePoint& eye, const Eigen::AlignedBox3d& bounds, const Progress& progress)
{
    rounds_ = 0;
    bits_ = 32;
    if (mesh.cellCount == 0)
        return true;
    begin(context, *programs.face, mesh, eye, bounds);
    bool right = false;
    while (!right && rounds_ < mostRounds) {
        if (progress.cancelled())
            return cancelledError(orderingTetrahedra);
        right = relax(context, *programs.relax, mesh);
        if (Status status = checkDriver(context); !status)
            return status.error();
    }
    return right;
}

void CardKeys::take(const ComputeContext& context, std::span<const std::uint32_t> order)
{
    Buffer<std::uint32_t> ranks(order.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        ranks[order[i]] = static_cast<std::uint32_t>(i);
    keys_.fill(context, std::as_bytes(std::span(ranks)));
    bits_ = static_cast<unsigned>(std::bit_width(order.size()));
}

} // namespace tetra
