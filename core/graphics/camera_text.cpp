// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/camera_text.h"

#include "core/base/json.h"
#include "core/base/number_text.h"
#include "core/base/shown_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace tetra {
namespace {

constexpr std::array<std::string_view, 9> keys{"azimuth",     "elevation", "roll",   "up",      "fieldOfView",
                                               "perspective", "trackball", "target", "distance"};
/// In the order of UpAxis.
constexpr std::array<std::string_view, 6> upNames{"x", "-x", "y", "-y", "z", "-z"};

std::optional<double> numberOf(const JsonValue& value)
{
    const JsonValue::Number* number = value.number();
    return number != nullptr ? parseNumber<double>(number->text) : std::nullopt;
}

/// Reads keys one by one; the first mistake stays.
class CameraReader {
public:
    explicit CameraReader(const JsonValue& root) : root_(root) {}

    void number(std::string_view key, double& target, double least, double largest)
    {
        const JsonValue* value = root_.find(key);
        if (value == nullptr)
            return;
        const auto parsed = numberOf(*value);
        if (parsed && *parsed >= least && *parsed <= largest)
            target = *parsed;
        else
            fail(*value, key, "is no number from " + formatNumber(least) + " to " + formatNumber(largest));
    }

    void truth(std::string_view key, bool& target)
    {
        const JsonValue* value = root_.find(key);
        if (value == nullptr)
            return;
        if (const bool* truth = std::get_if<bool>(&value->content))
            target = *truth;
        else
            fail(*value, key, "is neither true nor false");
    }

    void upAxis(std::string_view key, UpAxis& target)
    {
        const JsonValue* value = root_.find(key);
        if (value == nullptr)
            return;
        const auto* name = value->string();
        const auto found = name != nullptr ? std::ranges::find(upNames, *name) : upNames.end();
        if (found != upNames.end())
            target = static_cast<UpAxis>(found - upNames.begin());
        else
            fail(*value, key, "is none of x, -x, y, -y, z and -z");
    }

    void point(std::string_view key, Eigen::Vector3d& target)
    {
        const JsonValue* value = root_.find(key);
        if (value == nullptr)
            return;
        const JsonArray* list = value->array();
        if (list == nullptr || list->size() != 3)
            return fail(*value, key, "is not a list of three numbers");
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto parsed = numberOf((*list)[axis]);
            if (!parsed || !std::isfinite(*parsed))
                return fail((*list)[axis], key, "is not a list of three numbers");
            target[static_cast<Eigen::Index>(axis)] = *parsed;
        }
    }

    void refuseOthers()
    {
        for (const auto& [name, value] : *root_.object())
            if (std::ranges::find(keys, name) == keys.end())
                fail(value, name, "is not known");
    }

    const std::optional<Error>& error() const noexcept { return error_; }

private:
    void fail(const JsonValue& value, std::string_view key, const std::string& what)
    {
        if (!error_)
            error_ = Error{ErrorKind::BadInput, "The key \"" + shownText(key) + "\" of the camera " + what + " (" +
                                                    describePlace(value.place) + ")."};
    }

    const JsonValue& root_;
    std::optional<Error> error_;
};

} // namespace

std::string cameraToText(const Camera& camera)
{
    const auto& target = camera.target;
    const Camera usual;
    std::string text =
        "{\n  \"azimuth\": " + formatNumber(camera.azimuth) + ",\n  \"elevation\": " + formatNumber(camera.elevation);
    if (camera.roll != usual.roll)
        text += ",\n  \"roll\": " + formatNumber(camera.roll);
    if (camera.up != usual.up)
        text += ",\n  \"up\": \"" + std::string(upNames[static_cast<std::size_t>(camera.up)]) + "\"";
    text += ",\n  \"fieldOfView\": " + formatNumber(camera.fieldOfView) +
            ",\n  \"perspective\": " + (camera.perspective ? "true" : "false");
    if (camera.trackball)
        text += ",\n  \"trackball\": true";
    return text + ",\n  \"target\": [" + formatNumber(target.x()) + ", " + formatNumber(target.y()) + ", " +
           formatNumber(target.z()) + "],\n  \"distance\": " + formatNumber(camera.distance) + "\n}\n";
}

Result<Camera> cameraFromText(std::string_view text, const Eigen::AlignedBox3d& bounds, double aspectRatio)
{
    const Result<JsonValue> root = parseJson(text);
    if (!root)
        return Error{ErrorKind::BadInput, "This is no camera. " + root.error().text};
    if (root->object() == nullptr)
        return Error{ErrorKind::BadInput, "This is no camera: it holds no JSON object, in braces."};
    CameraReader reader(*root);
    Camera camera;
    reader.number("azimuth", camera.azimuth, -1e6, 1e6);
    reader.number("elevation", camera.elevation, -90, 90);
    reader.number("roll", camera.roll, -1e6, 1e6);
    reader.upAxis("up", camera.up);
    reader.number("fieldOfView", camera.fieldOfView, 1, 170);
    reader.truth("perspective", camera.perspective);
    reader.truth("trackball", camera.trackball);
    camera = fitted(camera, bounds, aspectRatio);
    reader.number("distance", camera.distance, 1e-30, 1e30);
    reader.point("target", camera.target);
    reader.refuseOthers();
    if (reader.error())
        return *reader.error();
    return camera;
}

} // namespace tetra
