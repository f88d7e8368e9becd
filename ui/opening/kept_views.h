// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/picture/session_document.h"
#include "ui/work/long_task.h"

#include <QLockFile>

#include <map>
#include <mutex>

namespace tetra {

/// How something was seen that was open in a program which did not end as it should, or which was ended before a
/// session could be saved.
struct LostView {
    std::filesystem::path path; ///< of the file that keeps it
    SessionDocument document;
    bool wasEnded = false; ///< by the system, say; there was no mishap
};

/// How models were seen, a small file each in a folder of the user's data, so that it is back when they are opened
/// again. A file belongs to what is open, by its path: to a model, or to a session whose changes are not saved yet.
///
/// What is open is locked, by a file beside its own. A lock whose program is gone says that this did not end as it
/// should; then the view is set aside as a lost one, to be offered, so that a view that ends the program does not
/// come back by itself.
///
/// Files are written in a worker, in the order of the calls, whole or not at all, and before this is destroyed. Others
/// that run at the same time may use the same folder. The newest two hundred files of one year are kept.
class KeptViews : public QObject {
    Q_OBJECT
public:
    /// `folder` is made when it is needed.
    explicit KeptViews(std::filesystem::path folder, QObject* parent = nullptr);
    ~KeptViews() override;

    const std::filesystem::path& folder() const noexcept { return folder_; }

    /// `what` is open, and seen like this.
    void keep(const std::filesystem::path& what, const SessionDocument& document);
    /// Nothing is open any more; the view of what was stays as it was kept last.
    void release();
    /// The program is being ended, and the session `what` is seen like this, with changes that its file does not have:
    /// they are offered the next time. keep() or forget() takes that back.
    void setAside(const std::filesystem::path& what, const SessionDocument& document);
    /// How `what` was seen is not wanted any more, nor is it open.
    void forget(const std::filesystem::path& what);
    /// How `what` was seen last, also if that is still being written; nothing if that is not known or not readable. For
    /// any thread but that of the GUI.
    std::optional<SessionDocument> find(const std::filesystem::path& what) const;

    /// What programs left behind, newest first; the first programs, too, which had another folder for it.
    std::vector<LostView> lost() const;
    /// It was restored, or is not wanted. Of other files than those of lost views nothing happens.
    void removeLost(const std::filesystem::path& path) const;
    /// All is written.
    bool idle() const noexcept { return !writing_.running(); }

signals:
    /// A view cannot be kept; once, until one can be again.
    void failed(const QString& text);

private:
    struct Pending {
        quint64 number = 0;
        std::optional<std::string> text; ///< none: the file goes
    };
    enum class Place { Open, Aside };

    /// Without a text the file goes.
    void write(const std::filesystem::path& what, const std::optional<std::string>& text, Place place = Place::Open);
    Status writeNow(const std::filesystem::path& what, const std::optional<std::string>& text, Place place);
    Status setAsideNow(const QString& file, const std::string& text);
    void lock(const QString& file);
    void written(const std::filesystem::path& what, quint64 number, const Status& status);
    void removeOld() const;

    std::filesystem::path folder_;
    mutable std::mutex mutex_; ///< guards the next one
    std::map<std::filesystem::path, Pending> pending_;
    quint64 newest_ = 0;
    bool told_ = false;
    QString aside_;                   ///< the file of what this program has set aside; the worker's, as the next two
    QString locked_;                  ///< the file of what is open
    std::unique_ptr<QLockFile> lock_; ///< held by this program
    LongTask writing_;                ///< last: ends before what it uses
};

/// Where this user's programs keep them.
std::filesystem::path viewFolder();

} // namespace tetra
