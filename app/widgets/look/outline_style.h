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
    int styleHint(StyleHint hint, const QStyleOption *option, const QWidget *widget,
                  QStyleHintReturn *result) const override;
    int pixelMetric(PixelMetric metric, const QStyleOption *option, const QWidget *widget) const override;
};

} // namespace suffuse
