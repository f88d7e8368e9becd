// SPDX-License-Identifier: GPL-3.0-or-later
// R13: models of every kind, damaged at random in every section, with checksums that say all is well: each kind of
// query gives an error or a mesh, never a crash. Meant to be run with sanitizers, too.
#include "core/history/query/history_part.h"
#include "tests/core/history/model_fixture.h"
#include "tests/core/history/query/lattice_models.h"
#include "tests/core/history/query/random_fields.h"
#include "tests/core/history/query/some_models.h"
#include "tests/soak.h"

#include <tan/query.h>

#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <limits>
#include <random>

using namespace tetra;

namespace {

/// Numbers that programs trip over, as integers, floats or doubles.
constexpr std::array<std::uint64_t, 8> evilNumbers = {0,
                                                      1,
                                                      0x7fffffff7fffffff,
                                                      0x8000000080000000,
                                                      0xfffffffefffffffe,
                                                      0xffffffffffffffff,
                                                      0x7fc00000,
                                                      0x7ff8000000000000};

/// Changes a few bytes of a section.
void damage(std::span<std::byte> bytes, std::mt19937& random)
{
    for (unsigned hits = 1 + random() % 4; hits > 0; --hits) {
        const std::size_t at = random() % bytes.size();
        switch (random() % 3) {
        case 0: bytes[at] ^= std::byte(1u << random() % 8); break;
        case 1: bytes[at] = std::byte(random() % 256); break;
        default: {
            const std::uint64_t evil = evilNumbers[random() % evilNumbers.size()];
            const auto number = std::as_bytes(std::span(&evil, 1));
            const std::size_t start = at / 8 * 8;
            const std::size_t count = std::min(number.size(), bytes.size() - start);
            std::ranges::copy(number.first(count), bytes.begin() + static_cast<std::ptrdiff_t>(start));
        }
        }
    }
}

SpaceRamp randomFocus(std::mt19937& random, const Eigen::AlignedBox3d& bounds)
{
    const auto place = [&]() -> Eigen::Vector3d {
        const auto part = [&] { return std::uniform_real_distribution()(random); };
        return bounds.min() + bounds.sizes().cwiseProduct(Eigen::Vector3d(part(), part(), part()));
    };
    const Eigen::Vector3d one = place(), other = place();
    SpaceRamp ramp;
    ramp.inner = static_cast<double>(random() % 3);
    ramp.outer = 3.0 + static_cast<double>(random() % 60);
    if (random() % 2 == 0)
        ramp.region = Box{one.cwiseMin(other), one.cwiseMax(other)};
    else
        ramp.region = Sphere{one, 0.3 * bounds.diagonal().norm()};
    ramp.falloff = random() % 3 == 0 ? 0.1 * bounds.diagonal().norm() : 0;
    return ramp;
}

MeshQuery randomQuery(std::mt19937& random, const Eigen::AlignedBox3d& bounds)
{
    MeshQuery query;
    switch (random() % 4) {
    case 0: query.error = static_cast<double>(random() % 40); break;
    case 1: query.error = randomField(random, 3); break;
    default: query.error = randomFocus(random, bounds);
    }
    query.warping = random() % 2 == 0 ? query.error : ErrorField(anyWarping);
    query.method = static_cast<VariableMethod>(random() % 3);
    if (random() % 3 == 0)
        query.budget = random() % 4 == 0 ? std::numeric_limits<std::uint64_t>::max() : 1 + random() % 2000;
    if (random() % 4 == 0)
        query.values = {{-0.5, 0.5}, {20, 90}};
    if (random() % 4 == 0)
        query.window = Window{Box{bounds.min(), bounds.center()}, static_cast<WindowBorder>(random() % 3)};
    return query;
}

bool isWellFormed(const ExtractedMesh& mesh)
{
    const std::size_t count = mesh.mesh.positions.size();
    return mesh.mesh.values.size() == count && mesh.sites.size() == count &&
           (mesh.points.empty() || mesh.points.size() == count) &&
           std::ranges::all_of(mesh.mesh.tetrahedra,
                               [count](const auto& t) { return *std::ranges::max_element(t) < count; });
}

} // namespace

class ExtractorDamageTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        models_ = someModels(folder());
        models_.push_back({"blocks", modelOf(randomLattice(LatticeKind::Smooth, {9, 8, 9}, 3), 4, folder())});
        models_.push_back({"wide", modelOf(randomLattice(LatticeKind::Wide, {6, 7, 5}, 4), 0, folder())});
    }

    void damagedModelsNeverCrash_data()
    {
        QTest::addColumn<int>("number");
        for (std::size_t number = 0; number < models_.size(); ++number)
            QTest::newRow(models_[number].name.c_str()) << int(number);
    }
    void damagedModelsNeverCrash()
    {
        QFETCH(int, number);
        const Model& whole = *models_[std::size_t(number)].model;
        const Eigen::AlignedBox3d bounds = whole.description().bounds;
        const std::vector<std::byte> bytes = readBytes(whole.path());
        const std::filesystem::path path = folder() / "damaged.tan";
        std::mt19937 random(seedOf(static_cast<unsigned>(number) + 1));
        int meshes = 0, errors = 0;
        const std::size_t sections = FileParts(bytes).sections().size();
        for (std::size_t round = 0; round < timesOf(15u, 60u) * sections; ++round) {
            FileParts parts(bytes);
            const format::Section& section = parts.sections()[round % sections];
            if (section.bytes > 0)
                damage(std::span(parts.content).subspan(section.offset, section.bytes), random);
            parts.repairChecksums();
            writeBytes(path, parts.content);
            const auto model = Model::open(path);
            if (!model)
                continue;
            MeshExtractor extractor(*model);
            for (int query = 0; query < 4; ++query) {
                const auto mesh = extractor.extract(randomQuery(random, bounds));
                if (mesh.ok())
                    QVERIFY(isWellFormed(**mesh));
                else
                    QVERIFY(mesh.error().text().size() > 20);
                ++(mesh.ok() ? meshes : errors);
            }
            const auto part = extractHistory(**model, {20}, {1});
            if (part.ok())
                for (const auto& t : part->mesh.tetrahedra)
                    QVERIFY(*std::ranges::max_element(t) < part->mesh.positions.size());
        }
        QVERIFY2(meshes > 75 && errors > 25, qPrintable(QString("%1 %2").arg(meshes).arg(errors)));
    }

private:
    std::filesystem::path folder() const { return folder_.path().toStdString(); }

    QTemporaryDir folder_;
    std::vector<SomeModel> models_;
};

QTEST_GUILESS_MAIN(ExtractorDamageTest)
#include "extractor_damage_test.moc"
