// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/api/parameter.h"
#include "ui/session/animation.h"
#include "ui/session/annotation_state.h"
#include "ui/session/look.h"
#include "ui/session/query_state.h"

#include <QObject>

#include <vector>

namespace tetra {

/// What the user has chosen to see of a model, apart from the camera: which mesh, how it is looked at, the
/// isovalues, what is written over the picture, and a film. Tells every change; Session makes the changes undoable. An
/// index is a position in isovalues().
class ViewState : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

    const QueryState& query() const noexcept { return query_; }
    const Look& look() const noexcept { return look_; }
    double error() const noexcept { return query_.error; } ///< % of the value range
    const std::vector<Isovalue>& isovalues() const noexcept { return isovalues_; }
    int isovalueCount() const noexcept { return static_cast<int>(isovalues_.size()); }

    const AnnotationState& annotations() const noexcept { return annotations_; }
    const Animation& animation() const noexcept { return animation_; }

    /// The annotations stay; there is no film any more.
    void reset(const QueryState& query, std::vector<Isovalue> isovalues, Look look);
    void setQuery(const QueryState& query);
    void setLook(const Look& look);
    void setAnnotations(const AnnotationState& annotations);
    void setAnimation(const Animation& animation);
    void insertIsovalue(int index, const Isovalue& isovalue);
    void removeIsovalue(int index);
    void setIsovalue(int index, const Isovalue& isovalue);

signals:
    void wasReset();
    void queryChanged();
    void lookChanged();
    void annotationsChanged();
    void animationChanged();
    void isovalueInserted(int index);
    void isovalueRemoved(int index);
    void isovalueChanged(int index);

private:
    QueryState query_;
    Look look_;
    std::vector<Isovalue> isovalues_;
    AnnotationState annotations_;
    Animation animation_;
};

} // namespace tetra
