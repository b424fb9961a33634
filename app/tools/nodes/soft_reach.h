// How far along a stroke a drag of its nodes or its curve takes along what lies near.
#pragma once

#include "model/painting/stroke.h"
#include "model/painting/stroke_places.h"
#include "model/shaping/nodes/soft_move.h"
#include "render/view.h"

#include <QObject>
#include <QPointer>

#include <optional>

class QHBoxLayout;
class QToolButton;

namespace suffuse {

class NumberField;

/// The reach is a length along the curve in canvas units. Either the user has chosen it, or it follows the view: where
/// nodes are left out because they would crowd on the screen, a drag bends a soft part of the stroke, which goes to
/// some shown nodes on either side. Elsewhere the drag moves nothing else. The settings remember the choice.
class SoftReach : public QObject {
    Q_OBJECT

public:
    explicit SoftReach(QObject *parent = nullptr);

    /// The reach that the user has chosen; no value while it follows the view.
    std::optional<double> chosen() const { return m_chosen; }
    void choose(std::optional<double> reach);

    /// What the ends of strokes do: where the reach follows the view, they stay.
    SoftMove::Ends ends() const { return m_chosen ? SoftMove::Ends::Follow : SoftMove::Ends::Stay; }

    /// The reach of a drag of a node that begins in a view. If it is 0, the drag takes nothing along.
    double ofNode(const Stroke &stroke, int node, const View &view, double dpr) const;
    /// The reach of a drag of a place on the curve.
    double ofCurve(const Stroke &stroke, const CurvePlace &place, const View &view, double dpr) const;
    /// The reach that follows the view, where it takes anything along.
    static double usual(const View &view, double dpr);
    /// A reach that is made larger by so many steps, or smaller, and is 0 at last.
    static double stepped(double reach, double steps, const View &view, double dpr);
    /// The reach, or 0 if it is shorter on the screen than a hand can set.
    static double settled(double reach, const View &view, double dpr);

    /// Adds a field for it, and a button that lets it follow the view, to the tool's row.
    void addTo(QHBoxLayout &row);
    /// Follows the view: the field shows the reach that a soft drag has there, unless the user has chosen one.
    void follow(const View &view, double dpr);
    /// Shows in the field the reach of the drag that goes on; no value if the drag is over.
    void showInEffect(std::optional<double> reach);

private:
    void update();

    std::optional<double> m_chosen;
    std::optional<double> m_inEffect; ///< the reach of the drag that goes on
    std::optional<double> m_usual;    ///< that of the view
    QPointer<NumberField> m_field;
    QPointer<QToolButton> m_follows;
};

} // namespace suffuse
