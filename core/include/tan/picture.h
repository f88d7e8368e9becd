// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// tan/picture.h: from a model and a view to a picture, as TAn's own programs make it: with its renderers, which are
/// plugins, with what is written over it, and as a file. These functions are in a library of their own,
/// TAn::picture, which needs TAn's programs to be installed, and no Qt.
///
/// A PictureMaker draws one model. It keeps what it has made: the next picture of the same mesh takes no extraction, of
/// the same scene no preparation. Views are values (tan/view.h); how a model is seen at first, startingView() tells.
///
/// ~~~{.cpp}
/// /// A model from above, its surfaces drawn in another mode, as a picture that says how it was made.
/// tetra::Status pictureFromAbove(const std::filesystem::path& file, const std::string& mode,
///                                const std::filesystem::path& target)
/// {
///     const auto model = tetra::Model::open(file);
///     if (!model)
///         return model.error();
///     auto maker = tetra::PictureMaker::of(*model);
///     if (!maker)
///         return maker.error();
///     tetra::ViewValue view = maker->startingView();
///     view.appearance.mode = mode;
///     view.camera.elevation = 90;
///     const auto picture = maker->draw(view, {.width = 320, .height = 240});
///     if (!picture)
///         return picture.error();
///     return tetra::writePicture(*picture, target, {.texts = maker->pictureTexts(view, target)});
/// }
///
/// /// The frames of a view's film, one file each.
/// tetra::Status framesOf(tetra::PictureMaker& maker, const tetra::ViewValue& film, const std::filesystem::path&
/// folder)
/// {
///     for (int frame = 0; frame < tetra::frameCount(film.animation); ++frame) {
///         const auto picture = maker.drawFrame(film, frame, {.width = 64, .height = 48});
///         if (!picture)
///             return picture.error();
///         const auto written = tetra::writePicture(*picture, folder / (std::to_string(frame) + ".png"));
///         if (!written)
///             return written;
///     }
///     return {};
/// }
/// ~~~

#include <tan/base.h>
#include <tan/model.h>
#include <tan/parameter.h>
#include <tan/render.h>
#include <tan/view.h>

#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace tetra {

/// What the file of a picture says besides its pixels.
struct PngFacts {
    bool transparent = false; ///< with how opaque each pixel is; else all of them are
    int dotsPerInch = 0;      ///< for printing; 0 says nothing
    /// By keywords of 1 to 79 characters of ASCII ("Title", "Software" ...). Texts are UTF-8.
    std::map<std::string, std::string> texts{};
};

/// The picture as a PNG file in memory, 8 bits a channel. O(pixels). Errors (OutOfResource): not enough memory.
TAN_API Result<std::vector<std::byte>> pngOf(const Picture& picture, const PngFacts& facts = {});

/// Writes the picture into a file, whole or not at all: by the ending of its name as TIFF (.tif, .tiff), JPEG (.jpg,
/// .jpeg) or PDF (.pdf), else as PNG. All say what there is to say, as far as their formats have room. Errors: those of
/// pngOf(), of a file that cannot be written, of a format that this build does not write, and of a transparent
/// picture as JPEG, which has none (both WrongUsage).
TAN_API Status writePicture(const Picture& picture, const std::filesystem::path& target, const PngFacts& facts = {});

/// How a picture of a view is to be. `tan render` makes the same by default.
struct PictureRequest {
    int width = 1024; ///< of the picture, in pixels
    int height = 768;
    /// Of the view that it is a picture of: texts and lines take as much of the picture as they do of that.
    int viewWidth = 1024;
    int viewHeight = 768;
    bool transparent = false; ///< without the background
    int samplesPerAxis = 4;   ///< a pixel is the mean of this many squared samples, 1 to 4
    int threads = 0;          ///< the most to use for drawing; 0: all
};

/// A way to show a model: the plugin of a renderer.
struct RenderingMode {
    std::string id;   ///< for Appearance::mode
    std::string name; ///< in English
};

/// A view that was kept in a file, as far as it can be had of a model.
struct KeptView {
    ViewValue view;
    std::vector<Message> differences{}; ///< a sentence for each thing that is not as it was
    int viewWidth = 1024;               ///< as in PictureRequest
    int viewHeight = 768;
};

/// Draws a model. It owns the plugins and what it keeps of the last picture; a scene or a picture that it has given
/// away stays what it is. One thread at a time, which may be another one each time; it draws with all of them.
class TAN_API PictureMaker {
public:
    /// With the plugins of the TAn that this library belongs to, those of the user, and those of TAN_PLUGIN_PATH; drawn
    /// by this back end. Reads a coarse mesh of the model, which takes some milliseconds, or asks its server. Errors:
    /// there is no renderer (OutOfResource); those of a mesh.
    static Result<PictureMaker> of(std::shared_ptr<const Model> model,
                                   std::unique_ptr<RenderBackend> backend = makeCpuBackend(),
                                   const Progress& progress = {});
    PictureMaker(PictureMaker&& other) noexcept;
    PictureMaker& operator=(PictureMaker&& other) noexcept;
    ~PictureMaker();

    const std::shared_ptr<const Model>& model() const noexcept;
    /// The ways to show it, the usual one first.
    std::vector<RenderingMode> modes() const;
    /// What the settings of a view's mode (Appearance::settings) can be, with defaults that fit the model and the
    /// error that the view asks for. Errors (WrongUsage): there is no such mode.
    Result<std::vector<Parameter>> parameters(const ViewValue& view) const;

    /// How the model is seen that nobody has looked at yet, in a picture of this width / height.
    ViewValue startingView(double aspectRatio = 4.0 / 3) const;
    /// The view's camera, as near to what there is to see as shows it whole from its direction: without the background
    /// (objectOutline()), or all of the model if nobody knows what that is or its box has axes.
    Camera framed(const ViewValue& view, double aspectRatio = 4.0 / 3) const;
    /// The view of a session, a file of its own (.tansession) or a PNG picture that holds one, whatever model it was
    /// kept of. Errors (BadInput): neither, or a damaged one.
    Result<KeptView> keptView(const std::filesystem::path& file) const;
    /// Writes a session of this model that the window and `tan render` open, whole or not at all.
    Status writeSession(const ViewValue& view, const std::filesystem::path& file) const;
    /// What a picture in `file` says of how it was made, for PngFacts::texts: by these the window opens its view again.
    std::map<std::string, std::string> pictureTexts(const ViewValue& view, const std::filesystem::path& file) const;

    /// The scene of a view: its mesh, prepared by its renderer, without what is written over a picture. Errors:
    /// WrongUsage, there is no such mode, or it cannot show what the view asks for; those of a mesh; Cancelled.
    Result<std::shared_ptr<const Scene>> scene(const ViewValue& view, const PictureRequest& request = {},
                                               const Progress& progress = {});
    /// The picture of a view: its scene, its lens and its annotations, in English. As long as extracting the mesh,
    /// preparing and drawing it take; what has not changed since the last picture is used again. Errors: those of
    /// scene() and of the back end, and OutOfResource if texts are to be written and the system has no font.
    Result<Picture> draw(const ViewValue& view, const PictureRequest& request = {}, const Progress& progress = {});
    /// The picture of frame `number` of the view's film, from 0 to frameCount(film.animation) - 1.
    Result<Picture> drawFrame(const ViewValue& film, int number, const PictureRequest& request = {},
                              const Progress& progress = {});

private:
    struct Parts;
    explicit PictureMaker(std::unique_ptr<Parts> parts);

    std::unique_ptr<Parts> parts_;
};

} // namespace tetra
