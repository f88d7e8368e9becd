// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QLabel;
class QPushButton;
class QVBoxLayout;

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
    /// What programs that ended unexpectedly have left; seen while nothing is open.
    LostOffers& lost() noexcept { return *lost_; }

signals:
    void openClicked();
    void recentClicked(const QString& path);
    void sampleClicked(const QString& name);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QWidget* makeSamples(LongTask& sampling);
    void showRecent(const QStringList& files);

    QLabel* title_;
    QLabel* text_;
    QPushButton* open_;
    LostOffers* lost_;
    QWidget* recentBox_;
    QVBoxLayout* recent_;
    QWidget* samples_;
    bool dropping_ = false;
};

} // namespace tetra
