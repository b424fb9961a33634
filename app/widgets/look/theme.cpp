#include "app/widgets/look/theme.h"

#include "app/session/settings/settings.h"
#include "app/widgets/look/outline_style.h"

#include <QApplication>
#include <QImage>
#include <QMessageBox>
#include <QPalette>
#include <QToolTip>

namespace suffuse {

namespace {

struct Tones {
    QRgb window, base, alternate, button, text, dim, disabled, accent, accentText, light, mid, dark, tip, tipText, link,
        warning;
};

constexpr Tones lightTones{0xFFF0F0F1, 0xFFFCFCFC, 0xFFF5F5F6, 0xFFE6E6E8, 0xFF1E1F22, 0xFF5C5F66,
                           0xFF9A9CA2, 0xFF2F6690, 0xFFFFFFFF, 0xFFFFFFFF, 0xFFC4C5C9, 0xFFA3A5AA,
                           0xFF2B2D31, 0xFFF0F0F1, 0xFF275A80, 0xFFA23B1A};
constexpr Tones darkTones{0xFF2F3135, 0xFF1C1D20, 0xFF212326, 0xFF3A3D41, 0xFFE3E4E6, 0xFFA6A9AF,
                          0xFF74777D, 0xFF376F9B, 0xFFFFFFFF, 0xFF4A4E53, 0xFF1D1E21, 0xFF17181A,
                          0xFFE3E4E6, 0xFF1E1F22, 0xFF86B6DA, 0xFFF0A48A};

QPalette paletteOf(const Tones &t)
{
    QPalette p;
    const auto set = [&p](QPalette::ColorRole role, QRgb colour) { p.setColor(role, QColor::fromRgb(colour)); };
    set(QPalette::Window, t.window);
    set(QPalette::WindowText, t.text);
    set(QPalette::Base, t.base);
    set(QPalette::AlternateBase, t.alternate);
    set(QPalette::Text, t.text);
    set(QPalette::PlaceholderText, t.dim);
    set(QPalette::Button, t.button);
    set(QPalette::ButtonText, t.text);
    set(QPalette::BrightText, t.warning);
    set(QPalette::Highlight, t.accent);
    set(QPalette::HighlightedText, t.accentText);
    set(QPalette::ToolTipBase, t.tip);
    set(QPalette::ToolTipText, t.tipText);
    set(QPalette::Link, t.link);
    set(QPalette::LinkVisited, t.link);
    set(QPalette::Light, t.light);
    set(QPalette::Midlight, t.button);
    set(QPalette::Mid, t.mid);
    set(QPalette::Dark, t.dark);
    set(QPalette::Shadow, 0xFF101113);
    for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        p.setColor(QPalette::Disabled, role, QColor::fromRgb(t.disabled));
    p.setColor(QPalette::Disabled, QPalette::Highlight, QColor::fromRgb(t.mid));
    p.setColor(QPalette::Disabled, QPalette::HighlightedText, QColor::fromRgb(t.disabled));
    return p;
}

bool systemIsDark()
{
    // Before the first applyTheme the palette is the platform's own.
    static const bool dark = QApplication::palette().color(QPalette::Window).lightness() <
                             QApplication::palette().color(QPalette::WindowText).lightness();
    return dark;
}

} // namespace

QPalette lightPalette()
{
    return paletteOf(lightTones);
}

QPalette darkPalette()
{
    return paletteOf(darkTones);
}

void applyTheme()
{
    const bool platformDark = systemIsDark();
    const settings::Theme theme = settings::theme();
    const bool dark = theme == settings::Theme::Dark || (theme == settings::Theme::System && platformDark);
    if (!qobject_cast<OutlineStyle *>(QApplication::style()))
        QApplication::setStyle(new OutlineStyle);
    const QPalette palette = dark ? darkPalette() : lightPalette();
    QApplication::setPalette(palette);
    QToolTip::setPalette(palette); // tool tips have a palette of their own
    for (QWidget *window : QApplication::topLevelWidgets())
        if (auto *box = qobject_cast<QMessageBox *>(window))
            box->setIcon(box->icon()); // the box keeps its icon as a picture
}

bool isDarkTheme()
{
    return QApplication::palette().color(QPalette::Window).lightness() < 128;
}

QColor previewPaper()
{
    return QColor::fromRgb(isDarkTheme() ? 0xFFECEAE5 : 0xFFFFFEFB);
}

QColor paperFor(const QImage &picture)
{
    // The lightest half of the covering pixels decides: a dark outline around white paint would be seen anyway.
    constexpr int light = 215, covers = 24;
    qint64 covered = 0, pale = 0;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x) {
            const QRgb pixel = picture.pixel(x, y);
            covered += qAlpha(pixel) >= covers;
            pale += qAlpha(pixel) >= covers && qGray(pixel) >= light;
        }
    return covered > 0 && pale > covered / 2 ? QColor::fromRgb(0xFF8E8F92) : previewPaper();
}

QColor edgeOfColours()
{
    return QColor::fromRgb(isDarkTheme() ? 0xFF85888E : 0xFF7E8187);
}

QColor warningText()
{
    return QApplication::palette().color(QPalette::BrightText);
}

QColor focusFrame()
{
    return QApplication::palette().color(QPalette::Link); // the accent colour, as light or dark as it takes to be seen
}

QColor hairline()
{
    return QColor::fromRgb(isDarkTheme() ? 0xFF45484D : 0xFFCFD0D4);
}

} // namespace suffuse
