// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/work_folder.h"
#include "core/history/model_writer.h"

#include <tan/build.h>

#include <filesystem>
#include <memory>

namespace tetra {

/// Whether a file of these first bytes is a TAn model, whole or damaged.
TAN_INTERNAL bool beginsLikeModel(std::span<const std::byte> firstBytes) noexcept;

/// An error (WrongUsage) if there is a file `output` that does not begin like a TAn model, whatever its name is: a
/// model replaces only models and empty files. Guards the samples that a header names, which no input list shows, and
/// notes that somebody called .tan. Also an error if that file cannot be read, or is none that a FileWriter replaces: a
/// folder, a pipe, a device, a file that is read-only. So what takes long to make is not made in vain.
TAN_INTERNAL Status checkModelOutput(const std::filesystem::path& output);

/// The folder beside a model (beside what a link leads to) that holds the files of its build until it is done.
TAN_INTERNAL std::filesystem::path workFolderOf(const std::filesystem::path& output);

/// A model file that a build fills: the folder of its work files, and the writers of either kind. What is finished
/// appears under `output` at once; else nothing does.
class TAN_INTERNAL ModelFileTarget {
public:
    /// What becomes of the finished file.
    enum class Finished {
        AtOnce, ///< it appears under `output`
        Later   ///< it stays in the work folder until place() gives it a name
    };

    /// `description` needs builder and parameters. `resume`: as BuildTarget's. Errors: the file cannot be written.
    static Result<std::unique_ptr<ModelFileTarget>> open(const std::filesystem::path& output, const Dataset& dataset,
                                                         const ModelDescription& description, bool resume,
                                                         Finished finished = Finished::AtOnce);

    ModelWriter& writer() noexcept { return *writer_; }
    /// What a builder is given, whose steps go to `history`: the writer(), or what hands on to it. This outlives it.
    BuildTarget target(HistorySink& history);
    /// Of Finished::Later: the file in the work folder, which is there once it is finished.
    const std::filesystem::path& finished() const noexcept { return output_; }
    /// Gives it a name in the folder of `output`, in place of what is there, with the permissions of `output` if that
    /// is there. Error: CannotWrite.
    Status place(const std::filesystem::path& path) const;
    /// Leaves the work files for a build that goes on with them.
    void keepWork() noexcept { folder_.keep(); }

private:
    ModelFileTarget(std::filesystem::path output, const Dataset& dataset, ModelDescription description,
                    WorkFolder folder, bool resume);

    std::filesystem::path output_; ///< or the file in the work folder
    std::filesystem::path wanted_; ///< what was asked for
    Dataset dataset_;
    ModelDescription description_;
    WorkFolder folder_;
    bool resume_;
    std::unique_ptr<ModelWriter> writer_;
};

} // namespace tetra
