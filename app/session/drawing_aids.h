// What helps to draw and is no part of the picture.
#pragma once

#include "model/geometry/assistant.h"
#include "model/geometry/guide.h"
#include "model/geometry/symmetry.h"

#include <QObject>

#include <vector>

namespace suffuse {

/// The symmetry in which a painting is painted, its guides, and the assistants that lead strokes. Files keep them with
/// how the painting was looked at, so changing them is no undo step, and all windows of a painting share them.
class DrawingAids : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    const Symmetry &symmetry() const { return m_symmetry; }
    /// Numbers out of range are brought within it.
    void setSymmetry(Symmetry symmetry);
    /// The one that a painting begins with: off, around the middle of its canvas.
    static Symmetry usualSymmetry(const Rect &canvas);

    const std::vector<Guide> &guides() const { return m_guides; }
    void setGuides(std::vector<Guide> guides);

    const std::vector<Assistant> &assistants() const { return m_assistants; }
    /// Those that lack points, or have them too far away, are left out.
    void setAssistants(std::vector<Assistant> assistants);

    /// Of another painting, with nothing of the one before.
    void reset(const Rect &canvas);

signals:
    void changed();
    /// Another painting comes: whoever drags something must let it go now.
    void aboutToReset();

private:
    Symmetry m_symmetry;
    std::vector<Guide> m_guides;
    std::vector<Assistant> m_assistants;
};

} // namespace suffuse
