// What opens where the pointer is: a menu, the brush palette, and values.
#pragma once

#include "app/canvas/input/pointer_event.h"
#include "app/window/workplace.h"
#include "model/painting/selection.h"

#include <QObject>
#include <QPointer>

#include <optional>

class QMenu;

namespace suffuse {

class BrushPalette;
class ValueCard;

/// With the Brush the right button opens the palette, with Shift and with every other tool the menu; on a ruler it
/// opens the ruler's menu. A double click of the Select tool on paint opens its values. All three have keys, too, and
/// open at the pointer then, or at the selection where the pointer is elsewhere.
class AtPointer : public QObject {
    Q_OBJECT

public:
    AtPointer(const Workplace &place, QObject *parent);
    ~AtPointer() override;

    QMenu *menu() const { return m_menu; }

private:
    void addRows();
    void ask(const PointerEvent &event);
    bool isOnRuler(Point pixel) const;
    void openMenu(Point pixel);
    void openPalette(Point pixel);
    void openValues(Point pixel, std::optional<SegmentRef> at);
    void editHere();
    void menuByKey();
    /// Where the pointer is over the canvas, else the middle of what is selected and seen, else of the canvas.
    Point here() const;
    QPoint onScreen(Point pixel) const;

    Workplace m_place;
    QMenu *m_menu = nullptr;
    QPointer<BrushPalette> m_palette; ///< made when it is wanted
    QPointer<ValueCard> m_values;
};

} // namespace suffuse
