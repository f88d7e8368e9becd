// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/opening/session_file.h"

#include "core/picture/text_file.h"
#include "ui/opening/recent_files.h"
#include "ui/session/files.h"
#include "ui/session/message_text.h"

namespace tetra {

QString sentencesOf(std::span<const SessionDifference> differences)
{
    QString list;
    for (const SessionDifference& difference : differences)
        list += ' ' + translatedMessage(difference.text);
    return list;
}

void SessionFile::set(const std::filesystem::path& path)
{
    path_ = path;
    if (path.empty())
        found_ = {};
    emit changed();
}

void SessionFile::take(const RestoredView& restored, const OpenedModel& opened)
{
    const SessionDocument& document = restored.document;
    const bool isLost = opened.source == SessionSource::Lost && !document.file.empty();
    const bool isAll = restored.differences.empty();
    if (opened.source == SessionSource::File || isLost) {
        const std::filesystem::path& file = isLost ? document.file : opened.from;
        addRecentFile(pathText(file));
        if (isAll) {
            found_ = document.found;
            set(file);
        }
    }
    if (isLost || opened.isLocated)
        session_.undoStack().resetClean(); // the file does not have what was lost, or says another place
    QStringList told;
    const bool isWhole = opened.sitesOfWhole == 0;
    if (const auto other = differentModel(document, *opened.model); other && isWhole)
        told << translatedMessage(other->text);
    if (!isAll)
        told << tr("Not all of the session could be kept.") + sentencesOf(restored.differences)
             << (opened.source == SessionSource::Lost
                     ? tr("It will be offered again the next time.")
                     : tr("The session %1 is not changed; saving will ask for another file name.")
                           .arg(shownName(opened.from)));
    else if (!told.isEmpty())
        told << tr("The view saved in the session is applied.");
    if (!told.isEmpty())
        emit failed(told.join(' '));
}

void SessionFile::save(const std::filesystem::path& target, const SessionDocument& document,
                       const std::function<void(bool saved)>& then)
{
    session_.undoStack().setClean();
    const std::string text = sessionToText(document, std::filesystem::absolute(target).parent_path());
    saving_.enqueue([this, target, text, then, model = session_.model()](const Progress&) -> std::function<void()> {
        return [this, target, then, model, written = writeTextFile(target, text)] {
            const bool isOpen = session_.model() == model;
            if (!written) {
                if (isOpen)
                    session_.undoStack().resetClean();
                emit saveFailed(translatedMessage(written.error().message));
            } else {
                if (isOpen)
                    set(target);
                addRecentFile(pathText(target));
                emit saved(pathText(target));
            }
            if (then)
                then(written.ok());
        };
    });
}

} // namespace tetra
