// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/host/plugin_host.h"

#include <tan/base.h>

#include <QImage>
#include <QString>

#include <filesystem>
#include <string>
#include <vector>

namespace tetra {

/// Where the models of samples are kept between starts: this user's cache, which may be emptied at any time.
std::filesystem::path sampleFolder();
/// Whether the file lies there.
bool isOfSample(const std::filesystem::path& file);

/// The model of a sample (plugins/samples/samples.h) in the folder; makes dataset and model there unless it is there
/// already, in a size that takes a few seconds. Call from a worker thread. Errors: as of making, saving, reading and
/// building.
Result<std::filesystem::path> sampleModel(PluginHost& host, const std::string& name,
                                          const std::filesystem::path& folder, const Progress& progress = {});

/// A sample as people meet it.
struct SampleCard {
    std::string name; ///< of the sample: stable
    QString title;
    QString description; ///< what it is, its size, where it is from and what to look at
};

/// All samples, those first that show most.
std::vector<SampleCard> sampleCards();

/// The size of the pictures of samples, in pixels of a screen with twice as many as usual.
constexpr int thumbnailWidth = 208;
constexpr int thumbnailHeight = 156;

/// A small picture of a sample, without a background: from the folder if it is there, else drawn of a small version of
/// the sample, in a fraction of a second, and kept there. Call from a worker thread. Errors: as of making and building.
Result<QImage> sampleThumbnail(PluginHost& host, const std::string& name, const std::filesystem::path& folder,
                               const Progress& progress = {});

} // namespace tetra
