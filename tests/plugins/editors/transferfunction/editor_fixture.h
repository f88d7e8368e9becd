// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/editors/transferfunction/transfer_canvas.h"
#include "tests/core/render/scene_parts.h"
#include "tests/ui/window_fixture.h"

#include <tan/transfer.h>

#include <QAbstractButton>
#include <QApplication>
#include <QDialog>

namespace tetra {

/// The window with a small model as a volume, and the editor that it has loaded as a plugin.
class EditorFixture : public WindowFixture {
public:
    explicit EditorFixture(const QString& model)
    {
        window.resize(1366, 768);
        window.show();
        window.open(model);
        [&] { QTRY_VERIFY(session().model() && settled()); }();
        session().setTransfer(
            sequentialTransferFunction(session().range().minimum, session().range().maximum, function().unitDistance));
        // In the plot the isovalue stands where no test drags anything.
        Isovalue isovalue = session().view().isovalues.front();
        isovalue.value = (session().range().minimum + session().range().maximum) / 2;
        session().setIsovalue(0, isovalue);
        find<QAction>("action.mode.volume").trigger();
        [&] { QTRY_VERIFY(settled() && testing::partsOf(*viewport().scene()).volume); }();
        opened_ = session().model();
        session().undoStack().clear();
        start_ = session().view();
    }

    /// Brings back what was there at first, and says whether that is so; then another test can begin.
    bool goBack() const
    {
        while (QWidget* popup = QApplication::activePopupWidget())
            popup->close();
        for (QDialog* dialog : window.findChildren<QDialog*>())
            dialog->close();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        find<MessageBar>("messages").clear();
        if (session().model() != opened_)
            return false;
        session().endGesture();
        session().undoStack().setIndex(0);
        session().undoStack().clear();
        state().setCurrent({});
        state().setRule(NeighbourRule::Stop);
        state().setView({});
        state().host().forgetPicked();
        find<QAbstractButton>("transfer.logarithmic").setChecked(true);
        find<QAbstractButton>("transfer.table.show").setChecked(false);
        for (const char* action :
             {"transfer.axis.squareRoot", "transfer.valueAxis.linear", "transfer.change.rule.stop"})
            find<QAction>(action).trigger();
        QEvent leave(QEvent::Leave);
        QCoreApplication::sendEvent(&canvas(), &leave);
        return session().view() == start_; // its picture is drawn while the next test has begun
    }

    Session& session() const { return workbench.session(); }
    const TransferFunction& transfer() const { return session().view().appearance.transfer; }
    /// As the editor shows it.
    JoinedFunction function() const { return joined(transfer()); }
    int undoSteps() const { return session().undoStack().index(); }
    void undo() const { find<QAction>("action.undo").trigger(); }
    /// The plugin has the class's meta-object twice, so that qobject_cast knows only its own: the name tells.
    TransferCanvas& canvas() const { return static_cast<TransferCanvas&>(find<QWidget>("transfer.canvas")); }
    EditorState& state() const { return canvas().state(); }
    QPoint placeOf(std::size_t point) const { return canvas().plot().place(function(), point).toPoint(); }
    /// With the left button down.
    void dragTo(QPoint place, Qt::KeyboardModifiers modifiers = {}) const
    {
        QMouseEvent move(QEvent::MouseMove, place, canvas().mapToGlobal(place), Qt::NoButton, Qt::LeftButton,
                         modifiers);
        QCoreApplication::sendEvent(&canvas(), &move);
    }
    void drag(QPoint from, QPoint to, Qt::KeyboardModifiers modifiers = {}) const
    {
        QTest::mousePress(&canvas(), Qt::LeftButton, modifiers, from);
        dragTo((from + to) / 2, modifiers);
        dragTo(to, modifiers);
        QTest::mouseRelease(&canvas(), Qt::LeftButton, modifiers, to);
    }

private:
    std::shared_ptr<const Model> opened_;
    ViewValue start_;
};

/// An editor as it is at first: the one that a test before has used, if that can go back.
inline void startAnew(std::unique_ptr<EditorFixture>& editor, const QString& model)
{
    if (!editor || !editor->goBack())
        editor = std::make_unique<EditorFixture>(model);
}

/// The model that the fixture opens, in `folder`.
inline QString editorModel(const QTemporaryDir& folder, const char* application)
{
    QCoreApplication::setOrganizationName("TAn");
    QCoreApplication::setApplicationName(application);
    QSettings().clear();
    QLocale::setDefault(QLocale::c());
    return QString::fromStdString(
        buildSampleModel(*hostOfThisBuild(), sampleDataset(12), folder.path().toStdString()).string());
}

} // namespace tetra
