#pragma once

#include "app/panels/brush_preview.h"

#include <QWidget>

#include <functional>

class QLabel;
class QListWidget;
class QToolButton;
class QVBoxLayout;

namespace suffuse {

class Editor;
class HintLabel;
class SliderField;

/// The brushes with pictures of their strokes, and size, flow and opacity of the one in hand.
class BrushPanel : public QWidget {
    Q_OBJECT

public:
    explicit BrushPanel(Editor &editor, QWidget *parent = nullptr);

    QListWidget *list() const { return m_list; }
    SliderField *size() const { return m_size; }
    SliderField *flow() const { return m_flow; }
    SliderField *opacity() const { return m_opacity; }
    QToolButton *resetButton() const { return m_reset; }
    /// Pictures still to be drawn.
    int pendingPreviews() const { return int(m_pending.size()); }

    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    void fillList();
    void addFields(QVBoxLayout &column);
    void choose(const QString &id);
    void edit(const std::function<void(Brush &)> &change);
    bool isModified() const;
    void refresh();
    void schedulePreviews();
    void renderNext();

    Editor &m_editor;
    QListWidget *m_list = nullptr;
    QLabel *m_title = nullptr;
    QToolButton *m_reset = nullptr;
    SliderField *m_size = nullptr;
    SliderField *m_flow = nullptr;
    SliderField *m_opacity = nullptr;
    HintLabel *m_hint = nullptr;
    BrushPreview m_preview;
    std::vector<int> m_pending; ///< rows whose picture is missing, last first
    bool m_started = false;
};

} // namespace suffuse
