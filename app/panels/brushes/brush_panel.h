#pragma once

#include "model/brush/brush.h"

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

class BrushGrid;
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

    QListWidget *list() const;
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
    int pendingPreviews() const;

    QSize sizeHint() const override;

signals:
    /// Emitted when somebody has chosen a brush to paint with, by mouse or keys; it may be the one in hand. A press of
    /// the right button, which opens the menu, only takes the brush in hand.
    void chosen();

private:
    void addHead(QVBoxLayout &column);
    void addList(QVBoxLayout &column);
    void addFields(QVBoxLayout &column);
    void fillList();
    void chooseFound();
    bool isShown(const Brush &brush) const;
    void edit(const std::function<void(Brush &)> &change);
    void refresh();
    QString inHand() const;

    Editor &m_editor;
    QLineEdit *m_search = nullptr;
    QToolButton *m_favourites = nullptr;
    BrushMenu *m_menu = nullptr;
    BrushGrid *m_list = nullptr;
    QLabel *m_title = nullptr;
    QToolButton *m_reset = nullptr;
    SliderField *m_size = nullptr;
    SliderField *m_flow = nullptr;
    SliderField *m_opacity = nullptr;
    HintLabel *m_hint = nullptr;
};

} // namespace suffuse
