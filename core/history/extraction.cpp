// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/guarded.h"
#include "core/base/json_writer.h"
#include "core/history/error_meaning.h"
#include "core/history/pair_limits.h"
#include "core/history/query_words.h"
#include "core/history/site_positions.h"
#include "core/history/walk.h"
#include "core/history/whole_elsewhere.h"
#include "core/mesh/topology.h"

#include <tan/query.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace tetra {

namespace {

/// Room behind the mesh for tetrahedra that are written before it is known that they are dead.
constexpr std::uint64_t slack = 1 << 13;
constexpr MarkedText extracting = Message::marked("Extracting the mesh");

/// Whether the file has as many tetrahedra as a mesh of it is said to have.
Status checkMeshSize(const Model& model, std::uint64_t tetrahedra)
{
    if (tetrahedra > model.tetrahedronCount())
        return inconsistentModel(model, Message::say("its star offsets do not match its mesh sizes"));
    return {};
}

Error laterSite(const Model& model, std::uint32_t creator)
{
    return inconsistentModel(
        model, Message::say("a tetrahedron of site %1 or soon after has a site that comes after its creator", creator));
}

Error tooManyTetrahedra(const Model& model, std::uint32_t sites, std::uint64_t expected)
{
    return inconsistentModel(
        model,
        Message::say("the mesh of %1 sites has more than the %2 tetrahedra that it should have", sites, expected));
}

Error tooFewTetrahedra(const Model& model, std::uint32_t sites, std::uint64_t found, std::uint64_t expected)
{
    return inconsistentModel(
        model, Message::say("the mesh of %1 sites has %2 tetrahedra instead of %3", sites, found, expected));
}

/// Takes the mesh out of the file, some stars at a time.
class PrefixScan {
public:
    PrefixScan(const Model& model, std::uint32_t sites, Buffer<Tetrahedron>& out)
        : model_(model), sites_(sites), expected_(model.meshSizes()[sites - 1]), out_(out)
    {
    }

    Status run(const Progress& progress);

private:
    Status scanStars(const Stars& stars);
    Status scanLongStars(const Stars& stars);

    const Model& model_;
    const std::uint32_t sites_;
    const std::uint64_t expected_; ///< tetrahedra in the mesh, as the file says
    Buffer<Tetrahedron>& out_;
    std::uint64_t found_ = 0;
};

Status PrefixScan::run(const Progress& progress)
{
    if (const Status fits = checkMeshSize(model_, expected_); !fits)
        return fits;
    out_.resize(expected_ + slack);
    const auto scan = [this](const Stars& stars) {
        const bool fits = stars.count() + aliveScanOverrun <= out_.size() - found_;
        return fits ? scanStars(stars) : scanLongStars(stars);
    };
    if (const Status walked = walkHistory(model_, 0, sites_, progress, extracting, scan); !walked)
        return walked;
    if (found_ != expected_)
        return tooFewTetrahedra(model_, sites_, found_, expected_);
    out_.resize(found_);
    return {};
}

Status PrefixScan::scanStars(const Stars& stars)
{
    const AliveScan scanned = scanAlive(stars, sites_, out_.data() + found_);
    found_ = static_cast<std::uint64_t>(scanned.end - out_.data());
    if (!scanned.sitesComeBefore)
        return laterSite(model_, stars.firstSite);
    return found_ > expected_ ? tooManyTetrahedra(model_, sites_, expected_) : Status();
}

/// Stars that may have more tetrahedra than there is room for: one tetrahedron at a time.
Status PrefixScan::scanLongStars(const Stars& stars)
{
    for (std::size_t star = 0; star + 1 < stars.offsets.size(); ++star)
        for (std::uint64_t t = stars.offsets[star]; t < stars.offsets[star + 1]; ++t) {
            const auto creator = static_cast<std::uint32_t>(stars.firstSite + star);
            const std::array<std::uint64_t, 2> one = {t, t + 1};
            Tetrahedron alive[1 + aliveScanOverrun];
            const AliveScan scanned = scanAlive({stars.otherSites, stars.destroyers, creator, one}, sites_, alive);
            if (!scanned.sitesComeBefore)
                return inconsistentModel(
                    model_, Message::say("a tetrahedron of site %1 has a site that comes after its creator", creator));
            if (scanned.end == alive)
                continue;
            if (found_ == expected_)
                return tooManyTetrahedra(model_, sites_, expected_);
            out_[found_++] = alive[0];
        }
    return {};
}

Status extractInto(const Model& model, std::uint32_t sites, const Progress& progress, TetrahedralMesh& mesh)
{
    if (sites == 0) {
        mesh = {};
        return model.checkIntact(); // damage may be why there are none
    }
    if (const Status scanned = PrefixScan(model, sites, mesh.tetrahedra).run(progress); !scanned)
        return scanned;
    turnToPhysicalSpace(model, mesh.tetrahedra);
    if (const Status placed = placeSites(model, sites, mesh.positions); !placed)
        return placed;
    if (const Status copied = copyValues(model, sites, mesh.values); !copied)
        return copied;
    return model.checkIntact();
}

/// The first mesh whose key is at most the limit, as its sites.
std::uint32_t firstWithin(const Model& model, double limit)
{
    const std::span<const float> keys = model.runningKeys();
    // The mesh of the first N sites has the key that was there before site N entered. Infinity is no mesh yet.
    const auto reached = std::ranges::partition_point(keys, [&](const float& key) {
        return !model.check(key) || std::isinf(key) || !(static_cast<double>(key) <= limit);
    });
    return static_cast<std::uint32_t>(reached - keys.begin());
}

/// The first batch that ends with so many sites or more.
std::size_t batchWith(const Model& model, std::uint32_t sites)
{
    const std::span<const std::uint32_t> ends = model.batchEnds();
    const auto found = std::ranges::partition_point(
        ends, [&](const std::uint32_t& end) { return !model.check(end) || end + 1 < sites; });
    return static_cast<std::size_t>(found - ends.begin());
}

/// The first mesh before that of `last` sites which keeps both limits by the bounds that the file has of each, or else
/// that one. A key is the larger of what the two bounds say: no mesh of a larger one than both limits allow keeps them.
std::uint32_t firstWithinBoth(const Model& model, const UnitLimits& limits, std::uint32_t last)
{
    constexpr double rounding = 1e-6, roundedUp = 1 + rounding;
    if (model.batchErrors().empty() || isInRatio(model, limits, rounding))
        return last;
    const double weighted = model.description().warpingWeight * limits.warping;
    const std::size_t first = batchWith(model, firstWithin(model, roundedUp * std::max(limits.error, weighted)));
    const std::size_t end = batchWith(model, last);
    if (first >= end || end > model.batchErrors().size())
        return last;
    const auto errors = model.batchErrors().subspan(first, end - first);
    const auto warpings = model.batchWarpings().subspan(first, end - first);
    if (!model.check(errors) || !model.check(warpings))
        return last;
    for (std::size_t batch = 0; batch < errors.size(); ++batch)
        if (static_cast<double>(errors[batch]) <= limits.error &&
            static_cast<double>(warpings[batch]) <= limits.warping)
            return std::min(model.batchEnds()[first + batch], last - 1) + 1;
    return last;
}

} // namespace

UnitLimits unitLimits(const Model& model, const Accuracy& accuracy)
{
    constexpr double unlimited = std::numeric_limits<double>::infinity();
    const double extent = model.description().range.extent();
    if (model.description().warpingWeight == 0)
        return {accuracy.error / 100 * extent, unlimited};
    return {extent > 0 && accuracy.error < anyError ? accuracy.error / 100 * extent : unlimited,
            accuracy.warping < anyWarping ? accuracy.warping / 100 * model.diagonal() : unlimited};
}

bool isInRatio(const Model& model, const UnitLimits& limits, double tolerance)
{
    const double weighted = model.description().warpingWeight * limits.warping;
    return model.description().warpingWeight == 0 || weighted == limits.error ||
           (std::isfinite(limits.error) && std::abs(weighted - limits.error) <= tolerance * limits.error);
}

MeshSize meshSizeAt(const Model& model, const Accuracy& accuracy)
{
    if (model.elsewhere() != nullptr) {
        const std::vector<MeshSize>& meshes = model.elsewhere()->sizes().meshes;
        const auto keeps = [&](const MeshSize& size) {
            return size.error <= accuracy.error && size.warping <= accuracy.warping;
        };
        const auto found = std::ranges::find_if(meshes, keeps);
        return found != meshes.end() ? *found : meshes.back();
    }
    const std::span<const float> keys = model.runningKeys();
    const UnitLimits limits = unitLimits(model, accuracy);
    const double weight = model.description().warpingWeight;
    const double key = weight > 0 ? std::min(limits.error, weight * limits.warping) : limits.error;
    std::uint32_t sites = firstWithin(model, key);
    // Keys may rise, and be up at the end: then an earlier mesh is the most accurate one.
    if (sites > 0 && sites == keys.size() && model.finalKey() > keys.back())
        sites = firstWithin(model, static_cast<double>(keys.back()));
    return meshSizeOf(model, firstWithinBoth(model, limits, sites));
}

MeshSize meshSizeOf(const Model& model, std::uint32_t sites)
{
    if (sites == 0) // only in a damaged file: the initial sites have no error
        return {};
    if (model.elsewhere() != nullptr) {
        const std::vector<MeshSize>& meshes = model.elsewhere()->sizes().meshes;
        const auto found = std::ranges::lower_bound(meshes, sites, {}, &MeshSize::sites);
        return found != meshes.end() ? *found : meshes.back();
    }
    const double extent = model.description().range.extent();
    const double weight = model.description().warpingWeight;
    const std::span<const float> keys = model.runningKeys();
    const float& next = sites == keys.size() ? keys.back() : keys[sites];
    const double key = sites == keys.size() ? model.finalKey() : next;
    if (!model.check(next) || !model.check(model.meshSizes()[sites - 1]))
        return {};
    double error = extent > 0 ? 100 * key / extent : 0;
    double warping = weight > 0 ? 100 * key / (weight * model.diagonal()) : 0;
    const std::size_t batch = model.batchErrors().empty() ? 0 : batchWith(model, sites);
    if (batch < model.batchErrors().size() && model.batchEnds()[batch] + 1 == sites &&
        model.check(model.batchErrors()[batch]) && model.check(model.batchWarpings()[batch])) {
        error = extent > 0 ? std::min(error, 100 * static_cast<double>(model.batchErrors()[batch]) / extent) : 0;
        warping = std::min(warping, 100 * static_cast<double>(model.batchWarpings()[batch]) / model.diagonal());
    }
    return {sites, model.meshSizes()[sites - 1], error, warping};
}

namespace {

/// Whether the first `sites` sites have a mesh of their own.
Status checkPrefix(const Model& model, std::uint32_t sites)
{
    if (sites > model.siteCount())
        return Error{ErrorKind::WrongUsage, Message::say("'%1' has %2 sites, fewer than the %3 requested.",
                                                         model.path().string(), model.siteCount(), sites)};
    if (sites > 0 && (!model.check(model.groupGoesOn()[sites - 1]) || !model.check(model.meshSizes()[sites - 1])))
        if (const Status intact = model.checkIntact(); !intact)
            return intact.error();
    if (sites > 0 && model.groupGoesOn()[sites - 1] != 0)
        return Error{
            ErrorKind::WrongUsage,
            Message::say(
                "The first %1 sites of '%2' have no mesh of their own: site %3 enters together with the one before it.",
                sites, model.path().string(), sites)};
    return {};
}

constexpr MarkedText tooLittleMemory =
    Message::marked("Not enough memory for a mesh of %1 sites. Choose a larger error.");

} // namespace

Result<TetrahedralMesh> extractPrefix(const Model& model, std::uint32_t sites, const Progress& progress,
                                      TetrahedralMesh reuse)
{
    if (const Status hasMesh = checkPrefix(model, sites); !hasMesh)
        return hasMesh.error();
    const Status extracted = guarded(
        tooLittleMemory, [&] { return extractInto(model, sites, progress, reuse); }, sites);
    if (!extracted)
        return extracted.error();
    return reuse;
}

Status forEachTetrahedron(const Model& model, std::uint32_t sites,
                          const std::function<void(std::span<const std::array<std::uint32_t, 4>>)>& visit,
                          const Progress& progress)
{
    if (const Status hasMesh = checkPrefix(model, sites); !hasMesh || sites == 0)
        return hasMesh;
    const std::uint64_t expected = model.meshSizes()[sites - 1];
    if (const Status fits = checkMeshSize(model, expected); !fits)
        return fits;
    std::uint64_t found = 0;
    Buffer<Tetrahedron> some;
    const auto tell = [&](const Stars& stars) -> Status {
        some.resize(stars.count() + aliveScanOverrun);
        const AliveScan scanned = scanAlive(stars, sites, some.data());
        if (!scanned.sitesComeBefore)
            return laterSite(model, stars.firstSite);
        some.resize(static_cast<std::size_t>(scanned.end - some.data()));
        found += some.size();
        if (found > expected)
            return tooManyTetrahedra(model, sites, expected);
        turnToPhysicalSpace(model, some);
        visit(some);
        return {};
    };
    const Status visited = guarded(
        tooLittleMemory, [&] { return walkHistory(model, 0, sites, progress, extracting, tell); }, sites);
    if (!visited)
        return visited;
    return found == expected ? model.checkIntact() : tooFewTetrahedra(model, sites, found, expected);
}

namespace {

struct Level {
    Accuracy asked;
    MeshSize size;
};

/// Without warping its columns are 0.
Level levelAt(const Model& model, Accuracy asked)
{
    const MeshSize size = meshSizeAt(model, asked);
    if (model.description().warpingWeight <= 0)
        asked.warping = 0;
    return {asked, size};
}

std::string jsonOf(const Level& level)
{
    return "{\"error\": " + formatNumber(level.asked.error) + ", \"warping\": " + formatNumber(level.asked.warping) +
           ", \"sites\": " + std::to_string(level.size.sites) +
           ", \"tetrahedra\": " + std::to_string(level.size.tetrahedra) +
           ", \"reached\": " + formatNumber(level.size.error) +
           ", \"reached_warping\": " + formatNumber(level.size.warping) + "}";
}

} // namespace

std::string levelsAsCsv(const Model& model, std::span<const Accuracy> levels)
{
    // Which error it is stands there where there are two, as in the facts of files.
    const ErrorMeaning meaning = errorMeaning(model.description());
    const bool saysKind = meaning != ErrorMeaning::Only;
    std::string text = "error_percent,warping_percent,sites,tetrahedra,reached_error_percent,reached_warping_percent";
    text += saysKind ? ",error_kind\n" : "\n";
    for (const Accuracy& asked : levels) {
        const Level level = levelAt(model, asked);
        text += formatNumber(level.asked.error) + "," + formatNumber(level.asked.warping) + "," +
                std::to_string(level.size.sites) + "," + std::to_string(level.size.tetrahedra) + "," +
                formatNumber(level.size.error) + "," + formatNumber(level.size.warping);
        text += saysKind ? "," + std::string(wordOf(errorKindWords, meaning)) + "\n" : "\n";
    }
    return text;
}

std::string levelsAsJson(const Model& model, std::span<const Accuracy> levels)
{
    std::string list;
    for (const Accuracy& asked : levels)
        list += (list.empty() ? "\n    " : ",\n    ") + jsonOf(levelAt(model, asked));
    return "{\n  \"model\": " + jsonString(model.path().filename().string()) +
           ",\n  \"source\": " + jsonString(model.description().sourceName) +
           ",\n  \"builder\": " + jsonString(model.description().builder) +
           ",\n  \"error_kind\": " + jsonString(wordOf(errorKindWords, errorMeaning(model.description()))) +
           ",\n  \"sites\": " + std::to_string(wholeSites(model)) +
           ",\n  \"tetrahedra\": " + std::to_string(wholeTetrahedra(model)) +
           ",\n  \"bytes\": " + std::to_string(wholeBytes(model)) + ",\n  \"levels\": [" + list + "\n  ]\n}\n";
}

Result<std::string> levelsAsText(const std::filesystem::path& path, const Model& model,
                                 std::span<const Accuracy> levels)
{
    const std::string ending = fileEnding(path);
    if (ending == ".csv")
        return levelsAsCsv(model, levels);
    if (ending == ".json")
        return levelsAsJson(model, levels);
    return Error{
        ErrorKind::WrongUsage,
        Message::say("'%1' does not end in .csv or .json, the formats of statistics. Choose one of these endings.",
                     path.string())};
}

} // namespace tetra
