// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/opening/samples.h"

#include "ui/opening/sample_models.h"
#include "ui/session/files.h"

#include <utility>

namespace tetra {

Samples::Samples(PluginHost& host, Reading& reading) : host_(host), reading_(reading) {}

void Samples::open(const std::string& name)
{
    making_.start([this, name](const Progress& progress) -> std::function<void()> {
        return [this, model = sampleModel(host_, name, sampleFolder(), progress)] {
            if (model)
                emit made(pathText(*model));
            else
                reading_.tell(model.error());
        };
    });
}

void Samples::drawThumbnails()
{
    if (std::exchange(thumbnailsWanted_, true))
        return;
    if (reading_.running()) // what the user waits for comes first
        connect(&reading_.task(), &LongTask::finished, this, &Samples::startThumbnails, Qt::SingleShotConnection);
    else
        startThumbnails();
}

void Samples::startThumbnails()
{
    drawing_.start([this](const Progress& progress) -> std::function<void()> {
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
