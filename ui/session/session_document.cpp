// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/session_document.h"

#include "core/view/view_text.h"
#include "ui/session/files.h"

#include <tan/open.h>

#include <QBuffer>
#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QImageReader>
#include <QJsonArray>
#include <QJsonDocument>

#include <cstddef>
#include <cstring>
#include <span>

namespace tetra {
namespace {

constexpr const char* formatName = "tan-session";
constexpr int formatVersion = 1;
constexpr const char* relativeKey = "relativePath";
constexpr const char* absoluteKey = "absolutePath";
/// Corners of one domain may differ by so much of its diagonal: data may be written in other digits.
constexpr double sameCorner = 1e-9;

Error wrong(const Message& what)
{
    return {ErrorKind::BadInput, Message::say("The session cannot be read: %1", what)};
}

/// `ours` over `found`: objects member by member, all else whole.
QJsonObject over(QJsonObject found, const QJsonObject& ours)
{
    for (auto member = ours.begin(); member != ours.end(); ++member)
        found[member.key()] = member.value().isObject() && found.value(member.key()).isObject()
                                  ? QJsonValue(over(found.value(member.key()).toObject(), member.value().toObject()))
                                  : member.value();
    return found;
}

/// The paths of a model as they are written, with slashes. "path" is relative if the model lies in the folder or below
/// it, else absolute; the other one is beside it.
QJsonObject writtenPaths(const std::filesystem::path& model, const std::filesystem::path& folder)
{
    const QString absolute = pathText(model);
    if (isAddress(model.string()))
        return {{"path", absolute}};
    const QString relative = QDir(pathText(folder)).relativeFilePath(absolute);
    if (relative.startsWith(".."))
        return {{"path", absolute}, {relativeKey, relative}};
    return {{"path", relative}, {absoluteKey, absolute}};
}

Result<QJsonObject> objectOf(std::string_view text)
{
    QJsonParseError parsed;
    const auto document =
        QJsonDocument::fromJson(QByteArray(text.data(), static_cast<qsizetype>(text.size())), &parsed);
    if (parsed.error != QJsonParseError::NoError)
        return wrong(Message::say("it is not valid JSON, at byte %1.", parsed.offset));
    const QJsonObject object = document.object();
    if (object.value("format").toString() != formatName)
        return wrong(Message::say("its \"format\" is not \"%1\".", formatName));
    if (object.value("version").toInt() != formatVersion)
        return wrong(Message::say("this program knows version %1 of sessions only.", formatVersion));
    return object;
}

const QString& sessionKey()
{
    static const QString key = "TAn-session"; // with a blank Qt would not find it
    return key;
}

/// On one line, and without two blanks side by side: Qt makes one of them when it reads.
QString oneLine(const std::string& json)
{
    QString text = QJsonDocument::fromJson(QByteArray::fromStdString(json)).toJson(QJsonDocument::Compact);
    return text.replace("  ", " \\u0020");
}

} // namespace

std::uint64_t modelIdentity(const Model& model)
{
    std::uint64_t identity = 0;
    std::memcpy(&identity, model.fileBytes().data() + headerChecksumOffset, sizeof identity);
    return identity;
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

bool isSessionFile(const std::filesystem::path& path)
{
    return path.extension() == std::string(".") + sessionSuffix;
}

std::string sessionToText(const SessionDocument& document, const std::filesystem::path& folder)
{
    QJsonObject model = writtenPaths(document.model, folder);
    model["identity"] = QString::number(document.identity, 16);
    if (!document.bounds.isEmpty()) {
        const auto corner = [](const Eigen::Vector3d& place) { return QJsonArray{place[0], place[1], place[2]}; };
        model["bounds"] = QJsonArray{corner(document.bounds.min()), corner(document.bounds.max())};
    }
    model["withDirections"] = document.withDirections;
    if (document.range)
        model["range"] = QJsonArray{document.range->minimum, document.range->maximum};
    QJsonObject ours = {{"format", formatName}, {"version", formatVersion}, {"model", model}};
    ours = over(ours, QJsonDocument::fromJson(QByteArray::fromStdString(viewToText(document.view))).object());
    if (!document.hasCamera)
        ours.remove("camera");
    QJsonObject found = document.found;
    for (const char* ofOthers : {"background", "camera", "file", "tools", "viewSize"})
        found.remove(ofOthers);
    QJsonObject foundModel = found.value("model").toObject();
    for (const char* path : {relativeKey, absoluteKey})
        foundModel.remove(path);
    found.insert("model", foundModel);
    // Settings, functions and ends are whole values: what was in the old ones must not come back.
    QJsonObject look = found.value("look").toObject();
    look.remove("transfer");
    look.remove("settings");
    found.insert("look", look);
    QJsonObject annotations = found.value("annotations").toObject();
    annotations.remove("barEnds");
    found.insert("annotations", annotations);
    if (document.viewSize[0] > 0 && document.viewSize[1] > 0)
        ours["viewSize"] = QJsonArray{document.viewSize[0], document.viewSize[1]};
    if (!document.file.empty())
        ours["file"] = pathText(document.file);
    return QJsonDocument(over(found, ours)).toJson().toStdString();
}

Result<SessionDocument> sessionFromText(std::string_view text, const std::filesystem::path& folder)
{
    const Result<QJsonObject> root = objectOf(text);
    if (!root)
        return root.error();
    // As Qt writes it: without what Qt takes and core does not, a member that is there twice for one.
    const Result<JsonValue> members = parseJson(QJsonDocument(*root).toJson().toStdString());
    if (!members)
        return wrong(members.error().message);
    SessionDocument document;
    document.found = *root;
    std::optional<Error> error;
    const JsonFields fields(&*members, {}, error);
    const JsonFields model = fields.fields("model");
    std::string path, relative, absolute, identity;
    model.read("path", path);
    model.read(relativeKey, relative);
    model.read(absoluteKey, absolute);
    model.read("identity", identity);
    document.identity = QString::fromStdString(identity).toULongLong(nullptr, 16);
    const auto placeOf = [&folder](const std::string& written) {
        return (folder / filePath(QString::fromStdString(written))).lexically_normal();
    };
    document.model = isAddress(path) ? std::filesystem::path(path) : placeOf(path);
    if (!relative.empty())
        document.relativeModel = placeOf(relative);
    if (!absolute.empty())
        document.absoluteModel = placeOf(absolute);
    const QJsonObject foundModel = root->value("model").toObject();
    document.withDirections = foundModel.value("withDirections").toBool();
    const QJsonArray corners = foundModel.value("bounds").toArray();
    const QJsonArray range = foundModel.value("range").toArray();
    for (const QJsonValue& corner : corners)
        document.bounds.extend(Eigen::Vector3d(corner[0].toDouble(), corner[1].toDouble(), corner[2].toDouble()));
    if (range.size() == 2)
        document.range = ValueRange{range[0].toDouble(), range[1].toDouble()};
    const QJsonArray viewSize = root->value("viewSize").toArray();
    if (viewSize.size() == 2 && viewSize[0].toInt() > 0 && viewSize[1].toInt() > 0)
        document.viewSize = {viewSize[0].toInt(), viewSize[1].toInt()};
    std::string file;
    fields.read("file", file);
    document.file = filePath(QString::fromStdString(file));
    readView(fields, document.view);
    document.hasCamera = fields.has("camera");
    if (path.empty() && !error)
        error = Error{ErrorKind::BadInput, Message::say("it names no model in \"model.path\".")};
    if (error)
        return wrong(error->message);
    return document;
}

std::map<QString, QString> pictureTexts(const SessionDocument& document, const QString& accuracy,
                                        const std::filesystem::path& folder)
{
    return {{"Software", QString("TAn %1").arg(QCoreApplication::applicationVersion())},
            {"Title", QFileInfo(pathText(document.model)).completeBaseName()},
            {"Description", accuracy},
            {sessionKey(), oneLine(sessionToText(document, folder))}};
}

Result<std::string> sessionInPicture(const std::filesystem::path& path)
{
    const auto file = MappedFile::open(path);
    if (!file)
        return file.error();
    const std::span<const std::byte> bytes = (*file)->bytes();
    const QByteArray content =
        QByteArray::fromRawData(reinterpret_cast<const char*>(bytes.data()), static_cast<qsizetype>(bytes.size()));
    QBuffer device;
    device.setData(content);
    QImageReader reader(&device, "png");
    return reader.text(sessionKey()).toStdString();
}

bool isPictureFile(const std::filesystem::path& path)
{
    return QFileInfo(pathText(path)).suffix().compare("png", Qt::CaseInsensitive) == 0;
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
