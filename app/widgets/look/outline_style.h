// The Fusion style with our own icons, also in dialogs and on title bars.
#pragma once

#include <QProxyStyle>

namespace suffuse {

/// Fusion draws small pictures of fixed size, which blur on fine screens and stay as they are when the theme changes.
/// This style returns outlines in their place (app/widgets/look/icons.h).
class OutlineStyle : public QProxyStyle {
    Q_OBJECT

public:
    OutlineStyle();

    QIcon standardIcon(StandardPixmap standard, const QStyleOption *option, const QWidget *widget) const override;
    QPixmap standardPixmap(StandardPixmap standard, const QStyleOption *option, const QWidget *widget) const override;
    /// Check boxes have an edge that is seen on every ground, in menus too: Fusion's is dark on dark there. So have
    /// buttons and lists that drop down, where they have the keyboard.
    void drawPrimitive(PrimitiveElement element, const QStyleOption *option, QPainter *painter,
                       const QWidget *widget) const override;
    /// In the dark palette tool bars have quiet edges, and lines between the entries of a menu are seen: Fusion's edges
    /// are white there and its lines black.
    void drawControl(ControlElement element, const QStyleOption *option, QPainter *painter,
                     const QWidget *widget) const override;
    /// The handle of a scroll bar is seen on its groove, in the light palette too.
    void drawComplexControl(ComplexControl control, const QStyleOptionComplex *option, QPainter *painter,
                            const QWidget *widget) const override;
    /// Headings in menus have room above and below them, so that one on top does not touch the frame.
    QSize sizeFromContents(ContentsType type, const QStyleOption *option, const QSize &contents,
                           const QWidget *widget) const override;
    int styleHint(StyleHint hint, const QStyleOption *option, const QWidget *widget,
                  QStyleHintReturn *result) const override;
    int pixelMetric(PixelMetric metric, const QStyleOption *option, const QWidget *widget) const override;
};

} // namespace suffuse
