// The values of what was double-clicked, where it was.
#pragma once

#include "app/panels/inspector/inspected.h"
#include "app/widgets/habits/floating_card.h"

#include <optional>

class QLabel;
class QToolButton;

namespace suffuse {

class CanvasWidget;
class Editor;
class HintLabel;
class FillSection;
class NumberField;
class SegmentSection;
class SliderField;
class ValueEntry;

/// Width, D, φ, colour and opacity of the selected strokes, or of the one segment that was pointed at. The rows are
/// those of the inspector and do what they do there; the widths of several segments keep their proportions.
class ValueCard : public FloatingCard {
    Q_OBJECT

public:
    explicit ValueCard(CanvasWidget &canvas);

    /// For the selection, which has strokes; `at` is the segment that was pointed at, if any.
    void openAt(QPoint global, std::optional<SegmentRef> at);

    SegmentSection *segments() const { return m_segments; }
    SliderField *width() const { return m_width; }
    FillSection *fill() const { return m_fill; }
    QToolButton *wholeButton() const { return m_whole; }
    QToolButton *segmentButton() const { return m_one; }

protected:
    /// Return leaves the card open where a number was refused, so that it is seen why.
    void keyPressEvent(QKeyEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void addHead();
    void refuse(const QString &why);
    void showFew();
    void refresh();
    void setWidth(double width, ValueEntry *entry);
    NumberField *firstNumber() const;
    double widest(const Inspected &inspected) const;
    void choose(bool whole);

    CanvasWidget &m_canvas;
    Editor &m_editor;
    QLabel *m_title = nullptr;
    QToolButton *m_whole = nullptr;
    QToolButton *m_one = nullptr;
    SliderField *m_width = nullptr;
    SegmentSection *m_segments = nullptr;
    FillSection *m_fill = nullptr; ///< in their place where fills are all that is seen
    HintLabel *m_hint = nullptr;
    bool m_refused = false; ///< what was typed last, by the key that is being handled
    std::optional<SegmentRef> m_at;
    std::set<StrokeId> m_strokes; ///< of the selection that it was opened for
};

} // namespace suffuse
