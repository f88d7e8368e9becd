// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/view_value.h"

#include <tan/base.h>

#include <QJsonArray>
#include <QJsonObject>
#include <QString>

#include <array>
#include <optional>
#include <vector>

namespace tetra {

/// The members of a JSON object, read one after the other: a member that is missing leaves the value as it is, one of
/// another type is remembered as the error, by its whole name ("mesh.focus.radius"). The first error stays.
class JsonFields {
public:
    JsonFields(QJsonObject object, QString name, std::optional<Error>& error)
        : object_(std::move(object)), name_(std::move(name)), error_(error)
    {
    }

    bool has(const QString& key) const { return object_.contains(key); }
    const QJsonObject& object() const noexcept { return object_; }

    void read(const QString& key, bool& value) const
    {
        if (const QJsonValue found = object_.value(key); found.isBool())
            value = found.toBool();
        else
            refuse(key, found, Message::marked("true or false"));
    }
    void read(const QString& key, double& value) const
    {
        if (const QJsonValue found = object_.value(key); found.isDouble())
            value = found.toDouble();
        else
            refuse(key, found, Message::marked("a number"));
    }
    void read(const QString& key, float& value) const
    {
        double wide = value;
        read(key, wide);
        value = static_cast<float>(wide);
    }
    void read(const QString& key, std::string& value) const
    {
        if (const QJsonValue found = object_.value(key); found.isString())
            value = found.toString().toStdString();
        else
            refuse(key, found, Message::marked("text in quotes"));
    }
    /// Three numbers.
    template <class Vector> void readThree(const QString& key, Vector& value) const
    {
        const QJsonArray numbers = object_.value(key).toArray();
        const bool good =
            numbers.size() == 3 && numbers[0].isDouble() && numbers[1].isDouble() && numbers[2].isDouble();
        for (int axis = 0; good && axis < 3; ++axis)
            value[axis] = numbers[axis].toDouble();
        if (!good)
            refuse(key, object_.value(key), Message::marked("three numbers in brackets"));
    }
    /// The members of a member; none if it is missing.
    JsonFields fields(const QString& key) const
    {
        const QJsonValue found = object_.value(key);
        if (!found.isObject())
            refuse(key, found, Message::marked("an object, in braces"));
        return {found.toObject(), full(key), error_};
    }
    /// The members of each object of a list; none if it is missing.
    std::vector<JsonFields> list(const QString& key) const
    {
        std::vector<JsonFields> elements;
        const QJsonArray list = object_.value(key).toArray();
        for (qsizetype i = 0; i < list.size(); ++i)
            elements.emplace_back(list[i].toObject(), QString("%1[%2]").arg(full(key)).arg(i), error_);
        return elements;
    }
    void refuse(const QString& key, const QJsonValue& found, MarkedText wanted) const
    {
        if (!found.isUndefined())
            refuse({ErrorKind::BadInput, Message::say("\"%1\" must be %2.", full(key).toStdString(), wanted)});
    }
    void refuse(const Error& error) const
    {
        if (!error_)
            error_ = error;
    }

private:
    QString full(const QString& key) const { return name_.isEmpty() ? key : name_ + "." + key; }

    QJsonObject object_;
    QString name_;
    std::optional<Error>& error_;
};

/// The number of the name among `names`, an enumeration's.
template <class Enumeration, std::size_t Count> void
readName(const JsonFields& fields, const QString& key, const std::array<const char*, Count>& names, Enumeration& value)
{
    std::string name = names[static_cast<std::size_t>(value)];
    fields.read(key, name);
    for (std::size_t i = 0; i < Count; ++i)
        if (name == names[i]) {
            value = static_cast<Enumeration>(i);
            return;
        }
    fields.refuse(key, fields.object().value(key), Message::marked("one of the known names"));
}

/// A view as JSON, and back: the one form that sessions, views that are kept, and pictures have of it.
///
///     {"mesh": {"error": 1, "focus": {...}, ...}, "look": {"mode": "volume", "transfer": {...}, "settings": {...}},
///      "isovalues": [...], "annotations": {"axes": {"shown": true, "corner": "bottomLeft"}, ...},
///      "animation": {...}, "camera": {...}, "background": [0, 0, 0.5],
///      "lens": {"shape": "circle", "x": 0.5, "y": 0.5, "radius": 0.25, "magnification": 3, "error": 0.25}}
///
/// Cameras and transfer functions are in the forms that their own files have. Settings keep their type:
/// {"integer": 3}, {"number": 0.5}, true, "text". A background that nobody chose is left out.
QJsonObject toJson(const ViewValue& view);

/// What the text leaves open stays as it is in `view`; of a camera, what fits a box of side 1.
void readView(const JsonFields& fields, ViewValue& view);

} // namespace tetra
