#pragma once

#include "model/document/edit.h"

#include <QObject>

namespace suffuse {

/// The only writer of a painting. Lives on the GUI thread; snapshots may go anywhere.
class Document : public QObject {
    Q_OBJECT

public:
    explicit Document(QObject *parent = nullptr);

    /// The committed painting, without the draft.
    const PaintingPtr &painting() const { return m_painting; }
    /// What is to be seen: the painting with the draft on top, if there is one.
    PaintingPtr snapshot() const;

    const Selection &selection() const { return m_selection; }
    /// Selects without an undo step. Ids and segments that do not exist are dropped.
    void setSelection(Selection selection);

    /// Swaps the edit's state with the document's and emits `changed` once. The edit must name existing strokes or ones
    /// that it adds, and its order must be a permutation of what is then there (asserted). A whole order is replaced by
    /// the places that differ: what an undo step holds is in proportion to what it changes. Segments that no longer
    /// exist leave the selection.
    void exchange(Edit &edit);

    /// The stroke in hand, drawn on top, in no undo step; null removes it.
    void setDraft(StrokePtr draft);
    const StrokePtr &draft() const { return m_draft; }

    /// Another painting: selection and draft are cleared.
    void reset(PaintingPtr painting);

    /// An id that no stroke has, nor had in this document's life (undo may bring strokes back).
    StrokeId takeStrokeId();
    GroupId takeGroupId();
    /// Never gives away the ids that an edit names: a later undo may bring them back.
    void reserve(const Edit &edit);

signals:
    /// An edit is about to be exchanged. Who shows a state that is in no step yet takes it back before that.
    void aboutToExchange();
    void changed(const suffuse::Change &change);

private:
    /// Once all else is exchanged. Segments that no longer exist leave the selection.
    void exchangeSelection(Edit &edit, Change &change);

    PaintingPtr m_painting;
    StrokePtr m_draft;
    Selection m_selection;
    StrokeId m_nextStroke = 1;
    GroupId m_nextGroup = 1;
};

} // namespace suffuse
