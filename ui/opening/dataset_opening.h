// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/host/build_estimate.h"
#include "plugins/host/plugin_host.h"
#include "ui/opening/import_question.h"
#include "ui/opening/reading.h"

#include <tan/data.h>

#include <filesystem>
#include <memory>
#include <vector>

namespace tetra {

/// Opens datasets, the source of what is built, and has the one that is open.
class DatasetOpening : public QObject {
    Q_OBJECT
public:
    /// Both outlive it; `reading` need not be there before something is read.
    DatasetOpening(PluginHost& host, Reading& reading);

    /// Asks by choicesNeeded() how a dataset is to be read, whether it must be known or not.
    void openWithOptions(const std::filesystem::path& path);
    /// The same for the file of the dataset that is open.
    void readDifferently();
    /// Opens a dataset so; ends with datasetOpened() or importFailed().
    void importDataset(const std::filesystem::path& path, const ImportOptions& options);

    /// The dataset that models can be built of; none before one was opened.
    const std::shared_ptr<const Dataset>& dataset() const noexcept { return dataset_; }
    /// How it was opened.
    const ImportOptions& importOptions() const noexcept { return imported_; }
    /// What each of the host's builders says of the dataset, in their order: asked when it was read, not while somebody
    /// waits.
    const std::vector<Acceptance>& acceptances() const noexcept { return acceptances_; }
    /// What building it is expected to take follows from this; zeros without one. Made in the worker that read it.
    const BuildSize& buildSize() const noexcept { return buildSize_; }
    /// Whether a model was built of the dataset that is open.
    bool isBuilt() const noexcept { return dataset_ && dataset_ == built_; }
    void setBuilt(const std::shared_ptr<const Dataset>& dataset) { built_ = dataset; }
    /// A dataset that is in use is not closed.
    void setInUse(bool inUse) { inUse_ = inUse; }
    bool canClose() const noexcept { return dataset_ && !inUse_; }
    /// Closes the dataset, if there is one and it is not in use.
    void close();

    /// In a worker: what is to be done with a file that may hold a dataset. `asks`: its choices are wanted in any case.
    std::function<void()> whenRead(const std::filesystem::path& path, bool asks, const Progress& progress);

signals:
    void datasetOpened();
    void datasetClosed();
    void choicesNeeded(const tetra::ImportQuestion& question);
    /// Why the reader refuses the choices; empty if the user stopped it.
    void importFailed(const QString& reason);

private:
    struct ReadDataset {
        Result<Dataset> dataset;
        BuildSize size;
        ImportOptions options;
        std::vector<Acceptance> acceptances{}; ///< by the builders, in their order
    };

    ReadDataset readDataset(const std::filesystem::path& path, const ImportOptions& options,
                            const Progress& progress) const;
    std::function<void()> whenImported(const std::filesystem::path& path, const ImportOptions& options,
                                       const Progress& progress);
    void datasetRead(const std::filesystem::path& path, const ReadDataset& read);
    void take(const std::filesystem::path& path, const ReadDataset& read);

    PluginHost& host_;
    Reading& reading_;
    std::shared_ptr<const Dataset> dataset_;
    BuildSize buildSize_{.points = 0};
    ImportOptions imported_;
    std::vector<Acceptance> acceptances_;
    std::shared_ptr<const Dataset> built_; ///< that a model was built of last
    bool inUse_ = false;
};

} // namespace tetra
