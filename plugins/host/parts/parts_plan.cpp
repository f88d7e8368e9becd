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
#include <system_error>

namespace tetra {
namespace {

constexpr std::string_view planFile = "plan.json";
constexpr std::array axes{"x", "y", "z"};

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

/// Numbers of 64 bits, which JSON's readers round.
std::string exact(std::uint64_t number)
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
    std::uint64_t exactNumber(std::string_view name) { return taken(parseNumber<std::uint64_t>(text(name))); }
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
    JsonObject size, spacing;
    for (std::size_t axis = 0; axis < axes.size(); ++axis) {
        size[axes[axis]] = plan.size[axis];
        spacing[axes[axis]] = plan.spacing[static_cast<Eigen::Index>(axis)];
    }
    text["size"] = std::move(size);
    text["spacing"] = std::move(spacing);
    if (plan.samples)
        text["samples"] = JsonObject{{"file", plan.samples->file.string()},
                                     {"offset", exact(plan.samples->offset)},
                                     {"file_bytes", exact(plan.samples->fileBytes)},
                                     {"checksum", exact(plan.samples->checksum)}};
    return indentedJson(std::move(text));
}

Result<PartsPlan> readPlan(const std::filesystem::path& folder)
{
    constexpr std::size_t mostBytes = 1 << 20;
    const std::filesystem::path path = folder / planFile;
    std::error_code problem;
    if (!std::filesystem::exists(path, problem))
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
    plan.imported = textsOf(value->find("import"));
    plan.parameters = textsOf(value->find("parameters"));
    plan.name = all.text("name");
    plan.hash = all.exactNumber("hash");
    const auto domain = domainNamed(all.text("domain"));
    plan.domain = domain.value_or(DomainClass::RegularLattice);
    const auto type = sampleTypeNamed(all.text("type"));
    plan.type = type.value_or(SampleType::UInt8);
    plan.range = {all.number<double>("minimum"), all.number<double>("maximum")};
    plan.blocks = all.number<std::uint32_t>("blocks");
    PlanReader size = all.part("size"), spacing = all.part("spacing");
    for (std::size_t axis = 0; axis < axes.size(); ++axis) {
        plan.size[axis] = size.number<std::uint32_t>(axes[axis]);
        plan.spacing[static_cast<Eigen::Index>(axis)] = spacing.number<double>(axes[axis]);
    }
    bool isWhole = domain && type && all.isWhole() && size.isWhole() && spacing.isWhole();
    if (const JsonValue* const samples = value->find("samples")) {
        PlanReader in(*samples);
        plan.samples = SamplesInFile{in.text("file"), in.exactNumber("offset"), in.exactNumber("file_bytes"),
                                     in.exactNumber("checksum")};
        isWhole = isWhole && in.isWhole();
    }
    if (!isWhole)
        return unusable(path, Message::say("it is damaged. Prepare the build again."));
    if (const Status usable = checkLatticeSize({plan.size[0], plan.size[1], plan.size[2]}); !usable)
        return unusable(path, usable.error().message);
    if (const Status usable = checkLatticePlacement({.size = plan.size, .spacing = plan.spacing}); !usable)
        return unusable(path, usable.error().message);
    return plan;
}

Status writePlan(const std::filesystem::path& folder, const PartsPlan& plan)
{
    const std::string text = planText(plan);
    std::error_code problem;
    std::filesystem::create_directory(folder, problem); // what writes the file says what is wrong
    const auto there = pathsIn(folder, problem);
    const bool hasPlan = std::ranges::find(there, folder / planFile) != there.end();
    if (!hasPlan && !there.empty())
        return Error{ErrorKind::WrongUsage,
                     Message::say("'%1' is not empty. The processes that share a build need a folder of their own: "
                                  "name another one.",
                                  folder.string())};
    if (!hasPlan)
        return writeWholeFile(folder / planFile, std::as_bytes(std::span(text)));
    const auto other = readPlan(folder);
    if (other && planText(*other) == text)
        return {};
    return Error{ErrorKind::WrongUsage,
                 Message::say("'%1' holds another build: of other data, with other options, or by "
                              "another version of TAn. Remove it, or name another folder.",
                              folder.string())};
}

std::optional<SamplesInFile> samplesInFile(const Dataset& dataset)
{
    if (!dataset.mappedFile || dataset.positions)
        return std::nullopt;
    const std::span<const std::byte> file = dataset.mappedFile->bytes(), samples = dataset.values.bytes();
    if (samples.data() < file.data() || samples.data() + samples.size() > file.data() + file.size())
        return std::nullopt;
    return SamplesInFile{std::filesystem::absolute(dataset.mappedFile->path()),
                         static_cast<std::uint64_t>(samples.data() - file.data()), file.size(), checksumOfSome(file)};
}

Result<Dataset> mappedDataset(const PartsPlan& plan)
{
    const SamplesInFile& samples = *plan.samples;
    const auto file = MappedFile::open(samples.file);
    if (!file)
        return file.error();
    const std::span<const std::byte> bytes = (*file)->bytes();
    const std::uint64_t needed = plan.points() * sampleSize(plan.type);
    if (bytes.size() != samples.fileBytes || samples.offset > bytes.size() || needed > bytes.size() - samples.offset ||
        checksumOfSome(bytes) != samples.checksum)
        return Error{ErrorKind::BadInput,
                     Message::say("'%1' has changed since the build was prepared. Prepare it anew, in another folder.",
                                  samples.file.string()),
                     samples.file};
    Dataset dataset{.lattice = {.size = plan.size, .spacing = plan.spacing},
                    .values = ScalarField::ofKnownRange(plan.type, plan.points(),
                                                        {*file, bytes.data() + samples.offset}, plan.range),
                    .source = {plan.name, plan.input, plan.hash}};
    dataset.mappedFile = *file;
    return dataset;
}

} // namespace tetra
