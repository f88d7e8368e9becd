// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QScrollArea>

#include <functional>

class QHBoxLayout;
class QLabel;
class QPushButton;
class QToolButton;
class QVBoxLayout;

namespace tetra {

/// What a message is about. Those about the file that is open go when another one is.
enum class MessageSubject { File, Program };

/// Whether something is wrong, or the user is told or offered something.
enum class MessageKind { Problem, News };

/// One message with a button that takes it away.
class MessageRow : public QFrame {
    Q_OBJECT
public:
    explicit MessageRow(const QString& text, MessageSubject subject, MessageKind kind);
    /// A button before the one that takes the message away.
    QPushButton& addButton(const QString& text);
    const QString& text() const noexcept { return text_; }
    /// The same happened again.
    void countAgain();
    /// What it is about may soon not be open any more.
    void markOld() { isOld_ = subject_ == MessageSubject::File; }
    bool isOld() const noexcept { return isOld_; }

signals:
    void dismissed();

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QString text_;
    MessageSubject subject_;
    MessageKind kind_;
    QLabel* count_;
    QHBoxLayout* layout_;
    int times_ = 1;
    bool isOld_ = false;
};

/// The rows, as high as they are; when all are shown not higher than half of the window.
class MessageList : public QScrollArea {
    Q_OBJECT
public:
    MessageList();
    void insert(MessageRow* row);
    void showAll(bool all);
    bool showsAll() const noexcept { return showsAll_; }

    int heightForWidth(int width) const override;
    QSize sizeHint() const override { return {0, heightForWidth(width())}; }
    QSize minimumSizeHint() const override { return {0, 0}; }

private:
    QVBoxLayout* rows_;
    bool showsAll_ = false;
};

/// Messages above the picture that stay until they are taken away, newest first; they stop nobody from working, and
/// their text can be selected. The newest are shown, all on demand; of those about files that were tried before only
/// the newest. Takes no room while there is none.
class MessageBar : public QWidget {
    Q_OBJECT
public:
    explicit MessageBar(QWidget* parent = nullptr);
    void add(const QString& text, MessageSubject subject = MessageSubject::File);
    /// The same of what is no problem.
    void tell(const QString& text, MessageSubject subject = MessageSubject::File);
    /// A message that offers something: it goes when it was answered. `declined` is called when the user takes it away
    /// instead.
    void ask(const QString& text, const QString& answer, const std::function<void()>& accepted,
             const std::function<void()>& declined, MessageSubject subject = MessageSubject::File,
             MessageKind kind = MessageKind::News);
    /// The texts that are there, newest first.
    QStringList texts() const;
    /// Takes away what says just this, if it is there: it is not so any more.
    void remove(const QString& text);
    /// Takes all away, without an answer.
    void clear();
    /// Another file may be opened soon: what is said of this one from now on is said of that. clearOld() takes away
    /// what was said before.
    void markOld();
    void clearOld();

private:
    void add(const QString& text, MessageSubject subject, MessageKind kind);
    void insert(MessageRow* row);
    void showRows();
    void dismiss(MessageRow* row);

    QList<MessageRow*> rows_; ///< newest first
    MessageList* list_;
    QWidget* below_;
    QToolButton* more_;
};

} // namespace tetra
