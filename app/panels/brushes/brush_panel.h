#pragma once

#include "app/widgets/brush/brush_preview.h"

#include <QHash>
#include <QWidget>

#include <functional>

class QLabel;
class QLineEdit;
class QListWidget;
class QListWidgetItem;
class QMenu;
class QToolButton;
class QVBoxLayout;

namespace suffuse {

class BrushMenu;
class Editor;
class HintLabel;
class SliderField;

/// Shows the brushes in their groups, with pictures of their strokes. It has a search, favourites and a menu for the
/// brush, and fields for size, flow and opacity of the brush in hand.
class BrushPanel : public QWidget {
    Q_OBJECT

public:
    explicit BrushPanel(Editor &editor, QWidget *parent = nullptr);

    QListWidget *list() const { return m_list; }
    QLineEdit *search() const { return m_search; }
    QToolButton *favouritesButton() const { return m_favourites; }
    QMenu *menu() const;
    SliderField *size() const { return m_size; }
    SliderField *flow() const { return m_flow; }
    SliderField *opacity() const { return m_opacity; }
    QToolButton *resetButton() const { return m_reset; }
    /// The item that shows a brush; null if there is none.
    QListWidgetItem *itemOf(const QString &name) const;
    /// The number of pictures that are still to be drawn.
    int pendingPreviews() const { return int(m_pending.size()); }

    QSize sizeHint() const override;

signals:
    /// Emitted when somebody has chosen a brush to paint with, by mouse or keys; it may be the one in hand. A press of
    /// the right button, which opens the menu, only takes the brush in hand.
    void chosen();

protected:
    void paintEvent(QPaintEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    void addHead(QVBoxLayout &column);
    void addList(QVBoxLayout &column);
    void addFields(QVBoxLayout &column);
    void fillList();
    void addHeading(const QString &group);
    void fitHeadings();
    bool isShown(const Brush &brush) const;
    void edit(const std::function<void(Brush &)> &change);
    void refresh();
    void setPicture(QListWidgetItem *item);
    void schedulePreviews();
    void renderNext();
    QString inHand() const;

    Editor &m_editor;
    QLineEdit *m_search = nullptr;
    QToolButton *m_favourites = nullptr;
    BrushMenu *m_menu = nullptr;
    QListWidget *m_list = nullptr;
    QLabel *m_title = nullptr;
    QToolButton *m_reset = nullptr;
    SliderField *m_size = nullptr;
    SliderField *m_flow = nullptr;
    SliderField *m_opacity = nullptr;
    HintLabel *m_hint = nullptr;
    BrushPreview m_preview;
    /// Which pictures are drawn, and what they show.
    struct Drawn {
        Brush brush;
        QImage image;
    };
    QHash<QString, Drawn> m_drawn;
    std::vector<QString> m_pending; ///< the brushes without a picture yet, the next one last
    bool m_started = false;
};

} // namespace suffuse
