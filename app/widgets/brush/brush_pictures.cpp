#include "app/widgets/brush/brush_pictures.h"

#include "app/session/settings/brush_library.h"
#include "app/widgets/look/theme.h"

#include <QApplication>
#include <QPainter>
#include <QPainterPath>
#include <QPalette>
#include <QPointer>
#include <QTimer>

namespace suffuse {

namespace {

/// `key`: 0: no favourite, else its number; beyond those with a key it has a star only.
void paintStar(QPainter &painter, int key, int width)
{
    QFont font = QApplication::font();
    font.setPixelSize(10);
    painter.setFont(font);
    painter.setPen(QColor(70, 70, 76));
    const QString number = key <= BrushLibrary::keys ? QString::number(key) : QString();
    painter.drawText(QRectF(0, 3, width - 5, 14), Qt::AlignRight | Qt::AlignTop, QStringLiteral("★") + number);
}

/// The mark of a brush that differs from what is saved.
void paintDot(QPixmap &sheet)
{
    QPainter painter(&sheet);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(Qt::white, 1.5));
    painter.setBrush(QApplication::palette().color(QPalette::Highlight));
    painter.drawEllipse(QPointF(9, 9), 4, 4);
}

QPixmap onPaper(const QImage &stroke, QSize size, double ratio, bool chosen, int key)
{
    QPixmap pixmap(size * ratio);
    pixmap.setDevicePixelRatio(ratio);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    QPainterPath paper;
    paper.addRoundedRect(QRectF(0.5, 0.5, size.width() - 1, size.height() - 1), 4, 4);
    painter.fillPath(paper, paperFor(stroke));
    if (!stroke.isNull()) {
        painter.setClipPath(paper);
        painter.drawImage(QRectF(QPointF(), QSizeF(size)), stroke);
        painter.setClipping(false);
    }
    painter.strokePath(paper,
                       chosen ? QPen(QApplication::palette().color(QPalette::Highlight), 4) : QPen(hairline(), 1));
    if (key > 0)
        paintStar(painter, key, size.width());
    return pixmap;
}

} // namespace

BrushPictures &BrushPictures::instance()
{
    static QPointer<BrushPictures> pictures; // goes with the application
    if (!pictures)
        pictures = new BrushPictures(qApp);
    return *pictures;
}

QIcon BrushPictures::icon(const QString &name, double ratio, bool changed) const
{
    const int key = int(BrushLibrary::instance().favourites().indexOf(name)) + 1;
    const QImage image = m_drawn.value(name).image;
    QIcon result;
    // A brush that is chosen has a frame, since a tint would change its colours.
    for (const QIcon::Mode mode : {QIcon::Normal, QIcon::Selected}) {
        QPixmap sheet = onPaper(image, size, ratio, mode == QIcon::Selected, key);
        if (changed)
            paintDot(sheet);
        result.addPixmap(sheet, mode);
    }
    return result;
}

QPixmap BrushPictures::sheet(const QString &name, QSize pixels, double ratio) const
{
    return onPaper(m_drawn.value(name).image, pixels, ratio, false, 0);
}

bool BrushPictures::isDrawn(const Brush &brush) const
{
    const auto found = m_drawn.constFind(brush.name);
    return found != m_drawn.constEnd() && found->brush == brush && found->ratio >= m_ratio;
}

void BrushPictures::want(double ratio)
{
    m_ratio = std::max(m_ratio, ratio);
    const bool idle = m_pending.empty();
    m_pending.clear();
    const std::vector<Brush> &brushes = BrushLibrary::instance().brushes();
    for (auto brush = brushes.rbegin(); brush != brushes.rend(); ++brush)
        if (!isDrawn(*brush))
            m_pending.push_back(brush->name);
    if (idle && !m_pending.empty())
        QTimer::singleShot(0, this, &BrushPictures::renderNext);
}

void BrushPictures::renderNext()
{
    if (m_pending.empty())
        return;
    const QString name = m_pending.back();
    m_pending.pop_back();
    if (const Brush *brush = BrushLibrary::instance().find(name)) {
        m_drawn.insert(name, {*brush, m_ratio, m_preview.render(*brush, size * m_ratio)});
        emit drawn(name);
    }
    if (!m_pending.empty())
        QTimer::singleShot(0, this, &BrushPictures::renderNext);
}

} // namespace suffuse
