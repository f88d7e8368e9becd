// SPDX-License-Identifier: GPL-3.0-or-later
// Takes arbitrary bytes for a .tan file, with checksums made right where there is room for them: opens it, extracts by
// every method, verifies.
#include "core/history/query/history_part.h"
#include "tests/core/history/model_fixture.h"
#include "tests/fuzz/fuzz_folder.h"
#include "tests/fuzz/fuzz_input.h"
#include "tests/fuzz/small_part.h"

#include <tan/query.h>
#include <tan/verify.h>

namespace tetra {
namespace {

/// Without this nearly every input would be refused for the same reason.
std::vector<std::byte> withChecksums(std::span<const std::byte> bytes)
{
    FileParts parts({bytes.begin(), bytes.end()});
    if (bytes.size() < sizeof(format::Header))
        return parts.content;
    const std::size_t room = (bytes.size() - sizeof(format::Header)) / sizeof(format::Section);
    if (parts.header().sectionCount <= std::min<std::size_t>(room, 64))
        parts.repairChecksums();
    return parts.content;
}

void requireWellFormed(const TetrahedralMesh& mesh)
{
    const std::size_t count = mesh.positions.size();
    require(mesh.values.size() == count, "one value a vertex");
    for (const auto& tetrahedron : mesh.tetrahedra)
        require(*std::ranges::max_element(tetrahedron) < count, "tetrahedra are of vertices of the mesh");
}

std::vector<MeshQuery> queriesOf(const Model& model)
{
    const Eigen::AlignedBox3d bounds = model.description().bounds;
    MeshQuery all;
    MeshQuery window;
    window.error = 20.0;
    window.window = Window{Box{bounds.min(), bounds.center()}, WindowBorder::Clipped};
    MeshQuery budget;
    budget.budget = 40;
    MeshQuery focus;
    focus.error = SpaceRamp{Box{bounds.min(), bounds.center()}, 1, 30, 0};
    MeshQuery sharp = focus;
    sharp.method = VariableMethod::Insertion;
    return {all, window, budget, focus, sharp};
}

/// A dataset of the model's kind, which need not be the one that it was made of.
const Dataset& datasetFor(const Model& model)
{
    static const Dataset lattice = bumps(SampleType::UInt8, {3, 3, 3});
    static const Dataset bent = bentBumps(SampleType::Float32, {3, 3, 3});
    static const Dataset part = smallPart();
    switch (model.description().domain) {
    case DomainClass::Curvilinear: return bent;
    case DomainClass::Irregular: return part;
    default: return lattice;
    }
}

void examine(const std::shared_ptr<const Model>& model)
{
    MeshExtractor extractor(model);
    for (const MeshQuery& query : queriesOf(*model)) {
        const auto mesh = extractor.extract(query);
        if (mesh)
            requireWellFormed((*mesh)->mesh);
        else
            requireText(mesh.error());
    }
    const auto part = extractHistory(*model, {20}, {1});
    if (part)
        requireWellFormed(part->mesh);
    require(verify(*model, datasetFor(*model), {{5}, {0}}).ok(), "verification finds, it does not fail");
}

} // namespace
} // namespace tetra

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    using namespace tetra;
    static const FuzzFolder folder;
    const auto model = Model::open(folder.write("model.tan", withChecksums(std::as_bytes(std::span(bytes, size)))));
    if (model)
        examine(*model);
    else
        requireText(model.error());
    return 0;
}
