// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of models: views as texts, pictures as arrays.
#include "binding.h"
#include "opened_model.h"

#include <tan/picture.h>
#include <tan/transfer.h>
#include <tan/view.h>

#include <algorithm>

namespace tetra::python {

namespace {

using Pixels = py::array_t<std::uint8_t, py::array::c_style>;

/// How a picture is to be.
struct DrawOptions {
    int width = 0;
    int height = 0;
    bool transparent = false;
    int samples = 0;
    int threads = 0;
    bool fitted = false;                         ///< the camera looks from where the view says, at the whole domain
    double zoom = 1;                             ///< and then comes so many times nearer
    std::optional<std::array<double, 3>> target; ///< and looks at this place
    std::string colours;                         ///< the map whose colours the transfer function gets; empty: its own
    bool openGl = false;
    std::optional<int> frame;
};

/// `use(maker)`, which gives a Result, with the model's maker of pictures, by one thread at a time.
template <class Use> auto withMaker(OpenedModel& opened, bool openGl, const py::object& progress, Use use)
{
    using Outcome = decltype(use(std::declval<PictureMaker&>(), std::declval<const Progress&>()));
    return finished(progress, [&](const Progress& told) -> Outcome {
        const auto lock = locked(opened.drawing, told);
        if (!lock)
            return cancelledError("Drawing");
        if (openGl) {
            auto backend = makeGlBackend();
            if (!backend)
                return backend.error();
            auto maker = PictureMaker::of(opened.model(), *std::move(backend), told.part(0, 0.1));
            return maker ? use(*maker, told.part(0.1, 1)) : Outcome(maker.error());
        }
        if (!opened.maker) {
            auto maker = PictureMaker::of(opened.model(), makeCpuBackend(), told.part(0, 0.1));
            if (!maker)
                return maker.error();
            opened.maker.emplace(*std::move(maker));
        }
        return use(*opened.maker, told);
    });
}

std::string startingViewText(OpenedModel& opened, double aspectRatio)
{
    return withMaker(opened, false, py::none(), [&](PictureMaker& maker, const Progress&) {
        return Result<std::string>(viewToText(maker.startingView(aspectRatio)));
    });
}

std::vector<std::pair<std::string, std::string>> modesOf(OpenedModel& opened)
{
    return withMaker(opened, false, py::none(), [&](PictureMaker& maker, const Progress&) {
        std::vector<std::pair<std::string, std::string>> modes;
        for (const RenderingMode& mode : maker.modes())
            modes.emplace_back(mode.id, mode.name);
        return Result<std::vector<std::pair<std::string, std::string>>>(std::move(modes));
    });
}

/// What can be set of the mode of a view: of each setting its id, its type, what is usual, its least and largest
/// number, equal where it has no bounds, and its choices, none where any text will do.
py::list settingsOf(OpenedModel& opened, const std::string& text)
{
    const auto parameters = withMaker(opened, false, py::none(), [&](PictureMaker& maker, const Progress&) {
        const auto view = viewFromText(text, maker.startingView());
        return view ? maker.parameters(*view) : Result<std::vector<Parameter>>(view.error());
    });
    py::list settings;
    for (const Parameter& parameter : parameters) {
        const ParameterValue& value = parameter.defaultValue;
        py::object usual = py::none(); // of what is more than a word or a number
        if (const auto* truth = std::get_if<bool>(&value))
            usual = py::bool_(*truth);
        else if (const auto* whole = std::get_if<std::int64_t>(&value))
            usual = py::int_(*whole);
        else if (const auto* number = std::get_if<double>(&value))
            usual = py::float_(*number);
        else if (const auto* word = std::get_if<std::string>(&value))
            usual = py::str(*word);
        settings.append(py::make_tuple(parameter.id, parameterTypeName(value), usual, parameter.minimum,
                                       std::max(parameter.minimum, parameter.maximum), parameter.choices));
    }
    return settings;
}

/// With the colours of a map from the least value to the largest.
Result<TransferFunction> coloured(const TransferFunction& function, const std::string& name, const ValueRange& range)
{
    std::string known;
    for (const ColourMap& map : colourMaps()) {
        if (map.id == name)
            return withColourMap(function, map, {range.minimum, range.maximum});
        known += (known.empty() ? "" : ", ") + map.id;
    }
    return Error{ErrorKind::WrongUsage,
                 Message::say("There is no colour map '%1'. There are: %2.", printable(name), known)};
}

/// What a text says of a view, and else how the model is seen at first.
Result<ViewValue> viewOf(const PictureMaker& maker, const std::string& text, const DrawOptions& options)
{
    const double aspectRatio = static_cast<double>(options.width) / options.height;
    auto view = viewFromText(text, maker.startingView(aspectRatio));
    if (!view)
        return view;
    const Model& model = *maker.model();
    view->query = corrected(view->query, startingQuery(model, startingError(model)), model);
    if (!options.colours.empty()) {
        auto function = coloured(view->appearance.transfer, options.colours, model.description().range);
        if (!function)
            return function.error();
        view->appearance.transfer = *std::move(function);
    }
    if (options.fitted)
        view->camera = maker.framed(*view, aspectRatio);
    view->camera = zoomed(view->camera, 1 / options.zoom);
    if (options.target)
        view->camera.target = Eigen::Vector3d(options.target->data());
    return view;
}

Pixels arrayOf(const Picture& picture)
{
    Pixels pixels({static_cast<py::ssize_t>(picture.height), static_cast<py::ssize_t>(picture.width), py::ssize_t(4)});
    std::ranges::copy(std::as_bytes(std::span(picture.pixels)),
                      reinterpret_cast<std::byte*>(pixels.mutable_data())); // NOLINT: bytes of an array of bytes
    return pixels;
}

Picture pictureOf(const Pixels& pixels)
{
    if (pixels.ndim() != 3 || pixels.shape(2) != 4 || pixels.shape(0) < 1 || pixels.shape(1) < 1 ||
        std::max(pixels.shape(0), pixels.shape(1)) > 65535)
        raise({ErrorKind::WrongUsage, Message::say("A picture is an array of shape (height, width, 4).")});
    Picture picture;
    picture.height = static_cast<int>(pixels.shape(0));
    picture.width = static_cast<int>(pixels.shape(1));
    picture.pixels.resize(static_cast<std::size_t>(picture.height) * static_cast<std::size_t>(picture.width));
    std::copy_n(pixels.data(), pixels.size(), picture.pixels.front().data());
    return picture;
}

Pixels draw(OpenedModel& opened, const std::string& text, const DrawOptions& options, const py::object& progress)
{
    if (options.width < 1 || options.height < 1)
        raise({ErrorKind::WrongUsage, Message::say("A picture has at least one pixel along each axis.")});
    const PictureRequest request{.width = options.width,
                                 .height = options.height,
                                 .viewWidth = options.width,
                                 .viewHeight = options.height,
                                 .transparent = options.transparent,
                                 .samplesPerAxis = options.samples,
                                 .threads = options.threads};
    const auto use = [&](PictureMaker& maker, const Progress& told) -> Result<Picture> {
        const auto view = viewOf(maker, text, options);
        if (!view)
            return view.error();
        return options.frame ? maker.drawFrame(*view, *options.frame, request, told) : maker.draw(*view, request, told);
    };
    return arrayOf(withMaker(opened, options.openGl, progress, use));
}

py::tuple keptViewOf(OpenedModel& opened, const std::string& file)
{
    const KeptView kept = withMaker(opened, false, py::none(),
                                    [&](PictureMaker& maker, const Progress&) { return maker.keptView(file); });
    std::vector<std::string> differences;
    for (const Message& difference : kept.differences)
        differences.push_back(visibleText(difference));
    return py::make_tuple(viewToText(kept.view), differences, kept.viewWidth, kept.viewHeight);
}

/// The view's text with its camera as it is in a picture, for what is written of it.
std::string fittedText(OpenedModel& opened, const std::string& text, const DrawOptions& options)
{
    return withMaker(opened, false, py::none(), [&](PictureMaker& maker, const Progress&) -> Result<std::string> {
        const auto view = viewOf(maker, text, options);
        return view ? Result<std::string>(viewToText(*view)) : view.error();
    });
}

void writeSession(OpenedModel& opened, const std::string& text, const DrawOptions& options, const std::string& file)
{
    withMaker(opened, false, py::none(), [&](PictureMaker& maker, const Progress&) -> Result<bool> {
        const auto view = viewOf(maker, text, options);
        if (!view)
            return view.error();
        const Status written = maker.writeSession(*view, file);
        return written ? Result<bool>(true) : written.error();
    });
}

/// With what it says of how it was made, by which the window opens its view again.
void writePng(OpenedModel& opened, const Pixels& pixels, const std::string& text, const DrawOptions& options,
              const std::string& file)
{
    const Picture picture = pictureOf(pixels);
    withMaker(opened, false, py::none(), [&](PictureMaker& maker, const Progress&) -> Result<bool> {
        const auto view = viewOf(maker, text, options);
        if (!view)
            return view.error();
        const Status written =
            writePicture(picture, file, {.transparent = options.transparent, .texts = maker.pictureTexts(*view, file)});
        return written ? Result<bool>(true) : written.error();
    });
}

py::bytes png(const Pixels& pixels)
{
    const auto file = valueOf(pngOf(pictureOf(pixels), {.transparent = true}));
    return {reinterpret_cast<const char*>(file.data()), file.size()}; // NOLINT: bytes
}

} // namespace

void bindPictures(py::module_& module)
{
    py::class_<DrawOptions>(module, "DrawOptions")
        .def(py::init<>())
        .def_readwrite("width", &DrawOptions::width)
        .def_readwrite("height", &DrawOptions::height)
        .def_readwrite("transparent", &DrawOptions::transparent)
        .def_readwrite("samples", &DrawOptions::samples)
        .def_readwrite("threads", &DrawOptions::threads)
        .def_readwrite("fitted", &DrawOptions::fitted)
        .def_readwrite("zoom", &DrawOptions::zoom)
        .def_readwrite("target", &DrawOptions::target)
        .def_readwrite("colours", &DrawOptions::colours)
        .def_readwrite("open_gl", &DrawOptions::openGl)
        .def_readwrite("frame", &DrawOptions::frame);
    module.def("starting_view", &startingViewText);
    module.def("modes", &modesOf);
    module.def("settings", &settingsOf);
    module.def("draw", &draw);
    module.def("kept_view", &keptViewOf);
    module.def("fitted_view", &fittedText);
    module.def("write_session", &writeSession);
    module.def("write_png", &writePng);
    module.def("png", &png);
}

} // namespace tetra::python
