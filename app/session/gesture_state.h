// What one gesture knows: what it shows, and the way back.
#pragma once

#include "model/document/edit.h"
#include "model/painting/stroke.h"
#include "model/shaping/transform.h"

#include <QPointer>
#include <QString>

#include <functional>
#include <map>
#include <optional>
#include <set>

namespace suffuse {

class GestureDesk;
class GestureSteps;

/// Of a Gesture, which says what its functions do, and of the desk on which it lies while it is open. It may outlive
/// the desk, and shows nothing then.
class GestureState {
public:
    GestureState(GestureDesk &desk, const QString &name, GestureSteps *steps = nullptr);

    void show(Edit edit);
    void take(const std::set<StrokeId> &strokes);
    /// Where all of it is one map, texts follow it.
    void showEach(const std::function<Stroke(const Stroke &)> &change, const Affine *map = nullptr);
    void floatBy(const Affine &map, SpreadRule rule);
    bool isRefused() const { return m_isRefused; }
    std::set<StrokeId> strokes() const;
    const Stroke *before(StrokeId stroke) const;
    void rest();
    void commit();
    void giveUp();

    // For the desk.
    const QString &name() const { return m_name; }
    GestureSteps *steps() const { return m_steps; } ///< null: it has none
    /// The way back so far; null: nothing has been changed.
    const Edit *back() const { return m_back ? &*m_back : nullptr; }
    /// Puts what floats into the document.
    void settle();
    /// Lifts strokes anew that have left the picture.
    void liftAnew();
    /// The way back to the start; what is shown stays. None, where nothing was changed.
    std::optional<Edit> takeBack();
    /// The same, of what is to be exchanged now: everything is put back.
    std::optional<Edit> takeUndo();
    /// Another painting is there: there is no way back, and nothing to go on with.
    void forget();

private:
    struct Taken {
        StrokePtr before;
        StrokePtr shown;
        bool kept = false; ///< it is in the document as it was shown
    };
    void showMapped();
    /// From where strokes were lifted to where they are shown.
    Affine sinceLift() const;

    QPointer<GestureDesk> m_desk;
    QString m_name;
    GestureSteps *m_steps = nullptr;
    std::optional<Edit> m_back;
    std::map<StrokeId, Taken> m_taken;
    std::map<GroupId, Text> m_texts; ///< of which all strokes are taken, as they were
    Affine m_map;                    ///< that is shown
    SpreadRule m_rule = SpreadRule::Scales;
    Affine m_liftedAt; ///< the map under which the strokes were lifted
    bool m_maps = false;
    bool m_leads = false;     ///< a text that is not taken follows what is, and must be seen to
    bool m_isRefused = false; ///< the map that is shown
    bool m_afloat = false;    ///< something is shown that the document does not have
};

} // namespace suffuse
