// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture/session_document.h"

#include "core/base/json_writer.h"
#include "core/base/mapped_file.h"
#include "core/base/text.h"
#include "core/picture/png_file.h"
#include "core/picture/text_file.h"
#include "core/view/view_text.h"
#include "plugins/api/scene_parameters.h"

#include <tan/open.h>
#include <tan/version.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstring>
#include <initializer_list>
#include <utility>

namespace tetra {
namespace {

constexpr const char* formatName = "tan-session";
constexpr int formatVersion = 1;
constexpr const char* relativeKey = "relativePath";
constexpr const char* absoluteKey = "absolutePath";
constexpr std::string_view arrayKey = "array";
/// Corners of one domain may differ by so much of its diagonal: data may be written in other digits.
constexpr double sameCorner = 1e-9;

Error wrong(const Message& what)
{
    return {ErrorKind::BadInput, Message::say("The session cannot be read: %1", what)};
}

/// `ours` over `found`: objects member by member, all else whole.
JsonObject over(JsonObject found, const JsonObject& ours)
{
    for (const auto& [name, value] : ours) {
        JsonValue& member = found[name];
        const JsonObject* const inner = value.object();
        if (inner != nullptr && member.object() != nullptr)
            member = over(std::move(*member.object()), *inner);
        else
            member = value;
    }
    return found;
}

JsonObject without(const JsonObject& object, std::initializer_list<std::string_view> names)
{
    JsonObject rest;
    for (const auto& [name, value] : object)
        if (std::ranges::find(names, name) == names.end())
            rest.append(name, value);
    return rest;
}

/// The object of a name; an empty one if there is none.
JsonObject objectIn(const JsonObject& object, std::string_view name)
{
    const JsonValue* const found = object.find(name);
    return found != nullptr && found->object() != nullptr ? *found->object() : JsonObject();
}

std::string hexadecimal(std::uint64_t number)
{
    std::array<char, 16> digits{};
    const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), number, 16);
    return {digits.data(), end};
}

/// 0 for what is no such number.
std::uint64_t fromHexadecimal(const std::string& text)
{
    std::uint64_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number, 16);
    return error == std::errc() && end == text.data() + text.size() ? number : 0;
}

/// The paths of a model as they are written. "path" is relative if the model lies in the folder or below it, else
/// absolute; the other one is beside it.
JsonObject writtenPaths(const std::filesystem::path& model, const std::filesystem::path& folder)
{
    if (isAddress(model.string()))
        return {{"path", model.string()}};
    const std::filesystem::path normal = model.lexically_normal();
    const std::filesystem::path relative =
        normal.is_relative() ? normal : normal.lexically_relative(std::filesystem::absolute(folder).lexically_normal());
    if (relative.empty() || *relative.begin() == "..")
        return {{"path", model.string()}, {relativeKey, relative.string()}};
    return {{"path", relative.string()}, {absoluteKey, model.string()}};
}

Result<JsonValue> rootOf(std::string_view text)
{
    constexpr std::string_view byteOrderMark = "\xef\xbb\xbf"; // some editors write it before all else
    if (text.starts_with(byteOrderMark))
        text.remove_prefix(byteOrderMark.size());
    auto root = parseJson(text);
    if (!root)
        return wrong(root.error().message);
    const JsonValue* const format = root->find("format");
    if (format == nullptr || format->string() == nullptr || *format->string() != formatName)
        return wrong(Message::say("its \"format\" is not \"%1\".", formatName));
    const JsonValue* const version = root->find("version");
    if (version == nullptr || version->numberAs<double>() != formatVersion)
        return wrong(Message::say("this program reads version %1 of sessions only.", formatVersion));
    return root;
}

/// Two positive numbers of a list; nothing else.
std::optional<std::array<int, 2>> sizeIn(const JsonObject& object, std::string_view name)
{
    const JsonValue* const found = object.find(name);
    const JsonArray* const list = found != nullptr ? found->array() : nullptr;
    if (list == nullptr || list->size() != 2)
        return std::nullopt;
    const auto width = (*list)[0].numberAs<int>(), height = (*list)[1].numberAs<int>();
    if (!width || !height || *width <= 0 || *height <= 0)
        return std::nullopt;
    return std::array{*width, *height};
}

/// What a session says of its model besides where that is: as far as it says it.
void readModelFacts(const JsonObject& model, SessionDocument& document)
{
    if (const JsonValue* const directions = model.find("withDirections"))
        if (const bool* const has = std::get_if<bool>(&directions->content))
            document.withDirections = *has;
    if (const JsonValue* const corners = model.find("bounds"); corners != nullptr && corners->array() != nullptr)
        for (const JsonValue& corner : *corners->array())
            if (const auto place = JsonFields::threeOf(&corner))
                document.bounds.extend(Eigen::Vector3d((*place)[0], (*place)[1], (*place)[2]));
    if (const JsonValue* const array = model.find(arrayKey); array != nullptr && array->string() != nullptr)
        document.valueName = *array->string();
    const JsonValue* const range = model.find("range");
    const JsonArray* const ends = range != nullptr ? range->array() : nullptr;
    if (ends == nullptr || ends->size() != 2)
        return;
    const auto least = (*ends)[0].numberAs<double>(), largest = (*ends)[1].numberAs<double>();
    if (least && largest)
        document.range = ValueRange{*least, *largest};
}

/// Of sessions in which volumes are lit unless their setting says otherwise.
constexpr std::string_view shadedKey = "usuallyShaded";
/// Of sessions in which the bounding box is not drawn around an object in a background unless their setting says so.
constexpr std::string_view outlineKey = "usuallyWithoutBox";

constexpr std::string_view sessionKey = "TAn-session"; // without a blank, as Qt reads keywords

/// On one line, and without two blanks side by side: programs with Qt make one of them when they read a picture.
std::string oneLine(const JsonValue& json)
{
    std::string text = compactJson(json);
    for (std::size_t at = text.find("  "); at != std::string::npos; at = text.find("  ", at))
        text.replace(at, 2, " \\u0020");
    return text;
}

/// A session as JSON, with what was found in it and is not known here.
JsonValue sessionJson(const SessionDocument& document, const std::filesystem::path& folder)
{
    JsonObject model = writtenPaths(document.model, folder);
    model["identity"] = hexadecimal(document.identity);
    if (!document.bounds.isEmpty())
        model["bounds"] = JsonArray{jsonThree(document.bounds.min()), jsonThree(document.bounds.max())};
    model["withDirections"] = document.withDirections;
    if (!document.valueName.empty())
        model[std::string(arrayKey)] = document.valueName;
    if (document.range)
        model["range"] = JsonArray{document.range->minimum, document.range->maximum};
    JsonObject ours = {{"format", formatName}, {"version", formatVersion}, {"model", model}};
    ours[shadedKey] = true;
    ours[outlineKey] = true;
    if (const auto view = parseJson(viewToText(document.view)); view && view->object() != nullptr)
        ours = over(std::move(ours), *view->object());
    if (!document.hasCamera)
        ours = without(ours, {"camera"});
    if (document.viewSize[0] > 0 && document.viewSize[1] > 0)
        ours["viewSize"] = JsonArray{document.viewSize[0], document.viewSize[1]};
    if (!document.file.empty())
        ours["file"] = document.file.string();
    // What is written anew or left out must not come back from the old text, nor parts of settings, functions and ends,
    // which are whole values.
    JsonObject found = without(document.found, {"background", "camera", "file", "tools", "views", "viewSize"});
    found["model"] = without(objectIn(found, "model"), {relativeKey, absoluteKey});
    found["look"] = without(objectIn(found, "look"), {"transfer", "settings"});
    found["annotations"] = without(objectIn(found, "annotations"), {"barEnds", "boldText", "lengths", "numbers",
                                                                    "quantity", "textSize", "titleText", "unit"});
    return byName(over(std::move(found), ours));
}

} // namespace

std::uint64_t modelIdentity(const Model& model)
{
    std::uint64_t identity = 0;
    std::memcpy(&identity, model.fileBytes().data() + headerChecksumOffset, sizeof identity);
    return identity;
}

SessionDocument documentOf(const Model& model, const ViewValue& view)
{
    const ModelDescription& description = model.description();
    return {.model = isAddress(model.path().string()) ? model.path() : std::filesystem::absolute(model.path()),
            .identity = modelIdentity(model),
            .bounds = description.bounds,
            .withDirections = !description.lattice.isAlongAxes(),
            .range = description.range,
            .valueName = description.valueName,
            .view = view,
            .hasCamera = true};
}

bool lacksDirections(const SessionDocument& document, const Model& model)
{
    const Lattice& lattice = model.description().lattice;
    if (document.bounds.isEmpty() || document.withDirections || document.identity == modelIdentity(model) ||
        model.description().domain != DomainClass::RegularLattice || lattice.isAlongAxes())
        return false;
    Eigen::Vector3d lengths = lattice.spacing;
    for (Eigen::Index axis = 0; axis < 3; ++axis)
        lengths[axis] *= lattice.size[static_cast<std::size_t>(axis)] - 1;
    return document.bounds.sizes().isApprox(lengths, sameCorner);
}

bool isOfSameDomain(const SessionDocument& document, const Model& model)
{
    if (document.bounds.isEmpty() || document.identity == modelIdentity(model))
        return true;
    if (lacksDirections(document, model))
        return false;
    const Eigen::AlignedBox3d& bounds = model.description().bounds;
    const double tolerance = sameCorner * bounds.diagonal().norm();
    return (document.bounds.min() - bounds.min()).norm() <= tolerance &&
           (document.bounds.max() - bounds.max()).norm() <= tolerance;
}

bool isOfSameRange(const SessionDocument& document, const Model& model)
{
    const ValueRange& range = model.description().range;
    return !document.range || document.identity == modelIdentity(model) ||
           (document.range->minimum == range.minimum && document.range->maximum == range.maximum);
}

bool isOfOtherValues(const SessionDocument& document, const Model& model)
{
    const std::string& name = model.description().valueName;
    return !document.valueName.empty() && !name.empty() && document.valueName != name;
}

bool isSessionFile(const std::filesystem::path& path)
{
    return path.extension() == std::string(".") + sessionSuffix;
}

std::string sessionToText(const SessionDocument& document, const std::filesystem::path& folder)
{
    return indentedJson(sessionJson(document, folder));
}

Result<SessionDocument> sessionFromText(std::string_view text, const std::filesystem::path& folder)
{
    const Result<JsonValue> root = rootOf(text);
    if (!root)
        return root.error();
    SessionDocument document;
    document.found = *root->object();
    std::optional<Error> error;
    const JsonFields fields(&*root, {}, error);
    const JsonFields model = fields.fields("model");
    std::string path, relative, absolute, identity, file;
    model.read("path", path);
    model.read(relativeKey, relative);
    model.read(absoluteKey, absolute);
    model.read("identity", identity);
    document.identity = fromHexadecimal(identity);
    const auto placeOf = [&folder](const std::string& written) { return (folder / written).lexically_normal(); };
    document.model = isAddress(path) ? std::filesystem::path(path) : placeOf(path);
    if (!relative.empty())
        document.relativeModel = placeOf(relative);
    if (!absolute.empty())
        document.absoluteModel = placeOf(absolute);
    readModelFacts(objectIn(document.found, "model"), document);
    document.viewSize = sizeIn(document.found, "viewSize").value_or(document.viewSize);
    fields.read("file", file);
    document.file = file;
    readView(fields, document.view);
    if (!fields.has(shadedKey)) // then volumes are not lit unless their setting says so
        document.view.appearance.settings.try_emplace(shadedId, false);
    if (!fields.has(outlineKey))
        document.view.appearance.settings.try_emplace(outlineId, true);
    document.hasCamera = fields.has("camera");
    if (path.empty() && !error)
        error = Error{ErrorKind::BadInput, Message::say("it names no model in \"model.path\".")};
    if (error)
        return wrong(error->message);
    return document;
}

std::map<std::string, std::string> pictureTexts(const SessionDocument& document, const std::string& accuracy,
                                                const std::filesystem::path& folder)
{
    return {{"Software", "TAn " TAN_VERSION},
            {"Title", visibleText(document.model.stem().string())},
            {"Description", accuracy},
            {std::string(sessionKey), oneLine(sessionJson(document, folder))}};
}

Result<std::string> sessionInPicture(const std::filesystem::path& path)
{
    const auto file = MappedFile::open(path);
    if (!file)
        return file.error();
    return textInPng((*file)->bytes(), sessionKey);
}

bool isPictureFile(const std::filesystem::path& path)
{
    return fileEnding(path) == ".png";
}

Result<SessionDocument> readSession(const std::filesystem::path& path)
{
    const bool isPicture = isPictureFile(path);
    const auto text = isPicture ? sessionInPicture(path) : readTextFile(path);
    if (!text)
        return text.error();
    if (isPicture && text->empty())
        return Error{ErrorKind::BadInput, Message::say("The picture '%1' does not say how it was made. Choose a model "
                                                       "or a session.",
                                                       path.string())};
    auto document = sessionFromText(*text, std::filesystem::absolute(path).parent_path());
    if (!document)
        return Error{document.error().kind, Message::say("%1: %2", path.string(), document.error().message)};
    return document;
}

} // namespace tetra
