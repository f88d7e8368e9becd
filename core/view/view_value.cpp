// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/view/view_value.h"

#include <tan/view.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace tetra {
namespace {

/// In the order of ViewPart.
template <class View> auto viewParts(View& view)
{
    return std::tie(view.query, view.appearance.mode, view.appearance.transfer, view.appearance.settings,
                    view.isovalues, view.annotations, view.animation, view.camera, view.background, view.lens,
                    view.tools, view.bookmarks);
}

constexpr auto partCount = std::tuple_size_v<decltype(viewParts(std::declval<const ViewValue&>()))>;

/// Calls `call` with the number of each part, as a constant.
template <class Call> void forEachPart(Call call)
{
    [&]<std::size_t... Part>(std::index_sequence<Part...>)
    {
        (call(std::integral_constant<std::size_t, Part>()), ...);
    }
    (std::make_index_sequence<partCount>());
}

constexpr ViewPart partNumbered(std::size_t number)
{
    return static_cast<ViewPart>(1U << number);
}

} // namespace

bool isUsable(const BarEnds& ends)
{
    return std::isfinite(ends.least) && std::isfinite(ends.largest) && ends.least < ends.largest &&
           std::isfinite(ends.largest - ends.least);
}

Camera usualCamera(const ModelDescription& description)
{
    constexpr double flat = 0.4, elevationOfFlat = 50;
    const Lattice& lattice = description.lattice;
    const bool isPlain = description.domain == DomainClass::RegularLattice && lattice.isAlongAxes() &&
                         lattice.origin == Eigen::Vector3d::Zero() && lattice.spacing == Eigen::Vector3d::Ones();
    if (isPlain)
        return {.up = UpAxis::Y};
    const Eigen::Vector3d extent = description.bounds.sizes();
    return extent.z() < flat * std::min(extent.x(), extent.y()) ? Camera{.elevation = elevationOfFlat} : Camera();
}

AnnotationState ofOtherData(AnnotationState annotations)
{
    annotations.barEnds.reset();
    for (const auto text : {&AnnotationState::title, &AnnotationState::quantity, &AnnotationState::unit})
        (annotations.*text).clear();
    return annotations;
}

ViewParts differingParts(const ViewValue& one, const ViewValue& other)
{
    ViewParts differing;
    forEachPart([&](auto part) {
        if (std::get<part>(viewParts(one)) != std::get<part>(viewParts(other)))
            differing |= partNumbered(part);
    });
    return differing;
}

PartialView::PartialView(const ViewValue& view, ViewParts parts)
{
    forEachPart([&](auto part) {
        if (parts & partNumbered(part))
            parts_.emplace_back(std::in_place_index<part>, std::get<part>(viewParts(view)));
    });
}

ViewValue PartialView::putInto(ViewValue view) const
{
    for (const Part& part : parts_)
        std::visit([&](const auto& value) { std::get<std::decay_t<decltype(value)>&>(viewParts(view)) = value; }, part);
    return view;
}

ViewParts PartialView::parts() const
{
    ViewParts parts;
    for (const Part& part : parts_)
        parts |= partNumbered(part.index());
    return parts;
}

void PartialView::complete(const PartialView& others)
{
    const ViewParts own = parts();
    for (const Part& part : others.parts_)
        if (!(own & partNumbered(part.index())))
            parts_.push_back(part);
    std::ranges::sort(parts_, {}, &Part::index);
}

PresentView presentView(const ViewValue& view)
{
    PresentView present{eyePosition(view.camera), {}, opacityKnots(view.appearance.transfer)};
    for (const Isovalue& isovalue : view.isovalues)
        if (isovalue.visible)
            present.isovalues.push_back(isovalue.value);
    return present;
}

FilmFrame frameOf(const ViewValue& view)
{
    return {view.camera,      view.appearance.transfer, view.isovalues,
            view.query.error, view.query.byBudget,      view.query.budget};
}

ViewValue withFrame(ViewValue view, const FilmFrame& frame)
{
    view.camera = frame.camera;
    view.appearance.transfer = frame.transfer;
    view.isovalues = frame.isovalues;
    view.query.error = frame.error;
    view.query.byBudget = frame.byBudget;
    view.query.budget = frame.budget;
    return view;
}

ViewValue withBookmark(ViewValue view, const std::string& name)
{
    Bookmark bookmark{name, view};
    bookmark.view.animation = {};
    bookmark.view.bookmarks.clear();
    const auto same = std::ranges::find(view.bookmarks, name, &Bookmark::name);
    if (same != view.bookmarks.end())
        *same = std::move(bookmark);
    else if (view.bookmarks.size() < mostBookmarks)
        view.bookmarks.push_back(std::move(bookmark));
    return view;
}

ViewValue atBookmark(const ViewValue& view, const Bookmark& bookmark)
{
    ViewValue shown = bookmark.view;
    shown.animation = view.animation;
    shown.bookmarks = view.bookmarks;
    return shown;
}

ViewValue viewAtFrame(const ViewValue& view, int frame)
{
    return withFrame(view, frameOf(view.animation, frameOf(view), frame));
}

} // namespace tetra
