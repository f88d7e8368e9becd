// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/verify/verify_parts.h"

#include "core/base/checksum.h"
#include "core/base/progress.h"
#include "core/history/build_facts.h"
#include "core/history/file_layout.h"
#include "core/verify/exact_cell.h"
#include "core/verify/findings.h"
#include "core/verify/irregular_original.h"

#include <tan/base.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <vector>

namespace tetra {

namespace {

using format::Section;

/// Bytes summed up between two looks at whether the work was cancelled.
constexpr std::size_t bytesAtOnce = 64 << 20;

bool allZero(std::span<const std::byte> bytes)
{
    return std::ranges::all_of(bytes, [](std::byte byte) { return byte == std::byte{}; });
}

/// The checksums of the chunks of all sections but their own, in order, as the file gives them: none if it gives none.
struct StoredSums {
    std::uint64_t chunkBytes = 0;
    std::span<const std::uint64_t> left; ///< those of the sections that were not looked at yet
};

StoredSums storedSums(std::span<const std::byte> file, const FileLayout& layout)
{
    if (!layout.has(format::SectionId::ChunkSums))
        return {};
    const Section& section = layout.section(format::SectionId::ChunkSums);
    const std::span elements(reinterpret_cast<const std::uint64_t*>(file.data() + section.offset),
                             section.bytes / sizeof(std::uint64_t));
    return elements.empty() ? StoredSums() : StoredSums{elements.front(), elements.subspan(1)};
}

Status verifySection(const Section& section, std::span<const std::byte> bytes, StoredSums& stored,
                     std::vector<std::string>& failures, SharedProgress& progress)
{
    const bool hasChunks = stored.chunkBytes > 0 && section.id != std::uint32_t(format::SectionId::ChunkSums);
    const std::uint64_t atOnce = hasChunks ? stored.chunkBytes : bytesAtOnce;
    Checksum sum;
    std::uint64_t wrongChunks = 0;
    for (std::size_t at = 0; at < bytes.size(); at += atOnce) {
        if (progress.cancelled())
            return cancelledError(Message::marked("Verifying the model"));
        const auto piece = bytes.subspan(at, std::min<std::size_t>(atOnce, bytes.size() - at));
        sum.add(piece);
        if (hasChunks) {
            wrongChunks += stored.left.empty() || checksum(piece) != stored.left.front() ? 1 : 0;
            stored.left = stored.left.subspan(stored.left.empty() ? 0 : 1);
        }
        progress.done(piece.size());
    }
    const std::string name = "Section '" + std::string(format::sectionName(section.id)) + "' (" +
                             std::to_string(bytes.size()) + " bytes at " + std::to_string(section.offset) + ")";
    if (sum.value() != section.checksum)
        failures.push_back(name + " is damaged: its checksum is wrong.");
    if (wrongChunks > 0)
        failures.push_back(name + " has " + std::to_string(wrongChunks) + " of " +
                           std::to_string(format::chunkCount(bytes.size(), atOnce)) +
                           " chunks that do not fit their checksums.");
    if (!allZero(std::as_bytes(std::span(section.reserved))) || (section.flags & ~format::required) != 0)
        failures.push_back(name + " has reserved fields that are not zero.");
    return {};
}

} // namespace

Status verifyBytes(const Model& model, std::vector<std::string>& failures, const Progress& progress)
{
    const std::span<const std::byte> file = model.fileBytes();
    const Result<FileLayout> layout = readLayout(file, model.path());
    if (!layout) {
        failures.push_back(layout.error().text());
        return {};
    }
    StoredSums stored = storedSums(file, *layout);
    SharedProgress shared(progress, file.size(), "Verifying checksums");
    std::uint64_t end = sizeof(format::Header) + layout->sections.size() * sizeof(Section);
    for (const Section& section : layout->sections) {
        if (!allZero(file.subspan(end, section.offset - end)))
            failures.push_back("The bytes from " + std::to_string(end) + " to " + std::to_string(section.offset) +
                               ", between two sections, are not zero.");
        end = section.offset + section.bytes;
        const auto bytes = file.subspan(section.offset, section.bytes);
        if (const Status done = verifySection(section, bytes, stored, failures, shared); !done)
            return done;
    }
    if (!allZero(std::as_bytes(std::span(layout->header.reserved))))
        failures.emplace_back("Reserved fields of the header are not zero.");
    return {};
}

namespace {

/// "5 x 4 x 6 samples of type uint8"; a domain that is no regular lattice comes first.
std::string kindText(DomainClass domain, const Lattice& lattice, SampleType type)
{
    const std::string ofType = " of type " + std::string(sampleTypeName(type));
    if (domain == DomainClass::Irregular)
        return "an irregular mesh of " + std::to_string(lattice.pointCount()) + " points" + ofType;
    if (domain == DomainClass::Scattered)
        return std::to_string(lattice.pointCount()) + " scattered points" + ofType;
    const std::string kind =
        domain == DomainClass::RegularLattice ? std::string() : std::string(domainClassName(domain)) + ", ";
    return kind + std::to_string(lattice.size[0]) + " x " + std::to_string(lattice.size[1]) + " x " +
           std::to_string(lattice.size[2]) + " samples" + ofType;
}

std::string hexadecimal(std::uint64_t number)
{
    constexpr std::string_view digits = "0123456789abcdef";
    std::string text(16, '0');
    for (auto place = text.rbegin(); place != text.rend(); ++place, number >>= 4)
        *place = digits[number & 15];
    return text;
}

bool isCorner(const LatticePoint& place, const Lattice& lattice)
{
    for (int axis = 0; axis < 3; ++axis)
        if (place[axis] != 0 && place[axis] != std::int64_t(lattice.size[axis]) - 1)
            return false;
    return true;
}

/// The first mesh can only fill the domain if it has the domain's corners.
void verifyCorners(const Model& model, const Lattice& lattice, const std::vector<LatticePoint>& places,
                   Findings& findings)
{
    constexpr std::ptrdiff_t cornerCount = 8;
    const auto initial = places.begin() + std::ptrdiff_t(initialSiteCount(model));
    const auto corners =
        std::count_if(places.begin(), initial, [&](const LatticePoint& place) { return isCorner(place, lattice); });
    if (corners != cornerCount)
        findings.add(0, [&] {
            return "The " + std::to_string(initialSiteCount(model)) + " initial sites hold " + std::to_string(corners) +
                   " corners of the domain instead of all eight.";
        });
}

void verifyPlaces(const Model& model, const Dataset& original, std::vector<LatticePoint>& places, Findings& findings)
{
    const Lattice& lattice = original.lattice;
    std::vector<bool> taken(lattice.pointCount());
    bool usable = true;
    for (std::uint32_t site = 0; site < model.siteCount(); ++site) {
        const std::uint32_t point = model.points()[site];
        if (point >= lattice.pointCount()) {
            findings.add(site, [&] {
                return "Site " + std::to_string(site) + " is point " + std::to_string(point) +
                       ", and the lattice has " + std::to_string(lattice.pointCount()) + ".";
            });
            usable = false;
            continue;
        }
        const auto c = lattice.coordinates(point);
        places.push_back({c[0], c[1], c[2]});
        if (taken[point])
            findings.add(site, [&] {
                return "Site " + std::to_string(site) + " at " + textOf(places.back()) +
                       " lies where an earlier site lies.";
            });
        taken[point] = true;
    }
    if (!usable)
        places.clear();
    else if (isOnLattice(original.domain))
        verifyCorners(model, lattice, places, findings);
}

void verifyValues(const Model& model, const Dataset& original, Findings& findings)
{
    visitSampleType(model.description().sampleType, [&]<class T>() {
        const std::span<const T> values(reinterpret_cast<const T*>(model.values().data()), model.siteCount());
        const std::span<const T> samples = original.values.as<T>();
        for (std::uint32_t site = 0; site < model.siteCount(); ++site) {
            const std::uint32_t point = model.points()[site];
            if (point < samples.size() && values[site] == samples[point])
                continue;
            findings.add(site, [&] {
                return "The value of site " + std::to_string(site) + " is " +
                       textOf(static_cast<double>(values[site])) +
                       (point < samples.size()
                            ? "; the original has " + textOf(static_cast<double>(samples[point])) + " at that point."
                            : " at no point of the original.");
            });
        }
    });
}

/// The samples that a file may hold, beside those of its sites.
void verifyAllSamples(const Model& model, const Dataset& original, Findings& findings)
{
    if (model.samples().empty())
        return;
    const std::span<const std::byte> samples = original.values.bytes();
    const std::size_t size = sampleSize(original.values.type());
    // Rows: what is equal, as nearly all is, is compared quickly.
    const std::size_t rowBytes = original.lattice.size[0] * size;
    for (std::size_t at = 0; at < samples.size(); at += rowBytes) {
        if (std::ranges::equal(model.samples().subspan(at, rowBytes), samples.subspan(at, rowBytes)))
            continue;
        findings.add(at, [&] {
            const auto place = original.lattice.coordinates(at / size);
            return "The samples that the file holds of row y = " + std::to_string(place[1]) +
                   ", z = " + std::to_string(place[2]) + " are not those of the original.";
        });
    }
}

/// Likewise where they lie.
void verifySamplePositions(const Model& model, const Dataset& original, Findings& findings)
{
    const std::size_t count = model.samples().empty() || !original.positions ? 0 : original.positions->size();
    for (std::size_t point = 0; point < count; ++point) {
        const Eigen::Vector3d held = model.floatSamplePositions().empty()
                                         ? model.doubleSamplePositions()[point]
                                         : model.floatSamplePositions()[point].cast<double>().eval();
        if (held != (*original.positions)[point])
            findings.add(point, [&] {
                return "The position that the file holds of point " + std::to_string(point) +
                       " is not that of the original.";
            });
    }
}

void verifyPositions(const Model& model, const Dataset& original, Findings& findings)
{
    for (std::uint32_t site = 0; site < model.siteCount(); ++site) {
        const std::uint32_t point = model.points()[site];
        if (point < original.pointCount() && model.position(site) == original.position(point))
            continue;
        findings.add(site, [&] {
            return "Site " + std::to_string(site) + " does not lie where the original has point " +
                   std::to_string(point) + ".";
        });
    }
}

void verifyRunningKeys(const Model& model, Findings& findings)
{
    const std::span<const float> errors = model.runningKeys();
    const std::uint32_t initial = initialSiteCount(model);
    if (initial == 0)
        findings.add(0,
                     [] { return std::string("No site has an infinite running error, so there is no first mesh."); });
    for (std::uint32_t site = std::max(initial, 1u); site < model.siteCount(); ++site)
        if (!(errors[site] >= 0 && std::isfinite(errors[site]) && errors[site] <= errors[site - 1]))
            findings.add(site, [&] {
                return "The running error of site " + std::to_string(site) + " is " +
                       textOf(static_cast<double>(errors[site])) + ", after " +
                       textOf(static_cast<double>(errors[site - 1])) + ": it must be finite and must not increase.";
            });
}

} // namespace

std::uint32_t initialSiteCount(const Model& model)
{
    const std::span<const float> errors = model.runningKeys();
    const auto end = std::ranges::find_if(errors, [](float error) { return !(std::isinf(error) && error > 0); });
    return static_cast<std::uint32_t>(end - errors.begin());
}

Result<Dataset> takenByModel(const Model& model, const Dataset& dataset, const Progress& progress)
{
    const DomainClass domain = model.description().domain;
    if (domain == DomainClass::Irregular && dataset.domain == DomainClass::Scattered) {
        auto mesh = tetrahedrized(dataset, progress);
        // Points that make no mesh are those of another model.
        return mesh || mesh.error().kind == ErrorKind::Cancelled ? mesh : Result<Dataset>(dataset);
    }
    if (domain == DomainClass::Irregular && dataset.domain == DomainClass::Curvilinear) {
        auto mesh = asMesh(dataset, progress);
        return mesh || mesh.error().kind == ErrorKind::Cancelled ? mesh : Result<Dataset>(dataset);
    }
    const Lattice& lattice = model.description().lattice;
    if (domain == DomainClass::RegularLattice && dataset.domain == domain &&
        model.description().metric == dataset.lattice.spacing) {
        Dataset placed = dataset;
        placed.lattice.spacing = lattice.spacing;
        placed.lattice.origin = lattice.origin;
        return placed;
    }
    const bool isOfGridOrMesh = dataset.domain == DomainClass::Irregular || dataset.domain == DomainClass::Curvilinear;
    return domain == DomainClass::Scattered && isOfGridOrMesh ? asPoints(dataset) : dataset;
}

namespace {

/// Whether each coordinate is that of the line of points along one axis, the same one everywhere.
bool followsItsAxes(const Dataset& grid)
{
    const auto at = [&](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
        return (*grid.positions)[grid.lattice.index(i, j, k)];
    };
    std::array<std::array<bool, 3>, 3> follows{{{true, true, true}, {true, true, true}, {true, true, true}}};
    const auto& size = grid.lattice.size;
    for (std::uint32_t k = 0; k < size[2]; ++k)
        for (std::uint32_t j = 0; j < size[1]; ++j)
            for (std::uint32_t i = 0; i < size[0]; ++i) {
                const Eigen::Vector3d place = at(i, j, k);
                const std::array<Eigen::Vector3d, 3> onAxes{at(i, 0, 0), at(0, j, 0), at(0, 0, k)};
                for (std::size_t axis = 0; axis < 3; ++axis)
                    for (std::size_t c = 0; c < 3; ++c)
                        follows[axis][c] = follows[axis][c] && place[int(c)] == onAxes[axis][int(c)];
            }
    std::array<std::size_t, 3> axes{0, 1, 2};
    do {
        if (follows[axes[0]][0] && follows[axes[1]][1] && follows[axes[2]][2])
            return true;
    } while (std::ranges::next_permutation(axes).found);
    return false;
}

/// By how much an initial site lies outside of a face's plane, at most.
double heightOfSites(const Model& model, std::span<const Eigen::Vector3d> positions, const Triangle& face)
{
    const Eigen::Vector3d &a = positions[face[0]], &b = positions[face[1]], &c = positions[face[2]];
    const Eigen::Vector3d normal = (b - a).cross(c - a).normalized();
    double height = 0;
    for (std::uint32_t site = 0; site < initialSiteCount(model); ++site) {
        const Eigen::Vector3d& place = positions[model.points()[site]];
        if (volumeSign(a, b, c, place) > 0)
            height = std::max(height, normal.dot(place - a));
    }
    return height;
}

} // namespace

void verifyConvex(const Model& model, const Dataset& dataset, std::vector<std::string>& failures)
{
    if (dataset.domain == DomainClass::Curvilinear && !followsItsAxes(dataset))
        failures.emplace_back(
            "The model takes the grid as its points, but it is not rectilinear: their hull need not be "
            "its domain.");
    if (dataset.domain != DomainClass::Irregular)
        return;
    const IrregularOriginal original(dataset, failures);
    if (original.surfaces.surfaces.size() != 1)
        failures.push_back("The model takes the mesh as its points, but its boundary is " +
                           std::to_string(original.surfaces.surfaces.size()) +
                           " surfaces: their hull is not its domain.");
    const double allowed = 1e-6 * original.diagonal;
    Findings outside;
    tbb::parallel_for(std::size_t(0), original.boundary.size(), [&](std::size_t number) {
        const Triangle& face = original.boundary[number];
        const double height = heightOfSites(model, original.points.positions, face);
        if (height > allowed)
            outside.add(number, [&] {
                return "The model takes the mesh as its points, but its boundary's face " +
                       textOf(original.points.positions[face[0]]) + " " + textOf(original.points.positions[face[1]]) +
                       " " + textOf(original.points.positions[face[2]]) + " is " +
                       textOf(100 * height / original.diagonal) + " % of the diagonal inside of their hull.";
            });
    });
    outside.moveTo(failures);
}

bool verifySource(const Model& model, const Dataset& dataset, const Dataset& original,
                  std::vector<std::string>& failures)
{
    const ModelDescription& description = model.description();
    const Lattice& lattice = original.lattice;
    if (description.domain != original.domain || description.lattice.size != lattice.size ||
        description.sampleType != original.values.type() ||
        (original.domain == DomainClass::Irregular && !original.tetrahedra)) {
        failures.push_back("The model was built from another dataset: " +
                           kindText(description.domain, description.lattice, description.sampleType) + " ('" +
                           description.sourceName + "'), and '" + original.source.name + "' has " +
                           kindText(dataset.domain, dataset.lattice, dataset.values.type()) +
                           (original.domain == DomainClass::RegularLattice && !lattice.isAlongAxes()
                                ? ". TAn up to version 0.1 read lattices with directions as other ones, or as "
                                  "curvilinear grids: a model of that version is to be built again."
                                : "."));
        return false;
    }
    const std::uint64_t hash = contentHash(dataset.values, dataset.positions, dataset.tetrahedra);
    if (description.sourceHash != hash)
        failures.push_back("The model was built from other samples or positions ('" + description.sourceName +
                           "', XXH3 " + hexadecimal(description.sourceHash) + ") than those of '" +
                           original.source.name + "' (XXH3 " + hexadecimal(hash) + ").");
    if (description.lattice.spacing != lattice.spacing || description.lattice.origin != lattice.origin)
        failures.emplace_back("The spacing or the origin of the lattice is not that of the original.");
    if (description.lattice.directions != lattice.directions)
        failures.emplace_back(
            description.lattice.isAlongAxes()
                ? "The model was read without the directions of the lattice's axes, or with its samples "
                  "in another order in their place, as TAn did up to version 0.1. Build it again."
                : "The directions of the lattice's axes are not those of the original.");
    const Eigen::AlignedBox3d bounds = original.bounds();
    if (description.bounds.min() != bounds.min() || description.bounds.max() != bounds.max())
        failures.emplace_back("The bounding box is not that of the original.");
    const ValueRange range = original.values.range();
    if (description.range.minimum != range.minimum || description.range.maximum != range.maximum)
        failures.push_back("The value range is " + textOf(description.range.minimum) + " to " +
                           textOf(description.range.maximum) + "; that of the original is " + textOf(range.minimum) +
                           " to " + textOf(range.maximum) + ".");
    return true;
}

std::vector<LatticePoint> verifySites(const Model& model, const Dataset& original, std::vector<std::string>& failures)
{
    std::vector<LatticePoint> places;
    places.reserve(model.siteCount());
    Findings wrongPlaces;
    Findings wrongValues;
    Findings wrongSamples;
    Findings wrongPositions;
    Findings wrongErrors;
    verifyPlaces(model, original, places, wrongPlaces);
    verifyValues(model, original, wrongValues);
    verifyAllSamples(model, original, wrongSamples);
    verifySamplePositions(model, original, wrongSamples);
    verifyPositions(model, original, wrongPositions);
    verifyRunningKeys(model, wrongErrors);
    for (Findings* findings : {&wrongPlaces, &wrongValues, &wrongSamples, &wrongPositions, &wrongErrors})
        findings->moveTo(failures);
    return places;
}

Result<Weights> weightsOf(const Model& model, const Dataset& original, std::vector<std::string>& failures,
                          const Progress& progress)
{
    const Result<Weighting> weighting = parseWeighting(buildFacts(model.description()).weights);
    if (!weighting) {
        failures.push_back("The model's weights cannot be read. " + weighting.error().text());
        return Weights{};
    }
    return pointWeights(*weighting, original, progress);
}

namespace {

constexpr std::uint32_t historySitesAtOnce = 256;

/// Calls function(first, end) for the sites of each group.
template <class Function> void forEachGroup(const Model& model, Function&& function)
{
    std::uint32_t first = 0;
    for (std::uint32_t site = 0; site < model.siteCount(); ++site)
        if (model.groupGoesOn()[site] == 0 || site + 1 == model.siteCount()) {
            function(first, site + 1);
            first = site + 1;
        }
}

/// What the sites make and destroy, gathered from the tetrahedra alone.
struct Balance {
    explicit Balance(std::uint32_t sites) : destroyed(sites), destroyedVolume(sites), createdVolume(sites) {}

    std::vector<std::atomic<std::uint32_t>> destroyed;
    std::vector<std::atomic<std::int64_t>> destroyedVolume; ///< six times the volume
    std::vector<std::int64_t> createdVolume;
};

class HistoryCheck {
public:
    HistoryCheck(const Model& model, const Original& original, const std::vector<LatticePoint>& places)
        : model_(model), original_(original), onLattice_(isOnLattice(original.dataset.domain)), places_(places),
          balance_(model.siteCount())
    {
    }

    Status run(const Progress& progress);
    bool usable() const { return offsets_.none() && sites_.none(); }
    void moveTo(std::vector<std::string>& failures)
    {
        for (Findings* findings : {&offsets_, &sites_, &destroyers_, &errors_, &volumes_, &sizes_, &balances_})
            findings->moveTo(failures);
        if (usable())
            for (Findings* findings : {&positions_, &placedVolumes_})
                findings->moveTo(failures);
    }

private:
    void checkOffsets();
    void checkStar(std::uint32_t creator);
    void checkTetrahedron(std::uint32_t creator, std::uint64_t number);
    void checkSizes();
    void checkBalance();
    void checkPositions();

    const Model& model_;
    const Original& original_;
    const bool onLattice_;
    const std::vector<LatticePoint>& places_;
    Balance balance_;
    Findings offsets_;
    Findings sites_;
    Findings destroyers_;
    Findings errors_;
    Findings volumes_;
    Findings sizes_;
    Findings balances_;
    Findings positions_;     ///< of data that are on no lattice
    Findings placedVolumes_; ///< likewise
};

Status HistoryCheck::run(const Progress& progress)
{
    checkOffsets();
    if (!offsets_.none())
        return {};
    const Status checked = verifyEach(model_.siteCount(), historySitesAtOnce, "Verifying the history", progress,
                                      [this](std::size_t creator) { checkStar(static_cast<std::uint32_t>(creator)); });
    if (!checked)
        return checked;
    checkSizes();
    if (usable() && onLattice_)
        checkBalance();
    else if (usable())
        checkPositions();
    return {};
}

void HistoryCheck::checkOffsets()
{
    const std::span<const std::uint64_t> offsets = model_.starOffsets();
    if (offsets.front() != 0 || offsets.back() != model_.tetrahedronCount())
        offsets_.add(0, [&] {
            return "The star offsets go from " + std::to_string(offsets.front()) + " to " +
                   std::to_string(offsets.back()) + " instead of from 0 to " +
                   std::to_string(model_.tetrahedronCount()) + ".";
        });
    for (std::uint32_t site = 0; site < model_.siteCount(); ++site)
        if (offsets[site] > offsets[site + 1] || offsets[site + 1] > model_.tetrahedronCount())
            offsets_.add(site, [&] {
                return "The star of site " + std::to_string(site) + " goes from tetrahedron " +
                       std::to_string(offsets[site]) + " to " + std::to_string(offsets[site + 1]) + " of " +
                       std::to_string(model_.tetrahedronCount()) + ".";
            });
}

void HistoryCheck::checkStar(std::uint32_t creator)
{
    for (std::uint64_t number = model_.starOffsets()[creator]; number < model_.starOffsets()[creator + 1]; ++number)
        checkTetrahedron(creator, number);
}

void HistoryCheck::checkTetrahedron(std::uint32_t creator, std::uint64_t number)
{
    const std::array<std::uint32_t, 3> others = model_.otherSites()[number];
    const std::uint32_t destroyer = model_.destroyers()[number];
    const std::string name = "Tetrahedron ";
    if (model_.ownErrors()[number] > 0x7c00)
        errors_.add(number, [&] { return name + std::to_string(number) + " has an own error that is not a number."; });
    const bool destroyerKnown = destroyer == Model::never || (destroyer > creator && destroyer < model_.siteCount());
    if (!destroyerKnown)
        destroyers_.add(number, [&] {
            return name + std::to_string(number) + ", made by site " + std::to_string(creator) +
                   ", is destroyed by site " + std::to_string(destroyer) + " of " + std::to_string(model_.siteCount()) +
                   ".";
        });
    if (std::ranges::any_of(others, [creator](std::uint32_t site) { return site >= creator; })) {
        sites_.add(number, [&] {
            return name + std::to_string(number) + " has a site that is not earlier than its creator, site " +
                   std::to_string(creator) + ".";
        });
        return;
    }
    if (destroyerKnown && destroyer != Model::never)
        balance_.destroyed[destroyer].fetch_add(1, std::memory_order_relaxed);
    const auto checkSign = [&](Findings& findings, std::int64_t sign, const auto& corners) {
        if (sign <= 0)
            findings.add(number, [&] {
                return name + std::to_string(number) + " with corners " + textOf(corners) + " is " +
                       (sign == 0 ? "flat." : "inverted.");
            });
    };
    if (!onLattice_) {
        const std::span<const std::uint32_t> points = model_.points();
        const PlacedCell corners = placedCell(
            original_.points().positions, {points[creator], points[others[0]], points[others[1]], points[others[2]]});
        return checkSign(placedVolumes_, volumeSign(corners), corners);
    }
    const LatticeCorners corners = {places_[creator], places_[others[0]], places_[others[1]], places_[others[2]]};
    const std::int64_t volume = sixVolumes(corners);
    checkSign(volumes_, volume, corners);
    balance_.createdVolume[creator] += volume;
    if (destroyerKnown && destroyer != Model::never)
        balance_.destroyedVolume[destroyer].fetch_add(volume, std::memory_order_relaxed);
}

void HistoryCheck::checkSizes()
{
    std::int64_t alive = 0;
    forEachGroup(model_, [&](std::uint32_t first, std::uint32_t end) {
        alive += static_cast<std::int64_t>(model_.starOffsets()[end] - model_.starOffsets()[first]);
        for (std::uint32_t site = first; site < end; ++site)
            alive -= balance_.destroyed[site].load();
        for (std::uint32_t site = first; site < end; ++site)
            if (const std::int64_t claimed = model_.meshSizes()[site]; alive != claimed)
                sizes_.add(site, [&] {
                    return "The mesh of sites 0 to " + std::to_string(end - 1) + " has " + std::to_string(alive) +
                           " tetrahedra, and the file says " + std::to_string(claimed) + ".";
                });
    });
}

/// After the first mesh a group only divides anew what it empties, so every mesh fills the domain if the first one
/// does.
void HistoryCheck::checkBalance()
{
    const auto domain = 6 * static_cast<std::int64_t>(model_.description().lattice.cellCount());
    const std::uint32_t initialSites = initialSiteCount(model_);
    std::int64_t initial = 0;
    forEachGroup(model_, [&](std::uint32_t first, std::uint32_t end) {
        std::int64_t created = 0;
        std::int64_t destroyed = 0;
        for (std::uint32_t site = first; site < end; ++site) {
            created += balance_.createdVolume[site];
            destroyed += balance_.destroyedVolume[site].load();
        }
        if (first < initialSites)
            initial += created - destroyed;
        else if (created != destroyed)
            balances_.add(first, [&] {
                return "The group of " + std::to_string(end - first) + " sites from site " + std::to_string(first) +
                       " at " + textOf(places_[first]) + " on empties " + std::to_string(destroyed) +
                       " sixths of a cell and fills " + std::to_string(created) + ".";
            });
    });
    if (initial != domain)
        balances_.add(0, [&] {
            return "The first mesh fills " + std::to_string(initial) + " sixths of a cell; the domain has " +
                   std::to_string(domain) + ".";
        });
}

void HistoryCheck::checkPositions()
{
    for (std::uint32_t site = 0; site < model_.siteCount(); ++site)
        if (const Eigen::Vector3d place = original_.points().positions[model_.points()[site]];
            model_.position(site) != place)
            positions_.add(site, [&] {
                return "Site " + std::to_string(site) + " lies at " + textOf(model_.position(site)) +
                       "; the original's point is at " + textOf(place) + ".";
            });
}

} // namespace

Status verifyHistory(const Model& model, const Original& original, const std::vector<LatticePoint>& places,
                     std::vector<std::string>& failures, bool& usable, const Progress& progress)
{
    HistoryCheck check(model, original, places);
    const Status done = check.run(progress);
    usable = check.usable();
    check.moveTo(failures);
    return done;
}

namespace {

constexpr std::uint32_t groupSitesAtOnce = 4096;

class GroupCheck {
public:
    explicit GroupCheck(const Model& model) : model_(model), groupOf_(model.siteCount()) {}

    Status run(const Progress& progress);
    void moveTo(std::vector<std::string>& failures)
    {
        for (Findings* findings : {&flags_, &order_, &links_, &lives_})
            findings->moveTo(failures);
    }

private:
    void readGroups();
    void checkOrder();
    void checkStar(std::uint32_t creator);
    bool sameBatch(std::uint32_t first, std::uint32_t second) const
    {
        return model_.runningKeys()[first] == model_.runningKeys()[second];
    }

    const Model& model_;
    std::vector<std::uint32_t> groupOf_; ///< the first site of each site's group
    Findings flags_;
    Findings order_;
    Findings links_;
    Findings lives_;
};

void GroupCheck::readGroups()
{
    const std::span<const std::uint8_t> goesOn = model_.groupGoesOn();
    std::uint32_t first = 0;
    for (std::uint32_t site = 0; site < model_.siteCount(); ++site) {
        groupOf_[site] = first;
        const bool last = site + 1 == model_.siteCount();
        if (goesOn[site] > 1 || (goesOn[site] == 1 && (last || !sameBatch(site, site + 1))))
            flags_.add(site, [&] {
                return "The group of site " + std::to_string(site) + " goes on with a site of another running error.";
            });
        if (goesOn[site] == 0)
            first = site + 1;
    }
    const std::uint32_t initial = initialSiteCount(model_);
    if (initial > 0 && groupOf_[initial - 1] != 0)
        flags_.add(0, [] { return std::string("The initial sites are not one group."); });
}

/// In a batch, groups come in the order of their first points, sites in a group in that of theirs.
void GroupCheck::checkOrder()
{
    for (std::uint32_t site = 1; site < model_.siteCount(); ++site) {
        if (!sameBatch(site - 1, site))
            continue;
        const std::uint32_t before = groupOf_[site] == site ? groupOf_[site - 1] : site - 1;
        if (model_.points()[before] >= model_.points()[site])
            order_.add(site, [&] {
                return "Sites " + std::to_string(before) + " and " + std::to_string(site) +
                       " have the same running error and are not in the order of their points.";
            });
    }
}

void GroupCheck::checkStar(std::uint32_t creator)
{
    for (std::uint64_t number = model_.starOffsets()[creator]; number < model_.starOffsets()[creator + 1]; ++number) {
        for (const std::uint32_t site : model_.otherSites()[number])
            if (sameBatch(site, creator) && groupOf_[site] != groupOf_[creator])
                links_.add(number, [&] {
                    return "Tetrahedron " + std::to_string(number) + " joins sites " + std::to_string(site) + " and " +
                           std::to_string(creator) + " of two groups with the same running error.";
                });
        const std::uint32_t destroyer = model_.destroyers()[number];
        if (destroyer < model_.siteCount() && sameBatch(creator, destroyer))
            lives_.add(number, [&] {
                return "Tetrahedron " + std::to_string(number) +
                       " is made and destroyed at the same running error: no mesh holds it.";
            });
    }
}

Status GroupCheck::run(const Progress& progress)
{
    readGroups();
    checkOrder();
    return verifyEach(model_.siteCount(), groupSitesAtOnce, "Verifying the groups", progress,
                      [this](std::size_t creator) { checkStar(static_cast<std::uint32_t>(creator)); });
}

} // namespace

Status verifyGroups(const Model& model, std::vector<std::string>& failures, const Progress& progress)
{
    GroupCheck check(model);
    const Status done = check.run(progress);
    check.moveTo(failures);
    return done;
}

namespace {

constexpr std::size_t groupsAtOnce = 256;

/// The tetrahedra by the site that destroys them.
struct Destroyed {
    std::vector<std::uint64_t> starts;
    std::vector<std::uint64_t> numbers;

    explicit Destroyed(const Model& model) : starts(model.siteCount() + 1)
    {
        const auto forEach = [&](auto&& use) {
            for (std::uint64_t number = 0; number < model.tetrahedronCount(); ++number)
                if (const std::uint32_t destroyer = model.destroyers()[number]; destroyer < model.siteCount())
                    use(destroyer, number);
        };
        forEach([&](std::uint32_t destroyer, std::uint64_t) { ++starts[destroyer + 1]; });
        for (std::size_t site = 1; site < starts.size(); ++site)
            starts[site] += starts[site - 1];
        numbers.resize(starts.back());
        std::vector<std::uint64_t> next(starts.begin(), starts.end() - 1);
        forEach([&](std::uint32_t destroyer, std::uint64_t number) { numbers[next[destroyer]++] = number; });
    }
};

/// The faces that belong to one of the tetrahedra, sorted; each with its sites in increasing order.
std::vector<Triangle> outerFaces(std::span<const Tetrahedron> tetrahedra)
{
    std::vector<Triangle> faces;
    for (const auto& t : tetrahedra)
        for (std::size_t opposite = 0; opposite < 4; ++opposite) {
            Triangle face = {t[(opposite + 1) % 4], t[(opposite + 2) % 4], t[(opposite + 3) % 4]};
            std::ranges::sort(face);
            faces.push_back(face);
        }
    std::ranges::sort(faces);
    std::vector<Triangle> outer;
    for (auto begin = faces.begin(); begin != faces.end();) {
        const auto end = std::find_if(begin, faces.end(), [&](const Triangle& face) { return face != *begin; });
        if (end - begin == 1)
            outer.push_back(*begin);
        begin = end;
    }
    return outer;
}

class ClosureCheck {
public:
    explicit ClosureCheck(const Model& model) : model_(model), destroyed_(model), creators_(model.tetrahedronCount())
    {
        for (std::uint32_t site = 0; site < model.siteCount(); ++site)
            std::fill(creators_.begin() + static_cast<std::ptrdiff_t>(model.starOffsets()[site]),
                      creators_.begin() + static_cast<std::ptrdiff_t>(model.starOffsets()[site + 1]), site);
        forEachGroup(model, [&](std::uint32_t first, std::uint32_t) { groups_.push_back(first); });
        groups_.push_back(model.siteCount());
    }

    Status run(const Progress& progress)
    {
        return verifyEach(groups_.size() - 1, groupsAtOnce, "Verifying what sites depend on", progress,
                          [this](std::size_t group) {
                              if (group > 0) // the first one stands on nothing
                                  checkGroup(groups_[group], groups_[group + 1]);
                          });
    }
    void moveTo(std::vector<std::string>& failures) { findings_.moveTo(failures); }

private:
    Tetrahedron sitesOf(std::uint64_t number) const
    {
        const auto& others = model_.otherSites()[number];
        return {creators_[number], others[0], others[1], others[2]};
    }

    void checkGroup(std::uint32_t first, std::uint32_t end)
    {
        std::vector<Tetrahedron> emptied;
        std::vector<Tetrahedron> filled;
        for (std::uint64_t i = destroyed_.starts[first]; i < destroyed_.starts[end]; ++i)
            emptied.push_back(sitesOf(destroyed_.numbers[i]));
        for (std::uint64_t number = model_.starOffsets()[first]; number < model_.starOffsets()[end]; ++number)
            filled.push_back(sitesOf(number));
        const std::vector<Triangle> before = outerFaces(emptied);
        for (const Triangle& face : outerFaces(filled))
            if (face[2] < first && !std::ranges::binary_search(before, face))
                findings_.add(first, [&] {
                    return "The group of site " + std::to_string(first) + " has a tetrahedron on the face of sites " +
                           std::to_string(face[0]) + ", " + std::to_string(face[1]) + " and " +
                           std::to_string(face[2]) +
                           ", which is none of what it destroys: not every closed set with it has a mesh.";
                });
    }

    const Model& model_;
    Destroyed destroyed_;
    std::vector<std::uint32_t> creators_;
    std::vector<std::uint32_t> groups_; ///< their first sites, and one beyond all
    Findings findings_;
};

} // namespace

Status verifyClosure(const Model& model, std::vector<std::string>& failures, const Progress& progress)
{
    ClosureCheck check(model);
    const Status done = check.run(progress);
    check.moveTo(failures);
    return done;
}

} // namespace tetra
