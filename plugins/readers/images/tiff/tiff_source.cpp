// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/images/tiff/tiff_source.h"

#include "plugins/api/placement_parameters.h"
#include "plugins/process/process_limits.h"
#include "plugins/readers/images/tiff/tiff_planes.h"

#include <algorithm>
#include <cmath>

namespace tetra {
namespace {

namespace fs = std::filesystem;

/// Numbers of the format (PhotometricInterpretation).
enum TiffColours : std::uint16_t { whiteIsZero = 0, blackIsZero = 1, rgb = 2, palette = 3 };

/// What is to be read, all of it known from headers.
struct TiffChoice {
    TiffPlanes planes;
    TiffSamples samples;
    TiffWanted wanted;
    Lattice lattice;
    std::string lengthUnit;
    std::vector<std::string> untold;
    std::vector<Taken> taken;
    std::uint64_t bytes = 0; ///< of all files
};

std::string nameOf(const fs::path& path)
{
    return printable(path.filename().string());
}

Error inFile(const TiffPlanes& planes, const fs::path& path, const Error& error)
{
    return planes.files.size() > 1 ? Error{error.kind, Message::say("its file '%1': %2", nameOf(path), error.message)}
                                   : error;
}

/// The pages of all slices are of one kind, and there.
Status checkSlices(const TiffFile& opened, const fs::path& path, TiffChoice& choice, const TellProgress& progress)
{
    std::optional<TiffSamples> first;
    std::optional<TiffFile> other;
    std::size_t otherNumber = ~std::size_t(0);
    for (std::size_t slice = 0; slice < choice.planes.slices.size(); ++slice) {
        const TiffPlane& plane = choice.planes.slices[slice];
        const fs::path& name = choice.planes.files[plane.file];
        const bool isOpened = name == path;
        if (!isOpened && otherNumber != plane.file) {
            auto file = TiffFile::open(name);
            if (!file)
                return inFile(choice.planes, name, file.error());
            choice.bytes += file->bytes();
            other.emplace(*std::move(file));
            otherNumber = plane.file;
        }
        const TiffFile& file = isOpened ? opened : *other;
        const bool isBehind =
            file.pages().size() == 1 && file.pages().front().pixelsAt && choice.planes.description.isImageJ;
        if (plane.page >= file.pages().size() && !isBehind)
            return inFile(choice.planes, name,
                          Error{ErrorKind::BadInput,
                                Message::say("its description refers to page %1, and it has %2. Export it again.",
                                             plane.page + 1, file.pages().size())});
        const TiffPage& page = file.pages()[isBehind ? 0 : plane.page];
        if (!first)
            first = page.samples;
        if (page.isReduced || page.samples != *first)
            return inFile(choice.planes, name,
                          Error{ErrorKind::BadInput, Message::say("page %1 has another size or type than the first "
                                                                  "slice. The slices of one volume have one size.",
                                                                  plane.page + 1)});
        if (slice % 64 == 0)
            progress(static_cast<double>(slice) / static_cast<double>(choice.planes.slices.size()));
    }
    choice.bytes += opened.bytes();
    choice.samples = *first;
    return {};
}

/// Which of several samples of a pixel is taken.
Status chooseComponent(const std::string& wanted, TiffChoice& choice)
{
    const std::uint16_t count = choice.samples.samples;
    if (count == 1) {
        choice.wanted.component = 0;
        return {};
    }
    const bool isColour = choice.samples.photometric == rgb;
    choice.wanted.colours = isColour ? std::min<std::uint16_t>(count, 3) : count;
    const bool isMagnitude = wanted == "magnitude" || (wanted.empty() && isColour);
    const auto number = wanted.empty() ? std::optional<std::uint16_t>(0) : parseNumber<std::uint16_t>(wanted);
    if (!isMagnitude && (!number || *number >= count))
        return Error{
            ErrorKind::WrongUsage,
            Message::say(
                "its pixels have %1 components, and number %2 was requested. Choose one from 0 to %3, or 'magnitude'.",
                count, printable(wanted), count - 1)};
    if (!isMagnitude)
        choice.wanted.component = *number;
    choice.taken.push_back({TakenPart::Component,
                            isMagnitude ? Message::say("the magnitude of %1", choice.wanted.colours)
                                        : Message::say("%1 of 0 to %2", *number, count - 1),
                            wanted.empty()});
    choice.planes.leftOut.push_back(
        Message::say("Each pixel has %1 numbers, of which one value is made. Choose one with 'component'.", count));
    return {};
}

/// What the samples mean, as far as TAn reads them.
Status chooseValues(const ImagesRequest& request, TiffChoice& choice)
{
    const TiffSamples& samples = choice.samples;
    const PictureDescription& description = choice.planes.description;
    if (samples.photometric == palette && !choice.planes.hasDescription)
        return Error{ErrorKind::BadInput, Message::say("its pixels are the numbers of colours in a palette. Convert it "
                                                       "to shades of grey.")};
    if (samples.photometric > palette)
        return Error{ErrorKind::BadInput, Message::say("its colours are of a kind that TAn does not read "
                                                       "(PhotometricInterpretation %1). Convert it to shades of grey.",
                                                       samples.photometric)};
    if (samples.photometric == palette)
        choice.planes.leftOut.push_back(Message::say("The colours of its palette are not used."));
    if (samples.photometric == whiteIsZero)
        choice.planes.leftOut.push_back(
            Message::say("Its pictures are meant to be shown with small values bright; the values are as the file has "
                         "them."));
    const auto type = typeOf(samples);
    if (!type)
        return Error{ErrorKind::BadInput,
                     Message::say("its samples have %1 bits and the format %2 (SampleFormat), which TAn does not read. "
                                  "Write whole numbers or floating-point numbers of 32 bits.",
                                  samples.bits, samples.format)};
    choice.wanted.type = *type;
    if (const Status chosen = chooseComponent(request.component, choice); !chosen)
        return chosen;
    if (!choice.wanted.component)
        choice.wanted.type = samples.bits > 24 ? SampleType::Float64 : SampleType::Float32;
    if (description.offset && *description.offset != 0) {
        choice.wanted.offset = *description.offset;
        const bool isShifted = *type == SampleType::UInt16 && *description.offset == -32768;
        choice.wanted.type = isShifted ? SampleType::Int16 : SampleType::Float64;
    }
    if (description.hasCurve)
        choice.planes.leftOut.push_back(
            Message::say("ImageJ's calibration of the values is not used: the stored values are."));
    return {};
}

/// Of a file without a description: pixels per inch or centimetre, as far as they are meant.
void readResolution(const TiffTexts& texts, PictureDescription& description, std::vector<Message>& leftOut)
{
    constexpr std::uint16_t inch = 2, centimetre = 3;
    const auto& perUnit = texts.pixelsPerUnit;
    if (!perUnit[0] || !perUnit[1] || (texts.resolutionUnit != inch && texts.resolutionUnit != centimetre) ||
        description.spacing[0])
        return;
    if (texts.resolutionUnit == inch && (*perUnit[0] == 72 || *perUnit[0] == 96)) {
        leftOut.push_back(
            Message::say("It states %1 pixels per inch, as pictures without a scale do; that is not used.",
                         formatNumber(*perUnit[0])));
        return;
    }
    for (std::size_t axis = 0; axis < 2; ++axis) // files hold single precision
        description.spacing[axis] = (texts.resolutionUnit == inch ? 25.4 : 10) / *perUnit[axis];
    description.unit = "mm";
}

/// Where the slices lie.
void place(const TiffTexts& texts, TiffChoice& choice)
{
    PictureDescription& description = choice.planes.description;
    readResolution(texts, description, choice.planes.leftOut);
    const auto& spacing = description.spacing;
    Lattice& lattice = choice.lattice;
    lattice.size = {choice.samples.width, choice.samples.height,
                    static_cast<std::uint32_t>(choice.planes.slices.size())};
    const bool tellsPixels = spacing[0] && spacing[1];
    const bool isDepthOfImageJ = tellsPixels && description.isImageJ && !description.unit.empty();
    const double pixel = tellsPixels ? *spacing[0] : 1;
    const double depth = spacing[2].value_or(isDepthOfImageJ ? 1 : pixel);
    lattice.spacing = {pixel, tellsPixels ? *spacing[1] : 1, depth};
    if (tellsPixels && !spacing[2])
        choice.taken.push_back(
            {TakenPart::Frame,
             isDepthOfImageJ
                 ? Message::say("slices 1 %1 apart, as ImageJ assumes without 'spacing'", printable(description.unit))
                 : Message::say("slices as far apart as pixels, %1", formatNumber(depth)),
             true});
    choice.lengthUnit = printable(description.unit);
    const bool tellsSpacing = spacing[2] ? tellsPixels || description.isImageJ : isDepthOfImageJ;
    choice.untold = untoldPlacement(tellsSpacing, false, !choice.lengthUnit.empty());
    if (!description.valueUnit.empty())
        choice.taken.push_back({TakenPart::Unit, printable(description.valueUnit)});
}

/// What the planes took, and this; each part once.
std::vector<Taken> allTaken(const TiffChoice& choice)
{
    std::vector<Taken> all = choice.planes.taken;
    for (const Taken& taken : choice.taken)
        if (std::ranges::find(all, taken.part, &Taken::part) == all.end())
            all.push_back(taken);
    std::ranges::stable_sort(all, {}, &Taken::part);
    return all;
}

void limitTo(const TiffChoice& choice)
{
    constexpr std::uint64_t positionBytes = 24;
    const std::uint64_t perPoint = sampleSize(choice.wanted.type) + (choice.planes.heights.empty() ? 0 : positionBytes);
    limitWork(limitsFor(choice.bytes, choice.lattice.pointCount() * perPoint, physicalBytes()));
}

/// Where the points lie if slices are missing.
std::vector<Eigen::Vector3d> pointsOf(const TiffChoice& choice)
{
    std::vector<Eigen::Vector3d> points;
    points.reserve(choice.lattice.pointCount());
    for (const double height : choice.planes.heights)
        for (std::uint32_t j = 0; j < choice.lattice.size[1]; ++j)
            for (std::uint32_t i = 0; i < choice.lattice.size[0]; ++i)
                points.push_back(choice.lattice.spacing.cwiseProduct(Eigen::Vector3d(i, j, height)));
    return points;
}

FileContents contentsOf(const TiffChoice& choice)
{
    FileContents contents;
    contents.domain = choice.planes.heights.empty() ? DomainClass::RegularLattice : DomainClass::Curvilinear;
    contents.lattice = choice.lattice;
    contents.points = choice.lattice.pointCount();
    contents.type = choice.wanted.type;
    contents.untold = choice.untold;
    contents.channels = choice.planes.channels;
    contents.series = choice.planes.series;
    for (std::uint64_t time = 1; choice.planes.times > 1 && time <= choice.planes.times; ++time)
        contents.timeSteps.push_back(choice.planes.description.betweenTimes ? choice.planes.description.atTime(time - 1)
                                                                            : static_cast<double>(time));
    contents.taken = allTaken(choice);
    contents.leftOut = choice.planes.leftOut;
    return contents;
}

Result<FileFindings> findingsOf(const TiffChoice& choice, const TellProgress& progress)
{
    FileFindings found;
    found.kind = choice.planes.heights.empty() ? FoundKind::Lattice : FoundKind::Grid;
    found.lattice = choice.lattice;
    found.lengthUnit = choice.lengthUnit;
    found.untold = choice.untold;
    found.type = choice.wanted.type;
    found.samples.resize(choice.lattice.pointCount() * sampleSize(choice.wanted.type));
    const std::size_t sliceBytes =
        std::size_t(choice.samples.width) * choice.samples.height * sampleSize(choice.wanted.type);
    std::optional<TiffFile> file;
    std::size_t opened = ~std::size_t(0);
    std::uint64_t rounded = 0;
    for (std::size_t slice = 0; slice < choice.planes.slices.size(); ++slice) {
        const TiffPlane& plane = choice.planes.slices[slice];
        const fs::path& path = choice.planes.files[plane.file];
        if (opened != plane.file) {
            auto next = TiffFile::open(path);
            if (!next)
                return inFile(choice.planes, path, next.error());
            file.emplace(*std::move(next));
            opened = plane.file;
        }
        if (const Status read =
                file->read(plane.page, choice.wanted, found.samples.data() + slice * sliceBytes, rounded);
            !read)
            return inFile(choice.planes, path, read.error());
        progress(static_cast<double>(slice + 1) / static_cast<double>(choice.planes.slices.size()));
    }
    if (found.kind == FoundKind::Grid)
        found.positions = pointsOf(choice);
    found.remarks = choice.planes.remarks;
    if (rounded > 0)
        found.remarks.push_back(Message::say("%1 whole numbers of 64 bits were rounded to double precision.", rounded));
    found.taken = allTaken(choice);
    found.leftOut = choice.planes.leftOut;
    return found;
}

} // namespace

Result<ReadAnswer> answerTiff(const ImagesRequest& request, const TellProgress& progress)
{
    constexpr double untilChecked = 0.2; // of the time, roughly
    const fs::path path = request.path;
    const auto file = TiffFile::open(path);
    if (!file)
        return file.error();
    auto planes = tiffPlanes(path, *file, request);
    if (!planes)
        return planes.error();
    TiffChoice choice;
    choice.planes = *std::move(planes);
    const auto reduced = std::ranges::count(file->pages(), true, &TiffPage::isReduced);
    if (reduced > 0)
        choice.planes.leftOut.push_back(
            Message::say("%1 of its pages are smaller copies of others, or masks.", reduced));
    if (std::ranges::any_of(file->pages(), &TiffPage::hasCopies))
        choice.planes.leftOut.push_back(Message::say("Smaller copies of its pages (SubIFDs) are not read."));
    if (const Status sound =
            checkSlices(*file, path, choice, [&](double fraction) { progress(untilChecked * fraction); });
        !sound)
        return sound.error();
    if (const Status chosen = chooseValues(request, choice); !chosen)
        return chosen.error();
    place(file->texts(), choice);
    if (const Status fits = checkUntold(request.given, choice.untold); !fits)
        return fits.error();
    if (request.contentsOnly)
        return ReadAnswer(contentsOf(choice));
    limitTo(choice);
    auto found = findingsOf(choice, [&](double fraction) { progress(untilChecked + (1 - untilChecked) * fraction); });
    return found ? Result<ReadAnswer>(ReadAnswer(*std::move(found))) : found.error();
}

} // namespace tetra
