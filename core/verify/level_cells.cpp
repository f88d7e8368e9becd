// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/verify/level_cells.h"
#include "core/base/progress.h"
#include "core/mesh/topology.h"
#include "core/verify/findings.h"

#include <tan/base.h>

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <compare>
#include <limits>
#include <string>

namespace tetra {

MeshBounds::MeshBounds(double error, double warping) : error_(error), warping_(warping) {}

MeshBounds::MeshBounds(const MeshQuery& query, double scale, const Dataset& original)
    : errorField_(query.error), warpingField_(query.warping), scale_(scale), original_(&original),
      extent_(original.values.range().extent()), diagonal_(original.bounds().diagonal().norm())
{
}

/// In %.
double MeshBounds::asked(const ErrorField& field, std::uint64_t sample) const
{
    return field.at(original_->position(sample), original_->values.at(sample));
}

double MeshBounds::error(std::uint64_t sample) const
{
    constexpr double allowance = 1e-12; // of the range
    if (areUniform())
        return error_;
    const double percent = asked(errorField_, sample);
    const bool warps = original_->domain == DomainClass::Curvilinear || original_->domain == DomainClass::Irregular;
    return warps && percent >= anyError ? std::numeric_limits<double>::infinity()
                                        : (keptPercent(percent, scale_) / 100 + allowance) * extent_;
}

double MeshBounds::warping(std::uint64_t sample) const
{
    if (areUniform())
        return warping_;
    const double percent = asked(warpingField_, sample);
    return percent >= anyWarping ? std::numeric_limits<double>::infinity()
                                 : keptPercent(percent, scale_) / 100 * diagonal_;
}

namespace {

constexpr std::uint64_t facesAtOnce = 8 << 20;

/// A face as one of its cells sees it.
struct LevelFace {
    Triangle vertices; ///< in increasing order
    bool odd;          ///< whether sorting them turned the face over
    std::uint32_t cell;

    /// Cells break ties, so that messages do not depend on the sorting.
    std::strong_ordering operator<=>(const LevelFace& other) const
    {
        if (const auto order = vertices <=> other.vertices; order != 0)
            return order;
        return cell <=> other.cell;
    }
};

/// Face `opposite` of a cell, with its normal outwards before it was sorted.
LevelFace faceOf(const Tetrahedron& s, int opposite, std::uint32_t cell)
{
    const auto& c = cornersOfFace[static_cast<std::size_t>(opposite)];
    LevelFace face{{s[c[0]], s[c[1]], s[c[2]]}, false, cell};
    for (const auto& [first, second] : {std::pair{0, 1}, std::pair{1, 2}, std::pair{0, 1}})
        if (face.vertices[first] > face.vertices[second]) {
            std::swap(face.vertices[first], face.vertices[second]);
            face.odd = !face.odd;
        }
    return face;
}

class FaceCheck {
public:
    FaceCheck(const LevelCells& cells, const FaceRule& rule, std::vector<BoundaryFace>* boundary)
        : cells_(cells), rule_(rule), boundary_(boundary)
    {
    }

    Status run(const Progress& progress);
    void moveTo(LevelReport& verdict)
    {
        verdict.conforming = findings_.none();
        findings_.moveTo(verdict.failures);
    }

private:
    std::vector<std::uint32_t> batches() const;
    void gather(std::uint32_t firstVertex, std::uint32_t endVertex);
    void checkBatch();
    void checkFace(std::span<const LevelFace> sameFace);

    const LevelCells& cells_;
    const FaceRule& rule_;
    std::vector<BoundaryFace>* boundary_;
    std::vector<LevelFace> faces_;
    Findings findings_;
};

/// Ranges of the smallest vertex of a face that hold about facesAtOnce faces each; the bounds, the last one beyond all.
std::vector<std::uint32_t> FaceCheck::batches() const
{
    std::vector<std::uint32_t> facesOfSmallest;
    for (std::size_t cell = 0; cell < cells_.size(); ++cell)
        for (int opposite = 0; opposite < 4; ++opposite) {
            const std::uint32_t smallest = faceOf(cells_.vertices(cell), opposite, 0).vertices[0];
            if (smallest >= facesOfSmallest.size())
                facesOfSmallest.resize(smallest + 1);
            ++facesOfSmallest[smallest];
        }
    std::vector<std::uint32_t> bounds = {0};
    std::uint64_t faces = 0;
    for (std::uint32_t vertex = 0; vertex < facesOfSmallest.size(); ++vertex) {
        if (faces > 0 && faces + facesOfSmallest[vertex] > facesAtOnce) {
            bounds.push_back(vertex);
            faces = 0;
        }
        faces += facesOfSmallest[vertex];
    }
    bounds.push_back(static_cast<std::uint32_t>(facesOfSmallest.size()));
    return bounds;
}

Status FaceCheck::run(const Progress& progress)
{
    const std::vector<std::uint32_t> bounds = batches();
    SharedProgress shared(progress, bounds.size() - 1, "Verifying that the cells fit together");
    for (std::size_t batch = 0; batch + 1 < bounds.size(); ++batch) {
        if (shared.cancelled())
            return cancelledError(Message::marked("Verifying the model"));
        gather(bounds[batch], bounds[batch + 1]);
        tbb::parallel_sort(faces_);
        checkBatch();
        shared.done(1);
    }
    return {};
}

void FaceCheck::gather(std::uint32_t firstVertex, std::uint32_t endVertex)
{
    faces_.clear();
    for (std::size_t cell = 0; cell < cells_.size(); ++cell)
        for (int opposite = 0; opposite < 4; ++opposite) {
            const LevelFace face = faceOf(cells_.vertices(cell), opposite, static_cast<std::uint32_t>(cell));
            if (face.vertices[0] >= firstVertex && face.vertices[0] < endVertex)
                faces_.push_back(face);
        }
}

void FaceCheck::checkBatch()
{
    for (auto begin = faces_.begin(); begin != faces_.end();) {
        const auto end = std::find_if(begin, faces_.end(),
                                      [begin](const LevelFace& face) { return face.vertices != begin->vertices; });
        checkFace({begin, end});
        begin = end;
    }
}

void FaceCheck::checkFace(std::span<const LevelFace> sameFace)
{
    const LevelFace& face = sameFace.front();
    std::string wrong;
    if (sameFace.size() == 1 && boundary_ != nullptr) {
        const auto& [a, b, c] = face.vertices;
        boundary_->push_back({face.odd ? std::array{a, c, b} : face.vertices, face.cell});
    }
    if (sameFace.size() > 2)
        wrong = " belongs to " + std::to_string(sameFace.size()) + " cells.";
    else if (sameFace.size() == 2 && face.odd == sameFace.back().odd)
        wrong = " has two cells on the same side.";
    else if (sameFace.size() == 1 && !rule_.onBoundary(face.vertices))
        wrong = " belongs to one cell only and does not lie on the boundary of the domain.";
    else
        return;
    const auto place = [&](int corner) { return rule_.place(face.vertices[static_cast<std::size_t>(corner)]); };
    findings_.add(face.cell, [&] { return "The face " + place(0) + " " + place(1) + " " + place(2) + wrong; });
}

} // namespace

Status verifyFaces(const LevelCells& cells, const FaceRule& rule, LevelReport& verdict, const Progress& progress,
                   std::vector<BoundaryFace>* boundary)
{
    FaceCheck check(cells, rule, boundary);
    const Status done = check.run(progress);
    check.moveTo(verdict);
    return done;
}

} // namespace tetra
