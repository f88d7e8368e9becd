// SPDX-License-Identifier: GPL-3.0-or-later
// A mesh that was handed out is not written again before everybody is done with it, whatever thread that is in; then it
// is, and costs no memory anew. Meant to be run with the thread sanitizer, which sees what no result shows.
#include "tests/core/history/query/lattice_models.h"

#include <tan/query.h>

#include <QTemporaryDir>
#include <QTest>

#include <atomic>
#include <numeric>
#include <thread>

using namespace tetra;

namespace {

using MeshPointer = std::shared_ptr<const ExtractedMesh>;

double sumOf(const ExtractedMesh& mesh)
{
    return std::accumulate(mesh.mesh.values.begin(), mesh.mesh.values.end(), 0.0);
}

} // namespace

class MeshLendingTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { model_ = modelOf(randomLattice(LatticeKind::Noise, {9, 8, 9}, 3), 0, folder()); }

    void whatIsHeldStaysAsItIs()
    {
        MeshExtractor extractor(model_);
        const MeshPointer held = mesh(extractor, 20);
        const ExtractedMesh copy = *held;
        for (const double error : {10.0, 40.0, 20.0})
            QVERIFY(mesh(extractor, error) != held);
        QCOMPARE(held->mesh.values, copy.mesh.values);
        QCOMPARE(held->mesh.tetrahedra, copy.mesh.tetrahedra);
    }

    void whatComesBackIsUsedAgain()
    {
        MeshExtractor extractor(model_);
        const ExtractedMesh* const first = mesh(extractor, 20).get();
        QCOMPARE(mesh(extractor, 10).get(), first);
        MeshPointer other = mesh(extractor, 40);
        QCOMPARE(other.get(), first);
        const MeshPointer again = mesh(extractor, 20);
        QVERIFY(again.get() != first);
        other.reset();
    }

    void meshesOutliveTheirExtractor()
    {
        MeshPointer held;
        ExtractedMesh copy;
        {
            MeshExtractor extractor(model_);
            held = mesh(extractor, 20);
            copy = *held;
        }
        // Others of the same size take what memory is free.
        std::vector<std::unique_ptr<MeshExtractor>> others;
        std::vector<MeshPointer> meshes;
        for (const double error : {10.0, 20.0, 40.0, 20.0}) {
            others.push_back(std::make_unique<MeshExtractor>(model_));
            meshes.push_back(mesh(*others.back(), error));
        }
        QVERIFY(copy.mesh.values.size() > 8);
        QCOMPARE(held->mesh.values, copy.mesh.values);
        QVERIFY(held->mesh.positions == copy.mesh.positions);
        QCOMPARE(held->mesh.tetrahedra, copy.mesh.tetrahedra);
        QCOMPARE(held->sites, copy.sites);
    }

    /// As a render thread does: it reads a mesh and lets it go, and nothing else tells the extractor.
    void othersMayLetGoAtAnyTime()
    {
        MeshExtractor extractor(model_);
        std::atomic<MeshPointer*> handedOver = nullptr;
        std::atomic<bool> done = false;
        double sum = 0;
        std::jthread reader([&] {
            while (!done)
                if (MeshPointer* const got = handedOver.exchange(nullptr)) {
                    sum += sumOf(**got);
                    got->reset();
                    delete got;
                }
        });
        for (int round = 0; round < 400; ++round) {
            auto* const next = new MeshPointer(mesh(extractor, round % 2 == 0 ? 20 : 12));
            for (MeshPointer* expected = nullptr;
                 !handedOver.compare_exchange_weak(expected, next, std::memory_order_release);)
                expected = nullptr;
        }
        while (handedOver.load() != nullptr)
            std::this_thread::yield();
        done = true;
        reader.join();
        QVERIFY(sum != 0);
    }

private:
    std::filesystem::path folder() const { return folder_.path().toStdString(); }

    static MeshPointer mesh(MeshExtractor& extractor, double error)
    {
        MeshQuery query;
        query.error = error;
        return *extractor.extract(query);
    }

    QTemporaryDir folder_;
    std::shared_ptr<const Model> model_;
};

QTEST_GUILESS_MAIN(MeshLendingTest)
#include "mesh_lending_test.moc"
