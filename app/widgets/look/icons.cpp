#include "app/widgets/look/icons.h"

#include <QDir>
#include <QGuiApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QResource>
#include <QSvgRenderer>

namespace suffuse {

namespace {

/// The file of an outline, on a 24 × 24 grid and in "currentColor"; empty if there is none.
QByteArray svgOf(const QString &name)
{
    return QResource(QStringLiteral(":/outlines/%1.svg").arg(name)).uncompressedData();
}

QColor inkOf(QIcon::Mode mode)
{
    const QPalette p = QGuiApplication::palette();
    if (mode == QIcon::Selected)
        return p.color(QPalette::HighlightedText);
    return p.color(mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active, QPalette::ButtonText);
}

/// Paints a drawing sharply at every size, and an outline in the palette's present colour.
class DrawingEngine : public QIconEngine {
public:
    explicit DrawingEngine(const QByteArray &svg) : m_svg(svg) {}

    void paint(QPainter *painter, const QRect &rect, QIcon::Mode mode, QIcon::State) override
    {
        const QColor ink = inkOf(mode);
        const QByteArray stroke = ink.name().toLatin1() + "\" stroke-opacity=\"" + QByteArray::number(ink.alphaF());
        QSvgRenderer svg(QByteArray(m_svg).replace("currentColor", stroke));
        svg.setAspectRatioMode(Qt::KeepAspectRatio);
        painter->setRenderHint(QPainter::Antialiasing);
        svg.render(painter, rect);
    }

    QPixmap pixmap(const QSize &size, QIcon::Mode mode, QIcon::State state) override
    {
        QPixmap pixmap(size);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        paint(&painter, QRect(QPoint(), size), mode, state);
        return pixmap;
    }

    QIconEngine *clone() const override { return new DrawingEngine(m_svg); }
    QString key() const override { return "suffuse-drawing"; }
    bool isNull() override { return m_svg.isEmpty(); }

private:
    const QByteArray m_svg;
};

} // namespace

QIcon icon(const QString &name)
{
    const QByteArray outline = svgOf(name);
    return outline.isEmpty() ? QIcon() : QIcon(new DrawingEngine(outline));
}

QStringList iconNames()
{
    return QDir(QStringLiteral(":/outlines")).entryList(QDir::Files, QDir::Name).replaceInStrings(".svg", QString());
}

QIcon applicationIcon()
{
    // The icon needs pixmaps: window systems ask it for the sizes that it has.
    DrawingEngine drawing(QResource(QStringLiteral(":/suffuse.svg")).uncompressedData());
    QIcon result;
    for (const int size : {16, 24, 32, 48, 64, 128, 256})
        result.addPixmap(drawing.pixmap(QSize(size, size), QIcon::Normal, QIcon::Off));
    return result;
}

} // namespace suffuse
