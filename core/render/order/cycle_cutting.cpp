// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/order/cycle_cutting.h"

#include "core/mesh/topology.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace tetra {
namespace {

using Eigen::Vector3d;

constexpr std::uint32_t none = 0xffffffff;
/// Places that are nearer to a plane than this part of the cells' extent lie in it.
constexpr double flatness = 1e-12;
/// Pieces of less volume than this part of a cube of their longest edge show nothing.
constexpr double leastVolume = 1e-12;
/// So many faces of a group are tried, and so many of its cells looked at for each, unless no face parts them.
constexpr std::size_t mostPlanes = 48;
constexpr std::size_t mostSides = 256;

/// A corner that the mesh does not have.
struct CutPoint {
    Vector3d place;
    double value;
};

using Piece = std::array<std::uint32_t, 4>; ///< vertices of the mesh, and after them those of cuts

/// A cell, or what is left of it on this side of the cuts.
struct Part {
    std::uint32_t node;
    std::vector<Piece> pieces; ///< front to back; none: the whole cell
};

struct Plane {
    Vector3d normal; ///< of unit length, towards the eye
    double offset;
    double heightOf(const Vector3d& place) const { return normal.dot(place) - offset; }
};

/// A face of a cell, by the cell's node.
struct NodeFace {
    std::uint32_t node;
    std::uint32_t face;
};

/// What hides what among some cells, which are its nodes.
class NodeGraph {
public:
    NodeGraph(const TetrahedralMesh& mesh, const OcclusionGraph& graph, std::span<const std::uint32_t> cells)
        : neighbours_(cells.size(), {none, none, none, none}), first_(cells.size() + 2, 0)
    {
        std::vector<std::uint32_t> nodeOf(graph.cellCount(), none);
        for (std::uint32_t node = 0; node < cells.size(); ++node)
            if (std::ranges::all_of(mesh.tetrahedra[cells[node]],
                                    [&](std::uint32_t vertex) { return mesh.positions[vertex].allFinite(); }))
                nodeOf[cells[node]] = node;
        std::vector<CellRelation> edges;
        for (std::uint32_t node = 0; node < cells.size(); ++node) {
            if (nodeOf[cells[node]] == none)
                continue;
            for (std::size_t face = 0; face < 4; ++face) {
                const std::uint32_t side = graph.adjacency.neighbours[cells[node]][face];
                const std::uint32_t other = side == FaceAdjacency::none ? none : nodeOf[FaceAdjacency::cellOf(side)];
                neighbours_[node][face] = other;
                if (other == none)
                    continue;
                // Of an inverted cell the one across the face may see it otherwise.
                if ((graph.facing[cells[node]] >> face & 1) != 0)
                    edges.push_back({other, node});
                if ((graph.facing[cells[node]] >> face & 16) != 0)
                    edges.push_back({node, other});
            }
        }
        for (const CellRelation& relation : graph.relations)
            if (nodeOf[relation.front] != none && nodeOf[relation.back] != none)
                edges.push_back({nodeOf[relation.front], nodeOf[relation.back]});
        for (const CellRelation& edge : edges)
            ++first_[edge.front + 2];
        for (std::size_t node = 2; node < first_.size(); ++node)
            first_[node] += first_[node - 1];
        hidden_.resize(edges.size());
        for (const CellRelation& edge : edges)
            hidden_[first_[edge.front + 1]++] = edge.back;
    }

    std::span<const std::uint32_t> hiddenBy(std::uint32_t node) const
    {
        return std::span(hidden_).subspan(first_[node], first_[node + 1] - first_[node]);
    }
    /// The node across a face, or none.
    std::uint32_t neighbour(std::uint32_t node, std::size_t face) const { return neighbours_[node][face]; }

private:
    std::vector<std::array<std::uint32_t, 4>> neighbours_;
    std::vector<std::uint32_t> first_; ///< for each node, and after the last the end, in hidden_
    std::vector<std::uint32_t> hidden_;
};

/// Parts a group of nodes into strongly connected ones, by R. Tarjan's algorithm ("Depth-first search and linear graph
/// algorithms", SIAM Journal on Computing 1, 1972), without recursion. Keeps its memory from group to group.
class ComponentFinder {
public:
    explicit ComponentFinder(const NodeGraph& graph, std::size_t nodes)
        : graph_(graph), state_(nodes, State::Outside), number_(nodes), lowest_(nodes)
    {
    }

    /// The components, front to back.
    std::vector<std::vector<std::uint32_t>> find(std::span<const std::uint32_t> nodes)
    {
        components_.clear();
        next_ = 0;
        for (const std::uint32_t node : nodes)
            state_[node] = State::New;
        for (const std::uint32_t node : nodes)
            if (state_[node] == State::New)
                visitFrom(node);
        for (const std::uint32_t node : nodes)
            state_[node] = State::Outside;
        std::ranges::reverse(components_);
        return std::move(components_);
    }

private:
    enum class State : std::uint8_t { Outside, New, Open, Done };
    struct Visit {
        std::uint32_t node;
        std::size_t edge;
    };

    void open(std::uint32_t node)
    {
        number_[node] = lowest_[node] = next_++;
        state_[node] = State::Open;
        open_.push_back(node);
        path_.push_back({node, 0});
    }

    void visitFrom(std::uint32_t start)
    {
        open(start);
        while (!path_.empty()) {
            const std::uint32_t node = path_.back().node;
            const auto hidden = graph_.hiddenBy(node);
            if (path_.back().edge < hidden.size()) {
                const std::uint32_t other = hidden[path_.back().edge++];
                if (state_[other] == State::New)
                    open(other);
                else if (state_[other] == State::Open)
                    lowest_[node] = std::min(lowest_[node], number_[other]);
                continue;
            }
            path_.pop_back();
            if (!path_.empty())
                lowest_[path_.back().node] = std::min(lowest_[path_.back().node], lowest_[node]);
            if (lowest_[node] == number_[node])
                close(node);
        }
    }

    void close(std::uint32_t root)
    {
        const auto first = std::ranges::find(open_.rbegin(), open_.rend(), root).base() - 1;
        components_.emplace_back(first, open_.end());
        for (const std::uint32_t node : components_.back())
            state_[node] = State::Done;
        open_.erase(first, open_.end());
    }

    const NodeGraph& graph_;
    std::vector<State> state_;
    std::vector<std::uint32_t> number_, lowest_;
    std::vector<std::uint32_t> open_;
    std::vector<Visit> path_;
    std::vector<std::vector<std::uint32_t>> components_;
    std::uint32_t next_ = 0;
};

class CycleCutter {
public:
    CycleCutter(const TetrahedralMesh& mesh, const OcclusionGraph& graph, const EyePoint& eye,
                std::span<const std::uint32_t> cells, VisibilityOrder& order)
        : mesh_(mesh), eye_(eye), cells_(cells), graph_(mesh, graph, cells), finder_(graph_, cells.size()),
          partOf_(cells.size(), none), order_(order)
    {
        Eigen::AlignedBox3d bounds;
        for (const std::uint32_t cell : cells)
            for (const std::uint32_t vertex : mesh.tetrahedra[cell])
                if (mesh.positions[vertex].allFinite())
                    bounds.extend(mesh.positions[vertex]);
        if (bounds.isEmpty())
            return;
        flat_ = flatness * bounds.diagonal().norm();
        centre_ = bounds.center();
        if (eye_.perspective)
            eye_.place -= centre_;
    }

    void run()
    {
        std::vector<Part> all;
        for (std::uint32_t node = 0; node < cells_.size(); ++node)
            all.push_back({node, {}});
        part(std::move(all));
        order_.cycles = static_cast<std::size_t>(std::ranges::count_if(groups_, &Group::isCycle));
        while (!groups_.empty()) {
            Group group = std::move(groups_.back());
            groups_.pop_back();
            if (group.isCycle)
                cut(std::move(group.parts));
            else if (group.parts.size() == 1)
                emit(group.parts.front());
            else
                part(std::move(group.parts));
        }
        finish();
    }

private:
    struct Group {
        std::vector<Part> parts;
        bool isCycle = false;
    };
    struct Sides {
        std::size_t near = 0, far = 0, cut = 0;
        bool isDivision() const { return near > 0 && far > 0; }
        std::size_t cost() const { return 2 * cut + std::max(near, far); }
    };

    /// Relative to the middle of the cells: so far from zero, too, heights are what they are.
    Vector3d placeOf(std::uint32_t vertex) const
    {
        return vertex < mesh_.positions.size() ? Vector3d(mesh_.positions[vertex] - centre_)
                                               : points_[vertex - mesh_.positions.size()].place;
    }
    double valueOf(std::uint32_t vertex) const
    {
        return vertex < mesh_.positions.size() ? double(mesh_.values[vertex])
                                               : points_[vertex - mesh_.positions.size()].value;
    }
    std::span<const Piece> piecesOf(const Part& part) const
    {
        return part.pieces.empty() ? std::span<const Piece>(&mesh_.tetrahedra[cells_[part.node]], 1)
                                   : std::span<const Piece>(part.pieces);
    }

    /// Puts the components of a group where it was, the foremost to be taken first.
    void part(std::vector<Part> parts)
    {
        std::vector<std::uint32_t> nodes;
        for (std::uint32_t i = 0; i < parts.size(); ++i) {
            nodes.push_back(parts[i].node);
            partOf_[parts[i].node] = i;
        }
        auto components = finder_.find(nodes);
        for (auto component = components.rbegin(); component != components.rend(); ++component) {
            Group group{{}, component->size() > 1};
            for (const std::uint32_t node : *component)
                group.parts.push_back(std::move(parts[partOf_[node]]));
            groups_.push_back(std::move(group));
        }
    }

    void cut(std::vector<Part> parts)
    {
        const std::optional<Plane> plane = choosePlane(parts);
        if (!plane) {
            ++order_.brokenCycles;
            std::ranges::sort(parts, {}, [&](const Part& one) { return std::pair(distanceOf(one.node), one.node); });
            for (const Part& one : parts)
                emit(one);
            return;
        }
        Group near, far;
        for (Part& one : parts) {
            const auto [before, behind] = reach(one, *plane);
            if (before && behind) {
                auto [nearPart, farPart] = split(one, *plane);
                if (!nearPart.pieces.empty())
                    near.parts.push_back(std::move(nearPart));
                if (!farPart.pieces.empty())
                    far.parts.push_back(std::move(farPart));
            } else {
                (behind ? far : near).parts.push_back(std::move(one));
            }
        }
        groups_.push_back(std::move(far));
        groups_.push_back(std::move(near));
    }

    /// That which parts the group best: into sides as small as can be, with few cuts. Faces between cells of the group
    /// come first, as each such plane takes one of the two from either side.
    std::optional<Plane> choosePlane(std::span<const Part> parts)
    {
        std::vector<NodeFace> inner, all;
        for (std::uint32_t i = 0; i < parts.size(); ++i)
            partOf_[parts[i].node] = i;
        const auto isHere = [&](std::uint32_t node) {
            return partOf_[node] < parts.size() && parts[partOf_[node]].node == node;
        };
        for (const Part& one : parts)
            for (std::uint32_t face = 0; face < 4; ++face) {
                const std::uint32_t other = graph_.neighbour(one.node, face);
                all.push_back({one.node, face});
                if (other != none && other > one.node && isHere(other))
                    inner.push_back({one.node, face});
            }
        std::optional<Plane> best = bestOf(inner, mostPlanes, parts, mostSides);
        if (!best)
            best = bestOf(all, mostPlanes, parts, mostSides);
        return best ? best : bestOf(all, all.size(), parts, parts.size());
    }

    /// Of `most` of the faces, as so many of the parts tell, each about as far from the next as the others.
    std::optional<Plane> bestOf(std::span<const NodeFace> faces, std::size_t most, std::span<const Part> parts,
                                std::size_t asked) const
    {
        std::optional<Plane> best;
        std::size_t leastCost = 0;
        const std::size_t tried = std::min(faces.size(), most), looked = std::min(parts.size(), asked);
        for (std::size_t i = 0; i < tried; ++i) {
            const std::optional<Plane> plane = planeOf(faces[i * faces.size() / tried]);
            if (!plane)
                continue;
            Sides sides;
            for (std::size_t place = 0; place < looked; ++place) {
                const auto [before, behind] = reach(parts[place * parts.size() / looked], *plane);
                sides.near += before || !behind ? 1 : 0;
                sides.far += behind ? 1 : 0;
                sides.cut += before && behind ? 1 : 0;
            }
            if (sides.isDivision() && (!best || sides.cost() < leastCost)) {
                best = plane;
                leastCost = sides.cost();
            }
        }
        return best;
    }

    /// None of a face without area.
    std::optional<Plane> planeOf(const NodeFace& face) const
    {
        std::array<Vector3d, 3> corners;
        for (std::size_t i = 0; i < 3; ++i)
            corners[i] = placeOf(mesh_.tetrahedra[cells_[face.node]][cornersOfFace[face.face][i]]);
        const Vector3d across = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
        const double area = across.norm();
        if (!(area > 0))
            return std::nullopt;
        Plane plane{across / area, 0};
        plane.offset = plane.normal.dot(corners[0]);
        const double towardsEye = eye_.perspective ? plane.heightOf(eye_.place) : plane.normal.dot(eye_.place);
        if (towardsEye < 0)
            plane = {-plane.normal, -plane.offset};
        return plane;
    }

    /// Whether something of it lies before and behind the plane.
    std::pair<bool, bool> reach(const Part& part, const Plane& plane) const
    {
        bool before = false, behind = false;
        for (const Piece& piece : piecesOf(part))
            for (const std::uint32_t vertex : piece) {
                const double height = plane.heightOf(placeOf(vertex));
                before = before || height > flat_;
                behind = behind || height < -flat_;
            }
        return {before, behind};
    }

    std::pair<Part, Part> split(const Part& part, const Plane& plane)
    {
        Part near{part.node, {}}, far{part.node, {}};
        const auto whole = piecesOf(part);
        for (const Piece& piece : std::vector<Piece>(whole.begin(), whole.end()))
            split(piece, plane, near.pieces, far.pieces);
        return {std::move(near), std::move(far)};
    }

    void split(const Piece& piece, const Plane& plane, std::vector<Piece>& near, std::vector<Piece>& far)
    {
        std::array<double, 4> heights;
        std::vector<std::size_t> before, others, behind;
        for (std::size_t i = 0; i < 4; ++i) {
            heights[i] = plane.heightOf(placeOf(piece[i]));
            if (std::abs(heights[i]) <= flat_)
                heights[i] = 0;
            (heights[i] > 0 ? before : heights[i] < 0 ? behind : others).push_back(i);
        }
        if (behind.empty() || before.empty()) {
            (behind.empty() ? near : far).push_back(piece);
            return;
        }
        // A corner in the plane is its own cut; what has no volume by that is left out.
        const auto cutBetween = [&](std::size_t from, std::size_t to) {
            return heights[to] == 0 ? piece[to] : pointBetween(piece[from], piece[to], heights[from], heights[to]);
        };
        if (before.size() == 2 && behind.size() == 2) {
            const std::size_t a = before[0], b = before[1], c = behind[0], d = behind[1];
            const std::uint32_t ac = cutBetween(a, c), ad = cutBetween(a, d), bc = cutBetween(b, c),
                                bd = cutBetween(b, d);
            addPrism({piece[a], ac, ad}, {piece[b], bc, bd}, near);
            addPrism({piece[c], ac, bc}, {piece[d], ad, bd}, far);
            return;
        }
        const bool nearTip = before.size() == 1;
        const std::size_t tip = nearTip ? before[0] : behind[0];
        std::array<std::uint32_t, 3> section{}, base{};
        for (std::size_t i = 0, place = 0; i < 4; ++i)
            if (i != tip) {
                base[place] = piece[i];
                section[place++] = cutBetween(tip, i);
            }
        addPiece({piece[tip], section[0], section[1], section[2]}, nearTip ? near : far);
        addPrism(section, base, nearTip ? far : near);
    }

    std::uint32_t pointBetween(std::uint32_t from, std::uint32_t to, double heightFrom, double heightTo)
    {
        const double share = heightFrom / (heightFrom - heightTo);
        points_.push_back({placeOf(from) + share * (placeOf(to) - placeOf(from)),
                           valueOf(from) + share * (valueOf(to) - valueOf(from))});
        return static_cast<std::uint32_t>(mesh_.positions.size() + points_.size() - 1);
    }

    void addPiece(const Piece& piece, std::vector<Piece>& pieces) const
    {
        std::array<Vector3d, 3> edges;
        double longest = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            edges[i] = placeOf(piece[i + 1]) - placeOf(piece[0]);
            longest = std::max(longest, edges[i].norm());
        }
        if (std::abs(edges[0].dot(edges[1].cross(edges[2]))) > leastVolume * longest * longest * longest)
            pieces.push_back(piece);
    }

    /// Three tetrahedra in a row, each with a face in common with the next, front to back.
    void addPrism(const std::array<std::uint32_t, 3>& a, const std::array<std::uint32_t, 3>& b,
                  std::vector<Piece>& pieces) const
    {
        const Piece row[] = {{a[0], a[1], a[2], b[0]}, {a[1], a[2], b[0], b[1]}, {a[2], b[0], b[1], b[2]}};
        const bool firstBeforeSecond = eyeIsBeside(a[0], {a[1], a[2], b[0]});
        const bool thirdBeforeSecond = eyeIsBeside(b[2], {a[2], b[0], b[1]});
        if (firstBeforeSecond)
            addPiece(row[0], pieces);
        if (thirdBeforeSecond)
            addPiece(row[2], pieces);
        addPiece(row[1], pieces);
        if (!firstBeforeSecond)
            addPiece(row[0], pieces);
        if (!thirdBeforeSecond)
            addPiece(row[2], pieces);
    }

    /// The eye lies on the same side of a face as a vertex.
    bool eyeIsBeside(std::uint32_t vertex, const std::array<std::uint32_t, 3>& face) const
    {
        const Vector3d corner = placeOf(face[0]);
        const Vector3d normal = (placeOf(face[1]) - corner).cross(placeOf(face[2]) - corner);
        const double eye = normal.dot(eye_.perspective ? (eye_.place - corner).eval() : eye_.place);
        return eye * normal.dot(placeOf(vertex) - corner) > 0;
    }

    /// Of a cell's centre, squared; in orthographic views along the view.
    double distanceOf(std::uint32_t node) const
    {
        Vector3d centre(0, 0, 0);
        for (const std::uint32_t vertex : mesh_.tetrahedra[cells_[node]])
            centre += placeOf(vertex) / 4;
        return eye_.perspective ? (centre - eye_.place).squaredNorm() : -centre.dot(eye_.place);
    }

    void emit(const Part& part)
    {
        const std::uint32_t cell = cells_[part.node];
        if (part.pieces.empty()) {
            order_.cells.push_back(cell);
            return;
        }
        CellPieces& pieces = order_.pieces;
        for (const Piece& piece : part.pieces) {
            order_.cells.push_back(static_cast<std::uint32_t>(mesh_.tetrahedra.size() + pieces.tetrahedra.size()));
            pieces.tetrahedra.push_back(piece);
            pieces.cells.push_back(cell);
        }
    }

    void finish()
    {
        CellPieces& pieces = order_.pieces;
        for (const CutPoint& point : points_) {
            pieces.positions.push_back(point.place + centre_);
            pieces.values.push_back(static_cast<float>(point.value));
        }
        std::vector<std::uint32_t> cut = pieces.cells;
        std::ranges::sort(cut);
        pieces.cutCells = cut.size() - std::ranges::unique(cut).size();
    }

    const TetrahedralMesh& mesh_;
    EyePoint eye_; ///< relative to the centre
    std::span<const std::uint32_t> cells_;
    NodeGraph graph_;
    ComponentFinder finder_;
    std::vector<std::uint32_t> partOf_; ///< of each node, its place in the group that is looked at
    VisibilityOrder& order_;
    double flat_ = 0;
    Vector3d centre_{0, 0, 0};
    std::vector<CutPoint> points_;
    std::vector<Group> groups_; ///< that are left, the foremost last
};

} // namespace

void orderCycles(const TetrahedralMesh& mesh, const OcclusionGraph& graph, const EyePoint& eye,
                 std::span<const std::uint32_t> held, VisibilityOrder& order)
{
    CycleCutter(mesh, graph, eye, held, order).run();
}

} // namespace tetra
