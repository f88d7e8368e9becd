// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include <string>

class QGridLayout;
class QLabel;
class QPushButton;
class QToolButton;

namespace tetra {

class LongTask;
class LostOffers;

/// What is seen instead of a picture while there is none: what to do next, the files opened last, and samples to begin
/// with. The whole page takes files that are dropped, and says so.
class EmptyPage : public QWidget {
    Q_OBJECT
public:
    /// `sampling` makes the models of samples, and outlives it.
    explicit EmptyPage(LongTask& sampling, QWidget* parent = nullptr);

    /// Nothing is open: invites to open something.
    void invite(const QStringList& recentFiles);
    /// Something is under way or next: `title` names it, `text` says what.
    void tell(const QString& title, const QString& text);
    /// Whether something is held over the window that could be dropped.
    void setDropping(bool dropping);
    /// The picture of a sample.
    void setThumbnail(const std::string& sample, const QImage& picture);
    /// What programs that ended unexpectedly have left; seen while nothing is open.
    LostOffers& lost() noexcept { return *lost_; }

signals:
    void openClicked();
    void recentClicked(const QString& path);
    void sampleClicked(const QString& name);
    /// The samples come into sight.
    void samplesShown();

protected:
    void showEvent(QShowEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    QWidget* makeSamples(LongTask& sampling);
    void showRecent(const QStringList& files);
    void setDescriptionWidth(int width);
    void describe(const QString& text);

    QLabel* title_;
    QLabel* text_;
    QPushButton* open_;
    LostOffers* lost_;
    QWidget* recentBox_;
    QGridLayout* recent_;
    QLabel* description_; ///< of the sample below the pointer or with the focus
    QGridLayout* grid_;   ///< of samples
    QList<QToolButton*> sampleButtons_;
    int columns_ = 0;
    QWidget* samples_;
    bool dropping_ = false;
};

} // namespace tetra
