// SPDX-License-Identifier: GPL-3.0-or-later
// What of a view differs, and parts of views: each part by itself, and any of them together.
#include "core/view/view_value.h"

#include <QTest>

#include <array>
#include <functional>

using namespace tetra;

namespace {

/// One change of each part, in the order of ViewPart.
const std::array<std::function<void(ViewValue&)>, 12> changes = {
    [](ViewValue& view) { view.query.focus.others.emplace_back(Sphere{}); },
    [](ViewValue& view) { view.appearance.mode = "volume"; },
    [](ViewValue& view) { view.appearance.transfer.unitDistance = 2; },
    [](ViewValue& view) { view.appearance.settings["outline"] = false; },
    [](ViewValue& view) { view.isovalues.emplace_back(); },
    [](ViewValue& view) { view.annotations.barEnds = BarEnds{}; },
    [](ViewValue& view) { view.animation.turntable.frames = 7; },
    [](ViewValue& view) { view.camera.azimuth = 31; },
    [](ViewValue& view) { view.background = Colour{}; },
    [](ViewValue& view) { view.lens.x = 0.4; },
    [](ViewValue& view) { view.tools["ruler"] = "1"; },
    [](ViewValue& view) { view.bookmarks.emplace_back(); }};
constexpr unsigned allChanges = (1U << changes.size()) - 1;

/// With those of the changes whose bits are set.
ViewValue changed(unsigned bits)
{
    ViewValue view;
    for (std::size_t part = 0; part < changes.size(); ++part)
        if ((bits >> part & 1) != 0)
            changes[part](view);
    return view;
}

ViewParts partsIn(unsigned bits)
{
    ViewParts parts;
    for (std::size_t part = 0; part < changes.size(); ++part)
        if ((bits >> part & 1) != 0)
            parts |= static_cast<ViewPart>(1U << part);
    return parts;
}

static_assert(!ViewParts());
static_assert(ViewPart::Scene & ViewPart::Transfer);
static_assert(!(ViewPart::Scene & ViewPart::Camera));
static_assert((ViewPart::Mode | ViewPart::Transfer | ViewPart::Settings) == ViewParts(ViewPart::Appearance));
static_assert((~ViewParts(ViewPart::Camera) & ViewPart::Lens) == ViewParts(ViewPart::Lens));

} // namespace

class ViewValueTest : public QObject {
    Q_OBJECT

private slots:
    void everyPartIsTold()
    {
        for (unsigned bits = 0; bits <= allChanges; ++bits) {
            QVERIFY(differingParts({}, changed(bits)) == partsIn(bits));
            QVERIFY(differingParts(changed(bits), changed(allChanges)) == partsIn(allChanges & ~bits));
        }
    }

    void bookmarksHaveNamesOfTheirOwn()
    {
        ViewValue view = changed(allChanges & ~2048U);
        view = withBookmark(view, "one");
        view.camera.azimuth = 5;
        view = withBookmark(view, "other");
        QCOMPARE(view.bookmarks.size(), std::size_t(2));
        QVERIFY(view.bookmarks[0].view.bookmarks.empty() && view.bookmarks[1].view.bookmarks.empty());
        QVERIFY(view.bookmarks[0].view.animation == Animation());
        QCOMPARE(view.bookmarks[0].view.camera.azimuth, 31.0);
        view.lens.x = 0.1;
        const ViewValue back = atBookmark(view, view.bookmarks[0]);
        QVERIFY(differingParts(back, view) == (ViewPart::Camera | ViewPart::Lens));
        view = withBookmark(view, "one"); // in its place
        QCOMPARE(view.bookmarks.size(), std::size_t(2));
        QCOMPARE(view.bookmarks[0].name, std::string("one"));
        QCOMPARE(view.bookmarks[0].view.lens.x, 0.1);
        for (std::size_t number = 0; number < 2 * mostBookmarks; ++number)
            view = withBookmark(view, std::to_string(number));
        QCOMPARE(view.bookmarks.size(), mostBookmarks);
    }

    /// Data are upright as they say, images that say nothing as their slices are.
    void dataAreSeenFromWhereTheyAreKnown()
    {
        ModelDescription image;
        image.domain = DomainClass::RegularLattice;
        image.bounds = {Eigen::Vector3d::Zero(), Eigen::Vector3d(9, 9, 2)};
        const auto up = [](const ModelDescription& of) { return usualCamera(of).up; };
        QCOMPARE(up(image), UpAxis::Y);
        QCOMPARE(usualCamera(image).elevation, Camera().elevation);
        for (const auto& place : std::array<std::function<void(ModelDescription&)>, 4>{
                 [](ModelDescription& of) {
                     of.lattice.spacing = {1, 1, 3};
                 },
                 [](ModelDescription& of) { of.lattice.origin.x() = -120; },
                 [](ModelDescription& of) { of.lattice.directions = Eigen::Vector3d(-1, -1, 1).asDiagonal(); },
                 [](ModelDescription& of) { of.domain = DomainClass::Irregular; }}) {
            ModelDescription placed = image;
            place(placed);
            QCOMPARE(up(placed), UpAxis::Z);
            QVERIFY(usualCamera(placed).elevation > 40); // it is flat
            placed.bounds = {Eigen::Vector3d::Zero(), Eigen::Vector3d(9, 9, 9)};
            QVERIFY(usualCamera(placed) == Camera());
        }
    }

    void partsArePutIntoOthers()
    {
        const ViewValue all = changed(allChanges);
        for (unsigned bits = 0; bits <= allChanges; ++bits) {
            const PartialView parts(all, partsIn(bits));
            QVERIFY(parts.parts() == partsIn(bits));
            QVERIFY(parts.putInto({}) == changed(bits));
            QVERIFY(parts.putInto(all) == all);
            PartialView completed = parts;
            completed.complete(PartialView({}, partsIn(0b1010101010)));
            QVERIFY(completed == PartialView(changed(bits), partsIn(bits | 0b1010101010)));
        }
    }

    void aFrameIsWhatMoves()
    {
        const ViewValue before, after = changed(allChanges);
        const ViewValue framed = withFrame(before, frameOf(after));
        QVERIFY(differingParts(before, framed) == (ViewPart::Transfer | ViewPart::Isovalues | ViewPart::Camera));
        QVERIFY(frameOf(framed) == frameOf(after));
        QVERIFY(viewAtFrame(after, 0) == after); // a turntable starts from the view
    }
};

QTEST_GUILESS_MAIN(ViewValueTest)
#include "view_value_test.moc"
