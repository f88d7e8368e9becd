// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/view_state.h"

namespace tetra {

void ViewState::reset(const QueryState& query, std::vector<Isovalue> isovalues, Look look)
{
    query_ = query;
    look_ = std::move(look);
    isovalues_ = std::move(isovalues);
    animation_ = {};
    emit wasReset();
}

void ViewState::setQuery(const QueryState& query)
{
    query_ = query;
    emit queryChanged();
}

void ViewState::setLook(const Look& look)
{
    look_ = look;
    emit lookChanged();
}

void ViewState::setAnnotations(const AnnotationState& annotations)
{
    annotations_ = annotations;
    emit annotationsChanged();
}

void ViewState::setAnimation(const Animation& animation)
{
    animation_ = animation;
    emit animationChanged();
}

void ViewState::insertIsovalue(int index, const Isovalue& isovalue)
{
    isovalues_.insert(isovalues_.begin() + index, isovalue);
    emit isovalueInserted(index);
}

void ViewState::removeIsovalue(int index)
{
    isovalues_.erase(isovalues_.begin() + index);
    emit isovalueRemoved(index);
}

void ViewState::setIsovalue(int index, const Isovalue& isovalue)
{
    isovalues_[static_cast<std::size_t>(index)] = isovalue;
    emit isovalueChanged(index);
}

} // namespace tetra
