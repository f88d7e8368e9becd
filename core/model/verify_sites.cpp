// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/findings.h"
#include "core/model/verify_parts.h"

#include <algorithm>
#include <cmath>

namespace tetra {

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

void verifyRunningErrors(const Model& model, Findings& findings)
{
    const std::span<const float> errors = model.runningErrors();
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
    const std::span<const float> errors = model.runningErrors();
    const auto end = std::ranges::find_if(errors, [](float error) { return !(std::isinf(error) && error > 0); });
    return static_cast<std::uint32_t>(end - errors.begin());
}

bool verifySource(const Model& model, const Dataset& original, std::vector<std::string>& failures)
{
    const ModelDescription& description = model.description();
    const Lattice& lattice = original.lattice;
    if (description.domain != original.domain || description.lattice.size != lattice.size ||
        description.sampleType != original.values.type() ||
        (original.domain == DomainClass::Irregular && !original.tetrahedra)) {
        failures.push_back("The model was built from another dataset: " +
                           kindText(description.domain, description.lattice, description.sampleType) + " ('" +
                           description.sourceName + "'), and '" + original.source.name + "' has " +
                           kindText(original.domain, lattice, original.values.type()) + ".");
        return false;
    }
    const std::uint64_t hash = contentHash(original.values, original.positions, original.tetrahedra);
    if (description.sourceHash != hash)
        failures.push_back("The model was built from other samples or positions ('" + description.sourceName +
                           "', XXH3 " + hexadecimal(description.sourceHash) + ") than those of '" +
                           original.source.name + "' (XXH3 " + hexadecimal(hash) + ").");
    if (description.lattice.spacing != lattice.spacing || description.lattice.origin != lattice.origin)
        failures.emplace_back("The spacing or the origin of the lattice is not that of the original.");
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
    verifyRunningErrors(model, wrongErrors);
    for (Findings* findings : {&wrongPlaces, &wrongValues, &wrongSamples, &wrongPositions, &wrongErrors})
        findings->moveTo(failures);
    return places;
}

} // namespace tetra
