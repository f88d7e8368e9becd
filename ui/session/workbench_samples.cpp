// SPDX-License-Identifier: GPL-3.0-or-later
// Samples: models that the program makes itself, to try things without data.
#include "ui/session/sample_models.h"
#include "ui/session/target_path.h"
#include "ui/session/workbench.h"

#include <utility>

namespace tetra {

void Workbench::openSample(const std::string& name)
{
    sampling_.start([this, name](const Progress& progress) -> std::function<void()> {
        return [this, model = sampleModel(host_, name, sampleFolder(), progress)] {
            if (model)
                open(pathText(*model));
            else
                tell(model.error());
        };
    });
}

void Workbench::drawThumbnails()
{
    if (std::exchange(thumbnailsWanted_, true))
        return;
    if (reading_.running()) // what the user waits for comes first
        connect(&reading_, &LongTask::finished, this, &Workbench::startThumbnails, Qt::SingleShotConnection);
    else
        startThumbnails();
}

void Workbench::startThumbnails()
{
    thumbnails_.start([this](const Progress& progress) -> std::function<void()> {
        for (const SampleCard& card : sampleCards()) {
            // A sample without a picture still has its name; what is wrong is told by whoever opens it.
            const auto picture = sampleThumbnail(host_, card.name, sampleFolder(), progress.withCallback({}));
            if (progress.cancelled())
                break;
            if (picture)
                QMetaObject::invokeMethod(
                    this, [this, name = card.name, image = *picture] { emit thumbnailDrawn(name, image); },
                    Qt::QueuedConnection);
        }
        return [] {};
    });
}

} // namespace tetra
