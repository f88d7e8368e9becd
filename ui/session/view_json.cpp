// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/view_json.h"

#include <tan/render.h>
#include <tan/transfer.h>

#include <QJsonDocument>

#include <array>
#include <cmath>

namespace tetra {
namespace {

constexpr std::array shapeNames = {"none", "box", "sphere"};
constexpr std::array borderNames = {"intersecting", "contained", "clipped"};

QJsonArray three(const Eigen::Vector3d& vector)
{
    return {vector[0], vector[1], vector[2]};
}

QJsonObject toJson(const FocusState& focus)
{
    return {{"shape", shapeNames[static_cast<std::size_t>(focus.shape)]},
            {"centre", three(focus.centre)},
            {"size", three(focus.size)},
            {"radius", focus.radius},
            {"error", focus.error},
            {"falloff", focus.falloff}};
}

void readFocus(const JsonFields& fields, FocusState& focus)
{
    readName(fields, "shape", shapeNames, focus.shape);
    fields.readThree("centre", focus.centre);
    fields.readThree("size", focus.size);
    fields.read("radius", focus.radius);
    fields.read("error", focus.error);
    fields.read("falloff", focus.falloff);
}

QJsonObject toJson(const WindowState& window)
{
    return {{"on", window.enabled},
            {"least", three(window.window.box.least)},
            {"largest", three(window.window.box.largest)},
            {"border", borderNames[static_cast<std::size_t>(window.window.border)]}};
}

void readWindow(const JsonFields& fields, WindowState& window)
{
    fields.read("on", window.enabled);
    fields.readThree("least", window.window.box.least);
    fields.readThree("largest", window.window.box.largest);
    readName(fields, "border", borderNames, window.window.border);
}

QJsonValue toJson(const ParameterValue& value)
{
    if (const bool* truth = std::get_if<bool>(&value))
        return *truth;
    if (const std::int64_t* integer = std::get_if<std::int64_t>(&value))
        return QJsonObject{{"integer", static_cast<qint64>(*integer)}};
    if (const double* number = std::get_if<double>(&value))
        return QJsonObject{{"number", *number}};
    if (const std::string* text = std::get_if<std::string>(&value))
        return QString::fromStdString(*text);
    if (const Colour* colour = std::get_if<Colour>(&value))
        return QJsonObject{{"colour", QJsonArray{colour->red, colour->green, colour->blue}}};
    if (const Eigen::Vector3d* vector = std::get_if<Eigen::Vector3d>(&value))
        return QJsonObject{{"vector", three(*vector)}};
    if (const OwnValue* own = std::get_if<OwnValue>(&value))
        return QJsonObject{{"type", QString::fromStdString(own->type)}, {"text", QString::fromStdString(own->text)}};
    return {};
}

std::optional<ParameterValue> settingOf(const QJsonValue& value)
{
    if (value.isBool())
        return ParameterValue(value.toBool());
    if (value.isString())
        return ParameterValue(value.toString().toStdString());
    const QJsonObject tagged = value.toObject();
    if (tagged.value("integer").isDouble())
        return ParameterValue(static_cast<std::int64_t>(tagged.value("integer").toInteger()));
    if (tagged.value("number").isDouble())
        return ParameterValue(tagged.value("number").toDouble());
    const auto numberOf = [](const QJsonArray& list, int index) { return list.at(index).toDouble(); };
    if (const QJsonArray colour = tagged.value("colour").toArray(); colour.size() == 3)
        return ParameterValue(Colour{static_cast<float>(numberOf(colour, 0)), static_cast<float>(numberOf(colour, 1)),
                                     static_cast<float>(numberOf(colour, 2))});
    if (const QJsonArray vector = tagged.value("vector").toArray(); vector.size() == 3)
        return ParameterValue(Eigen::Vector3d(numberOf(vector, 0), numberOf(vector, 1), numberOf(vector, 2)));
    if (tagged.value("type").isString() && tagged.value("text").isString())
        return ParameterValue(
            OwnValue{tagged.value("type").toString().toStdString(), tagged.value("text").toString().toStdString()});
    return std::nullopt;
}

} // namespace

QJsonObject toJson(const QueryState& query)
{
    return {
        {"error", query.error},
        {"byBudget", query.byBudget},
        {"budget", static_cast<qint64>(query.budget)},
        {"focus", toJson(query.focus)},
        {"window", toJson(query.window)},
        {"values",
         QJsonObject{{"on", query.values.enabled}, {"least", query.values.least}, {"largest", query.values.largest}}}};
}

void readQuery(const JsonFields& fields, QueryState& query)
{
    fields.read("error", query.error);
    fields.read("byBudget", query.byBudget);
    double budget = static_cast<double>(query.budget);
    fields.read("budget", budget);
    constexpr double mostTetrahedra = 1e15;
    query.budget = static_cast<std::uint64_t>(std::clamp(budget, 0.0, mostTetrahedra));
    readFocus(fields.fields("focus"), query.focus);
    readWindow(fields.fields("window"), query.window);
    const JsonFields values = fields.fields("values");
    values.read("on", query.values.enabled);
    values.read("least", query.values.least);
    values.read("largest", query.values.largest);
}

QJsonObject toJson(const TransferFunction& transfer)
{
    return QJsonDocument::fromJson(QByteArray::fromStdString(transferFunctionToText(transfer))).object();
}

void readTransfer(const QJsonValue& value, TransferFunction& transfer, std::optional<Error>& error)
{
    const QByteArray text = QJsonDocument(value.toObject()).toJson();
    const auto read = transferFunctionFromText({text.constData(), static_cast<std::size_t>(text.size())});
    if (read)
        transfer = *read;
    else if (!error)
        error = read.error();
}

QJsonObject toJson(const Camera& camera)
{
    return QJsonDocument::fromJson(QByteArray::fromStdString(cameraToText(camera))).object();
}

void readCamera(const QJsonValue& value, Camera& camera, std::optional<Error>& error)
{
    const std::string text = QJsonDocument(value.toObject()).toJson().toStdString();
    const Eigen::AlignedBox3d usual(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 1, 1));
    if (const auto read = cameraFromText(text, usual))
        camera = *read;
    else if (!error)
        error = read.error();
}

QJsonObject toJson(const Look& look)
{
    QJsonObject settings;
    for (const auto& [id, value] : look.settings)
        if (const QJsonValue json = toJson(value); !json.isNull())
            settings.insert(QString::fromStdString(id), json);
    return {{"mode", QString::fromStdString(look.mode)}, {"transfer", toJson(look.transfer)}, {"settings", settings}};
}

void readLook(const JsonFields& fields, Look& look, std::optional<Error>& error)
{
    fields.read("mode", look.mode);
    if (fields.has("transfer"))
        readTransfer(fields.object().value("transfer"), look.transfer, error);
    const QJsonObject settings = fields.fields("settings").object();
    for (auto setting = settings.begin(); setting != settings.end(); ++setting)
        if (const auto value = settingOf(setting.value()))
            look.settings[setting.key().toStdString()] = *value;
}

QJsonArray toJson(const std::vector<Isovalue>& isovalues)
{
    QJsonArray list;
    for (const Isovalue& isovalue : isovalues)
        list.append(QJsonObject{{"value", isovalue.value},
                                {"colour", QJsonArray{isovalue.red, isovalue.green, isovalue.blue}},
                                {"opacity", isovalue.opacity},
                                {"visible", isovalue.visible}});
    return list;
}

std::vector<Isovalue> isovaluesOf(const QJsonArray& list, std::optional<Error>& error)
{
    std::vector<Isovalue> isovalues;
    for (qsizetype i = 0; i < list.size(); ++i) {
        const JsonFields fields(list[i].toObject(), QString("isovalues[%1]").arg(i), error);
        Isovalue isovalue;
        std::array<double, 3> colour = {isovalue.red, isovalue.green, isovalue.blue};
        fields.read("value", isovalue.value);
        fields.readThree("colour", colour);
        fields.read("opacity", isovalue.opacity);
        fields.read("visible", isovalue.visible);
        isovalue.red = static_cast<float>(std::clamp(colour[0], 0.0, 1.0));
        isovalue.green = static_cast<float>(std::clamp(colour[1], 0.0, 1.0));
        isovalue.blue = static_cast<float>(std::clamp(colour[2], 0.0, 1.0));
        isovalues.push_back(isovalue);
    }
    return isovalues;
}

} // namespace tetra
