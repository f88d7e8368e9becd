// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/film_file.h"

#include "core/base/file_writer.h"
#include "core/base/folder.h"
#include "core/base/system_error.h"
#include "core/base/work_folder.h"
#include "ui/session/target_path.h"
#include "ui/session/video_encoding.h"

#include <QEventLoop>
#include <QString>
#include <QTimer>

#include <algorithm>

namespace tetra {
namespace {

constexpr int askEvery = 50; // milliseconds
constexpr int leastDigits = 4;
constexpr double drawingPart = 0.93; ///< of the time of a video
constexpr const char* framePattern = "%06d.png";

Error cancelledError()
{
    return tetra::cancelledError(Message::marked("The film"));
}

/// Makes scenes one after the other, waiting for each; the last one is used again as long as it fits. Lives in the
/// worker.
class SceneSource {
public:
    Result<BuiltScene> make(const SceneRequest& request, const Progress& progress)
    {
        const bool isSame = made_ && request.query == last_.query && request.values == last_.values;
        if (isSame)
            return *made_;
        Result<BuiltScene> result = cancelledError();
        const auto ready = QObject::connect(&builder_, &SceneBuilder::sceneReady, &loop_, [&](const BuiltScene& scene) {
            result = scene;
            loop_.quit();
        });
        const auto failed = QObject::connect(&builder_, &SceneBuilder::failed, &loop_, [&](const Error& error) {
            result = error;
            loop_.quit();
        });
        QTimer asking;
        QObject::connect(&asking, &QTimer::timeout, &loop_, [&] {
            if (progress.cancelled())
                loop_.quit();
        });
        asking.start(askEvery);
        builder_.request(request);
        loop_.exec();
        QObject::disconnect(ready);
        QObject::disconnect(failed);
        if (result) {
            made_ = *result;
            last_ = request;
        }
        return result;
    }

private:
    QEventLoop loop_; ///< first: timers need its dispatcher
    SceneBuilder builder_;
    SceneRequest last_;
    std::optional<BuiltScene> made_;
};

Result<QImage> drawFrame(const FilmOrder& order, const FilmFrame& frame, SceneSource& scenes, const Progress& progress)
{
    const auto built = scenes.make(sceneOf(order, frame), progress);
    if (!built)
        return built.error();
    PictureOrder picture = order.picture;
    picture.scene = built->scene;
    picture.camera = frame.camera;
    if (order.finish)
        picture.finish = [&](QImage& image) { order.finish(image, frame, built->mesh); };
    return drawPicture(picture, progress);
}

std::filesystem::path numbered(const std::filesystem::path& folder, int frame)
{
    return folder / QString::asprintf(framePattern, frame).toStdString();
}

Status drawFrames(const FilmOrder& order, const std::filesystem::path& folder, const Progress& progress)
{
    SceneSource scenes;
    const int count = frameCount(order.animation);
    for (int i = 0; i < count; ++i) {
        progress.report(static_cast<double>(i) / count, {});
        const auto image =
            drawFrame(order, frameOf(order.animation, order.start, i), scenes, progress.withCallback({}));
        if (!image)
            return image.error();
        if (progress.cancelled())
            return cancelledError();
        if (const Status written = writePicture(*image, numbered(folder, i)); !written)
            return written;
    }
    return {};
}

Status moveTo(const std::filesystem::path& from, const std::filesystem::path& target)
{
    std::error_code error;
    std::filesystem::rename(from, target, error);
    if (!error)
        return {};
    return Error{ErrorKind::CannotWrite, Message::say("'%1' cannot be written: %2. Choose another place.",
                                                      target.string(), systemErrorText(error.value()))};
}

Status nameFrames(const FilmOrder& order, const std::filesystem::path& folder)
{
    const int count = frameCount(order.animation);
    for (int i = 0; i < count; ++i)
        if (const Status moved = moveTo(numbered(folder, i), framePath(order.target, i, count)); !moved)
            return moved;
    return {};
}

Status encode(const FilmOrder& order, const std::filesystem::path& folder, const Progress& progress)
{
    std::filesystem::path film = "film";
    film += order.target.extension();
    const auto arguments = encoderArguments(framePattern, order.animation.framesPerSecond, pathText(film));
    progress.report(0, {});
    if (const Status encoded = encodeVideo(order.encoder, arguments, folder, progress); !encoded)
        return encoded;
    return moveTo(folder / film, behindLinks(order.target));
}

} // namespace

SceneRequest sceneOf(const FilmOrder& order, const FilmFrame& frame)
{
    SceneRequest request = order.scene;
    request.query = meshQuery(corrected(queryOf(frame, order.query), order.query, *request.model), *request.model);
    Look look = order.look;
    look.transfer = frame.transfer;
    request.values = rendererValues(order.parameters, look, frame.isovalues);
    return request;
}

std::filesystem::path framePath(const std::filesystem::path& target, int frame, int count)
{
    const int digits = std::max(leastDigits, static_cast<int>(QString::number(count).size()));
    const QString number = QString("%1").arg(frame + 1, digits, 10, QChar('0'));
    return target.parent_path() / filePath(pathText(target.stem()) + '_' + number + pathText(target.extension()));
}

std::vector<std::filesystem::path> filesInTheWay(const std::filesystem::path& target, int count)
{
    std::error_code failed;
    if (isVideoFile(target))
        return std::filesystem::exists(target, failed) ? std::vector{target} : std::vector<std::filesystem::path>();
    const QString begin = pathText(target.stem()) + '_';
    const QString end = pathText(target.extension());
    std::vector<std::filesystem::path> files;
    for (const std::filesystem::path& path : pathsIn(target.parent_path(), failed)) {
        const QString name = pathText(path.filename());
        if (!name.startsWith(begin) || !name.endsWith(end))
            continue;
        const int frame = name.mid(begin.size()).chopped(end.size()).toInt();
        if (frame > 0 && frame <= count && filePath(name) == framePath(target, frame - 1, count).filename())
            files.push_back(target.parent_path() / filePath(name));
    }
    std::ranges::sort(files);
    return files;
}

Status writeFilm(const FilmOrder& order, const Progress& progress)
{
    if (frameCount(order.animation) == 0)
        return Error{ErrorKind::WrongUsage, Message::say("A film needs two key frames at least. Add another view.")};
    std::filesystem::path beside = behindLinks(order.target);
    beside += ".frames";
    const auto folder = WorkFolder::open(beside, WorkFolder::Leftovers::Remove);
    if (!folder)
        return folder.error();
    const bool isVideo = isVideoFile(order.target);
    if (const Status drawn = drawFrames(order, folder->path(), progress.part(0, isVideo ? drawingPart : 1)); !drawn)
        return drawn;
    if (const Status right = order.scene.model->confirm(progress.withCallback({})); !right)
        return right;
    return isVideo ? encode(order, folder->path(), progress.part(drawingPart, 1)) : nameFrames(order, folder->path());
}

} // namespace tetra
