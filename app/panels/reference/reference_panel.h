#pragma once

#include <QImage>
#include <QWidget>

#include <functional>

class QLabel;
class QMimeData;
class QToolButton;

namespace suffuse {

class Editor;
class ReferenceView;

/// A picture to look at while painting, and to pick colours from: a file that is opened or dropped here, or a picture
/// that is dragged in from another program. The settings remember the file. It is in no painting.
class ReferencePanel : public QWidget {
    Q_OBJECT

public:
    /// `picks` says whether a click picks a colour, since the tool in use does so on the canvas.
    ReferencePanel(Editor &editor, std::function<bool()> picks, QWidget *parent = nullptr);

    /// Shows a file. Where it cannot be read, that is said, and the picture before stays.
    bool open(const QString &path);
    ReferenceView *view() const { return m_view; }

protected:
    void showEvent(QShowEvent *event) override;
    void dragEnterEvent(QDragEnterEvent *event) override;
    void dropEvent(QDropEvent *event) override;

private:
    void choose();
    void clear();
    void show(const QImage &picture, const QString &path);
    void refresh();

    Editor &m_editor;
    ReferenceView *m_view = nullptr;
    QLabel *m_message = nullptr;
    QToolButton *m_fit = nullptr;
    QToolButton *m_whole = nullptr;
    QToolButton *m_clear = nullptr;
    bool m_isRead = false; ///< the file of last time was looked for
};

} // namespace suffuse
