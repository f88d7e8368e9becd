// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/images/dicom/dicom_source.h"

#include "plugins/api/placement_parameters.h"
#include "plugins/api/time_steps.h"
#include "plugins/process/process_limits.h"
#include "plugins/readers/images/dicom/dicom_series.h"
#include "plugins/readers/images/dicom/dicom_volumes.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>

namespace tetra {
namespace {

namespace fs = std::filesystem;

constexpr double untilHeaders = 0.3; ///< of the time, roughly

/// What is to be read, all of it known from headers.
struct DicomChoice {
    std::span<const DicomHeader> series;
    DicomVolume volume;
    DicomPlaces places;
    SampleType type = SampleType::Int16;
    std::vector<Message> remarks;
    std::vector<Taken> taken;
    std::vector<Message> leftOut;
};

const DicomFrame& frameOf(const DicomChoice& choice, const DicomPicture& picture)
{
    return choice.series[picture.file].frames[picture.frame];
}

/// Why these pictures are no samples; empty if they are.
Message whyNoSamples(const DicomHeader& header)
{
    if (header.rows == 0 || header.columns == 0)
        return Message::say("it has no rows or columns. The file is damaged: copy or export it again.");
    if (header.samples > 1 || (!header.photometric.empty() && !header.photometric.starts_with("MONOCHROME")))
        return Message::say("its pictures are in colour (%1), and TAn reads one value for each point. Export them in "
                            "shades of grey.",
                            printable(header.photometric));
    if (header.isMosaic)
        return Message::say("each of its pictures is a mosaic of slices (Siemens). Convert it to NIfTI with dcm2niix.");
    if (header.isFilm)
        return Message::say("its pictures are frames of a film and not slices of a volume.");
    if (header.allocatedBits != 8 && header.allocatedBits != 16 && header.allocatedBits != 32)
        return Message::say("its pixels have %1 bits, and TAn reads those of 8, 16 and 32. Write them with 16.",
                            header.allocatedBits);
    if (header.storedBits == 0 || header.storedBits > header.allocatedBits || header.highBit + 1 < header.storedBits ||
        header.highBit >= header.allocatedBits)
        return Message::say("it states that %1 of %2 bits of a pixel count, up to bit %3. The file is damaged: copy or "
                            "export it again.",
                            header.storedBits, header.allocatedBits, header.highBit);
    return {};
}

bool isWhole(double number)
{
    return std::abs(number) < 1e9 && number == std::floor(number);
}

/// The smallest type that holds what the pictures can hold, exactly; for values that are no whole numbers the one whose
/// rounding is no worse than the file's.
SampleType typeFor(const DicomChoice& choice)
{
    double least = 0, most = 0;
    bool allWhole = true, isWide = false;
    for (const DicomPicture& picture : choice.volume.pictures) {
        const DicomHeader& header = choice.series[picture.file];
        const DicomFrame& frame = frameOf(choice, picture);
        const auto bits = static_cast<int>(header.storedBits);
        const double low = header.isSigned ? -std::ldexp(1, bits - 1) : 0;
        const double high = std::ldexp(1, header.isSigned ? bits - 1 : bits) - 1;
        for (const double stored : {low, high}) {
            least = std::min(least, stored * frame.slope + frame.intercept);
            most = std::max(most, stored * frame.slope + frame.intercept);
        }
        allWhole = allWhole && isWhole(frame.slope) && isWhole(frame.intercept);
        isWide = isWide || bits > 16;
    }
    if (!allWhole)
        return isWide ? SampleType::Float64 : SampleType::Float32;
    const auto fits = [&]<class T>(T) {
        return least >= static_cast<double>(std::numeric_limits<T>::min()) &&
               most <= static_cast<double>(std::numeric_limits<T>::max());
    };
    if (fits(std::uint8_t()))
        return SampleType::UInt8;
    if (fits(std::int8_t()))
        return SampleType::Int8;
    if (fits(std::uint16_t()))
        return SampleType::UInt16;
    if (fits(std::int16_t()))
        return SampleType::Int16;
    if (fits(std::uint32_t()))
        return SampleType::UInt32;
    return fits(std::int32_t()) ? SampleType::Int32 : SampleType::Float64;
}

/// What is said of the values and does not change them.
void tellOfValues(DicomChoice& choice)
{
    const DicomPicture& picture = choice.volume.pictures.front();
    const DicomHeader& header = choice.series[picture.file];
    const DicomFrame& first = frameOf(choice, picture);
    const auto hasUnit = [&](const DicomPicture& other) { return frameOf(choice, other).unit == first.unit; };
    if (!first.unit.empty() && std::ranges::all_of(choice.volume.pictures, hasUnit))
        choice.taken.push_back({TakenPart::Unit, printable(first.unit)});
    if (header.photometric == "MONOCHROME1")
        choice.leftOut.push_back(Message::say("Its pictures are meant to be shown with small values bright "
                                              "(MONOCHROME1); the values are as the file has them."));
    if (header.padding)
        choice.leftOut.push_back(Message::say(
            "Pixels outside the picture have the value %1 (PixelPaddingValue), and are treated as ordinary values.",
            formatNumber(*header.padding * first.slope + first.intercept)));
    if (header.hasTable)
        choice.leftOut.push_back(Message::say(
            "It has a table (ModalityLUT) that converts stored numbers into values; the stored numbers are used."));
    if (header.lostInPacking)
        choice.leftOut.push_back(Message::say("It states that its pictures were compressed with loss."));
}

void tellOfSeries(const DicomFolder& folder, std::size_t series, const DicomVolumes& volumes, bool isChosen,
                  DicomChoice& choice)
{
    constexpr std::size_t mostTold = 8;
    if (const std::size_t count = folder.series.size(); count > 1) {
        choice.taken.push_back(
            {TakenPart::Series, Message::say("%1 of %2: %3", series + 1, count, folder.series[series].name)});
        std::size_t told = 0;
        for (std::size_t other = 0; other < count && told < mostTold; ++other)
            if (other != series) {
                ++told;
                choice.leftOut.push_back(
                    isChosen ? Message::say("Next to it is series %1: %2.", other + 1, folder.series[other].name)
                             : Message::say("Next to it is series %1: %2. Choose it with 'series'.", other + 1,
                                            folder.series[other].name));
            }
        if (count - 1 > told)
            choice.leftOut.push_back(Message::say("%1 more series are next to it.", count - 1 - told));
    }
    if (volumes.others > 0)
        choice.leftOut.push_back(
            Message::say("%1 pictures of the series have another size or direction, as overviews have, and were left "
                         "out.",
                         volumes.others));
    if (volumes.copies > 0)
        choice.leftOut.push_back(Message::say("%1 files are copies of others, and were left out.", volumes.copies));
    std::ranges::copy_n(folder.unreadable.begin(),
                        static_cast<std::ptrdiff_t>(std::min(folder.unreadable.size(), mostTold)),
                        std::back_inserter(choice.leftOut));
}

/// The volume that is asked for, of those that the series makes.
Status chooseVolume(DicomVolumes& volumes, std::int64_t wanted, DicomChoice& choice)
{
    const auto count = static_cast<std::int64_t>(volumes.volumes.size());
    if (wanted > count)
        return noSuchTimeStep(volumes.volumes.size(), wanted);
    const std::size_t number = wanted == 0 ? volumes.opened : static_cast<std::size_t>(wanted - 1);
    choice.volume = volumes.volumes[number];
    if (count == 1)
        return {};
    const Message which = Message::say("%1 of %2", number + 1, count);
    const Message& name = choice.volume.name;
    choice.taken.push_back({TakenPart::TimeStep, name.empty() ? which : Message::say("%1, %2", which, name),
                            wanted == 0 || choice.volume.isGuessed});
    choice.leftOut.push_back(wanted == 0
                                 ? Message::say("The series holds %1 volumes; the others are not read. Choose one with "
                                                "'--time'.",
                                                count)
                                 : Message::say("The series holds %1 volumes; the others are not read.", count));
    return {};
}

/// A header of each file, sound and of the kind that is read.
Status checkFiles(const DicomChoice& choice)
{
    for (const DicomPicture& picture : choice.volume.pictures) {
        const DicomHeader& header = choice.series[picture.file];
        if (const Message why = whyNoSamples(header); !why.empty())
            return Error{ErrorKind::BadInput, Message::say("the file '%1' of its series: %2",
                                                           printable(header.path.filename().string()), why)};
        if (!std::isfinite(frameOf(choice, picture).slope * 4e9 + frameOf(choice, picture).intercept))
            return Error{ErrorKind::BadInput,
                         Message::say("its values are scaled beyond the range of numbers (RescaleSlope). The file is "
                                      "damaged: copy or export it again.")};
    }
    return {};
}

/// The stored number of a sample, whose bits may be fewer than those that it takes.
template <class Whole> double storedNumber(const char* bytes, const DicomHeader& header)
{
    Whole number{};
    std::memcpy(&number, bytes, sizeof number);
    const auto above = static_cast<unsigned>(header.allocatedBits - 1 - header.highBit);
    const auto unused = static_cast<unsigned>(header.allocatedBits - header.storedBits);
    number = static_cast<Whole>(static_cast<std::make_unsigned_t<Whole>>(number) << above);
    return static_cast<double>(static_cast<Whole>(number >> unused));
}

template <class T>
void putSlice(const std::vector<char>& samples, const DicomHeader& header, std::size_t number, T* target)
{
    const DicomFrame& frame = header.frames[number];
    const std::size_t count = header.rows * header.columns, size = header.allocatedBits / 8;
    const char* from = samples.data() + number * count * size;
    const auto put = [&](const auto& stored) {
        for (std::size_t sample = 0; sample < count; ++sample)
            target[sample] = static_cast<T>(stored(from + sample * size) * frame.slope + frame.intercept);
    };
    const auto putAs = [&]<class Signed>(Signed) {
        if (header.isSigned)
            put([&](const char* bytes) { return storedNumber<Signed>(bytes, header); });
        else
            put([&](const char* bytes) { return storedNumber<std::make_unsigned_t<Signed>>(bytes, header); });
    };
    if (size == 1)
        putAs(std::int8_t());
    else if (size == 2)
        putAs(std::int16_t());
    else
        putAs(std::int32_t());
}

/// The samples of all slices, file by file.
Result<Buffer<std::byte>> samplesOf(const DicomChoice& choice, const TellProgress& progress)
{
    const std::uint64_t slice = choice.places.lattice.pointCount() / choice.volume.pictures.size();
    Buffer<std::byte> all(choice.places.lattice.pointCount() * sampleSize(choice.type));
    std::map<std::size_t, std::vector<std::size_t>> slicesOfFile;
    for (std::size_t number = 0; number < choice.volume.pictures.size(); ++number)
        slicesOfFile[choice.volume.pictures[number].file].push_back(number);
    std::size_t done = 0;
    for (const auto& [file, slices] : slicesOfFile) {
        const DicomHeader& header = choice.series[file];
        const auto samples = dicomSamples(header);
        if (!samples)
            return Error{samples.error().kind,
                         Message::say("the file '%1' of its series: %2", printable(header.path.filename().string()),
                                      samples.error().message)};
        visitSampleType(choice.type, [&]<class T>() {
            for (const std::size_t number : slices)
                putSlice(*samples, header, choice.volume.pictures[number].frame,
                         reinterpret_cast<T*>(all.data()) + number * slice);
        });
        done += slices.size();
        progress(untilHeaders +
                 (1 - untilHeaders) * static_cast<double>(done) / static_cast<double>(choice.volume.pictures.size()));
    }
    return all;
}

void limitTo(const DicomChoice& choice)
{
    constexpr std::uint64_t place = 24; // bytes of a position
    std::uint64_t bytes = 0;
    for (const DicomHeader& header : choice.series)
        bytes += header.bytes;
    const std::uint64_t perPoint = sampleSize(choice.type) + (choice.places.slices.empty() ? 0 : place);
    limitWork(limitsFor(bytes, choice.places.lattice.pointCount() * perPoint, physicalBytes()));
}

FileContents contentsOf(const DicomFolder& folder, const DicomVolumes& volumes, DicomChoice choice)
{
    FileContents contents;
    contents.domain = choice.places.slices.empty() ? DomainClass::RegularLattice : DomainClass::Curvilinear;
    contents.lattice = choice.places.lattice;
    contents.points = contents.lattice.pointCount();
    contents.type = choice.type;
    contents.untold = choice.places.untold;
    if (folder.series.size() > 1)
        for (const DicomSeries& series : folder.series)
            contents.series.push_back(series.name.text());
    if (volumes.volumes.size() > 1)
        for (std::size_t volume = 0; volume < volumes.volumes.size(); ++volume)
            contents.timeSteps.push_back(static_cast<double>(volume + 1));
    contents.taken = std::move(choice.taken);
    contents.leftOut = std::move(choice.leftOut);
    return contents;
}

Result<ReadAnswer> findingsOf(DicomChoice choice, const TellProgress& progress)
{
    auto samples = samplesOf(choice, progress);
    if (!samples)
        return samples.error();
    FileFindings found;
    found.kind = choice.places.slices.empty() ? FoundKind::Lattice : FoundKind::Grid;
    found.lattice = choice.places.lattice;
    found.space = choice.places.space;
    found.lengthUnit = choice.places.lengthUnit;
    found.untold = choice.places.untold;
    if (found.kind == FoundKind::Grid)
        found.positions = positionsOf(choice.places);
    found.type = choice.type;
    found.samples = *std::move(samples);
    found.remarks = std::move(choice.remarks);
    found.taken = std::move(choice.taken);
    found.leftOut = std::move(choice.leftOut);
    return ReadAnswer(std::move(found));
}

} // namespace

Result<ReadAnswer> answerDicom(const ImagesRequest& request, const TellProgress& progress)
{
    const fs::path path = request.path;
    const auto folder = dicomFolder(path, [&](double fraction) { progress(untilHeaders * fraction); });
    if (!folder)
        return folder.error();
    const auto series = chosenSeries(*folder, request.series);
    if (!series)
        return series.error();
    DicomChoice choice;
    choice.series = folder->series[*series].headers;
    const auto own = std::ranges::find(choice.series, path, &DicomHeader::path);
    const auto opened = own == choice.series.end() ? 0 : static_cast<std::size_t>(own - choice.series.begin());
    if (const Message why = whyNoSamples(choice.series[opened]); !why.empty())
        return Error{ErrorKind::BadInput, why};
    auto volumes = volumesOf(choice.series, opened);
    if (!volumes)
        return volumes.error();
    tellOfSeries(*folder, *series, *volumes, !request.series.empty(), choice);
    if (const Status chosen = chooseVolume(*volumes, request.time, choice); !chosen)
        return chosen.error();
    if (const Status sound = checkFiles(choice); !sound)
        return sound.error();
    choice.places = placesOf(choice.series, choice.volume);
    if (const Status fits = checkUntold(request.given, choice.places.untold); !fits)
        return fits.error();
    if (choice.places.guess)
        choice.taken.push_back({TakenPart::Frame, *choice.places.guess, true});
    choice.remarks = choice.places.remarks;
    choice.type = typeFor(choice);
    tellOfValues(choice);
    limitTo(choice);
    if (request.contentsOnly)
        return ReadAnswer(contentsOf(*folder, *volumes, std::move(choice)));
    return findingsOf(std::move(choice), progress);
}

} // namespace tetra
