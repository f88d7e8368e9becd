// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/slice_preview.h"

#include <tan/base.h>

#include <QComboBox>
#include <QLabel>
#include <QLocale>
#include <QPainter>
#include <QResizeEvent>
#include <QSignalBlocker>
#include <QSlider>
#include <QSpinBox>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace tetra {
namespace {

constexpr int least = 200;              // pixels
constexpr std::uint32_t mostRead = 512; // samples along a side

} // namespace

QImage sliceImage(const SampleSlice& slice)
{
    constexpr QRgb missing = qRgb(176, 106, 72);
    constexpr QRgb missingToo = qRgb(120, 72, 48);
    const auto width = static_cast<int>(slice.width);
    const auto height = static_cast<int>(slice.height);
    QImage image(width, height, QImage::Format_RGB32);
    const double extent = slice.window.extent();
    for (int y = 0; y < height; ++y) {
        auto* line = reinterpret_cast<QRgb*>(image.scanLine(height - 1 - y)); // the second axis goes up
        for (int x = 0; x < width; ++x) {
            const float value = slice.values[static_cast<std::size_t>(y) * slice.width + static_cast<std::size_t>(x)];
            if (!std::isfinite(value)) {
                line[x] = (x + y) / 2 % 2 == 0 ? missing : missingToo;
                continue;
            }
            const double share = extent > 0 ? (value - slice.window.minimum) / extent : 0.5;
            const int grey = static_cast<int>(std::lround(255 * std::clamp(share, 0.0, 1.0)));
            line[x] = qRgb(grey, grey, grey);
        }
    }
    return image;
}

SlicePreview::SlicePreview(QWidget* parent)
    : QWidget(parent), picture_(new QLabel), legend_(new QLabel), axis_(new QComboBox),
      slider_(new QSlider(Qt::Horizontal)), layer_(new QSpinBox)
{
    setObjectName("import.preview");
    picture_->setObjectName("import.preview.picture");
    picture_->setAlignment(Qt::AlignCenter);
    picture_->setMinimumSize(least, least);
    picture_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Ignored);
    picture_->setFrameShape(QFrame::StyledPanel);
    picture_->setAccessibleName(tr("Preview of a layer"));
    legend_->setObjectName("import.preview.legend");
    legend_->setWordWrap(true);
    legend_->setMinimumHeight(2 * legend_->fontMetrics().lineSpacing()); // the longest takes two lines
    legend_->setAlignment(Qt::AlignTop);
    legend_->setForegroundRole(QPalette::PlaceholderText);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins({});
    layout->addWidget(picture_, 1);
    layout->addLayout(makeControls());
    layout->addWidget(legend_);
}

QLayout* SlicePreview::makeControls()
{
    axis_->setObjectName("import.preview.axis");
    axis_->setAccessibleName(tr("Axis of the layers"));
    axis_->setToolTip(tr("Axis perpendicular to the layer"));
    for (const char* name : {"x", "y", "z"})
        axis_->addItem(tr("Across %1").arg(name));
    axis_->setCurrentIndex(2);
    slider_->setObjectName("import.preview.slider");
    slider_->setAccessibleName(tr("Layer"));
    layer_->setObjectName("import.preview.layer");
    layer_->setAccessibleName(tr("Layer"));
    for (QWidget* control : {static_cast<QWidget*>(slider_), static_cast<QWidget*>(layer_)})
        control->setToolTip(tr("Layer shown, counted from 0"));
    connect(axis_, &QComboBox::currentIndexChanged, this, &SlicePreview::showAxis);
    connect(slider_, &QSlider::valueChanged, layer_, &QSpinBox::setValue);
    connect(layer_, &QSpinBox::valueChanged, slider_, &QSlider::setValue);
    connect(layer_, &QSpinBox::valueChanged, this, &SlicePreview::request);
    auto* row = new QHBoxLayout;
    row->addWidget(axis_);
    row->addWidget(slider_, 1);
    row->addWidget(layer_);
    return row;
}

void SlicePreview::setSamples(const std::filesystem::path& path, const std::optional<StoredSamples>& samples)
{
    path_ = path;
    samples_ = samples;
    showAxis();
}

/// The layer in the middle, of which there is most to be seen; the one that is shown if there still is one.
void SlicePreview::showAxis()
{
    setEnabled(samples_.has_value());
    const auto axis = static_cast<std::size_t>(std::max(axis_->currentIndex(), 0));
    const int last = samples_ ? static_cast<int>(samples_->size[axis]) - 1 : 0;
    const bool isOther = slider_->maximum() != last;
    {
        const QSignalBlocker sliderBlocker(slider_);
        const QSignalBlocker layerBlocker(layer_);
        slider_->setRange(0, last);
        layer_->setRange(0, last);
        if (isOther) {
            slider_->setValue((last + 1) / 2);
            layer_->setValue((last + 1) / 2);
        }
    }
    request();
}

void SlicePreview::request()
{
    const std::uint64_t number = ++asked_;
    if (!samples_) {
        job_.submit([this](const std::stop_token&) { file_.reset(); });
        shown_ = number;
        image_ = {};
        picture_->setText(tr("No preview: the layout is incomplete"));
        legend_->clear();
        return;
    }
    const int axis = axis_->currentIndex();
    const auto layer = static_cast<std::uint32_t>(layer_->value());
    job_.submit([this, number, path = path_, samples = *samples_, axis, layer](const std::stop_token& stop) {
        if (file_ == nullptr || file_->path() != path) {
            const auto opened = MappedFile::open(path);
            file_ = opened ? *opened : nullptr;
        }
        const auto bytes = file_ != nullptr ? file_->bytes() : std::span<const std::byte>();
        const auto slice = readSampleSlice(bytes, samples, axis, layer, mostRead, Progress(stop, {}));
        QMetaObject::invokeMethod(
            this,
            [this, number, slice] {
                if (slice || slice.error().kind != ErrorKind::Cancelled) {
                    shown_ = std::max(shown_, number);
                    show(slice);
                }
            },
            Qt::QueuedConnection);
    });
}

void SlicePreview::show(const Result<SampleSlice>& slice)
{
    if (!samples_ || !slice)
        return;
    image_ = sliceImage(*slice);
    static constexpr std::array directions{"yz", "xz", "xy"};
    const char* axes = directions[static_cast<std::size_t>(axis_->currentIndex())];
    const QLocale locale;
    legend_->setText(
        tr("%1 to the right, %2 up; black %3, white %4")
            .arg(QChar(axes[0]))
            .arg(QChar(axes[1]))
            .arg(locale.toString(slice->window.minimum, 'g', 5), locale.toString(slice->window.maximum, 'g', 5)));
    showImage();
}

void SlicePreview::showImage()
{
    if (image_.isNull())
        return;
    const QSize room = picture_->contentsRect().size() * devicePixelRatioF();
    QPixmap pixmap = QPixmap::fromImage(image_.scaled(room, Qt::KeepAspectRatio, Qt::FastTransformation));
    pixmap.setDevicePixelRatio(devicePixelRatioF());
    picture_->setPixmap(pixmap);
}

void SlicePreview::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    showImage();
}

} // namespace tetra
