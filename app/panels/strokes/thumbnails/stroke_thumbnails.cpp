#include "app/panels/strokes/thumbnails/stroke_thumbnails.h"

#include <algorithm>

namespace suffuse {

namespace {
constexpr std::size_t mostWanted = 64; ///< Older wishes are dropped, since their rows have been scrolled past.

QImage drawn(ThumbnailRenderer &renderer, const StrokePtr &stroke, double ratio)
{
    auto painting = std::make_shared<Painting>();
    auto shown = std::make_shared<Stroke>(*stroke);
    shown->visible = true;
    shown->group = 0;
    painting->strokes.push_back(shown);
    Rect box;
    for (const Segment &segment : stroke->segments)
        box = box.united(stroke->cubicOf(segment).controlBox().grown(1.2 * segment.spread(segment.driesAt())));
    return renderer.draw(painting, box, ratio);
}

} // namespace

StrokeThumbnails::StrokeThumbnails(QObject *parent) : QObject(parent), m_renderer(std::make_shared<ThumbnailRenderer>())
{
    m_thread.setMaxThreadCount(1);
}

StrokeThumbnails::~StrokeThumbnails()
{
    m_thread.waitForDone();
}

QImage StrokeThumbnails::of(const StrokePtr &stroke, double ratio, bool quiet)
{
    const Entry *entry = m_known.object(stroke->id);
    if (entry && entry->stroke == stroke && entry->image.devicePixelRatio() == ratio)
        return entry->image;
    const bool asked = m_running == stroke || std::any_of(m_wanted.begin(), m_wanted.end(),
                                                          [&](const auto &wish) { return wish.first == stroke; });
    if (!quiet && !asked) {
        if (m_wanted.size() >= mostWanted)
            m_wanted.erase(m_wanted.begin());
        m_wanted.emplace_back(stroke, ratio);
        startNext();
    }
    return entry ? entry->image : QImage();
}

void StrokeThumbnails::startNext()
{
    if (m_running || m_wanted.empty())
        return;
    const auto [stroke, ratio] = m_wanted.back();
    m_wanted.pop_back();
    m_running = stroke;
    m_thread.start([this, stroke = stroke, ratio = ratio, renderer = m_renderer] {
        const QImage image = drawn(*renderer, stroke, ratio);
        QMetaObject::invokeMethod(
            this, [this, stroke, image] { take(stroke, image); }, Qt::QueuedConnection);
    });
}

void StrokeThumbnails::take(const StrokePtr &stroke, const QImage &image)
{
    m_running = nullptr;
    m_known.insert(stroke->id, new Entry{stroke, image});
    emit ready(stroke->id);
    startNext();
}

} // namespace suffuse
