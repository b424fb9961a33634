// The layer that is painted on.
#pragma once

#include "app/session/layer_steps.h"
#include "model/formats/files.h"
#include "undo/layers/layer_edits.h"

#include <QObject>

namespace suffuse {

class PaintingClock;

/// The name of a group that people see. One without a name has what it is and its number; a text is called by what it
/// says.
QString titleOf(const Group &group);
/// A name for a copy of a group that no group of a painting has yet.
QString nameOfCopy(const std::vector<Group> &groups, const QString &name);

/// Remembers which group what is painted goes into, or that it is none. This is no part of the painting, and nothing
/// that is undone by itself; but where a step made another group the layer, undoing it gives back the one before, and
/// where undo or redo select strokes again, the layer is the one that it was when they were selected. Where
/// a group goes, the one around it becomes the layer. Where it goes since it has no stroke any more, it stays the layer
/// and comes again with the next stroke, in its place.
class CurrentLayer : public QObject {
    Q_OBJECT

public:
    CurrentLayer(Document &document, const PaintingClock &clock);

    /// The group; 0: none. It may be one that comes with its first stroke.
    GroupId group() const { return m_layer.group; }
    /// Whether it is not in the painting yet.
    bool isComing() const;
    /// The name of the layer, for people; empty where there is none.
    QString title() const;

    /// Makes a group the layer or, of a text, the group around it; 0: none.
    void choose(GroupId group);
    /// The same, as a part of the step that was done last: undoing that gives back the layer before.
    void chooseByStep(GroupId group);
    /// Begins a layer just above this one, or on top of all where there is none. It comes into being with the first
    /// stroke that is painted on it.
    void beginNew() { beginNew(false); }
    /// Begins a layer in the same way, clipped to the one below: it is seen only where that has paint.
    void beginClipped() { beginNew(true); }

    /// What beginNew or beginClipped has begun, as long as it has no stroke; none else, and none of a layer that was
    /// there before and has lost its last stroke.
    std::optional<BegunLayer> begun() const;
    /// Goes on with what was begun when the painting was saved, if the group around it is there.
    void beginAgain(const BegunLayer &begun);

    /// Whether tools reach only what is in the layer, where there is one. It is remembered in the settings.
    bool isOnly() const { return m_isOnly; }
    void setOnly(bool only);
    /// The layer, if tools reach only what is in it; 0: they reach everything.
    GroupId reachedGroup() const { return m_isOnly ? m_layer.group : 0; }
    /// The painting as tools find strokes in it: all, or what is in the layer. Of a hidden or locked one they find
    /// none.
    PaintingPtr reached() const;
    /// Says that tools reach the layer only.
    void noteOnly();

    /// Lets the edit take away the groups that lose their last stroke by it. If the layer is one of them, it will come
    /// again.
    void takeEmptied(Edit &edit);
    /// These follow the undo stack: a step is pushed, as that number; so many steps are done after undo or redo; and
    /// the stack has others now.
    void stepComes(int number);
    void walkTo(int steps);
    void forgetSteps(int steps);

    /// Whether paint may come. If the layer is hidden or locked, it may not, and `noted` says so.
    bool takesPaint();
    /// The edit with the strokes that it adds on top put into the layer; none if that takes no paint. Where others are
    /// shown alone, all are shown again.
    Edit take(Edit edit, LayerEnd end = LayerEnd::Top);
    /// The same of what is pasted: into the layer, or just above it where groups come or it takes no paint.
    Edit takePasted(Edit edit);
    /// Whether paint comes on top of all, and shows there.
    bool isTop() const;
    /// The painting with the draft, and what comes with it, in the place where they will be. There must be a draft.
    PaintingPtr withDraft() const;

signals:
    /// Emitted when another group is the layer, it has come into being or has another name, or whether tools reach it
    /// only.
    void changed();
    /// What people should read where they paint.
    void noted(const QString &text);

private:
    /// Where the draft is put. It is found once for each stroke.
    struct DraftPlace {
        PaintingPtr painting;
        StrokeId draft = 0;
        GroupId layer = 0;
        bool isInPast = false;
        std::size_t index = 0;
        GroupId group = 0;
        std::optional<std::vector<Group>> groups;
    };

    void follow(const Change &change);
    void set(PaintedLayer layer);
    void beginNew(bool clips);
    void noteNew();
    void tell();
    bool canBe(const PaintedLayer &layer) const;
    int numberIn(const QString &name) const;
    QString newName() const;
    void deselectWithin(GroupId group);
    const Group *closed() const;
    std::optional<Microseconds> bornIn(const Edit &edit) const;
    Edit put(Edit edit, LayerEnd end) const;
    Edit shown(Edit edit);
    bool findDraftPlace() const;

    Document &m_document;
    const PaintingClock &m_clock;
    PaintedLayer m_layer;
    PaintedLayer m_chosen; ///< as it was chosen, or after the step that was done last
    LayerSteps m_steps;
    int m_done = 0;                ///< steps
    bool m_selects = false;        ///< whether an edit has selected something else since the last step
    int m_lastNumber = 0;          ///< of a layer that was new in this painting
    std::vector<GroupId> m_around; ///< the groups around it when it was there last, the innermost first
    QString m_title;               ///< as it was told last
    bool m_wasComing = false;      ///< when that was told
    mutable DraftPlace m_place;
    bool m_isOnly = false;
    mutable PaintingPtr m_whole, m_reached; ///< what it was asked for last, and the answer
    mutable GroupId m_reachedGroup = 0;
};

} // namespace suffuse
