// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/draft_builder.h"

#include "ui/viewport/frame_pacer.h"

#include <tan/query.h>

#include <algorithm>
#include <functional>
#include <new>
#include <optional>

namespace tetra {
namespace {

/// A draft on its way is finished before a newer one begins, if it does not take longer.
constexpr auto patience = std::chrono::milliseconds(300);

bool haveSameMesh(const SceneRequest& first, const SceneRequest& second)
{
    return first.model == second.model && first.query == second.query;
}

/// The budgets of the meshes before window and values that leave a quarter of the last one each.
std::vector<std::uint64_t> budgetsFor(const ShownMesh& shown)
{
    const double whole = static_cast<double>(shown.wholeTetrahedra) / static_cast<double>(shown.tetrahedra);
    std::vector<std::uint64_t> budgets;
    for (const std::uint64_t size : coarserMeshes(shown.tetrahedra))
        budgets.push_back(static_cast<std::uint64_t>(whole * static_cast<double>(size)));
    return budgets;
}

/// Closed sets are found at once, whatever the field; a draft need not be the smallest mesh.
MeshQuery coarserQuery(MeshQuery query, std::uint64_t budget)
{
    query.budget = query.budget ? std::min(*query.budget, budget) : budget;
    query.method = VariableMethod::ClosedSet;
    return query;
}

} // namespace

/// What the worker keeps between two requests.
struct DraftBuilder::Workshop {
    struct Rung {
        std::shared_ptr<const ExtractedMesh> mesh;
        std::unique_ptr<RendererSession> session;
    };
    using Tell = std::function<void(std::vector<DraftScene>)>;

    std::optional<SceneRequest> present; ///< that the rungs belong to
    std::vector<std::uint64_t> budgets;  ///< of the rungs, the finest first
    std::vector<Rung> rungs;             ///< the coarsest first, as far as they were made
    std::optional<MeshExtractor> extractor;

    bool extractNext(const Progress& progress);
    bool prepare(Rung& rung, std::vector<DraftScene>& drafts, const Progress& progress);
    void make(const SceneRequest& request, const ShownMesh& shown, const Progress& progress, const Tell& tell);
    void clear();
};

bool DraftBuilder::Workshop::extractNext(const Progress& progress)
{
    if (!extractor || extractor->model() != present->model)
        extractor.emplace(present->model);
    const std::uint64_t budget = budgets[budgets.size() - 1 - rungs.size()];
    auto mesh = extractor->extract(coarserQuery(present->query, budget), progress);
    if (!mesh || (*mesh)->mesh.tetrahedra.empty())
        return false;
    rungs.push_back({*std::move(mesh), nullptr});
    return true;
}

bool DraftBuilder::Workshop::prepare(Rung& rung, std::vector<DraftScene>& drafts, const Progress& progress)
{
    if (!rung.session)
        rung.session = present->renderer->open(
            {.mesh = {rung.mesh, &rung.mesh->mesh}, .bounds = present->model->description().bounds});
    auto scene = rung.session->prepare({present->values, present->camera, present->width, present->height}, progress);
    if (!scene)
        return false;
    drafts.insert(drafts.begin(), {*std::move(scene), rung.mesh->mesh.tetrahedra.size()});
    return true;
}

/// What fails or is cancelled leaves fewer drafts: the full scene tells what is wrong.
void DraftBuilder::Workshop::make(const SceneRequest& request, const ShownMesh& shown, const Progress& progress,
                                  const Tell& tell)
try {
    if (!present || !haveSameMesh(*present, request)) {
        rungs.clear();
        budgets = budgetsFor(shown);
    } else if (present->renderer != request.renderer) {
        for (Rung& rung : rungs)
            rung.session.reset();
    }
    present = request;
    std::vector<DraftScene> drafts;
    for (std::size_t i = 0; i < budgets.size(); ++i) {
        const bool isNew = i >= rungs.size();
        if ((isNew && !extractNext(progress)) || !prepare(rungs[i], drafts, progress))
            return;
        if (isNew || i + 1 == budgets.size())
            tell(drafts);
    }
} catch (const std::bad_alloc&) {
    clear();
}

void DraftBuilder::Workshop::clear()
{
    rungs.clear();
    present.reset();
    extractor.reset();
}

DraftBuilder::DraftBuilder(QObject* parent) : QObject(parent), workshop_(std::make_shared<Workshop>()) {}

DraftBuilder::~DraftBuilder() = default;

void DraftBuilder::request(const SceneRequest& request, const ShownMesh& shown)
{
    if (shown.tetrahedra == 0)
        return clear();
    const bool isSameMesh = last_ && haveSameMesh(*last_, request);
    const bool isKnown = last_ && haveSameScene(*last_, request);
    shown_ = shown;
    if (!isSameMesh) {
        cleared_ = newest_; // drafts of another mesh, on their way yet
        emit draftsReady({});
    }
    if (!isKnown)
        submit(request);
}

void DraftBuilder::requestLook(const SceneRequest& request)
{
    if (last_ && haveSameMesh(*last_, request))
        submit(request);
}

void DraftBuilder::submit(const SceneRequest& request)
{
    last_ = request;
    job_.submit(
        [this, request, shown = shown_, workshop = workshop_, number = ++newest_](const std::stop_token& stop) {
            workshop->make(request, shown, Progress(stop, {}), [this, number](std::vector<DraftScene> drafts) {
                QMetaObject::invokeMethod(
                    this,
                    [this, number, drafts = std::move(drafts)] {
                        if (number > cleared_)
                            emit draftsReady(drafts);
                    },
                    Qt::QueuedConnection);
            });
        },
        patience);
}

void DraftBuilder::clear()
{
    last_.reset();
    cleared_ = newest_;
    job_.submit([workshop = workshop_](const std::stop_token&) { workshop->clear(); });
}

} // namespace tetra
