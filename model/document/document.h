#pragma once

#include "model/document/edit.h"

#include <QObject>

namespace suffuse {

/// The only writer of a painting. It lives on the GUI thread; its snapshots may be used on any thread.
class Document : public QObject {
    Q_OBJECT

public:
    explicit Document(QObject *parent = nullptr);

    /// The committed painting, without the draft.
    const PaintingPtr &painting() const { return m_painting; }
    /// What is to be shown: the painting with the draft on top, if there is one.
    PaintingPtr snapshot() const;

    const Selection &selection() const { return m_selection; }
    /// Selects without an undo step. Ids and segments that do not exist are dropped.
    void setSelection(Selection selection);

    /// Swaps the edit's state with the document's, and emits `changed` once. The edit must name strokes that exist or
    /// that it adds, and its order must be a permutation of those that exist then (asserted). A whole order is replaced
    /// by the places that differ, so that the size of an undo step is in proportion to what it changes. Segments that
    /// no longer exist leave the selection.
    void exchange(Edit &edit);

    /// Sets the stroke in hand, which is drawn on top and is in no undo step, and the strokes that come with it, such as
    /// its mirrored copies. Null removes all of them.
    void setDraft(StrokePtr draft, std::vector<StrokePtr> company = {});
    const StrokePtr &draft() const { return m_draft; }
    const std::vector<StrokePtr> &draftCompany() const { return m_draftCompany; }

    /// Takes another painting. Selection and draft are cleared.
    void reset(PaintingPtr painting);

    /// An id that no stroke has or has had while this document exists (undo may bring strokes back).
    StrokeId takeStrokeId();
    GroupId takeGroupId();
    /// Reserves the ids that an edit names, so that none of them is given away: a later undo may bring them back.
    void reserve(const Edit &edit);

signals:
    /// Emitted before an edit is exchanged. Whoever shows a state that is in no step yet must take it back now.
    void aboutToExchange();
    void changed(const suffuse::Change &change);

private:
    /// Swaps the selection, after all else. Segments that no longer exist leave it.
    void exchangeSelection(Edit &edit, Change &change);

    PaintingPtr m_painting;
    StrokePtr m_draft;
    std::vector<StrokePtr> m_draftCompany; ///< empty without a draft
    Selection m_selection;
    StrokeId m_nextStroke = 1;
    GroupId m_nextGroup = 1;
};

} // namespace suffuse
