// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/opening/damage_watch.h"
#include "ui/opening/dataset_opening.h"
#include "ui/opening/kept_views.h"
#include "ui/opening/model_opening.h"
#include "ui/opening/reading.h"
#include "ui/opening/samples.h"
#include "ui/opening/session_file.h"
#include "ui/opening/session_opening.h"

#include <QStringList>

namespace tetra {

/// Opens whatever a file holds, a model, a session or a dataset, and closes it: the front of those that can do this,
/// which share one reading. What is read is read in a worker, the newest only; what was read passes a gate before it
/// takes the place of what is open.
class Opening : public QObject {
    Q_OBJECT
public:
    /// All outlive it. How models are seen is kept in the folder `views`.
    Opening(PluginHost& host, Session& session, SceneService& scenes, std::filesystem::path views);
    ~Opening() override;

    Reading& reading() noexcept { return reading_; }
    ModelOpening& models() noexcept { return models_; }
    DatasetOpening& datasets() noexcept { return datasets_; }
    const DatasetOpening& datasets() const noexcept { return datasets_; }
    SessionOpening& sessions() noexcept { return sessions_; }
    SessionFile& sessionFile() noexcept { return sessionFile_; }
    Samples& samples() noexcept { return samples_; }
    /// How models are seen that are not part of a session.
    KeptViews& views() noexcept { return views_; }

    /// Filters for a file dialog: all that can be opened first.
    QStringList nameFilters();
    /// Opens a model, a session, or a dataset by the reader that fits it best; asks by DatasetOpening::choicesNeeded()
    /// where there is a choice.
    void open(const QString& path);
    /// The same, but asks how a dataset is to be read whether it must be known or not.
    void openWithOptions(const QString& path);
    /// Where a file about the model goes unless the user says otherwise: beside it, or while its build is watched to
    /// where it will be; of a sample to the user's documents. `ending` follows the model's name. There must be a model.
    QString proposedPath(const QString& ending) const;

    /// Whether there is something to close.
    bool hasSomethingOpen() const { return session_.model() || datasets_.canClose(); }
    /// Closes the model, and with it the dataset that it was built of; without a model the dataset.
    void close();

signals:
    /// Something could not be opened or shown, by whichever of them.
    void failed(const QString& text);
    /// A session was not saved.
    void saveFailed(const QString& text);
    /// A picture was opened that holds the session by which it was made.
    void pictureOpened(const QString& path);

private:
    PluginHost& host_;
    Session& session_;
    KeptViews views_;
    DamageWatch damage_;
    SessionFile sessionFile_;
    ModelOpening models_;
    DatasetOpening datasets_;
    SessionOpening sessions_;
    Samples samples_;
    Reading reading_; ///< last: its worker ends before those that it works for
};

} // namespace tetra
