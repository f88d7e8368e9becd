// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/host/import_options.h"
#include "plugins/host/packed_file.h"
#include "plugins/host/plugin_host.h"
#include "ui/work/latest_answer.h"

#include <QObject>
#include <QString>

#include <filesystem>
#include <optional>

namespace tetra {

/// A dataset of which the user is to say how it is to be read.
struct ImportQuestion {
    std::filesystem::path path;
    std::filesystem::path samples;           ///< what is in the file if it is packed, else the file
    std::optional<UnpackedFiles> unpacked{}; ///< that holds it
    Provided<Reader> reader;                 ///< that the options name, or that suits the file best
    FileContents contents{};                 ///< with these options
    ImportOptions options{};                 ///< to begin with
    QString reason{};                        ///< why it is asked, in a sentence; empty if the user wanted to be
};

/// Whether a file offers a choice that a user wants to be asked about: an array, a time step, a block, a layout.
bool offersChoice(const FileContents& contents);

/// Looks into files for what there is to choose, in a worker: the newest request wins.
class ImportProbe : public QObject {
    Q_OBJECT
public:
    /// `host` outlives it.
    explicit ImportProbe(PluginHost& host, QObject* parent = nullptr) : QObject(parent), host_(host) {}

    void request(const std::filesystem::path& path, const ImportOptions& options);

signals:
    /// Of the newest request.
    void probed(const tetra::Result<tetra::FileContents>& contents);

private:
    PluginHost& host_;
    LatestAnswer<Result<FileContents>> answer_; ///< last: ends before what it uses
};

/// How a file was opened last, kept in the user's settings for the fifty files that were opened so last.
void rememberImport(const std::filesystem::path& path, const ImportOptions& options);

/// As far as its reader still knows it; nothing chosen if the file was never opened so.
ImportOptions rememberedImport(const std::filesystem::path& path, PluginHost& host);

} // namespace tetra
