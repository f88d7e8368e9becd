// SPDX-License-Identifier: GPL-3.0-or-later
// tan-failing-allocations count: a line "CASE ALLOCATIONS" for each case. ... fail CASE NUMBER: runs the case with
// that allocation failing. The case must say so, as an error or an exception, or be right without it; nothing may leak
// (3 runs in a row say so: caches grow once) and no file be left.
#include "core/base/work_folder.h"
#include "core/history/blocks/block_runs.h"
#include "core/history/blocks/merged_model.h"
#include "core/history/model_writer.h"
#include "core/refine/curvilinear/curvilinear_refinement.h"
#include "core/refine/lattice/lattice_refinement.h"
#include "tests/core/history/irregular/irregular_models.h"

#include <tan/query.h>
#include <tan/render.h>

#include <tbb/global_control.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <new>
#include <string_view>

namespace {

std::atomic<long> allocations = 0;
std::atomic<long> living = 0;
std::atomic<long> failing = -1; ///< the number of the allocation that fails

void* allocate(std::size_t size, std::size_t alignment)
{
    if (allocations++ == failing)
        return nullptr;
    void* const memory = alignment > alignof(std::max_align_t)
                             ? std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment)
                             : std::malloc(size > 0 ? size : 1);
    living += memory != nullptr;
    return memory;
}

void* allocateOrThrow(std::size_t size, std::size_t alignment = 1)
{
    if (void* const memory = allocate(size, alignment))
        return memory;
    throw std::bad_alloc();
}

void release(void* memory)
{
    living -= memory != nullptr;
    std::free(memory);
}

} // namespace

void* operator new(std::size_t size)
{
    return allocateOrThrow(size);
}
void* operator new[](std::size_t size)
{
    return allocateOrThrow(size);
}
void* operator new(std::size_t size, std::align_val_t to)
{
    return allocateOrThrow(size, std::size_t(to));
}
void* operator new[](std::size_t size, std::align_val_t to)
{
    return allocateOrThrow(size, std::size_t(to));
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept
{
    return allocate(size, 1);
}
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept
{
    return allocate(size, 1);
}
void operator delete(void* memory) noexcept
{
    release(memory);
}
void operator delete[](void* memory) noexcept
{
    release(memory);
}
void operator delete(void* memory, std::size_t) noexcept
{
    release(memory);
}
void operator delete[](void* memory, std::size_t) noexcept
{
    release(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept
{
    release(memory);
}
void operator delete[](void* memory, std::align_val_t) noexcept
{
    release(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept
{
    release(memory);
}
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept
{
    release(memory);
}
void operator delete(void* memory, const std::nothrow_t&) noexcept
{
    release(memory);
}
void operator delete[](void* memory, const std::nothrow_t&) noexcept
{
    release(memory);
}

namespace tetra {
namespace {

const std::filesystem::path modelPath = "allocations.tan";

ModelDescription builtBy(const char* builder)
{
    ModelDescription description;
    description.builder = builder;
    return description;
}

Status buildLatticeModel(const Dataset& dataset)
{
    auto writer = ModelWriter::create(modelPath, dataset, builtBy("refinement"));
    if (!writer)
        return writer.error();
    LatticeRefinementOptions options;
    options.size = dataset.lattice.size;
    options.spacing = dataset.lattice.spacing;
    options.valueExtent = dataset.values.range().extent();
    const auto made = refineLattice(options, LatticeSamples(dataset.values.as<std::uint8_t>()), **writer);
    return made ? Status() : made.error();
}

/// Made in a folder with other files, with content, and gone again.
Status useWorkFolder(const Dataset&)
{
    const auto folder = WorkFolder::open("allocations.work", WorkFolder::Leftovers::Remove);
    if (!folder)
        return folder.error();
    std::filesystem::create_directory(folder->path() / "inner");
    std::ofstream(folder->path() / "inner" / "content") << "some";
    return {};
}

Status buildModelInBlocks(const Dataset& dataset)
{
    const auto folder = WorkFolder::open(modelPath.native() + ".work", WorkFolder::Leftovers::Remove);
    if (!folder)
        return folder.error();
    LatticeRunsOptions options;
    options.division = BlockDivision(dataset.lattice.size, 2);
    options.box.latticeSize = dataset.lattice.size;
    options.box.metric = latticeMetric(options.division.box(0).size, dataset.lattice.spacing).value();
    options.box.valueExtent = dataset.values.range().extent();
    RunFiles runs(folder->path(), 1, options.division.count());
    if (const Status opened = runs.openOwn(false); !opened)
        return opened;
    const auto made = makeLatticeRuns(options, LatticeSamples(dataset.values.as<std::uint8_t>()), runs, {});
    if (!made)
        return made.error();
    const ModelFileOpener open = [&](const FixedCounts& counts) {
        return ModelFileWriter::create(modelPath, dataset, builtBy("refinement"), counts, folder->path());
    };
    const auto merged = mergeRuns(runs, folder->path(), open, {});
    return merged ? Status() : merged.error();
}

Status buildCurvilinearModel(const Dataset& dataset)
{
    auto writer = ModelWriter::create(modelPath, dataset, builtBy("refinement"));
    if (!writer)
        return writer.error();
    CurvilinearRefinementOptions options;
    options.valueExtent = dataset.values.range().extent();
    options.positionExtent = dataset.bounds().diagonal().norm();
    const auto made = refineCurvilinear(dataset.lattice.size, *dataset.positions,
                                        LatticeSamples(dataset.values.as<std::uint8_t>()), options, **writer);
    return made ? Status() : made.error();
}

Status buildDecimatedModel(const Dataset& dataset)
{
    auto writer = ModelWriter::create(modelPath, dataset, builtBy("decimation"));
    if (!writer)
        return writer.error();
    std::vector<double> values(dataset.pointCount());
    for (std::uint64_t point = 0; point < values.size(); ++point)
        values[point] = dataset.values.at(point);
    DecimationOptions options;
    options.warpingWeight = dataset.values.range().extent() / dataset.bounds().diagonal().norm();
    const auto made = decimate({*dataset.positions, {}, values, {}, *dataset.tetrahedra, false}, options, **writer);
    return made ? Status() : made.error();
}

double middleOf(const ValueRange& range)
{
    return (range.minimum + range.maximum) / 2;
}

/// Of the model that is there: a mesh and an isosurface.
Status askModel(const Dataset&)
{
    const auto model = Model::open(modelPath);
    if (!model)
        return model.error();
    const auto mesh = extractPrefix(**model, (*model)->siteCount());
    if (!mesh)
        return mesh.error();
    const auto gradients = vertexGradients(*mesh);
    const auto surface = extractIsosurface(*mesh, std::span(gradients), middleOf((*model)->description().range));
    return surface ? Status() : surface.error();
}

Status buildByTheFace(const Dataset& dataset)
{
    const auto report = buildModel(dataset, modelPath);
    return report ? Status() : report.error();
}

struct Case {
    Dataset dataset;
    Status (*run)(const Dataset&);
    bool writes;         ///< a model; else there is one
    bool isFace = false; ///< throws nothing
};

std::vector<Case> allCases()
{
    const Dataset lattice = bumps(SampleType::UInt8, {5, 4, 4});
    return {{lattice, useWorkFolder, false},
            {lattice, buildLatticeModel, true},
            {lattice, buildModelInBlocks, true},
            {bentBumps(SampleType::UInt8, {5, 4, 4}), buildCurvilinearModel, true},
            {randomIrregular(1), buildDecimatedModel, true},
            {lattice, buildByTheFace, true, true},
            {bentBumps(SampleType::UInt8, {5, 4, 4}), buildByTheFace, true, true},
            {randomIrregular(1), buildByTheFace, true, true},
            {lattice, askModel, false}};
}

/// Whether it worked; tells what is wrong about how it did not.
bool worked(const Case& asked)
{
    try {
        const Status done = asked.run(asked.dataset);
        if (!done && done.error().kind != ErrorKind::OutOfResource) {
            std::fprintf(stderr, "said something else: %s\n", done.error().text().c_str());
            std::exit(1);
        }
        return done.ok();
    } catch (const std::bad_alloc&) {
        if (!asked.isFace)
            return false;
        std::fputs("threw, although it is of the face\n", stderr);
        std::exit(1);
    }
}

long allocationsOf(const Case& asked)
{
    worked(asked); // what is made once and kept is made now
    allocations = 0;
    if (!worked(asked)) {
        std::fputs("does not work with all memory\n", stderr);
        std::exit(1);
    }
    return allocations;
}

long livingAfter(const Case& asked, long number)
{
    allocations = 0;
    failing = number;
    const bool done = worked(asked);
    failing = -1;
    if (asked.writes && std::filesystem::exists(modelPath) != done) {
        std::fprintf(stderr, "allocation %ld: %s\n", number, done ? "no model" : "a model although it failed");
        std::exit(1);
    }
    if (asked.writes)
        std::filesystem::remove(modelPath);
    return living;
}

} // namespace
} // namespace tetra

int main(int argumentCount, char** arguments)
{
    using namespace tetra;
    const tbb::global_control oneThread(tbb::global_control::max_allowed_parallelism, 1);
    const std::vector<Case> cases = allCases();
    if (argumentCount == 2 && std::string_view(arguments[1]) == "count") {
        for (std::size_t number = 0; number < cases.size(); ++number) {
            if (!cases[number].writes && !buildLatticeModel(cases[number].dataset))
                return 1;
            std::printf("%zu %ld\n", number, allocationsOf(cases[number]));
        }
        std::filesystem::remove(modelPath);
        return 0;
    }
    if (argumentCount != 4)
        return 2;
    const Case& asked = cases.at(std::strtoul(arguments[2], nullptr, 10));
    if (!asked.writes && !buildLatticeModel(asked.dataset))
        return 1;
    allocationsOf(asked);
    if (asked.writes)
        std::filesystem::remove(modelPath);
    const long number = std::atol(arguments[3]);
    long before = livingAfter(asked, number);
    int grown = 0;
    for (long after = 0; grown < 3 && (after = livingAfter(asked, number)) > before; ++grown)
        before = after;
    std::filesystem::remove(modelPath);
    if (grown < 3)
        return 0;
    std::fputs("memory leaks\n", stderr);
    return 1;
}
