// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/scenes/scene_builder.h"
#include "ui/viewport/canvas.h"

#include <QTimer>

#include <span>

class QLabel;
class QProgressBar;
class QStatusBar;

namespace tetra {

/// Fills the status bar: the file, what is drawn and what it costs. Its labels are named status.file, .picked, .errors,
/// .remarks, .sites, .tetrahedra, .triangles, .frame, .extraction, .memory and .backend.
class StatusLine : public QObject {
    Q_OBJECT
public:
    explicit StatusLine(QStatusBar* bar);

    /// An empty name: nothing is open.
    void setFile(const QString& name, const QString& path, bool isAtServer);
    /// What of the scene its mesh's error alone may have made.
    void setRemarks(std::span<const ErrorRemark> remarks, const ModelDescription& model);
    /// Nothing is said of a scene any more: what is open is another one.
    void clearScene();
    void setScene(const BuiltScene& scene);
    /// The errors of the mesh that is shown, which may become known later than its scene.
    void setErrors(const ShownMesh& mesh, const Model& model);
    void setFrame(const FrameReport& report);
    void setBackend(const QString& name);
    /// The value that was picked in the picture and where it is; empty: none.
    void setPicked(const QString& text);
    void setBusy(bool busy);

private:
    static QString movingText(const FrameReport& report);
    QLabel* add(const char* name, const QString& toolTip);
    void showMemory();

    QStatusBar* bar_;
    QLabel* file_;
    QProgressBar* busy_;
    QLabel* picked_;
    QLabel* errors_;
    QLabel* remarks_;
    QLabel* sites_;
    QLabel* tetrahedra_;
    QLabel* triangles_;
    QLabel* extraction_;
    QLabel* frame_;
    QLabel* memory_;
    QLabel* backend_;
    QTimer busyShown_;
    QTimer memoryShown_;
};

} // namespace tetra
