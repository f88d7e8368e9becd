// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

#include <functional>

class QHBoxLayout;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace tetra {

/// One message with a button that takes it away.
class MessageRow : public QFrame {
    Q_OBJECT
public:
    explicit MessageRow(const QString& text, QWidget* parent = nullptr);
    /// A button before the one that takes the message away.
    QPushButton& addButton(const QString& text);
    const QString& text() const noexcept { return text_; }
    /// The same happened again.
    void countAgain();

signals:
    void dismissed();

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QString text_;
    QLabel* count_;
    QHBoxLayout* layout_;
    int times_ = 1;
};

/// Messages above the picture that stay until they are taken away, newest first; they stop nobody from working, and
/// their text can be selected. Takes no room while there is none.
class MessageBar : public QWidget {
    Q_OBJECT
public:
    explicit MessageBar(QWidget* parent = nullptr);
    void add(const QString& text);
    /// A message that asks: it goes when it was answered. `declined` is called when it is taken away instead.
    void ask(const QString& text, const QString& answer, const std::function<void()>& accepted,
             const std::function<void()>& declined);
    /// The texts that are shown, newest first.
    QStringList texts() const;
    void clear();

private:
    void insert(MessageRow* row);
    void showNewest();
    void dismiss(MessageRow* row);

    QList<MessageRow*> rows_; ///< newest first
    QVBoxLayout* layout_;
    QLabel* more_;
};

} // namespace tetra
