// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/json.h"

#include <tan/render.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

namespace tetra {

namespace {

/// Distances beyond these would lose the matrices' precision.
constexpr double smallestDistance = 1e-30;
constexpr double largestDistance = 1e30;
/// The nearest that a perspective view shows, as a fraction of the farthest; but of what is looked at from so near that
/// this would cut it off, all that is beyond a fraction of its distance.
constexpr double nearestFraction = 1e-4, nearestOfDistance = 0.01;

/// The part of the picture's width or height, whichever is filled, that a fitted box takes.
constexpr double fittedShare = 0.96;
/// The eye stays at least so far before a fitted box, in diagonals: one may look along a box that is but a line.
constexpr double leastFittedDistance = 0.01;

double radians(double degrees)
{
    return degrees * (std::numbers::pi / 180);
}

double inDegrees(double radians)
{
    return radians * (180 / std::numbers::pi);
}

/// The axes that angles are counted from: to the right and away from the eye where azimuth and elevation are 0, and up.
Eigen::Matrix3d axesOfAngles(UpAxis up)
{
    const auto axis = static_cast<int>(up) / 2;
    const double sign = static_cast<int>(up) % 2 == 0 ? 1 : -1;
    const Eigen::Vector3d above = sign * Eigen::Vector3d::Unit(axis);
    const Eigen::Vector3d away =
        axis == 1 ? Eigen::Vector3d(-Eigen::Vector3d::UnitZ()) : Eigen::Vector3d::Unit(axis == 0 ? 2 : 1);
    Eigen::Matrix3d axes;
    axes << away.cross(above), away, above;
    return axes;
}

/// The eye's axes without roll, in axesOfAngles().
Eigen::Matrix3d levelAxes(double azimuthDegrees, double elevationDegrees)
{
    const double azimuth = radians(azimuthDegrees);
    const double elevation = radians(elevationDegrees);
    const Eigen::Vector3d right(std::cos(azimuth), std::sin(azimuth), 0);
    const Eigen::Vector3d back(std::sin(azimuth) * std::cos(elevation), -std::cos(azimuth) * std::cos(elevation),
                               std::sin(elevation));
    Eigen::Matrix3d axes;
    axes << right, back.cross(right), back;
    return axes;
}

double tangentOfHalfField(const Camera& camera)
{
    return std::tan(radians(std::clamp(camera.fieldOfView, 0.01, 179.0)) / 2);
}

struct DepthRange {
    double nearest;
    double farthest;
};

/// The distances from the eye, along its axis, between which the box lies, with a little room.
DepthRange depthRange(const Camera& camera, const Eigen::AlignedBox3d& bounds)
{
    DepthRange range{0, 2 * camera.distance};
    if (!bounds.isEmpty()) {
        const Eigen::Vector3d back = eyeAxes(camera).col(2);
        const double middle = back.dot(eyePosition(camera) - bounds.center());
        const double half = back.cwiseAbs().dot(bounds.sizes()) / 2;
        const double margin = 0.01 * bounds.diagonal().norm() + 1e-6 * std::abs(middle);
        range = {middle - half - margin, middle + half + margin};
    }
    if (!camera.perspective)
        return range;
    if (range.farthest <= 0)
        return {nearestFraction * camera.distance, camera.distance};
    const double nearest = std::min(nearestFraction * range.farthest, nearestOfDistance * camera.distance);
    return {std::max(range.nearest, nearest), range.farthest};
}

/// The camera that looks at the middle of a box, so that places, which are given from there, are seen.
Camera fittedAround(const Camera& camera, const Eigen::AlignedBox3d& bounds, std::span<const Eigen::Vector3d> places,
                    double aspectRatio)
{
    const double diagonal = bounds.sizes().norm() > 0 ? bounds.sizes().norm() : 1;
    const Eigen::Matrix3d eyeFromWorld = eyeAxes(camera).transpose();
    // How far a place beside the target may lie from it, in distances from the eye.
    const Eigen::Array2d reach = fittedShare * tangentOfHalfField(camera) *
                                 Eigen::Array2d(std::max(1.0, aspectRatio), std::max(1.0, 1 / aspectRatio));
    double distance = leastFittedDistance * diagonal;
    for (const Eigen::Vector3d& place : places) {
        const Eigen::Vector3d seen = eyeFromWorld * place;
        const double wanted = (seen.head<2>().array().abs() / reach).maxCoeff();
        const double before = camera.perspective ? seen.z() : 0;
        distance = std::max({distance, before + wanted, before + leastFittedDistance * diagonal});
    }
    Camera result = camera;
    result.target = bounds.center();
    result.distance = 1;
    return zoomed(result, distance);
}

} // namespace

Camera fitted(const Camera& camera, const Eigen::AlignedBox3d& bounds, double aspectRatio)
{
    if (bounds.isEmpty())
        return camera;
    const Eigen::Vector3d half = bounds.sizes() / 2;
    std::array<Eigen::Vector3d, 8> corners;
    for (std::size_t corner = 0; corner < 8; ++corner)
        corners[corner] =
            half.cwiseProduct(Eigen::Vector3d(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1));
    return fittedAround(camera, bounds, corners, aspectRatio);
}

Camera fitted(const Camera& camera, std::span<const Eigen::Vector3d> places, double aspectRatio)
{
    if (places.empty())
        return camera;
    Eigen::AlignedBox3d bounds;
    for (const Eigen::Vector3d& place : places)
        bounds.extend(place);
    std::vector<Eigen::Vector3d> fromMiddle(places.begin(), places.end());
    for (Eigen::Vector3d& place : fromMiddle)
        place -= bounds.center();
    return fittedAround(camera, bounds, fromMiddle, aspectRatio);
}

Camera turned(const Camera& camera, double azimuth, double elevation)
{
    Camera result = camera;
    result.azimuth = std::remainder(camera.azimuth + azimuth, 360.0);
    result.elevation = std::clamp(camera.elevation + elevation, -90.0, 90.0);
    return result;
}

Camera rolled(const Camera& camera, double degrees)
{
    Camera result = camera;
    result.roll = std::remainder(camera.roll + degrees, 360.0);
    return result;
}

Camera rotated(const Camera& camera, const Eigen::Matrix3d& rotation)
{
    return withEyeAxes(camera, eyeAxes(camera) * rotation.transpose());
}

Camera upright(const Camera& camera, UpAxis up)
{
    Camera result = camera;
    result.up = up;
    result.roll = 0;
    return result;
}

UpAxis opposite(UpAxis up)
{
    return static_cast<UpAxis>(static_cast<int>(up) ^ 1);
}

Camera zoomed(const Camera& camera, double factor)
{
    Camera result = camera;
    if (factor > 0)
        result.distance = std::clamp(camera.distance * factor, smallestDistance, largestDistance);
    return result;
}

Camera panned(const Camera& camera, double right, double up)
{
    const double side = 2 * camera.distance * tangentOfHalfField(camera);
    Camera result = camera;
    result.target += eyeAxes(camera) * Eigen::Vector3d(right * side, up * side, 0);
    return result;
}

Eigen::Vector3d eyePosition(const Camera& camera)
{
    return camera.target + camera.distance * eyeAxes(camera).col(2);
}

Eigen::Matrix3d eyeAxes(const Camera& camera)
{
    const Eigen::Matrix3d level = axesOfAngles(camera.up) * levelAxes(camera.azimuth, camera.elevation);
    const double cosine = std::cos(radians(camera.roll));
    const double sine = std::sin(radians(camera.roll));
    Eigen::Matrix3d axes;
    axes << cosine * level.col(0) + sine * level.col(1), cosine * level.col(1) - sine * level.col(0), level.col(2);
    return axes;
}

/// At a pole, where no azimuth is told from a roll, the azimuth stays.
Camera withEyeAxes(const Camera& camera, const Eigen::Matrix3d& axes)
{
    constexpr double atPole = 1e-9;
    const Eigen::Matrix3d turned = axesOfAngles(camera.up).transpose() * axes;
    const Eigen::Vector3d back = turned.col(2).normalized();
    const double beside = std::hypot(back.x(), back.y());
    Camera result = camera;
    result.elevation = inDegrees(std::atan2(back.z(), beside));
    if (beside > atPole)
        result.azimuth = inDegrees(std::atan2(back.x(), -back.y()));
    const Eigen::Matrix3d level = levelAxes(result.azimuth, result.elevation);
    result.roll = inDegrees(std::atan2(level.col(1).dot(turned.col(0)), level.col(0).dot(turned.col(0))));
    return result;
}

Eigen::Matrix4d viewMatrix(const Camera& camera)
{
    const Eigen::Matrix3d rotation = eyeAxes(camera).transpose();
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
    matrix.topLeftCorner<3, 3>() = rotation;
    matrix.topRightCorner<3, 1>() = -rotation * eyePosition(camera);
    return matrix;
}

Eigen::Matrix4d projectionMatrix(const Camera& camera, double aspectRatio, const Eigen::AlignedBox3d& bounds)
{
    const auto [nearest, farthest] = depthRange(camera, bounds);
    const double depth = farthest - nearest;
    const double tangent = tangentOfHalfField(camera);
    const Eigen::Vector2d shape(std::min(1.0, 1 / aspectRatio), std::min(1.0, aspectRatio));

    Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
    if (camera.perspective) {
        matrix.diagonal() << shape / tangent, -(farthest + nearest) / depth, 0;
        matrix(2, 3) = -2 * farthest * nearest / depth;
        matrix(3, 2) = -1;
    } else {
        matrix.diagonal() << shape / (tangent * camera.distance), -2 / depth, 1;
        matrix(2, 3) = -(farthest + nearest) / depth;
    }
    return matrix;
}

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
            fail(Message::say("The key \"%1\" of the camera is not a number from %2 to %3 (%4).", key,
                              formatNumber(least), formatNumber(largest), describePlace(value->place)));
    }

    void boolean(std::string_view key, bool& target)
    {
        const JsonValue* value = root_.find(key);
        if (value == nullptr)
            return;
        if (const bool* boolean = std::get_if<bool>(&value->content))
            target = *boolean;
        else
            fail(Message::say("The key \"%1\" of the camera is neither true nor false (%2).", key,
                              describePlace(value->place)));
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
            fail(Message::say("The key \"%1\" of the camera is not one of x, -x, y, -y, z and -z (%2).", key,
                              describePlace(value->place)));
    }

    void point(std::string_view key, Eigen::Vector3d& target)
    {
        const JsonValue* value = root_.find(key);
        if (value == nullptr)
            return;
        const JsonArray* list = value->array();
        if (list == nullptr || list->size() != 3)
            return failPoint(*value, key);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto parsed = numberOf((*list)[axis]);
            if (!parsed || !std::isfinite(*parsed))
                return failPoint((*list)[axis], key);
            target[static_cast<Eigen::Index>(axis)] = *parsed;
        }
    }

    void refuseOthers()
    {
        for (const auto& [name, value] : *root_.object())
            if (std::ranges::find(keys, name) == keys.end())
                fail(Message::say("The key \"%1\" of the camera is not known (%2).", printable(name),
                                  describePlace(value.place)));
    }

    const std::optional<Error>& error() const noexcept { return error_; }

private:
    void failPoint(const JsonValue& value, std::string_view key)
    {
        fail(Message::say("The key \"%1\" of the camera is not a list of three numbers (%2).", key,
                          describePlace(value.place)));
    }

    void fail(const Message& what)
    {
        if (!error_)
            error_ = Error{ErrorKind::BadInput, what};
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
        return Error{ErrorKind::BadInput, Message::say("This is not a camera. %1", root.error().message)};
    if (root->object() == nullptr)
        return Error{ErrorKind::BadInput, Message::say("This is not a camera: it holds no JSON object, in braces.")};
    CameraReader reader(*root);
    Camera camera;
    reader.number("azimuth", camera.azimuth, -1e6, 1e6);
    reader.number("elevation", camera.elevation, -90, 90);
    reader.number("roll", camera.roll, -1e6, 1e6);
    reader.upAxis("up", camera.up);
    reader.number("fieldOfView", camera.fieldOfView, 1, 170);
    reader.boolean("perspective", camera.perspective);
    reader.boolean("trackball", camera.trackball);
    camera = fitted(camera, bounds, aspectRatio);
    reader.number("distance", camera.distance, 1e-30, 1e30);
    reader.point("target", camera.target);
    reader.refuseOthers();
    if (reader.error())
        return *reader.error();
    return camera;
}

} // namespace tetra
