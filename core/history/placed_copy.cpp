// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/guarded.h"
#include "core/data/dataset_checks.h"
#include "core/history/build_facts.h"
#include "core/history/file_layout.h"
#include "core/history/lattice_frame.h"
#include "core/history/section_writer.h"

#include <tan/data.h>
#include <tan/model.h>

#include <algorithm>
#include <string>
#include <vector>

namespace tetra {

namespace {

using format::Section;
using format::SectionId;

constexpr MarkedText copying = Message::marked("Copying the model");

bool isReplaced(const Section& section)
{
    const auto id = static_cast<SectionId>(section.id);
    return id == SectionId::Text || id == SectionId::ChunkSums || std::ranges::count(frameSectionIds, id) > 0;
}

/// Weights that hold at places of the world would mean others.
Status checkWeights(const Model& model)
{
    const std::string weights = buildFacts(model.description()).weights;
    if (weights.find("point:") == std::string::npos && weights.find("box:") == std::string::npos)
        return {};
    return Error{ErrorKind::WrongUsage,
                 Message::say("'%1' was built with weights at places ('%2'), which would then lie elsewhere than "
                              "intended. Build it again from data that state where they lie.",
                              model.path().string(), weights),
                 model.path()};
}

/// What the copy says of itself.
Result<ModelDescription> placed(const Model& model, const Placement& placement)
{
    ModelDescription description = model.description();
    Lattice& lattice = description.lattice;
    if (description.domain != DomainClass::RegularLattice)
        return Error{ErrorKind::WrongUsage,
                     Message::say("'%1' is not a model of a regular lattice: each of its points has its own position. "
                                  "Spacing, origin and unit can be set afterwards for a lattice only; for other data "
                                  "give '--unit' when you build the model.",
                                  model.path().string()),
                     model.path()};
    if (placement.spacing || placement.origin) {
        if (const Status free = checkWeights(model); !free)
            return free.error();
        description.metric = description.meshSpacing();
    }
    lattice.spacing = placement.spacing.value_or(lattice.spacing);
    lattice.origin = placement.origin.value_or(lattice.origin);
    description.lengthUnit = placement.lengthUnit.value_or(description.lengthUnit);
    if (const Status sensible = checkLatticePlacement(lattice); !sensible)
        return Error{ErrorKind::WrongUsage,
                     Message::say("The model cannot be placed there: %1", sensible.error().message)};
    description.bounds = lattice.bounds();
    return description;
}

Status copySection(const Model& model, const Section& section, const Progress& progress, std::uint64_t& done,
                   SectionWriter& sections)
{
    constexpr std::uint64_t atOnce = 1 << 20;
    for (std::uint64_t from = 0; from < section.bytes; from += atOnce) {
        if (progress.cancelled())
            return cancelledError(copying);
        const auto piece =
            model.fileBytes().subspan(section.offset + from, std::min<std::uint64_t>(atOnce, section.bytes - from));
        if (!model.check(piece))
            return model.checkIntact();
        if (const Status added = sections.add(static_cast<SectionId>(section.id), piece); !added)
            return added;
        done += piece.size();
        progress.report(static_cast<double>(done) / static_cast<double>(model.fileSize()), copying);
    }
    return {};
}

Status write(const Model& model, const ModelDescription& description, const std::filesystem::path& output,
             const Progress& progress)
{
    const Result<FileLayout> layout = readLayout(model.fileBytes(), model.path());
    if (!layout)
        return layout.error();
    const Result<std::string> text = textOf(description, output);
    if (!text)
        return text.error();
    Result<FileWriter> file = FileWriter::create(output);
    if (!file)
        return file.error();
    SectionWriter sections(*std::move(file));
    const std::vector<FrameSection> frame = frameSections(description);
    std::vector<PlannedSection> planned;
    for (const Section& section : layout->sections) {
        const auto id = static_cast<SectionId>(section.id);
        if (id == SectionId::Text) {
            for (const FrameSection& part : frame)
                planned.push_back({part.id, sizeof(double), part.numbers.size()});
            planned.push_back({id, 1, text->size()});
        } else if (id == SectionId::LevelIndex) {
            planned.push_back({id, section.elementBytes, format::mostLevels, section.flags, true});
        } else if (!isReplaced(section)) {
            planned.push_back({id, section.elementBytes, section.bytes / section.elementBytes, section.flags});
        }
    }
    if (const Status laidOut = sections.plan(planned); !laidOut)
        return laidOut;
    for (const FrameSection& part : frame)
        if (const Status added = sections.add(part.id, std::as_bytes(std::span(part.numbers))); !added)
            return added;
    if (const Status added = sections.add(SectionId::Text, std::as_bytes(std::span(*text))); !added)
        return added;
    std::uint64_t done = 0;
    for (const Section& section : layout->sections)
        if (!isReplaced(section))
            if (const Status copied = copySection(model, section, progress, done, sections); !copied)
                return copied;
    if (const Status intact = model.confirm(progress); !intact)
        return intact;
    format::Header header = headerOf(description);
    header.siteCount = layout->header.siteCount;
    header.tetrahedronCount = layout->header.tetrahedronCount;
    header.finalKey = layout->header.finalKey;
    return sections.finish(header);
}

} // namespace

Status writePlaced(const Model& model, const Placement& placement, const std::filesystem::path& output,
                   const Progress& progress)
{
    const Result<ModelDescription> description = placed(model, placement);
    if (!description)
        return description.error();
    return guarded(Message::marked("Not enough memory to copy the model. Close other programs."),
                   [&] { return write(model, *description, output, progress); });
}

} // namespace tetra
