#pragma once

#include "model/edit.h"

#include <QWidget>

class QLabel;
class QScrollArea;

namespace suffuse {

class CanvasSection;
class Editor;
class HintLabel;
class SegmentSection;
class StrokeSection;
class StyleSection;

/// Values of the selected segments and strokes; with nothing selected, those of the canvas. Each change is one undo
/// step, a slider drag too.
class InspectorPanel : public QWidget {
    Q_OBJECT

public:
    explicit InspectorPanel(Editor &editor, QWidget *parent = nullptr);

    SegmentSection *segmentSection() const { return m_segments; }
    StyleSection *styleSection() const { return m_style; }
    StrokeSection *strokeSection() const { return m_strokes; }
    CanvasSection *canvasSection() const { return m_canvas; }
    HintLabel *hint() const { return m_hint; }

    QSize sizeHint() const override;

protected:
    void showEvent(QShowEvent *event) override;

private:
    void refresh();
    void documentChanged(const Change &change);

    Editor &m_editor;
    QScrollArea *m_scroll = nullptr;
    QLabel *m_summary = nullptr;
    SegmentSection *m_segments = nullptr;
    StyleSection *m_style = nullptr;
    StrokeSection *m_strokes = nullptr;
    QWidget *m_selectionPage = nullptr;
    QWidget *m_canvasPage = nullptr;
    CanvasSection *m_canvas = nullptr;
    HintLabel *m_hint = nullptr;
    bool m_stale = true;
};

} // namespace suffuse
