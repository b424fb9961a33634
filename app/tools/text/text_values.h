// What a text is set with: shown and changed in the row, for the text in hand, the selected one or the next.
#pragma once

#include "app/session/lettering/text_entry.h"
#include "app/session/value_entry.h"
#include "app/tools/text/text_row.h"

#include <QPointer>

namespace suffuse {

class CanvasWidget;

/// Keeps how the next text will be set, and hands what is changed in the row to the text that is meant.
class TextValues : public QObject {
    Q_OBJECT

public:
    TextValues(CanvasWidget &canvas, TextEntry &entry, QObject *parent);

    QWidget *options();
    void showRow();
    /// How the next text will be set.
    const Text &style() const { return m_style; }
    /// What was selected when the text was taken into the hand.
    void noteChosen(const std::set<StrokeId> &strokes) { m_chosen = strokes; }

signals:
    void locked(); ///< the text that should be changed is locked, or something in it is

private:
    void changeValues(const TextRow::Change &how);
    StrokePtr selectedStroke() const;
    void bend();
    void straighten();
    void setOnCurve(const std::vector<Cubic> &curve, StrokeId stroke);

    CanvasWidget &m_canvas;
    Editor &m_editor;
    TextEntry &m_entry;
    Text m_style;
    TextLayout m_layout; ///< for texts that are not in hand
    ValueEntry m_values; ///< of the row, for a text that is selected
    std::set<StrokeId> m_chosen;
    QPointer<TextRow> m_row;
};

} // namespace suffuse
