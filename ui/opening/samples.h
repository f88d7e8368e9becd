// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/host/plugin_host.h"
#include "ui/opening/reading.h"

#include <QImage>

#include <string>

namespace tetra {

/// Makes samples (sampleKinds()), and draws small pictures of them.
class Samples : public QObject {
    Q_OBJECT
public:
    /// Both outlive it; `reading` need not be there before something is asked for.
    Samples(PluginHost& host, Reading& reading);

    /// Makes the sample of that name unless it is there from before; its model is to be opened by whoever hears made().
    void open(const std::string& name);
    LongTask& making() noexcept { return making_; }
    /// Draws small pictures of the samples in a worker, once, each told by thumbnailDrawn(). While a file is read they
    /// wait until it has been.
    void drawThumbnails();
    LongTask& drawing() noexcept { return drawing_; }

signals:
    void made(const QString& model);
    void thumbnailDrawn(const std::string& sample, const QImage& picture);

private:
    void startThumbnails();

    PluginHost& host_;
    Reading& reading_;
    bool thumbnailsWanted_ = false;
    LongTask making_;
    LongTask drawing_;
};

} // namespace tetra
