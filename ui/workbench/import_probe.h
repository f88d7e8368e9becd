// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/host/import_options.h"
#include "plugins/host/plugin_host.h"
#include "ui/work/latest_job.h"

#include <QObject>

#include <filesystem>

namespace tetra {

/// Looks into files for what there is to choose, in a worker: the newest request wins.
class ImportProbe : public QObject {
    Q_OBJECT
public:
    /// `host` outlives it.
    explicit ImportProbe(PluginHost& host, QObject* parent = nullptr) : QObject(parent), host_(host) {}

    void request(const std::filesystem::path& path, const ImportOptions& options);

signals:
    /// Of the newest request.
    void probed(const tetra::Result<tetra::FileContents>& contents);

private:
    PluginHost& host_;
    std::uint64_t newest_ = 0;
    LatestJob job_; ///< last: ends before what it uses
};

} // namespace tetra
