#pragma once

#include "model/document/edit.h"

#include <QPointer>
#include <QWidget>

class QLabel;
class QToolButton;
class QVBoxLayout;
class QScrollArea;

namespace suffuse {

class AlongDialog;
class CanvasSection;
class CompareButton;
class Editor;
class FiguresSection;
class FillSection;
class GroupSection;
class HintLabel;
struct Inspected;
class PictureSection;
class ScrollPlace;
class SegmentSection;
class StrokeSection;
class StyleSection;
class UnderlaySection;

/// Shows the values of the selected segments and strokes; with nothing selected, those of the canvas. Each change is
/// one undo step, and so is each drag of a slider.
class InspectorPanel : public QWidget {
    Q_OBJECT

public:
    explicit InspectorPanel(Editor &editor, QWidget *parent = nullptr);

    GroupSection *groupSection() const { return m_groups; }
    PictureSection *pictureSection() const { return m_picture; }
    SegmentSection *segmentSection() const { return m_segments; }
    StyleSection *styleSection() const { return m_style; }
    FillSection *fillSection() const { return m_fill; }
    FiguresSection *figuresSection() const { return m_figures; }
    StrokeSection *strokeSection() const { return m_strokes; }
    CanvasSection *canvasSection() const { return m_canvas; }
    UnderlaySection *underlaySection() const { return m_underlay; }
    CompareButton *compare() const { return m_compare; }
    QToolButton *alongButton() const { return m_alongButton; }
    AlongDialog *along() const; ///< null while it is not open
    HintLabel *hint() const { return m_hint; }

    QSize sizeHint() const override;

    /// Opens the dialog "Along the Stroke", or brings it to the front where it is open. The panel itself may be hidden.
    void openAlong();

signals:
    /// Emitted before the dialog is shown, so that the window can place it.
    void alongOpening(QWidget *dialog);

protected:
    void showEvent(QShowEvent *event) override;

private:
    void putFirst(bool fill);
    void orderTabs();
    void addHead(QVBoxLayout &column);
    void refresh();
    void showValues(const Inspected &inspected);
    void documentChanged(const Change &change);

    Editor &m_editor;
    QScrollArea *m_scroll = nullptr;
    ScrollPlace *m_place = nullptr;
    QLabel *m_summary = nullptr;
    CompareButton *m_compare = nullptr;
    QToolButton *m_alongButton = nullptr;
    QPointer<AlongDialog> m_along;
    GroupSection *m_groups = nullptr;
    PictureSection *m_picture = nullptr;
    SegmentSection *m_segments = nullptr;
    StyleSection *m_style = nullptr;
    FillSection *m_fill = nullptr;
    FiguresSection *m_figures = nullptr;
    StrokeSection *m_strokes = nullptr;
    QWidget *m_selectionPage = nullptr;
    QWidget *m_canvasPage = nullptr;
    CanvasSection *m_canvas = nullptr;
    UnderlaySection *m_underlay = nullptr;
    HintLabel *m_hint = nullptr;
    bool m_stale = true;
};

} // namespace suffuse
