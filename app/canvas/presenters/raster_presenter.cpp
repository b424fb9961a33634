#include "app/canvas/presenters/presenter.h"
#include "app/canvas/view_transform.h"

#include <QImage>
#include <QPaintEvent>
#include <QPainter>

namespace suffuse {

namespace {

/// Draws the frame with QPainter on a plain widget, which is the faster way where OpenGL is software.
class RasterPresenter : public QWidget, public Presenter {
public:
    RasterPresenter(CanvasContent &content, QWidget *parent) : QWidget(parent), m_content(content)
    {
        setAttribute(Qt::WA_TransparentForMouseEvents);
        setAttribute(Qt::WA_OpaquePaintEvent);
        setFocusPolicy(Qt::NoFocus);
    }

    QWidget *widget() override { return this; }
    QString name() const override { return QStringLiteral("raster"); }
    void updateArea(const QRegion &area) override { update(area); }

protected:
    void paintEvent(QPaintEvent *event) override
    {
        QPainter painter(this);
        m_content.withFrame([&](ShownFrame &frame) { paintPicture(painter, frame, event->region()); });
        begin(painter, event->region());
        m_content.paintOverlay(painter);
    }

private:
    /// Sets a painter up to work in device pixels, within a region of logical pixels.
    void begin(QPainter &painter, const QRegion &within)
    {
        const double toDevice = 1 / devicePixelRatioF();
        painter.resetTransform();
        painter.setClipRegion(within);
        painter.scale(toDevice, toDevice);
    }

    /// Paints a few rows at a time, so that the pasteboard finds the frame in the cache. (Around a sheet that is turned
    /// the pasteboard is a path, which takes longer to make than to fill.)
    void paintPicture(QPainter &painter, ShownFrame &frame, const QRegion &region)
    {
        const std::optional<ShownUnderlay> underlay = m_content.underlay();
        if (!underlay)
            m_underlay.forget();
        const QRect all = region.boundingRect();
        const int rows = m_content.shownView().rotation == 0 ? 64 : all.height();
        for (int y = all.top(); y <= all.bottom(); y += rows) {
            begin(painter, region & QRect(all.left(), y, all.width(), rows));
            const QRect part = painter.clipBoundingRect().toAlignedRect();
            if (m_content.screenColours().changesNothing())
                paintColours(painter, frame, underlay, part);
            else
                paintConverted(painter, frame, underlay, part);
            m_content.paintAround(painter);
        }
    }

    /// Paints the picture and what lies over it.
    void paintColours(QPainter &painter, ShownFrame &frame, const std::optional<ShownUnderlay> &underlay,
                      const QRect &part)
    {
        paintFrame(painter, frame);
        if (underlay)
            m_underlay.paint(painter, *underlay, m_content.shownView(), part);
    }

    /// Paints them in the screen's colours.
    void paintConverted(QPainter &painter, ShownFrame &frame, const std::optional<ShownUnderlay> &underlay,
                        const QRect &part)
    {
        if (part.isEmpty())
            return;
        if (m_converted.width() < part.width() || m_converted.height() < part.height())
            m_converted = QImage(part.size().expandedTo(m_converted.size()), QImage::Format_RGB32);
        QPainter colours(&m_converted);
        colours.translate(-part.topLeft());
        colours.setClipRect(part);
        paintColours(colours, frame, underlay, part);
        colours.end();
        for (int y = 0; y < part.height(); ++y)
            m_content.screenColours().convert(reinterpret_cast<std::uint32_t *>(m_converted.scanLine(y)),
                                              std::size_t(part.width()));
        painter.drawImage(part.topLeft(), m_converted, QRect({}, part.size()));
    }

    void paintFrame(QPainter &painter, ShownFrame &frame)
    {
        frame.dirty.clear();
        const View &view = m_content.shownView();
        const bool sharp = frame.view == view;
        if (!sharp || frame.picture.argb.empty())
            painter.fillRect(QRectF(0, 0, view.width + 1, view.height + 1), m_content.backgroundColour());
        if (frame.picture.argb.empty() || !isFrameUseful(frame, view))
            return;
        const QImage image(reinterpret_cast<const uchar *>(frame.picture.argb.data()), frame.picture.width,
                           frame.picture.height, qsizetype(frame.picture.width) * 4, QImage::Format_RGB32);
        painter.save();
        if (!sharp) {
            painter.setRenderHint(QPainter::SmoothPixmapTransform);
            painter.setTransform(mapBetween(frame.view, view), true);
        }
        painter.drawImage(QPointF(0, 0), image);
        painter.restore();
    }

    CanvasContent &m_content;
    UnderlaySheet m_underlay;
    QImage m_converted; ///< at least as large as what was painted last
};

} // namespace

Presenter *makeRasterPresenter(CanvasContent &content, QWidget *parent)
{
    return new RasterPresenter(content, parent);
}

} // namespace suffuse
