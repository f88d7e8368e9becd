// SPDX-License-Identifier: GPL-3.0-or-later
#include <plugins/api/plugin.h>
#include <plugins/api/scene_parameters.h>

#include <optional>
#include <string>

namespace {
using namespace tetra;

/// The number that follows a name in JSON; nothing if there is none.
std::optional<double> numberAfter(const std::string& text, const std::string& name)
{
    const std::size_t start = text.find('"' + name + '"');
    const std::size_t colon = text.find(':', start);
    if (start == std::string::npos || colon == std::string::npos)
        return std::nullopt;
    const std::size_t first = text.find_first_not_of(" \t\n", colon + 1);
    const std::size_t end = text.find_first_of(" \t\n,}", first);
    return first < end ? parseNumber<double>(text.substr(first, end - first)) : std::nullopt;
}

/// The limits of a band, {"low": 1, "high": 2}, which examples/editor edits; nothing if the text has none.
std::optional<ValueRange> bandOf(const std::string& text)
{
    const auto low = numberAfter(text, "low"), high = numberAfter(text, "high");
    return low && high ? std::optional(ValueRange{*low, *high}) : std::nullopt;
}

class Shells : public RendererSession {
public:
    explicit Shells(const RendererMeshes& meshes) : meshes_(meshes), surfaces_(meshes.mesh) {}

    Result<std::shared_ptr<const Scene>> prepare(const RendererView& view, const Progress& progress) override
    {
        auto scene = startScene(view, meshes_.bounds);
        if (!scene)
            return scene.error();
        const auto function = view.value<TransferFunction>(transferId);
        const auto count = view.value<std::int64_t>("shells");
        const ValueRange range = bandOf(view.value<OwnValue>("band").text).value_or(ValueRange{});
        std::vector<Isovalue> isovalues;
        for (std::int64_t i = 1; i <= count; ++i) {
            const double value = range.minimum + range.extent() * double(i) / double(count + 1);
            const auto [red, green, blue] = evaluateUnmasked(function, value).colour;
            isovalues.push_back({value, float(red), float(green), float(blue), 0.4f});
        }
        auto shells = surfaces_.drawables(isovalues, progress);
        if (!shells)
            return shells.error();
        std::ranges::move(*shells, std::back_inserter(scene->drawables));
        return std::make_shared<const Scene>(*std::move(scene));
    }

private:
    RendererMeshes meshes_;
    IsosurfaceCache surfaces_;
};
} // namespace

/// Shows isosurfaces of equally spaced values.
class ShellsRenderer : public tetra::Renderer {
public:
    std::vector<Parameter> parameters(const FieldExtent& field) const override
    {
        Parameter shells, band;
        shells.id = "shells";
        shells.label = "Shells";
        shells.explanation = "How many.";
        shells.defaultValue = std::int64_t{4};
        shells.minimum = 1;
        shells.maximum = 20;
        band.id = "band";
        band.label = "Band";
        band.explanation = "The values between which they are.";
        band.defaultValue = OwnValue{"example.band", R"({"low": )" + formatNumber(field.range.minimum) +
                                                         R"(, "high": )" + formatNumber(field.range.maximum) + "}"};
        band.mistake = [](const std::string& text) {
            return bandOf(text) ? Message() : Message::say(R"(A band is written {"low": 1, "high": 2}.)");
        };
        return {transferParameter(field), shells, band, clipParameter(), outlineParameter(field)};
    }
    std::unique_ptr<RendererSession> open(const RendererMeshes& meshes) const override
    {
        return std::make_unique<Shells>(meshes);
    }
};

TAN_PLUGIN(ShellsRenderer, tetra::Renderer)
