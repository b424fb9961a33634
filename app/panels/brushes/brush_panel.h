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

/// The brushes in their groups with pictures of their strokes; search, favourites and what can be done with a brush;
/// and size, flow and opacity of the one in hand.
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
    /// The item of a brush that is shown; null if there is none.
    QListWidgetItem *itemOf(const QString &name) const;
    /// Pictures still to be drawn.
    int pendingPreviews() const { return int(m_pending.size()); }

    QSize sizeHint() const override;

signals:
    /// A brush was chosen to paint with, by mouse or keys, be it the one in hand. A press of the right button, for the
    /// menu, only takes it in hand.
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
    /// Pictures that are drawn, and of what.
    struct Drawn {
        Brush brush;
        QImage image;
    };
    QHash<QString, Drawn> m_drawn;
    std::vector<QString> m_pending; ///< brushes whose picture is missing, last first
    bool m_started = false;
};

} // namespace suffuse
