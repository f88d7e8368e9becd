// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/host/parts/parts_plan.h"

#include "core/base/checksum.h"
#include "core/base/file_writer.h"
#include "core/base/folder.h"
#include "core/base/json.h"
#include "core/base/json_writer.h"
#include "core/base/mapped_file.h"
#include "core/data/dataset_checks.h"

#include <tan/version.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <system_error>

namespace tetra {
namespace {

constexpr std::string_view planFile = "plan.json";
constexpr std::array axes{"x", "y", "z"};
constexpr std::array directions{"direction_i", "direction_j", "direction_k"};

JsonObject membersOf(const PartsPlan::Texts& texts)
{
    JsonObject members;
    for (const auto& [name, text] : texts)
        members[name] = text;
    return members;
}

PartsPlan::Texts textsOf(const JsonValue* members)
{
    PartsPlan::Texts texts;
    if (members != nullptr && members->object() != nullptr)
        for (const auto& [name, value] : *members->object())
            if (value.string() != nullptr)
                texts.emplace_back(name, *value.string());
    return texts;
}

JsonObject vectorOf(const Eigen::Vector3d& vector)
{
    JsonObject members;
    for (std::size_t axis = 0; axis < axes.size(); ++axis)
        members[axes[axis]] = vector[static_cast<Eigen::Index>(axis)];
    return members;
}

/// Numbers of 64 bits, which JSON's readers round.
template <class Number> std::string exact(Number number)
{
    return std::to_string(number);
}

/// Of what a plan says: each gives nothing where a member is missing or of another kind, and notes that.
class PlanReader {
public:
    explicit PlanReader(const JsonValue& value) : value_(value) {}

    std::string text(std::string_view name)
    {
        const JsonValue* const found = value_.find(name);
        const bool isText = found != nullptr && found->string() != nullptr;
        isWhole_ = isWhole_ && isText;
        return isText ? *found->string() : std::string();
    }
    template <class Number = std::uint64_t> Number exactNumber(std::string_view name)
    {
        return taken(parseNumber<Number>(text(name)));
    }
    Eigen::Vector3d vector(std::string_view name)
    {
        Eigen::Vector3d found;
        PlanReader members = part(name);
        for (std::size_t axis = 0; axis < axes.size(); ++axis)
            found[static_cast<Eigen::Index>(axis)] = members.number<double>(axes[axis]);
        isWhole_ = isWhole_ && members.isWhole();
        return found;
    }
    PartsPlan::Texts texts(std::string_view name)
    {
        const JsonValue* const members = value_.find(name);
        isWhole_ = isWhole_ && members != nullptr && members->object() != nullptr;
        return textsOf(members);
    }
    template <class Number> Number number(std::string_view name)
    {
        const JsonValue* const found = value_.find(name);
        return taken(found != nullptr ? found->numberAs<Number>() : std::optional<Number>());
    }
    PlanReader part(std::string_view name)
    {
        static const JsonValue nothing;
        const JsonValue* const found = value_.find(name);
        isWhole_ = isWhole_ && found != nullptr;
        return PlanReader(found != nullptr ? *found : nothing);
    }
    bool isWhole() const noexcept { return isWhole_; }

private:
    template <class Number> Number taken(const std::optional<Number>& number)
    {
        isWhole_ = isWhole_ && number.has_value();
        return number.value_or(Number());
    }

    const JsonValue& value_;
    bool isWhole_ = true;
};

Error unusable(const std::filesystem::path& path, const Message& why)
{
    return {ErrorKind::BadInput, Message::say("Cannot use the plan '%1': %2", path.string(), why), path};
}

std::optional<SampleType> sampleTypeNamed(const std::string& name)
{
    constexpr std::array types{SampleType::UInt8,  SampleType::Int8,  SampleType::UInt16,  SampleType::Int16,
                               SampleType::UInt32, SampleType::Int32, SampleType::Float32, SampleType::Float64};
    const auto* const found = std::ranges::find(types, name, sampleTypeName);
    return found == types.end() ? std::nullopt : std::optional(*found);
}

/// Of those that have blocks.
std::optional<DomainClass> domainNamed(const std::string& name)
{
    for (const DomainClass domain : {DomainClass::RegularLattice, DomainClass::Curvilinear})
        if (domainClassName(domain) == name)
            return domain;
    return std::nullopt;
}

/// When a file was written last; 0 if the system does not tell.
std::int64_t modified(const std::filesystem::path& path)
{
    std::error_code problem;
    const auto time = std::filesystem::last_write_time(path, problem);
    return problem ? 0 : std::chrono::duration_cast<std::chrono::nanoseconds>(time.time_since_epoch()).count();
}

/// Of a file, pieces spread over it and its last one.
std::uint64_t checksumOfSome(std::span<const std::byte> bytes)
{
    constexpr std::size_t pieces = 64, pieceBytes = 4096;
    Checksum sum;
    for (std::size_t piece = 0; piece < pieces; ++piece) {
        const std::size_t begin = bytes.size() / pieces * piece;
        sum.add(bytes.subspan(begin, std::min(pieceBytes, bytes.size() - begin)));
    }
    sum.add(bytes.last(std::min(pieceBytes, bytes.size())));
    return sum.value();
}

} // namespace

std::string planText(const PartsPlan& plan)
{
    JsonObject text{{"tan", TAN_VERSION},
                    {"input", plan.input.string()},
                    {"import", membersOf(plan.imported)},
                    {"builder", plan.builder},
                    {"parameters", membersOf(plan.parameters)},
                    {"name", plan.name},
                    {"hash", exact(plan.hash)},
                    {"domain", domainClassName(plan.domain)},
                    {"type", sampleTypeName(plan.type)},
                    {"minimum", plan.range.minimum},
                    {"maximum", plan.range.maximum},
                    {"blocks", plan.blocks}};
    JsonObject size;
    for (std::size_t axis = 0; axis < axes.size(); ++axis)
        size[axes[axis]] = plan.lattice.size[axis];
    text["size"] = std::move(size);
    text["spacing"] = vectorOf(plan.lattice.spacing);
    text["origin"] = vectorOf(plan.lattice.origin);
    for (std::size_t axis = 0; axis < axes.size(); ++axis)
        text[directions[axis]] = vectorOf(plan.lattice.directions.col(static_cast<Eigen::Index>(axis)));
    if (plan.samples)
        text["samples"] = JsonObject{{"file", plan.samples->file.string()},
                                     {"offset", exact(plan.samples->offset)},
                                     {"file_bytes", exact(plan.samples->fileBytes)},
                                     {"modified", exact(plan.samples->modified)},
                                     {"checksum", exact(plan.samples->checksum)}};
    return indentedJson(std::move(text));
}

bool hasPlan(const std::filesystem::path& folder)
{
    std::error_code problem;
    return std::filesystem::exists(folder / planFile, problem);
}

Result<PartsPlan> readPlan(const std::filesystem::path& folder)
{
    constexpr std::size_t mostBytes = 1 << 20;
    const std::filesystem::path path = folder / planFile;
    if (!hasPlan(folder))
        return Error{ErrorKind::WrongUsage,
                     Message::say("There is no build to share in '%1'. Prepare one there first.", folder.string())};
    const auto text = wholeText(path, mostBytes);
    if (!text)
        return text.error();
    const auto value = parseJson(*text);
    if (!value)
        return unusable(path, value.error().message);
    PlanReader all(*value);
    if (const std::string version = all.text("tan"); version != TAN_VERSION)
        return unusable(path, Message::say("it was made by TAn %1, and this is TAn %2. Use one version for all parts.",
                                           version, TAN_VERSION));
    PartsPlan plan{.input = all.text("input"), .builder = all.text("builder")};
    plan.imported = all.texts("import");
    plan.parameters = all.texts("parameters");
    plan.name = all.text("name");
    plan.hash = all.exactNumber("hash");
    const auto domain = domainNamed(all.text("domain"));
    plan.domain = domain.value_or(DomainClass::RegularLattice);
    const auto type = sampleTypeNamed(all.text("type"));
    plan.type = type.value_or(SampleType::UInt8);
    plan.range = {all.number<double>("minimum"), all.number<double>("maximum")};
    plan.blocks = all.number<std::uint32_t>("blocks");
    PlanReader size = all.part("size");
    for (std::size_t axis = 0; axis < axes.size(); ++axis) {
        plan.lattice.size[axis] = size.number<std::uint32_t>(axes[axis]);
        plan.lattice.directions.col(static_cast<Eigen::Index>(axis)) = all.vector(directions[axis]);
    }
    plan.lattice.spacing = all.vector("spacing");
    plan.lattice.origin = all.vector("origin");
    bool isWhole = domain && type && all.isWhole() && size.isWhole();
    if (const JsonValue* const samples = value->find("samples")) {
        PlanReader in(*samples);
        plan.samples = SamplesInFile{in.text("file"), in.exactNumber("offset"), in.exactNumber("file_bytes"),
                                     in.exactNumber<std::int64_t>("modified"), in.exactNumber("checksum")};
        isWhole = isWhole && in.isWhole() && plan.samples->offset % sampleSize(plan.type) == 0;
    }
    if (!isWhole)
        return unusable(path, Message::say("it is damaged. Prepare the build again."));
    if (const Status usable = checkLatticeSize({plan.lattice.size[0], plan.lattice.size[1], plan.lattice.size[2]});
        !usable)
        return unusable(path, usable.error().message);
    if (const Status usable = checkLatticePlacement(plan.lattice); !usable)
        return unusable(path, usable.error().message);
    return plan;
}

Status writePlan(const std::filesystem::path& folder, const PartsPlan& plan)
{
    const std::string text = planText(plan);
    std::error_code problem;
    std::filesystem::create_directory(folder, problem); // what writes the file says what is wrong
    const auto there = pathsIn(folder, problem);
    const bool isThere = hasPlan(folder);
    // One that is being written has a hidden name yet, and what a killed process left of one is removed by who writes.
    const auto isHidden = [](const auto& path) { return path.filename().string().starts_with("."); };
    if (!isThere && !std::ranges::all_of(there, isHidden))
        return Error{ErrorKind::WrongUsage,
                     Message::say("'%1' is not empty. The processes that share a build need a folder of their own: "
                                  "name another one.",
                                  folder.string())};
    if (!isThere)
        if (const Status written = writeWholeFile(folder / planFile, std::as_bytes(std::span(text))); !written)
            return written;
    const auto read = readPlan(folder);
    if (read && planText(*read) == text && read->input == plan.input)
        return {};
    if (!isThere) {
        removeParts(folder);
        return Error{ErrorKind::WrongUsage,
                     Message::say("A build of '%1' cannot be shared, as its name or a folder's is no text in UTF-8. "
                                  "Rename it.",
                                  plan.input.string())};
    }
    return Error{ErrorKind::WrongUsage,
                 Message::say("'%1' holds another build: of other data, with other options, or by another version of "
                              "TAn. Remove it, or name another folder.",
                              folder.string())};
}

void removeParts(const std::filesystem::path& folder)
{
    std::error_code problem; // what cannot be removed stays
    for (const std::filesystem::path& path : pathsIn(folder, problem))
        if (const std::string name = path.filename().string(); name == planFile || name.starts_with("part-"))
            std::filesystem::remove(path, problem);
    std::filesystem::remove(folder, problem);
}

bool PartsPlan::readsOnlyItsBlocks() const
{
    constexpr std::string_view weights = "weights";
    const auto weighted = std::ranges::find(parameters, weights, &Texts::value_type::first);
    return samples && (weighted == parameters.end() || weighted->second.empty());
}

std::optional<SamplesInFile> samplesInFile(const Dataset& dataset)
{
    if (!dataset.mappedFile || dataset.positions)
        return std::nullopt;
    const std::span<const std::byte> file = dataset.mappedFile->bytes(), samples = dataset.values.bytes();
    if (samples.data() < file.data() || samples.data() + samples.size() > file.data() + file.size())
        return std::nullopt;
    const std::filesystem::path path = std::filesystem::absolute(dataset.mappedFile->path());
    return SamplesInFile{path, static_cast<std::uint64_t>(samples.data() - file.data()), file.size(), modified(path),
                         checksumOfSome(file)};
}

Result<Dataset> mappedDataset(const PartsPlan& plan)
{
    const SamplesInFile& samples = *plan.samples;
    const auto file = MappedFile::open(samples.file);
    if (!file)
        return file.error();
    const std::span<const std::byte> bytes = (*file)->bytes();
    const std::uint64_t points = plan.lattice.pointCount();
    if (modified(samples.file) != samples.modified || bytes.size() != samples.fileBytes ||
        samples.offset > bytes.size() || points > (bytes.size() - samples.offset) / sampleSize(plan.type) ||
        checksumOfSome(bytes) != samples.checksum)
        return Error{ErrorKind::BadInput,
                     Message::say("'%1' has changed since the build was prepared. Prepare it anew, in another folder.",
                                  samples.file.string()),
                     samples.file};
    Dataset dataset{
        .lattice = plan.lattice,
        .values = ScalarField::ofKnownRange(plan.type, points, {*file, bytes.data() + samples.offset}, plan.range),
        .source = {plan.name, plan.input, plan.hash}};
    dataset.mappedFile = *file;
    return dataset;
}

} // namespace tetra
