// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/picture/annotations/annotation_content.h"
#include "plugins/host/plugin_host.h"
#include "ui/scenes/error_measuring.h"
#include "ui/scenes/scene_builder.h"
#include "ui/session/session.h"

#include <tan/data.h>

#include <QSize>
#include <QTimer>

#include <optional>
#include <string>

namespace tetra {

/// A transfer function, and the parameter that it is of.
struct EditedTransfer {
    std::string id;
    TransferFunction function;
};

/// The scene of what the session shows, kept up to date in workers, with coarser drafts of it for moving pictures; and
/// what there is to say of it. All signals come in the thread that it lives in.
class SceneService : public QObject {
    Q_OBJECT
public:
    /// Both outlive it.
    SceneService(PluginHost& host, Session& session);
    ~SceneService() override;

    /// Drops what is shown and finds the ways to show another model, of such an extent, which is opened next. False if
    /// there is none, which is told by failed(); then nothing changes.
    bool prepare(const FieldExtent& field);
    /// The session's model has grown to this.
    void setExtent(const FieldExtent& field) { field_ = field; }
    void clear();

    SceneBuilder& sceneBuilder() noexcept { return sceneBuilder_; }
    DraftBuilder& draftBuilder() noexcept { return draftBuilder_; }
    /// The ways to look at a model; empty before the first one was opened.
    const std::vector<Provided<Renderer>>& modes() const noexcept { return modes_; }
    /// The one that is in use; null if it is not there.
    const Renderer* renderer() const;
    /// Its parameters, fitting the model; empty without one.
    std::vector<Parameter> renderingParameters() const;
    /// Those of them that matter as they are set.
    std::vector<Parameter> matteringParameters() const;
    /// What a drag or a key in the picture edits: the transfer function that is chosen in the editor, or else the
    /// mode's main one; none where the mode has none.
    std::optional<EditedTransfer> editedTransfer() const;
    /// This one is chosen from now on, wherever a mode has it.
    void editTransfer(const std::string& id) { wantedTransfer_ = id; }
    const FieldExtent& extent() const noexcept { return field_; }
    /// What a picture of this view of the model frames; none: all of the model.
    std::vector<Eigen::Vector3d> framedObject(const ViewValue& view) const;
    /// How `model`, for which this was prepared, is seen if nobody has ever looked at it.
    ViewValue startingView(const Model& model) const;
    /// The same of the session's model. There must be one.
    ViewValue startingView() const { return startingView(*session_.model()); }
    /// From where the model is seen, in a picture of this size in pixels: for renderers whose scenes depend on it.
    void setSeenFrom(const Camera& camera, QSize pixels);
    /// The scene of the session's own view, seen from there.
    SceneRequest sessionRequest() const;
    /// The scene of what is seen now: of the view that is previewed, if there is one.
    SceneRequest sceneRequest() const;
    /// What of a scene of the session's view is within the error of its mesh.
    std::vector<ErrorRemark> errorRemarks(const BuiltScene& scene) const;
    /// What the annotations of a picture of what is shown say, seen by `camera` before `background`.
    AnnotationContent annotations(const Camera& camera, const Colour& background) const;
    /// Those of what is written over pictures; null if the system has none.
    const std::shared_ptr<const Fonts>& fonts() const noexcept { return fonts_; }
    /// Shows another view, such as of a film, in place of the session's; nothing: that again. The camera is the
    /// viewport's.
    void previewView(const std::optional<ViewValue>& view);
    const std::optional<ViewValue>& previewedView() const noexcept { return preview_; }

signals:
    void failed(const QString& text);

private:
    SceneRequest requestOf(ViewValue view) const;
    void requestScene();
    void followCamera();
    void requestDrafts(const BuiltScene& scene);

    PluginHost& host_;
    Session& session_;
    std::vector<Provided<Renderer>> modes_;
    FieldExtent field_;          ///< of the model that is open
    std::string wantedTransfer_; ///< to be edited, if the mode has it
    std::optional<ViewValue> preview_;
    Camera settled_;  ///< that error fields see (C3): the view's, when it has come to rest
    QTimer settling_; ///< while that moves
    Camera camera_;   ///< setSeenFrom() with these
    QSize pixels_{1024, 768};
    SceneBuilder sceneBuilder_;
    DraftBuilder draftBuilder_;
    ErrorMeasuring errors_;
    std::shared_ptr<const Fonts> fonts_; ///< the window's; null if the system has none
};

} // namespace tetra
