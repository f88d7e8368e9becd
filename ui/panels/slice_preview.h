// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/data/sample_slice.h"
#include "ui/work/latest_job.h"

#include <tan/data.h>

#include <QImage>
#include <QWidget>

#include <filesystem>
#include <memory>
#include <optional>

class QComboBox;
class QLabel;
class QSlider;
class QSpinBox;

namespace tetra {

class MappedFile;

/// The grey picture of a layer: black to white over its window; what the file does not hold is hatched.
QImage sliceImage(const SampleSlice& slice);

/// A layer of the samples that a file would have in some layout, as grey values: whether a guess is right is seen at
/// once. Layers are read in a worker, the newest one that is asked for wins; no more is read than is shown.
class SlicePreview : public QWidget {
    Q_OBJECT
public:
    explicit SlicePreview(QWidget* parent = nullptr);

    /// Nothing: there is nothing to be seen.
    void setSamples(const std::filesystem::path& path, const std::optional<StoredSamples>& samples);
    /// Whether the picture is that of the last layer that was asked for.
    bool upToDate() const noexcept { return shown_ == asked_; }
    const QImage& image() const noexcept { return image_; }

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    QLayout* makeControls();
    void showAxis();
    void request();
    void show(const Result<SampleSlice>& slice);
    void showImage();

    std::filesystem::path path_;
    std::optional<StoredSamples> samples_;
    QImage image_;
    QLabel* picture_;
    QLabel* legend_;
    QComboBox* axis_;
    QSlider* slider_;
    QSpinBox* layer_;
    std::uint64_t asked_ = 0;
    std::uint64_t shown_ = 0;
    std::shared_ptr<const MappedFile> file_; ///< the worker's
    LatestJob job_;                          ///< last: ends before what it uses
};

} // namespace tetra
