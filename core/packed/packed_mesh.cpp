// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/packed/packed_mesh.h"

#include "core/base/checksum.h"
#include "core/base/flat_index.h"
#include "core/base/guarded.h"
#include "core/mesh/face_adjacency.h"
#include "core/mesh/topology.h"
#include "core/packed/number_order.h"
#include "core/packed/range_coder.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <deque>
#include <optional>
#include <type_traits>
#include <utility>

namespace tetra {
namespace {

constexpr std::uint32_t noVertex = 0xffffffff;

struct PackedMeshHeader {
    static constexpr std::array<std::uint8_t, 8> marked = {0x89, 'T', 'A', 'N', 'M', 0x0d, 0x0a, 0x1a};
    static constexpr std::uint32_t current = 1;
    static constexpr std::uint32_t withLives = 1; ///< a flag: errors of birth and death follow
    static constexpr std::uint32_t withScale = 2; ///< a flag: positions are doubles, told by a PlaceScale

    std::array<std::uint8_t, 8> magic = marked;
    std::uint32_t version = current;
    std::uint32_t flags = 0;
    std::uint64_t vertices = 0;
    std::uint64_t tetrahedra = 0;
    std::uint32_t factBytes = 0;
    std::uint32_t reserved = 0;
    std::uint64_t codedBytes = 0;
};
static_assert(sizeof(PackedMeshHeader) == 48 && std::endian::native == std::endian::little);

/// No decision costs less than about 1/700 bit, and a tetrahedron takes at least one.
constexpr std::uint64_t mostTetrahedraInByte = std::uint64_t(8) << 10;
constexpr std::uint32_t mostFactBytes = 1 << 20;
/// What a mesh takes while it is unpacked: 16 and perhaps 8 bytes a tetrahedron, 76 a vertex, each twice where its
/// array grows or is handed out as floats.
constexpr std::uint64_t bytesOfTetrahedron = 48, bytesOfVertex = 152;

float floatOfOrder(std::uint32_t order) noexcept
{
    return numberOfOrder<float>(order);
}
std::uint32_t orderOfFloat(float number) noexcept
{
    return static_cast<std::uint32_t>(orderOf(number));
}

/// The order of the float that other floats let expect (PACKED_MESH.md).
std::uint32_t expectedOrder(double expected) noexcept
{
    constexpr double largest = 3.4e38;
    return orderOfFloat(nearestNumber<float>(std::clamp(expected, -largest, largest)));
}

/// What an encoder is given and a decoder finds: a difference of two integers of 32 bits.
template <class Coder> std::int64_t codeDifference(Coder& coder, NumberModel& model, std::int64_t difference)
{
    constexpr std::uint64_t largest = std::uint64_t(1) << 40; // what damaged bytes may give must not overflow
    const std::uint64_t code = model.code(coder, zigzag(static_cast<std::uint64_t>(difference), 0, 64));
    return static_cast<std::int64_t>(unzigzag(std::min(code, largest), 0, 64));
}

/// One number of each vertex or tetrahedron, as a code: its place in a table of all that occur, where they are few (the
/// coordinates of a lattice, samples of 8 bits), else its order among the floats. Elements are coded one after the
/// other, each by its difference from what those before it let expect.
class CodedFloats {
public:
    /// Of a sender: the codes of all numbers, in its own order.
    template <class NumberAt> void take(std::size_t count, NumberAt&& at)
    {
        given_.resize(count);
        FlatIndex<std::uint32_t> distinct;
        for (std::size_t i = 0; i < count; ++i) {
            given_[i] = orderOfFloat(at(i));
            if (distinct.size() <= mostInTable)
                distinct.numberOf(given_[i]);
        }
        if (distinct.size() > std::min(mostInTable, count / 4 + 1))
            return;
        table_.assign(distinct.keys().begin(), distinct.keys().end());
        std::ranges::sort(table_);
        std::vector<std::uint32_t> places(table_.size());
        for (std::uint32_t place = 0; place < table_.size(); ++place)
            places[distinct.numberOf(table_[place])] = place;
        for (std::uint32_t& code : given_)
            code = places[distinct.numberOf(code)];
    }
    std::uint32_t given(std::uint64_t element) const { return given_[element]; }

    /// The table, which comes before the elements. False if it is none.
    template <class Coder> bool codeTable(Coder& coder)
    {
        NumberModel model;
        const std::uint64_t size = model.code(coder, table_.size());
        if (size > mostInTable)
            return false;
        table_.resize(size);
        for (std::size_t i = 0; i < size; ++i) {
            std::int64_t expected = i == 0 ? 0 : table_[i - 1];
            if (i > 1)
                expected = expectedOrder(2 * double(floatOfOrder(table_[i - 1])) - floatOfOrder(table_[i - 2]));
            const std::int64_t entry = expected + codeDifference(coder, model, table_[i] - expected);
            if (entry < 0 || entry > 0xffffffff || (i > 0 && entry <= table_[i - 1]))
                return false;
            table_[i] = static_cast<std::uint32_t>(entry);
        }
        return true;
    }

    /// The next element, of the code `given` where the coder encodes. `near` are elements that it is likely to be like,
    /// none of them if there are none yet. False if there is no such number.
    template <class Coder> bool codeNext(Coder& coder, std::uint32_t given, std::span<const std::uint32_t> near)
    {
        std::int64_t expected = 0;
        std::size_t context = contexts - 1;
        if (!near.empty()) {
            std::uint32_t least = 0xffffffff, largest = 0;
            std::uint64_t sum = 0;
            double mean = 0;
            for (const std::uint32_t element : near) {
                const std::uint32_t code = codes_[element];
                least = std::min(least, code);
                largest = std::max(largest, code);
                sum += code;
                if (table_.empty())
                    mean += floatOfOrder(code);
            }
            expected = table_.empty() ? expectedOrder(mean / double(near.size()))
                                      : static_cast<std::int64_t>((sum + near.size() / 2) / near.size());
            if (near.size() > 1)
                context = static_cast<std::size_t>(std::bit_width(largest - least)) / 2;
        }
        const std::int64_t code = expected + codeDifference(coder, models_[context], std::int64_t(given) - expected);
        if (code < 0 || code > (table_.empty() ? 0xffffffff : std::int64_t(table_.size()) - 1))
            return false;
        codes_.push_back(static_cast<std::uint32_t>(code));
        return true;
    }

    std::size_t size() const noexcept { return codes_.size(); }
    float operator[](std::size_t element) const
    {
        return floatOfOrder(table_.empty() ? codes_[element] : table_[codes_[element]]);
    }

private:
    static constexpr std::size_t mostInTable = std::size_t(1) << 16;
    static constexpr std::size_t contexts = 18; ///< by how far apart the neighbours are; the last: not known

    std::vector<std::uint32_t> table_; ///< ascending orders; empty: codes are orders
    Buffer<std::uint32_t> given_;
    std::vector<std::uint32_t> codes_;
    std::array<NumberModel, contexts> models_;
};

/// The faces between the tetrahedra that are known and what is not, as a queue and by their vertices. Corners run so
/// that with a vertex beyond the face they are a positive tetrahedron.
class OpenFaces {
public:
    struct Face {
        Triangle corners;
        std::uint32_t apex;        ///< the fourth corner of the known tetrahedron
        std::uint32_t tetrahedron; ///< the known one
        std::uint32_t side;        ///< its number and face with the sender
        bool open = true;
        std::array<std::uint32_t, 3> next{}, previous{}; ///< in the lists of the corners, face * 3 + corner
    };

    void addVertex() { first_.push_back(noVertex); }

    void add(const Face& face)
    {
        std::uint32_t number = static_cast<std::uint32_t>(faces_.size());
        if (free_.empty()) {
            faces_.push_back(face);
        } else {
            number = free_.back();
            free_.pop_back();
            faces_[number] = face;
        }
        for (std::uint32_t corner = 0; corner < 3; ++corner) {
            std::uint32_t& first = first_[face.corners[corner]];
            faces_[number].next[corner] = first;
            faces_[number].previous[corner] = noVertex;
            if (first != noVertex)
                faces_[first / 3].previous[first % 3] = number * 3 + corner;
            first = number * 3 + corner;
        }
        queue_.push_back(number);
    }

    /// The next face that is still open, which then is not any more; nothing if there is none.
    std::optional<Face> takeNext()
    {
        while (!queue_.empty()) {
            const std::uint32_t number = queue_.front();
            queue_.pop_front();
            free_.push_back(number);
            if (faces_[number].open) {
                close(number);
                return faces_[number];
            }
        }
        return {};
    }

    /// Closes the face that is this one seen from its other side, if it is open (and among the newest of its vertex).
    bool closeOpposite(const Triangle& corners)
    {
        const auto& [a, b, c] = corners;
        return anyAt(c, [&](std::uint32_t number) {
            const auto& [x, y, z] = faces_[number].corners;
            const bool same =
                (x == b && y == a && z == c) || (x == a && y == c && z == b) || (x == c && y == b && z == a);
            if (same)
                close(number);
            return same;
        });
    }

    /// Calls for the newest faces of a vertex.
    template <class Visit> void visitAt(std::uint32_t vertex, Visit&& visit) const
    {
        anyAt(vertex, [&](std::uint32_t number) {
            visit(faces_[number]);
            return false;
        });
    }

private:
    /// No mesh of a model has more at a vertex but a few, and what was made to have them would take for ever.
    static constexpr int mostLookedAt = 64;

    template <class Test> bool anyAt(std::uint32_t vertex, Test&& test) const
    {
        std::uint32_t place = first_[vertex];
        for (int count = 0; place != noVertex && count < mostLookedAt; ++count) {
            const std::uint32_t now = place;
            place = faces_[now / 3].next[now % 3];
            if (test(now / 3))
                return true;
        }
        return false;
    }

    void close(std::uint32_t number)
    {
        Face& face = faces_[number];
        face.open = false;
        for (std::uint32_t corner = 0; corner < 3; ++corner) {
            const std::uint32_t next = face.next[corner], previous = face.previous[corner];
            if (previous == noVertex)
                first_[face.corners[corner]] = next;
            else
                faces_[previous / 3].next[previous % 3] = next;
            if (next != noVertex)
                faces_[next / 3].previous[next % 3] = previous;
        }
    }

    std::vector<Face> faces_;
    std::vector<std::uint32_t> free_;
    std::deque<std::uint32_t> queue_;
    std::vector<std::uint32_t> first_; ///< for each vertex
};

/// A vertex that is known and may be the one beyond a face.
struct NearVertex {
    std::uint32_t vertex = noVertex;
    int edges = 0; ///< of the face, at which it has an open face, too
    bool ahead = false;
    double height = 0; ///< of the tetrahedron's circumcentre over the face, squared with its sign, by the face's own
                       ///< circumradius squared: of a Delaunay mesh the lowest is the right one
};

/// The sender's mesh, and which of its vertices and tetrahedra are known by now.
struct SentMesh {
    const TetrahedralMesh& mesh;
    FaceAdjacency adjacency{};
    std::vector<std::uint32_t> numbers{};  ///< of its vertices, by when they became known
    std::vector<std::uint32_t> vertices{}; ///< the inverse
    std::vector<bool> known{};             ///< tetrahedra
    std::uint64_t nextSeed = 0;
    std::uint32_t nextSingle = 0;
};

/// Goes through a mesh from tetrahedron to tetrahedron, over the open faces in turn, and codes of each face what lies
/// beyond it. Encoder and decoder go the same way, as all that decides on it is known to both.
template <class Coder> class MeshWalk {
    static constexpr bool encodes = std::is_same_v<Coder, RangeEncoder>;
    static constexpr MarkedText activity =
        encodes ? Message::marked("Packing the mesh") : Message::marked("Unpacking the mesh");

public:
    /// Without a scale, all coordinates are floats.
    MeshWalk(Coder& coder, std::uint64_t vertices, std::uint64_t tetrahedra, bool lives,
             const std::optional<PlaceScale>& scale, SentMesh* sent)
        : coder_(coder), vertexCount_(vertices), tetrahedronCount_(tetrahedra), lives_(lives), scale_(scale),
          sent_(sent)
    {
    }

    std::array<CodedFloats, 4>& ofVertices() noexcept { return ofVertices_; } ///< coordinates and value
    std::array<CodedFloats, 2>& ofTetrahedra() noexcept { return ofTetrahedra_; }
    Buffer<Tetrahedron> takeTetrahedra() noexcept { return std::move(tetrahedra_); }
    Buffer<Eigen::Vector3d> takePlaces() noexcept { return std::move(places_); }

    /// Cancelled, or BadInput if what is decoded is no mesh.
    Status run(const Progress& progress)
    {
        for (auto& floats : ofVertices_)
            if (!floats.codeTable(coder_))
                return damaged();
        if (lives_)
            for (auto& floats : ofTetrahedra_)
                if (!floats.codeTable(coder_))
                    return damaged();
        constexpr std::uint64_t lookUpEvery = 4096;
        std::uint64_t steps = 0;
        while (tetrahedra_.size() < tetrahedronCount_) {
            const auto gate = open_.takeNext();
            if (!(gate ? codeBeyond(*gate) : codeSeed()))
                return damaged();
            if (++steps % lookUpEvery == 0) {
                if (const Status status = report(progress); !status)
                    return status;
            }
        }
        while (positions_.size() < vertexCount_) {
            if (!addVertex(encodes ? nextSingle() : 0, lastVertex()))
                return damaged();
            if (positions_.size() % lookUpEvery == 0)
                if (const Status status = report(progress); !status)
                    return status;
        }
        return overrun() ? damaged() : Status();
    }

private:
    static Status damaged() { return Error{ErrorKind::BadInput, Message::say("This packed mesh is damaged.")}; }

    bool overrun() const
    {
        if constexpr (encodes)
            return false;
        else
            return coder_.overrun();
    }

    Status report(const Progress& progress) const
    {
        if (overrun())
            return damaged();
        if (progress.cancelled())
            return cancelledError(activity);
        progress.report(double(tetrahedra_.size() + positions_.size()) / double(tetrahedronCount_ + vertexCount_),
                        activity);
        return {};
    }

    std::vector<std::uint32_t> lastVertex() const
    {
        if (positions_.empty())
            return {};
        return {static_cast<std::uint32_t>(positions_.size() - 1)};
    }

    /// The sender's next vertex that no tetrahedron has.
    std::uint32_t nextSingle()
    {
        while (sent_->numbers[sent_->nextSingle] != noVertex)
            ++sent_->nextSingle;
        return sent_->nextSingle;
    }

    bool addVertex(std::uint32_t sentVertex, std::span<const std::uint32_t> near)
    {
        if (positions_.size() == vertexCount_)
            return false;
        for (auto& floats : ofVertices_)
            if (!floats.codeNext(coder_, encodes ? floats.given(sentVertex) : 0, near))
                return false;
        if constexpr (encodes) {
            sent_->numbers[sentVertex] = static_cast<std::uint32_t>(positions_.size());
            sent_->vertices.push_back(sentVertex);
        }
        const std::size_t vertex = positions_.size();
        const Eigen::Vector3d rough(ofVertices_[0][vertex], ofVertices_[1][vertex], ofVertices_[2][vertex]);
        positions_.push_back(scale_ ? scale_->unit.cwiseProduct(rough).eval() : rough);
        if constexpr (encodes)
            codePlace(sent_->mesh.positions[sentVertex]);
        else
            codePlace(rough);
        atBorder_.push_back(false);
        open_.addVertex();
        return true;
    }

    /// Where the last vertex lies: what its rough position is short of.
    void codePlace(const Eigen::Vector3d& truth)
    {
        if (!scale_) {
            places_.push_back(positions_.back());
            return;
        }
        const Eigen::Vector3d expected = scale_->origin + positions_.back();
        Eigen::Vector3d& place = places_.emplace_back();
        for (int axis = 0; axis < 3; ++axis) {
            const std::uint64_t from = orderOf(expected[axis]);
            const std::uint64_t difference = orderOf(truth[axis]) - from;
            const std::uint64_t folded =
                difference << 1 ^ (0 - (difference >> 63)); // small for small ones of either sign
            NumberModel* const models = placeModels_[static_cast<std::size_t>(axis)].data();
            const std::uint64_t high = models[0].code(coder_, folded >> 32);
            const std::uint64_t told = high << 32 | (models[1].code(coder_, folded & 0xffffffff) & 0xffffffff);
            place[axis] = numberOfOrder<double>(from + (told >> 1 ^ (0 - (told & 1))));
        }
    }

    /// A vertex that is known, by its number; noVertex if there is none.
    std::uint32_t codeKnown(std::uint32_t vertex)
    {
        const std::uint64_t last = positions_.size() - 1;
        const std::uint64_t back = known_.code(coder_, last - vertex);
        return back > last ? noVertex : static_cast<std::uint32_t>(last - back);
    }

    /// A tetrahedron that is no neighbour of one before.
    bool codeSeed()
    {
        Tetrahedron corners{}, sentCorners{};
        std::uint64_t cell = 0;
        if constexpr (encodes) {
            while (sent_->known[sent_->nextSeed])
                ++sent_->nextSeed;
            cell = sent_->nextSeed;
            sentCorners = sent_->mesh.tetrahedra[cell];
        }
        for (std::size_t i = 0; i < 4; ++i) {
            const std::uint32_t number = encodes ? sent_->numbers[sentCorners[i]] : 0;
            if (positions_.empty() || codedBit(coder_, seedIsNew_, number == noVertex)) {
                if (!addVertex(sentCorners[i], lastVertex()))
                    return false;
                corners[i] = static_cast<std::uint32_t>(positions_.size() - 1);
            } else {
                corners[i] = codeKnown(number);
                if (corners[i] == noVertex)
                    return false;
            }
        }
        const auto& [a, b, c, d] = corners;
        std::vector<std::uint32_t> before;
        if (!tetrahedra_.empty())
            before = {static_cast<std::uint32_t>(tetrahedra_.size() - 1)};
        if (!addTetrahedron(corners, cell, before))
            return false;
        addFace({b, a, c}, d, cell, sentCorners[3]);
        return true;
    }

    /// The three faces at its last corner, which is the one beyond a face or of a seed.
    bool addTetrahedron(const Tetrahedron& corners, std::uint64_t cell, std::span<const std::uint32_t> near)
    {
        const auto& [a, b, c, d] = corners;
        tetrahedra_.push_back(corners);
        if (lives_)
            for (auto& floats : ofTetrahedra_)
                if (!floats.codeNext(coder_, encodes ? floats.given(cell) : 0, near))
                    return false;
        if constexpr (encodes)
            sent_->known[cell] = true;
        const auto sentVertex = [&](std::uint32_t vertex) { return encodes ? sent_->vertices[vertex] : 0; };
        addFace({a, b, d}, c, cell, sentVertex(c));
        addFace({b, c, d}, a, cell, sentVertex(a));
        addFace({c, a, d}, b, cell, sentVertex(b));
        return true;
    }

    void addFace(const Triangle& corners, std::uint32_t apex, std::uint64_t cell, std::uint32_t sentApex)
    {
        if (open_.closeOpposite(corners))
            return;
        std::uint32_t side = 0;
        if constexpr (encodes) {
            const Tetrahedron& sentCorners = sent_->mesh.tetrahedra[cell];
            const auto face = std::ranges::find(sentCorners, sentApex) - sentCorners.begin();
            side = static_cast<std::uint32_t>(cell * 4 + static_cast<std::uint64_t>(face));
        }
        open_.add({.corners = corners,
                   .apex = apex,
                   .tetrahedron = static_cast<std::uint32_t>(tetrahedra_.size() - 1),
                   .side = side});
    }

    /// Of the sender: the vertex beyond a face, unless there is none or its tetrahedron is known.
    struct Beyond {
        std::uint32_t vertex = noVertex; ///< with the sender
        std::uint64_t cell = 0;
    };
    Beyond beyond(const OpenFaces::Face& gate) const
    {
        const std::uint32_t other = sent_->adjacency.neighbours[gate.side / 4][gate.side % 4];
        if (other == FaceAdjacency::none)
            return {};
        const std::uint32_t cell = FaceAdjacency::cellOf(other), face = FaceAdjacency::faceOf(other);
        if (sent_->known[cell])
            return {};
        // Seen from the other side its corners run the other way, unless one of the two is negative.
        const auto [apex, x, y, z] = withCornerFirst(sent_->mesh.tetrahedra[cell], face);
        const std::uint32_t a = sent_->vertices[gate.corners[0]], b = sent_->vertices[gate.corners[1]],
                            c = sent_->vertices[gate.corners[2]];
        const bool fits = (x == b && y == a && z == c) || (x == a && y == c && z == b) || (x == c && y == b && z == a);
        return fits ? Beyond{apex, cell} : Beyond{};
    }

    /// What lies beyond a face: nothing, a new vertex, or a known one.
    bool codeBeyond(const OpenFaces::Face& gate)
    {
        const auto& [a, b, c] = gate.corners;
        const Beyond there = encodes ? beyond(gate) : Beyond();
        findNear(gate);
        const std::size_t flags = std::size_t(atBorder_[a]) + atBorder_[b] + atBorder_[c];
        const std::size_t step = near_.empty() ? heights : near_[0].ahead ? stepOf(near_[0].height) : heights - 1;
        if (codedBit(coder_, isBorder_[flags][step], there.vertex == noVertex)) {
            atBorder_[a] = atBorder_[b] = atBorder_[c] = true;
            return true;
        }
        std::uint32_t number = noVertex;
        if constexpr (encodes)
            number = sent_->numbers[there.vertex];
        std::uint32_t vertex = noVertex;
        const auto isNear = [&](std::size_t rank) {
            const NearVertex& candidate = near_[rank];
            BitModel& model =
                isNear_[std::min(rank, ranks - 1)][static_cast<std::size_t>(std::min(candidate.edges, 3)) - 1]
                       [candidate.ahead ? stepOf(candidate.height) : heights - 1][flags == 3];
            if (!codedBit(coder_, model, candidate.vertex == number))
                return false;
            vertex = candidate.vertex;
            return true;
        };
        if (near_.empty() || !isNear(0)) {
            if (codedBit(coder_, isNew_[flags][step], number == noVertex)) {
                if (!addVertex(there.vertex, gate.corners))
                    return false;
                vertex = static_cast<std::uint32_t>(positions_.size() - 1);
            } else {
                for (std::size_t rank = 1; rank < near_.size() && vertex == noVertex; ++rank)
                    isNear(rank);
                if (vertex == noVertex)
                    vertex = codeKnown(number);
                if (vertex == noVertex)
                    return false;
            }
        }
        return addTetrahedron({a, b, c, vertex}, there.cell, std::array{gate.tetrahedron});
    }

    /// Known vertices that may lie beyond a face: those across its edges, the likeliest first.
    void findNear(const OpenFaces::Face& gate)
    {
        near_.clear();
        const auto& [a, b, c] = gate.corners;
        open_.visitAt(a, [&](const OpenFaces::Face& face) {
            addNear(face, a, b);
            addNear(face, a, c);
        });
        open_.visitAt(b, [&](const OpenFaces::Face& face) { addNear(face, b, c); });
        if (near_.empty())
            return;
        const Vector origin = at(a), toB = minus(at(b), origin), toC = minus(at(c), origin);
        const Vector normal = cross(toB, toC);
        const double area = dot(normal, normal);
        // The centre of the face's circle, from the origin.
        const Vector towardsC = cross(normal, toB), towardsB = cross(toC, normal);
        const double ofB = dot(toB, toB), ofC = dot(toC, toC);
        Vector centre{};
        for (std::size_t axis = 0; axis < 3; ++axis)
            centre[axis] = (towardsC[axis] * ofC + towardsB[axis] * ofB) / (2 * area);
        const double radius = dot(centre, centre);
        for (NearVertex& candidate : near_) {
            const Vector to = minus(at(candidate.vertex), origin);
            const double along = dot(to, normal);
            const double t = (dot(to, to) - 2 * dot(to, centre)) / (2 * along);
            candidate.height = (t < 0 ? -1 : 1) * t * t * area / radius;
            candidate.ahead = along > 0 && candidate.height == candidate.height;
        }
        // Few: by insertion, what is equal stays in order.
        const auto before = [](const NearVertex& one, const NearVertex& other) {
            return one.ahead != other.ahead ? one.ahead : one.ahead && one.height < other.height;
        };
        for (std::size_t i = 1; i < near_.size(); ++i)
            for (std::size_t j = i; j > 0 && before(near_[j], near_[j - 1]); --j)
                std::swap(near_[j], near_[j - 1]);
    }

    // Sums in a fixed order, so that any compiler's program decides as any other's.
    using Vector = std::array<double, 3>;
    Vector at(std::uint32_t vertex) const
    {
        const Eigen::Vector3d& position = positions_[vertex];
        return {position[0], position[1], position[2]};
    }
    static Vector minus(const Vector& one, const Vector& other)
    {
        return {one[0] - other[0], one[1] - other[1], one[2] - other[2]};
    }
    static double dot(const Vector& one, const Vector& other)
    {
        return one[0] * other[0] + one[1] * other[1] + one[2] * other[2];
    }
    static Vector cross(const Vector& one, const Vector& other)
    {
        return {one[1] * other[2] - one[2] * other[1], one[2] * other[0] - one[0] * other[2],
                one[0] * other[1] - one[1] * other[0]};
    }

    /// The third corner of a face that has this edge.
    void addNear(const OpenFaces::Face& face, std::uint32_t one, std::uint32_t other)
    {
        constexpr std::size_t most = 8;
        const auto& [x, y, z] = face.corners;
        if (x != other && y != other && z != other)
            return;
        const std::uint32_t third = x != one && x != other ? x : y != one && y != other ? y : z;
        const auto found = std::ranges::find(near_, third, &NearVertex::vertex);
        if (found != near_.end())
            ++found->edges;
        else if (near_.size() < most)
            near_.push_back({.vertex = third, .edges = 1});
    }

    static std::size_t stepOf(double height) noexcept
    {
        constexpr std::array<double, 9> steps = {-4, -1, -0.25, -0.02, 0.02, 0.25, 1, 4, 25};
        std::size_t step = 0;
        while (step < steps.size() && height >= steps[step])
            ++step;
        return step;
    }

    static constexpr std::size_t heights = 11; ///< stepOf(), and one for what is not ahead
    static constexpr std::size_t ranks = 3;

    Coder& coder_;
    std::uint64_t vertexCount_, tetrahedronCount_;
    bool lives_;
    std::optional<PlaceScale> scale_;
    SentMesh* sent_;

    std::vector<Eigen::Vector3d> positions_; ///< rough, from the scale's origin: what decides what comes next
    Buffer<Eigen::Vector3d> places_;         ///< exact
    std::vector<std::uint8_t> atBorder_;
    Buffer<Tetrahedron> tetrahedra_;
    OpenFaces open_;
    std::vector<NearVertex> near_;

    std::array<CodedFloats, 4> ofVertices_;
    std::array<CodedFloats, 2> ofTetrahedra_;
    BitModel seedIsNew_;
    NumberModel known_;
    std::array<std::array<NumberModel, 2>, 3> placeModels_; ///< of each axis: upper and lower half
    std::array<std::array<BitModel, heights + 1>, 4>
        isBorder_; ///< by corners known to lie at it, and the first near one
    std::array<std::array<BitModel, heights + 1>, 4> isNew_;
    std::array<std::array<std::array<std::array<BitModel, 2>, heights>, 3>, ranks> isNear_;
};

Status checkArrays(const TetrahedralMesh& mesh, std::span<const float> births, std::span<const float> deaths,
                   std::string_view facts)
{
    const std::size_t cells = mesh.tetrahedra.size();
    const bool fit = mesh.values.size() == mesh.positions.size() && mesh.positions.size() < noVertex &&
                     cells <= largestAdjacentCellCount && births.size() == deaths.size() &&
                     (births.empty() || births.size() == cells) && facts.size() <= mostFactBytes;
    const bool exist =
        fit && std::ranges::all_of(mesh.tetrahedra, [&](const Tetrahedron& corners) {
            return std::ranges::all_of(corners, [&](std::uint32_t corner) { return corner < mesh.positions.size(); });
        });
    if (exist)
        return {};
    return Error{ErrorKind::WrongUsage,
                 Message::say("This mesh cannot be packed: its arrays do not belong together, or it has more than "
                              "%1 tetrahedra.",
                              largestAdjacentCellCount)};
}

template <class Value> void appendBytes(std::vector<std::byte>& bytes, const Value& value)
{
    const auto* begin = reinterpret_cast<const std::byte*>(&value);
    bytes.insert(bytes.end(), begin, begin + sizeof value);
}

bool isFloat(const Eigen::Vector3d& place)
{
    return std::ranges::all_of(place, [](double coordinate) {
        return orderOf(static_cast<double>(static_cast<float>(coordinate))) == orderOf(coordinate);
    });
}

Result<std::vector<std::byte>> packedMesh(const TetrahedralMesh& mesh, std::span<const float> births,
                                          std::span<const float> deaths, std::string_view facts,
                                          const PlaceScale& given, const Progress& progress)
{
    if (const Status fit = checkArrays(mesh, births, deaths, facts); !fit)
        return fit.error();
    SentMesh sent{mesh};
    sent.adjacency = matchFaces(mesh.tetrahedra);
    sent.numbers.assign(mesh.positions.size(), noVertex);
    sent.vertices.reserve(mesh.positions.size());
    sent.known.resize(mesh.tetrahedra.size());
    RangeEncoder coder;
    const std::optional<PlaceScale> scale =
        std::ranges::all_of(mesh.positions, isFloat) ? std::nullopt : std::optional(given);
    MeshWalk<RangeEncoder> walk(coder, mesh.positions.size(), mesh.tetrahedra.size(), !births.empty(), scale, &sent);
    const PlaceScale asGiven = scale.value_or(PlaceScale());
    for (int axis = 0; axis < 3; ++axis)
        walk.ofVertices()[static_cast<std::size_t>(axis)].take(mesh.positions.size(), [&](std::size_t vertex) {
            return static_cast<float>((mesh.positions[vertex][axis] - asGiven.origin[axis]) / asGiven.unit[axis]);
        });
    walk.ofVertices()[3].take(mesh.values.size(), [&](std::size_t vertex) { return mesh.values[vertex]; });
    walk.ofTetrahedra()[0].take(births.size(), [&](std::size_t cell) { return births[cell]; });
    walk.ofTetrahedra()[1].take(deaths.size(), [&](std::size_t cell) { return deaths[cell]; });
    if (const Status done = walk.run(progress); !done)
        return done.error();
    const std::vector<std::byte> coded = coder.finish();

    PackedMeshHeader header;
    header.flags = (births.empty() ? 0 : PackedMeshHeader::withLives) | (scale ? PackedMeshHeader::withScale : 0);
    header.vertices = mesh.positions.size();
    header.tetrahedra = mesh.tetrahedra.size();
    header.factBytes = static_cast<std::uint32_t>(facts.size());
    header.codedBytes = coded.size();
    std::vector<std::byte> bytes;
    bytes.reserve(sizeof header + facts.size() + coded.size() + sizeof(std::uint64_t));
    appendBytes(bytes, header);
    bytes.insert(bytes.end(), reinterpret_cast<const std::byte*>(facts.data()),
                 reinterpret_cast<const std::byte*>(facts.data()) + facts.size());
    if (scale)
        appendBytes(bytes, *scale);
    bytes.insert(bytes.end(), coded.begin(), coded.end());
    appendBytes(bytes, checksum(bytes));
    return bytes;
}

Error noPackedMesh()
{
    return {ErrorKind::BadInput,
            Message::say("What was received is not a packed mesh of this version, or is damaged.")};
}

std::size_t scaleBytes(const PackedMeshHeader& header)
{
    static_assert(sizeof(PlaceScale) == 6 * sizeof(double));
    return (header.flags & PackedMeshHeader::withScale) != 0 ? sizeof(PlaceScale) : 0;
}

Result<UnpackedMesh> unpackedMesh(std::span<const std::byte> bytes, std::uint64_t mostTetrahedra,
                                  const Progress& progress)
{
    PackedMeshHeader header;
    std::uint64_t sum = 0;
    if (bytes.size() < sizeof header + sizeof sum)
        return noPackedMesh();
    std::memcpy(&header, bytes.data(), sizeof header);
    const auto body = bytes.first(bytes.size() - sizeof sum);
    std::memcpy(&sum, body.data() + body.size(), sizeof sum);
    const bool sound = header.magic == PackedMeshHeader::marked && header.version == PackedMeshHeader::current &&
                       header.flags <= (PackedMeshHeader::withLives | PackedMeshHeader::withScale) &&
                       header.factBytes <= mostFactBytes &&
                       header.codedBytes == body.size() - sizeof header - header.factBytes - scaleBytes(header) &&
                       sum == checksum(body) && header.vertices < noVertex &&
                       header.tetrahedra <= std::min<std::uint64_t>(largestAdjacentCellCount,
                                                                    (header.codedBytes + 8) * mostTetrahedraInByte) &&
                       header.vertices <= (header.codedBytes + 8) * mostTetrahedraInByte;
    if (!sound || body.size() < sizeof header + header.factBytes + scaleBytes(header))
        return noPackedMesh();
    const std::uint64_t usable = usableBytes();
    if (usable != 0 && header.tetrahedra * bytesOfTetrahedron + header.vertices * bytesOfVertex > usable / 2)
        return Error{ErrorKind::OutOfResource, Message::say("The mesh has %1 tetrahedra, too many for the memory of "
                                                            "this machine. Choose a larger error or a part of it.",
                                                            header.tetrahedra)};
    if (header.tetrahedra > mostTetrahedra || header.vertices / 4 > mostTetrahedra)
        return Error{ErrorKind::OutOfResource, Message::say("The mesh has %1 tetrahedra, and at most %2 are taken.",
                                                            header.tetrahedra, mostTetrahedra)};
    const auto facts = body.subspan(sizeof header, header.factBytes);
    std::optional<PlaceScale> scale;
    if (const std::size_t size = scaleBytes(header); size > 0)
        std::memcpy(static_cast<void*>(&scale.emplace()), body.data() + sizeof header + header.factBytes, size);
    RangeDecoder coder(body.subspan(sizeof header + header.factBytes + scaleBytes(header)));
    const bool lives = (header.flags & PackedMeshHeader::withLives) != 0;
    MeshWalk<RangeDecoder> walk(coder, header.vertices, header.tetrahedra, lives, scale, nullptr);
    if (const Status done = walk.run(progress); !done)
        return done.error();

    UnpackedMesh result;
    result.mesh.positions = walk.takePlaces();
    result.mesh.values.resize(header.vertices);
    for (std::size_t vertex = 0; vertex < header.vertices; ++vertex)
        result.mesh.values[vertex] = walk.ofVertices()[3][vertex];
    result.mesh.tetrahedra = walk.takeTetrahedra();
    if (lives) {
        result.birthErrors.resize(header.tetrahedra);
        result.deathErrors.resize(header.tetrahedra);
        for (std::size_t cell = 0; cell < header.tetrahedra; ++cell) {
            result.birthErrors[cell] = walk.ofTetrahedra()[0][cell];
            result.deathErrors[cell] = walk.ofTetrahedra()[1][cell];
        }
    }
    result.facts.assign(reinterpret_cast<const char*>(facts.data()), facts.size());
    return result;
}

constexpr MarkedText noMemoryForMesh =
    Message::marked("Not enough memory for a packed mesh. Choose a larger error or a part of it.");

} // namespace

Result<std::vector<std::byte>> packMesh(const TetrahedralMesh& mesh, std::span<const float> birthErrors,
                                        std::span<const float> deathErrors, std::string_view facts,
                                        const PlaceScale& scale, const Progress& progress)
{
    return guarded(noMemoryForMesh, [&] { return packedMesh(mesh, birthErrors, deathErrors, facts, scale, progress); });
}

Result<UnpackedMesh> unpackMesh(std::span<const std::byte> bytes, std::uint64_t mostTetrahedra,
                                const Progress& progress)
{
    return guarded(noMemoryForMesh, [&] { return unpackedMesh(bytes, mostTetrahedra, progress); });
}

} // namespace tetra
